#include "model/solids/shells/drawn_outlines.h"

#include "model/solids/shells/arc_shell.h"
#include "model/solids/shells/circle_shell.h"
#include "model/solids/shells/line_shell.h"
#include "model/solids/shells/trail_shell.h"

namespace model {

namespace {

constexpr std::string_view kNoWidth = "it has no width";
constexpr std::string_view kNotJoined = "its outline could not be found";

ElementOutlines oneRegion(EdgeLoops region) {
    return region.loopCount() > 0 ? ElementOutlines{{std::move(region)}, {}} : ElementOutlines{{}, kNoWidth};
}

ElementOutlines arcRegions(const ArcGeometry& arc) {
    std::optional<std::vector<EdgeLoops>> regions = arcOutlines(arc);
    return regions ? ElementOutlines{std::move(*regions), arc.width > 0 ? std::string_view{} : kNoWidth}
                   : ElementOutlines{{}, kNotJoined};
}

ElementOutlines trailRegions(const Document& document, TrailGeometry trail) {
    if (trail.width <= 0) {
        return {{}, kNoWidth};
    }
    trail.innerWidth = 0;
    std::optional<std::vector<EdgeLoops>> regions = trailOutlines(document, trail);
    return {regions ? std::move(*regions) : trackOutlines(document, trail), {}};
}

CircleGeometry drawnCircle(CircleGeometry circle, bool isHole) {
    if (isHole) {
        circle.innerDiameter = 0;
    }
    return circle;
}

}  // namespace

ElementOutlines drawnOutlinesOf(const Document& document, ElementId element) {
    const std::uint32_t row = document.elements.geometry[element.row()];
    const std::uint8_t flags = document.elements.flags[element.row()];
    switch (document.elements.kind[element.row()]) {
        case ElementKind::Area: return outlinesOf(document, element);
        case ElementKind::Line: {
            const LineGeometry& line = document.lines[row];
            return oneRegion(lineOutline({line.a, line.b, line.width}, (flags & kSquarePen) != 0));
        }
        case ElementKind::Arc: {
            const ArcGeometry& arc = document.arcs[row];
            return arcRegions({arc.node, arc.end, arc.width});
        }
        case ElementKind::Circle:
            return oneRegion(circleOutline(drawnCircle(document.circles[row], (flags & kHole) != 0)));
        case ElementKind::Trail: return trailRegions(document, document.trails[row]);
    }
    return {};
}

}  // namespace model
