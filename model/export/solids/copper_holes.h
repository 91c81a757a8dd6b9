#pragma once

#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "model/base/progress.h"
#include "model/solids/shells/drilled_copper.h"
#include "model/solids/shells/shared_shape.h"

namespace model {

/// What is drilled through the copper of a document, and which of its pads and tracks are drilled alike, so that they
/// are written once. Reading is safe from every thread.
class CopperHoles {
public:
    /// Those holes that `isOpen` wants.
    CopperHoles(const Document& document, const std::function<bool(ElementId)>& isOpen);

    /// Near a box on that layer; none on a layer that is no copper.
    [[nodiscard]] std::vector<RegionSearch> near(LayerId layer, const Box& box) const;
    [[nodiscard]] std::size_t countNear(LayerId layer, const Box& box) const;

    /// Compares how those of these elements are drilled that have a shape in common with others. Incomplete when
    /// cancelled.
    void compare(std::span<const ElementId> elements, const base::Progress& progress);
    /// The shape that an element has in common with others once it is drilled: of those of compare(). Without a value
    /// where it has none, or holes that are not round.
    [[nodiscard]] std::optional<SharedShape> sharedShapeOf(ElementId element) const;
    /// What is drilled through a shape, where SharedShape::placement is none.
    [[nodiscard]] std::vector<RegionSearch> through(const ShapeKey& key) const;

private:
    /// A round hole in the coordinates of a shape.
    struct RoundHole {
        Point centre;
        Nm diameter = 0;
        auto operator<=>(const RoundHole&) const = default;
    };
    using Pattern = std::vector<RoundHole>;
    class Shapes;

    struct DrilledElement {
        ElementId element;
        std::optional<std::uint32_t> pattern;  ///< row of m_patterns; none: it is like no other
    };

    [[nodiscard]] static std::vector<RegionSearch> regionsOf(const Pattern& pattern);
    [[nodiscard]] std::optional<Pattern> patternOf(const SharedShape& shape, const std::vector<RegionSearch>& holes,
                                                   Shapes& shapes) const;
    std::uint32_t rowOf(const Pattern& pattern);

    const Document* m_document;
    /// By layer, those of all layers that the same holes pass; none where there is no copper.
    std::vector<std::shared_ptr<const HoleRegions>> m_ofLayers;
    std::map<Pattern, std::uint32_t> m_rows;
    std::vector<Pattern> m_patterns = std::vector<Pattern>(1);  ///< the first one: nothing is drilled
    std::vector<DrilledElement> m_drilled;                      ///< rising
};

}  // namespace model
