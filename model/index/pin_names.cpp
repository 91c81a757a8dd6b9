#include "model/index/pin_names.h"

#include <algorithm>

namespace model {

namespace {

const std::string* designatorOf(const Document& document, const Pin& pin) {
    return pin.component.isValid() ? &document.components[pin.component.row()].refdes : nullptr;
}

}  // namespace

std::string pinName(const Document& document, PinId id) {
    const Pin& pin = document.pins[id.row()];
    const std::string& name = document.text(pin.name);
    const std::string* refdes = designatorOf(document, pin);
    if (refdes == nullptr || name.size() < refdes->size() + 2 || !name.starts_with(*refdes)) {
        return name;
    }
    const char separator = name[refdes->size()];
    return separator == '-' || separator == '.' ? name.substr(refdes->size() + 1) : name;
}

std::string fullPinName(const Document& document, PinId id) {
    const std::string* refdes = designatorOf(document, document.pins[id.row()]);
    const std::string name = pinName(document, id);
    return refdes == nullptr ? name : name.empty() ? *refdes : *refdes + '.' + name;
}

PinId pinOf(const Document& document, const PinFinder& pins, ElementId element) {
    const SubnetId subnet = document.elements.subnet[element.row()];
    if (subnet.isValid() && document.subnets[subnet.row()].pin.isValid()) {
        return document.subnets[subnet.row()].pin;
    }
    const std::vector<PinId> found = pins.pinsOf(element);
    return found.empty() ? PinId{} : found.front();
}

std::vector<PinId> pinsNamedAs(const Document& document, PinId id) {
    const Pin& pin = document.pins[id.row()];
    const std::string& name = document.text(pin.name);
    if (!pin.component.isValid() || name.empty()) {
        return {id};
    }
    const Component& part = document.components[pin.component.row()];
    std::vector<PinId> pins;
    for (std::size_t row = part.firstPin; row < part.firstPin + part.pinCount; ++row) {
        if (document.text(document.pins[row].name) == name) {
            pins.emplace_back(row);
        }
    }
    return pins;
}

std::vector<ComponentId> componentsNamedAs(const Document& document, ComponentId id) {
    const std::string& refdes = document.components[id.row()].refdes;
    if (refdes.empty()) {
        return {id};
    }
    std::vector<ComponentId> parts;
    for (std::size_t row = 0; row < document.components.size(); ++row) {
        if (document.components[row].refdes == refdes) {
            parts.emplace_back(row);
        }
    }
    return parts;
}

std::vector<NetId> netsOf(const Document& document, const Component& component) {
    std::vector<NetId> nets;
    for (const Pin& pin : document.pinsOf(component)) {
        if (pin.net.isValid()) {
            nets.push_back(pin.net);
        }
    }
    std::ranges::sort(nets);
    nets.erase(std::unique(nets.begin(), nets.end()), nets.end());
    return nets;
}

}  // namespace model
