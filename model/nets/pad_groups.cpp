#include "model/nets/pad_groups.h"

#include <algorithm>
#include <map>
#include <string>
#include <string_view>

#include "model/board/pad_group_names.h"
#include "model/index/pin_names.h"

namespace model {

namespace {

/// The words of "1, 2 ,3".
std::vector<std::string_view> wordsOf(std::string_view list) {
    constexpr std::string_view kBetween = ", \t";
    std::vector<std::string_view> words;
    for (std::size_t at = list.find_first_not_of(kBetween); at != std::string_view::npos;) {
        const std::size_t end = std::min(list.find_first_of(kBetween, at), list.size());
        words.push_back(list.substr(at, end - at));
        at = list.find_first_not_of(kBetween, end);
    }
    return words;
}

template <class Take>
void forEachPin(const Document& document, ComponentId id, const Take& take) {
    const Component& component = document.components[id.row()];
    for (std::uint32_t i = 0; i < component.pinCount; ++i) {
        const PinId pin{std::size_t{component.firstPin} + i};
        take(pin, pinName(document, pin));
    }
}

void addListed(const Document& document, ComponentId component, std::string_view head, std::vector<PinGroup>& groups) {
    for (const Property& property : document.propertiesOf(document.components[component.row()].properties)) {
        if (document.text(property.name) != head) {
            continue;
        }
        const std::vector<std::string_view> words = wordsOf(document.text(property.value));
        PinGroup group;
        forEachPin(document, component, [&](PinId pin, const std::string& name) {
            if (std::ranges::find(words, name) != words.end()) {
                group.push_back(pin);
            }
        });
        if (!group.empty()) {
            groups.push_back(std::move(group));
        }
    }
}

}  // namespace

std::vector<PinGroup> netTieGroups(const Document& document, ComponentId component) {
    std::vector<PinGroup> groups;
    addListed(document, component, kNetTieGroup, groups);
    return groups;
}

std::vector<PinGroup> jumperGroups(const Document& document, ComponentId component) {
    std::vector<PinGroup> groups;
    addListed(document, component, kJumperGroup, groups);
    const auto properties = document.propertiesOf(document.components[component.row()].properties);
    if (std::ranges::none_of(properties, [&](const Property& property) {
            return document.text(property.name) == kDuplicatesAreJumpers;
        })) {
        return groups;
    }
    std::map<std::string, PinGroup> ofNumber;
    forEachPin(document, component, [&](PinId pin, const std::string& name) { ofNumber[name].push_back(pin); });
    for (auto& [name, group] : ofNumber) {
        if (!name.empty() && group.size() > 1) {
            groups.push_back(std::move(group));
        }
    }
    return groups;
}

}  // namespace model
