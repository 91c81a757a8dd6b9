#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "model/board/document.h"

/// Attributes and properties of the job the other way round: from a name and a value to what has them.
namespace model {

/// `take` gets the name and the value of each attribute of a component that says something: its value is not empty, or
/// it is one that is on or off, whose name begins with a dot. Other properties without a value are left out.
template <class Take>
void forEachAttribute(const Document& document, const Component& component, const Take& take) {
    for (const Property& property : document.propertiesOf(component.properties)) {
        const std::string& name = document.text(property.name);
        const std::string& value = document.text(property.value);
        if (!value.empty() || name.starts_with('.')) {
            take(name, value);
        }
    }
}

/// Does this attribute of a component say that nobody buys it: that the bill of materials does not list it, or that it
/// is on the board alone? KiCad's footprints of logos, holes and fiducials have such.
[[nodiscard]] bool excludesFromBom(std::string_view name, std::string_view value);
/// Does none of its attributes exclude the component from the bill of materials?
[[nodiscard]] bool isInBom(const Document& document, const Component& component);

/// One value of one attribute. Part and package of a component count as attributes called "Part" and "Package".
struct AttributeValue {
    enum class Owner : std::uint8_t { Components, Elements };
    Owner owner = Owner::Components;
    std::string name;
    std::string value;        ///< empty: it is set, and has no value
    std::uint32_t count = 0;  ///< how many components or elements have it
};

/// Each once, by owner, name and value; of components those of forEachAttribute.
[[nodiscard]] std::vector<AttributeValue> listAttributes(const Document& document);

/// Rising; empty if it is one of elements.
[[nodiscard]] std::vector<ComponentId> componentsWith(const Document& document, const AttributeValue& attribute);
/// Rising; empty if it is one of components.
[[nodiscard]] std::vector<ElementId> elementsWith(const Document& document, const AttributeValue& attribute);

}  // namespace model
