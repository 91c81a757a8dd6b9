#pragma once

#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

#include "model/export/solids/step_text.h"
#include "model/geometry/shapes.h"

namespace model {

/// A part of the tree that a reader shows: a product with its shape.
struct StepProduct {
    StepId definition = 0;      ///< PRODUCT_DEFINITION
    StepId representation = 0;  ///< of its shape
};

/// How something looks, sRGB; opacity 1 is solid.
struct StepColour {
    std::uint32_t rgb = 0x808080;
    double opacity = 1.0;
    auto operator<=>(const StepColour&) const = default;
};

/// Writes what stands around the solids of a STEP file: units, products in products (NEXT_ASSEMBLY_USAGE_OCCURRENCE,
/// whose names readers show), shapes that are written once and placed often (MAPPED_ITEM), and colours.
class StepAssembly {
public:
    /// `origin` is the placement at the origin.
    StepAssembly(StepText& text, StepId origin);

    /// A product whose shape consists of these solids and mapped items.
    StepProduct addPart(std::string_view name, std::span<const StepId> items);
    /// A product that holds others, which are added by place().
    StepProduct addGroup(std::string_view name);
    /// Puts `child` into `parent` where `placement` says.
    void place(const StepProduct& child, const StepProduct& parent, std::string_view name, StepId placement);

    /// A shape that has no product of its own, to be placed by addCopy.
    StepId addShape(std::span<const StepId> solids);
    StepId addCopy(StepId shape, StepId placement);

    /// Colours a solid; also all copies of a shape that it belongs to.
    void colour(StepId solid, const StepColour& colour);
    /// Once, at the end: what holds the colours together.
    void finish();

private:
    StepProduct addProduct(std::string_view name, std::string_view kind, std::span<const StepId> items);
    StepId styleOf(const StepColour& colour);
    void flushStyles();

    StepText& m_text;
    StepId m_origin;
    StepId m_context = 0;  ///< of representations
    StepId m_productContext = 0;
    StepId m_definitionContext = 0;
    std::uint32_t m_placed = 0;
    std::vector<std::pair<StepColour, StepId>> m_styles;
    std::vector<StepId> m_styled;
};

/// What a file begins and ends with; `name` is the board's, `time` as in ISO 8601.
[[nodiscard]] std::string stepHeader(std::string_view name, std::string_view time, std::string_view program);
[[nodiscard]] std::string_view stepFooter();

}  // namespace model
