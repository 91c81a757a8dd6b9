#include "model/nets/tie_claims.h"

#include <algorithm>
#include <iterator>
#include <map>
#include <string>
#include <string_view>
#include <utility>

#include "model/base/ascii.h"
#include "model/index/attributes.h"
#include "model/index/pin_names.h"
#include "model/nets/pad_groups.h"

namespace model {

namespace {

/// "NetTie-2_SMD_Pad0.5mm", "NET_TIE" and "Net Tie" alike.
std::string lettersOf(std::string_view text) {
    std::string letters;
    for (const char c : text) {
        if (c != ' ' && c != '_' && c != '-') {
            letters += base::lowerAscii(c);
        }
    }
    return letters;
}

/// All that a component is called, a line each.
std::string namesOf(const Document& document, const Component& component) {
    std::string names = lettersOf(component.refdes) + '\n' + lettersOf(component.part) + '\n';
    if (component.package.isValid()) {
        names += lettersOf(document.packages[component.package.row()].name) + '\n';
    }
    forEachAttribute(document, component, [&](const std::string& name, const std::string& value) {
        names += lettersOf(name) + '\n' + lettersOf(value) + '\n';
    });
    return names;
}

/// Is it of that class, as R1 is a resistor?
bool isReference(const std::string& refdes, std::string_view letters) {
    return refdes.size() > letters.size() && refdes.starts_with(letters) && refdes[letters.size()] >= '0' &&
           refdes[letters.size()] <= '9';
}

TieClaim claimByName(const Document& document, const Component& component) {
    const std::string names = namesOf(document, component);
    const auto says = [&](std::string_view word) { return names.find(word) != std::string::npos; };
    if (says("nettie") || isReference(component.refdes, "NT")) {
        return TieClaim::NetTie;
    }
    const bool isJumper = says("jumper") || isReference(component.refdes, "JP") || isReference(component.refdes, "SJ");
    return isJumper && !says("open") && !says("header") ? TieClaim::Jumper : TieClaim::None;
}

/// Readers of KiCad's boards say so in the version.
bool canDeclareTies(const Document& document) {
    return document.job.version.starts_with("KiCad");
}

std::vector<NetId> netsOf(const Document& document, const PinGroup& pins) {
    std::vector<NetId> nets;
    for (const PinId pin : pins) {
        if (const NetId net = document.pins[pin.row()].net; net.isValid()) {
            nets.push_back(net);
        }
    }
    std::ranges::sort(nets);
    nets.erase(std::unique(nets.begin(), nets.end()), nets.end());
    return nets;
}

/// "unconnected-(U3-NC-Pad15)_7" without its number; empty for nets of other names.
std::string_view unconnectedPin(std::string_view net) {
    if (!net.starts_with("unconnected-(")) {
        return {};
    }
    const std::size_t end = net.rfind(')');
    return end == std::string_view::npos ? net : net.substr(0, end + 1);
}

/// Groups that share a net become one.
void addGroup(std::vector<NetId> nets, std::vector<std::vector<NetId>>& groups) {
    std::erase_if(groups, [&](const std::vector<NetId>& other) {
        std::vector<NetId> both;
        std::ranges::set_union(nets, other, std::back_inserter(both));
        const bool isShared = both.size() < nets.size() + other.size();
        if (isShared) {
            nets = std::move(both);
        }
        return isShared;
    });
    groups.push_back(std::move(nets));
}

/// Nets of pads that are one pin.
std::vector<std::vector<NetId>> netsOfOnePin(const Document& document, const Component& component) {
    std::map<std::string, PinGroup> pins;
    for (std::size_t row = component.firstPin; row < component.firstPin + component.pinCount; ++row) {
        const PinId pin{row};
        const NetId net = document.pins[row].net;
        const std::string_view unconnected = net.isValid() ? unconnectedPin(document.nets[net.row()].name) : "";
        if (!unconnected.empty()) {
            pins[std::string(unconnected)].push_back(pin);
        }
        if (const std::string name = pinName(document, pin); !name.empty()) {
            pins["pin " + name].push_back(pin);
        }
    }
    std::vector<std::vector<NetId>> groups;
    for (const auto& [name, group] : pins) {
        if (std::vector<NetId> nets = netsOf(document, group); nets.size() > 1) {
            addGroup(std::move(nets), groups);
        }
    }
    return groups;
}

}  // namespace

TiedNets tiedNetsOf(const Document& document, ComponentId id) {
    const Component& component = document.components[id.row()];
    TiedNets tied;
    if (const std::vector<PinGroup> groups = netTieGroups(document, id); !groups.empty()) {
        tied.claim = TieClaim::Declared;
        for (const PinGroup& group : groups) {
            tied.groups.push_back(netsOf(document, group));
        }
    } else if (!canDeclareTies(document)) {
        tied.claim = claimByName(document, component);
        tied.groups.push_back(tied.claim != TieClaim::None ? model::netsOf(document, component) : std::vector<NetId>());
    }
    std::ranges::move(netsOfOnePin(document, component), std::back_inserter(tied.groups));
    std::erase_if(tied.groups, [](const std::vector<NetId>& nets) { return nets.size() < 2; });
    if (tied.claim == TieClaim::None && !tied.groups.empty()) {
        tied.claim = TieClaim::OnePin;
    }
    return tied;
}

}  // namespace model
