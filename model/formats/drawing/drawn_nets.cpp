#include "model/formats/drawing/drawn_nets.h"

namespace model::formats {

Range addProperties(DocumentBuilder& builder, const Words& words) {
    std::vector<Property> rows;
    rows.reserve(words.size());
    for (const auto& [name, value] : words) {
        rows.push_back({builder.string(name), builder.string(value)});
    }
    return builder.addProperties(rows);
}

DrawnNets::DrawnNets(DocumentBuilder& builder, const DrawnStep& step) : m_builder(builder) {
    m_nets.reserve(step.nets.size());
    for (const DrawnNet& net : step.nets) {
        m_nets.push_back(builder.addNet(net.name, addProperties(builder, net.properties)));
    }
}

std::size_t DrawnNets::KeyHash::operator()(const Key& key) const noexcept {
    std::uint64_t hash = 0;
    for (const std::uint32_t part : key) {
        hash = (hash ^ part) * 0x9e3779b97f4a7c15u;
        hash ^= hash >> 29;
    }
    return static_cast<std::size_t>(hash);
}

NetId DrawnNets::net(std::int32_t row) const {
    return row >= 0 && static_cast<std::size_t>(row) < m_nets.size() ? m_nets[static_cast<std::size_t>(row)] : NetId{};
}

PinId DrawnNets::pinOf(const DrawnFeature& feature) const {
    const base::Table<Component>& components = m_builder.soFar().components;
    if (feature.component < 0 || feature.pin < 0 || static_cast<std::size_t>(feature.component) >= components.size()) {
        return {};
    }
    const Component& component = components[static_cast<std::size_t>(feature.component)];
    const auto pin = static_cast<std::uint32_t>(feature.pin);
    return pin < component.pinCount ? PinId{std::size_t{component.firstPin} + pin} : PinId{};
}

DrawnNets::Key DrawnNets::keyOf(const DrawnFeature& feature, NetId net, PinId pin, LayerId layer) {
    const SubnetKind kind = pin.isValid() ? SubnetKind::PinPads : feature.subnet;
    Key key{net.value, static_cast<std::uint32_t>(kind), 0, 0};
    if (kind == SubnetKind::PinPads) {
        key[2] = pin.value;
    } else if (kind == SubnetKind::Via) {
        key[2] = static_cast<std::uint32_t>(feature.a.x);
        key[3] = static_cast<std::uint32_t>(feature.a.y);
    } else if (kind == SubnetKind::Plane) {
        key[2] = layer.value;
    }
    return key;
}

DrawnLink DrawnNets::linkOf(const DrawnFeature& feature, LayerId layer) {
    const NetId of = net(feature.net);
    if (!of.isValid()) {
        return {};
    }
    const PinId pin = pinOf(feature);
    const Key key = keyOf(feature, of, pin, layer);
    const auto [location, isNew] = m_subnets.try_emplace(key);
    if (isNew) {
        Subnet subnet;
        subnet.net = of;
        subnet.kind = static_cast<SubnetKind>(key[1]);
        subnet.pin = pin;
        location->second = m_builder.addSubnet(subnet);
    }
    return {of, location->second};
}

}  // namespace model::formats
