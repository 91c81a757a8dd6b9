#include "model/nets/tie_claims.h"

#include <algorithm>
#include <string>
#include <string_view>

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
            letters += static_cast<char>(c >= 'A' && c <= 'Z' ? c - 'A' + 'a' : c);
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
    std::erase_if(tied.groups, [](const std::vector<NetId>& nets) { return nets.size() < 2; });
    return tied;
}

}  // namespace model
