#include "model/index/attributes.h"

#include <algorithm>
#include <array>
#include <map>
#include <string_view>

namespace model {

namespace {

using Key = std::pair<std::string_view, std::string_view>;

/// Of KiCad; "virtual" is what versions before 6 call it.
constexpr std::array<std::string_view, 3> kNotInBom = {"exclude_from_bom", "board_only", "virtual"};

/// The part, the package, and the attributes.
template <class Take>
void forEachKey(const Document& document, const Component& component, const Take& take) {
    const auto takeIfSaid = [&](std::string_view name, const std::string& value) {
        if (!value.empty()) {
            take(Key{name, value});
        }
    };
    takeIfSaid("Part", component.part);
    if (component.package.isValid()) {
        takeIfSaid("Package", document.packages[component.package.row()].name);
    }
    forEachAttribute(document, component, [&](const std::string& name, const std::string& value) {
        take(Key{name, value});
    });
}

void append(const std::map<Key, std::uint32_t>& counts, AttributeValue::Owner owner, std::vector<AttributeValue>& all) {
    for (const auto& [key, count] : counts) {
        all.push_back({owner, std::string(key.first), std::string(key.second), count});
    }
}

/// How many elements have each row of Document::attributeSets.
std::vector<std::uint32_t> usesOfSets(const Document& document) {
    std::vector<std::uint32_t> uses(document.attributeSets.size());
    for (const AttributeSetId set : document.elements.attributes) {
        if (set.isValid()) {
            ++uses[set.row()];
        }
    }
    return uses;
}

}  // namespace

bool excludesFromBom(std::string_view name, std::string_view value) {
    return value == "yes" && std::ranges::find(kNotInBom, name) != kNotInBom.end();
}

bool isInBom(const Document& document, const Component& component) {
    return std::ranges::none_of(document.propertiesOf(component.properties), [&](const Property& property) {
        return excludesFromBom(document.text(property.name), document.text(property.value));
    });
}

std::vector<AttributeValue> listAttributes(const Document& document) {
    std::vector<AttributeValue> all;
    std::map<Key, std::uint32_t> counts;
    for (const Component& component : document.components) {
        forEachKey(document, component, [&](const Key& key) { ++counts[key]; });
    }
    append(counts, AttributeValue::Owner::Components, all);
    counts.clear();
    const std::vector<std::uint32_t> uses = usesOfSets(document);
    for (std::size_t set = 0; set < uses.size(); ++set) {
        for (const auto& [name, value] : document.attributeSets[set]) {
            counts[Key{name, value}] += uses[set];
        }
    }
    append(counts, AttributeValue::Owner::Elements, all);
    return all;
}

std::vector<ComponentId> componentsWith(const Document& document, const AttributeValue& attribute) {
    std::vector<ComponentId> found;
    for (std::size_t row = 0; attribute.owner == AttributeValue::Owner::Components && row < document.components.size();
         ++row) {
        bool hasIt = false;
        forEachKey(document, document.components[row], [&](const Key& key) {
            hasIt |= key == Key{attribute.name, attribute.value};
        });
        if (hasIt) {
            found.emplace_back(row);
        }
    }
    return found;
}

std::vector<ElementId> elementsWith(const Document& document, const AttributeValue& attribute) {
    std::vector<bool> hasIt(document.attributeSets.size());
    for (std::size_t set = 0; set < hasIt.size(); ++set) {
        hasIt[set] = attribute.owner == AttributeValue::Owner::Elements &&
                     std::ranges::find(document.attributeSets[set], std::pair(attribute.name, attribute.value)) !=
                         document.attributeSets[set].end();
    }
    std::vector<ElementId> found;
    for (std::size_t row = 0; row < document.elements.size(); ++row) {
        const AttributeSetId set = document.elements.attributes[row];
        if (set.isValid() && hasIt[set.row()]) {
            found.emplace_back(row);
        }
    }
    return found;
}

}  // namespace model
