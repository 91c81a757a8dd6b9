#include "model/index/pin_finder.h"

#include <algorithm>
#include <numeric>

namespace model {

PinFinder::PinFinder(const Document& document) : m_document(&document), m_start(document.nets.size() + 2) {
    for (const Pin& pin : document.pins) {
        ++m_start[groupOf(pin.net) + 1];
    }
    std::partial_sum(m_start.begin(), m_start.end(), m_start.begin());
    m_pins.resize(m_start.back());
    std::vector<std::uint32_t> next = m_start;
    for (std::size_t row = 0; row < document.pins.size(); ++row) {
        m_pins[next[groupOf(document.pins[row].net)]++] = PinId{row};
    }
}

std::size_t PinFinder::groupOf(NetId net) const {
    return net.isValid() ? net.row() : m_document->nets.size();
}

bool PinFinder::mayHavePins(ElementId element) const {
    const ElementTable& elements = m_document->elements;
    const Layer& layer = m_document->layer(elements.layer[element.row()]);
    // Without a net, pads of paste and solder mask would count too.
    return (elements.flags[element.row()] & (kPad | kHole)) != 0 &&
           (elements.net[element.row()].isValid() || layer.isCopper() || layer.type == LayerType::Drill);
}

std::vector<PinId> PinFinder::pinsOf(ElementId element) const {
    const ElementTable& elements = m_document->elements;
    if (!mayHavePins(element)) {
        return {};
    }
    const SubnetId subnet = elements.subnet[element.row()];
    if (subnet.isValid() && m_document->subnets[subnet.row()].pin.isValid()) {
        return {m_document->subnets[subnet.row()].pin};
    }
    std::vector<PinId> pins;
    const Box box = m_document->boxOf(element);
    const std::size_t group = groupOf(elements.net[element.row()]);
    std::copy_if(m_pins.begin() + m_start[group], m_pins.begin() + m_start[group + 1], std::back_inserter(pins),
                 [&](PinId pin) { return box.holds(m_document->pins[pin.row()].position); });
    return pins;
}

ComponentId PinFinder::componentOf(ElementId element) const {
    if (const Body* body = m_document->bodyOf(element)) {
        return body->component;
    }
    const std::vector<PinId> pins = pinsOf(element);
    return pins.empty() ? ComponentId{} : m_document->pins[pins.front().row()].component;
}

std::vector<ElementId> PinFinder::elementsOf(std::uint32_t firstPin, std::uint32_t pinCount) const {
    std::vector<NetId> nets;
    for (std::uint32_t row = firstPin; row < firstPin + pinCount; ++row) {
        nets.push_back(m_document->pins[row].net);
    }
    std::ranges::sort(nets);
    nets.erase(std::unique(nets.begin(), nets.end()), nets.end());
    std::vector<ElementId> found;
    std::vector<bool> isFound(pinCount);
    const auto addIfMeant = [&](ElementId element) {
        bool isMeant = false;
        for (const PinId pin : pinsOf(element)) {
            if (pin.row() >= firstPin && pin.row() < firstPin + pinCount) {
                isMeant = isFound[pin.row() - firstPin] = true;
            }
        }
        if (isMeant) {
            found.push_back(element);
        }
    };
    for (const NetId net : nets) {
        if (net.isValid()) {
            std::ranges::for_each(m_document->elementsOf(net), addIfMeant);
            continue;
        }
        for (std::size_t row = 0; row < m_document->elements.size(); ++row) {
            if (!m_document->elements.net[row].isValid()) {
                addIfMeant(ElementId{row});
            }
        }
    }
    for (std::uint32_t i = 0; i < pinCount; ++i) {
        if (!isFound[i]) {
            addShared(m_document->pins[firstPin + i], found);
        }
    }
    std::ranges::sort(found);
    found.erase(std::unique(found.begin(), found.end()), found.end());
    return found;
}

void PinFinder::addShared(const Pin& pin, std::vector<ElementId>& found) const {
    if (pin.net.isValid()) {
        std::ranges::copy_if(m_document->elementsOf(pin.net), std::back_inserter(found), [&](ElementId element) {
            return mayHavePins(element) && m_document->boxOf(element).holds(pin.position);
        });
    }
}

std::vector<ElementId> PinFinder::elementsOf(PinId pin) const {
    return elementsOf(static_cast<std::uint32_t>(pin.row()), 1);
}

std::vector<ElementId> PinFinder::elementsOf(ComponentId component) const {
    const Component& part = m_document->components[component.row()];
    std::vector<ElementId> found = elementsOf(part.firstPin, part.pinCount);
    for (const Body& body : m_document->bodies) {
        if (body.component == component) {
            found.push_back(body.element);
        }
    }
    std::ranges::sort(found);
    return found;
}

}  // namespace model
