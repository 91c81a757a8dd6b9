#include "model/index/pin_finder.h"

#include <algorithm>
#include <numeric>
#include <tuple>

namespace model {

PinFinder::PinFinder(const Document& document) : m_document(&document), m_start(document.nets.size() + 2) {
    groupPins();
    listElements();
}

void PinFinder::groupPins() {
    const auto& pins = m_document->pins;
    for (const Pin& pin : pins) {
        ++m_start[groupOf(pin.net) + 1];
    }
    std::partial_sum(m_start.begin(), m_start.end(), m_start.begin());
    for (std::size_t row = 0; row < pins.size(); ++row) {
        m_pins.emplace_back(row);
    }
    std::ranges::sort(m_pins, {}, [&](PinId pin) {
        const Pin& at = pins[pin.row()];
        return std::tuple(groupOf(at.net), at.position.x, pin);
    });
}

void PinFinder::listElements() {
    std::vector<std::pair<PinId, ElementId>> pairs;
    for (std::size_t row = 0; row < m_document->elements.size(); ++row) {
        for (const PinId pin : pinsOf(ElementId{row})) {
            pairs.emplace_back(pin, ElementId{row});
        }
    }
    std::ranges::sort(pairs);
    m_firstElement.resize(m_document->pins.size() + 1);
    for (const auto& [pin, element] : pairs) {
        ++m_firstElement[pin.row() + 1];
        m_elements.push_back(element);
    }
    std::partial_sum(m_firstElement.begin(), m_firstElement.end(), m_firstElement.begin());
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

bool PinFinder::mayBeByLocation(ElementId element) const {
    const SubnetId subnet = m_document->elements.subnet[element.row()];
    const SubnetKind kind = subnet.isValid() ? m_document->subnets[subnet.row()].kind : SubnetKind::Other;
    return kind == SubnetKind::PinPads || kind == SubnetKind::Other;
}

bool PinFinder::mayBeOn(PinId id, const Layer& layer) const {
    const Pin& pin = m_document->pins[id.row()];
    if (!layer.isCopper() || !pin.component.isValid() || pin.packagePin >= m_document->packagePins.size()) {
        return true;
    }
    const Component& component = m_document->components[pin.component.row()];
    const bool isOnOneSide =
        component.mount == MountType::Surface && m_document->packagePins[pin.packagePin].kind == PinKind::Surface;
    return !isOnOneSide || layer.side == component.side;
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
    if (!mayBeByLocation(element)) {
        return pins;
    }
    const Layer& layer = m_document->layer(elements.layer[element.row()]);
    const Box box = m_document->boxOf(element);
    const std::size_t group = groupOf(elements.net[element.row()]);
    const auto at = [&](PinId pin) { return m_document->pins[pin.row()].position; };
    const auto end = m_pins.begin() + m_start[group + 1];
    auto next = std::lower_bound(m_pins.begin() + m_start[group], end, box.min.x,
                                 [&](PinId pin, Nm x) { return at(pin).x < x; });
    for (; next != end && at(*next).x <= box.max.x; ++next) {
        if (box.holds(at(*next)) && mayBeOn(*next, layer)) {
            pins.push_back(*next);
        }
    }
    std::ranges::sort(pins);
    return pins;
}

std::span<const PinId> PinFinder::pinsOf(NetId net) const {
    const std::size_t group = groupOf(net);
    return std::span(m_pins).subspan(m_start[group], m_start[group + 1] - m_start[group]);
}

ComponentId PinFinder::componentOf(ElementId element) const {
    if (const Body* body = m_document->bodyOf(element)) {
        return body->component;
    }
    const std::vector<PinId> pins = pinsOf(element);
    return pins.empty() ? ComponentId{} : m_document->pins[pins.front().row()].component;
}

std::vector<ElementId> PinFinder::elementsOf(PinId pin) const {
    const auto first = m_elements.begin() + m_firstElement[pin.row()];
    const auto end = m_elements.begin() + m_firstElement[pin.row() + 1];
    return first != end ? std::vector(first, end) : sharedBy(m_document->pins[pin.row()]);
}

std::vector<ElementId> PinFinder::elementsOf(ComponentId component) const {
    const Component& part = m_document->components[component.row()];
    std::vector<ElementId> found;
    for (std::size_t pin = part.firstPin; pin < part.firstPin + part.pinCount; ++pin) {
        std::ranges::copy(elementsOf(PinId{pin}), std::back_inserter(found));
    }
    for (const Body& body : m_document->bodies) {
        if (body.component == component) {
            found.push_back(body.element);
        }
    }
    std::ranges::sort(found);
    found.erase(std::unique(found.begin(), found.end()), found.end());
    return found;
}

std::vector<ElementId> PinFinder::sharedBy(const Pin& pin) const {
    std::vector<ElementId> found;
    if (pin.net.isValid()) {
        std::ranges::copy_if(m_document->elementsOf(pin.net), std::back_inserter(found), [&](ElementId element) {
            return mayHavePins(element) && mayBeByLocation(element) && m_document->boxOf(element).holds(pin.position);
        });
    }
    return found;
}

}  // namespace model
