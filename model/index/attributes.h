#pragma once

#include <string>
#include <vector>

#include "model/board/document.h"

/// Attributes and properties of the job the other way round: from a name and a value to what has them.
namespace model {

/// One value of one attribute. Part and package of a component count as attributes called "Part" and "Package".
struct AttributeValue {
    enum class Owner : std::uint8_t { Components, Elements };
    Owner owner = Owner::Components;
    std::string name;
    std::string value;        ///< empty: it is set, and has no value
    std::uint32_t count = 0;  ///< how many components or elements have it
};

/// Each once, by owner, name and value. Properties of components without a value are left out: they say nothing.
[[nodiscard]] std::vector<AttributeValue> listAttributes(const Document& document);

/// Rising; empty if it is one of elements.
[[nodiscard]] std::vector<ComponentId> componentsWith(const Document& document, const AttributeValue& attribute);
/// Rising; empty if it is one of components.
[[nodiscard]] std::vector<ElementId> elementsWith(const Document& document, const AttributeValue& attribute);

}  // namespace model
