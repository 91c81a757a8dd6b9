#include "model/solids/shells/element_shells.h"

#include "model/solids/shells/arc_shell.h"
#include "model/solids/shells/area_shell.h"
#include "model/solids/shells/circle_shell.h"
#include "model/solids/shells/line_shell.h"
#include "model/solids/shells/trail_shell.h"

namespace model {

namespace {

constexpr std::string_view kNoWidth = "it has no width";
constexpr std::string_view kOverlapsItself = "the track overlaps itself";
constexpr std::string_view kNoArea = "its outline has no area";

/// With a reason where nothing is left of an element that is not a hole.
ElementOutlines oneRegion(EdgeLoops region, Nm width) {
    ElementOutlines outlines;
    if (region.loopCount() > 0) {
        outlines.regions.push_back(std::move(region));
    } else if (width <= 0) {
        outlines.problem = kNoWidth;
    }
    return outlines;
}

ElementOutlines arcOutlines(const ArcGeometry& arc) {
    std::optional<EdgeLoops> region = arcOutline(arc);
    return region ? oneRegion(std::move(*region), arc.width) : ElementOutlines{{}, kOverlapsItself};
}

ElementOutlines placedArea(const Document& document, const AreaGeometry& area) {
    ElementOutlines outlines{areaOutlines(document.shapes, area.shape), {}};
    if (!isIdentity(area.placement)) {
        for (EdgeLoops& region : outlines.regions) {
            region = placed(region, area.placement);
        }
    }
    outlines.problem = outlines.regions.empty() ? kNoArea : std::string_view{};
    return outlines;
}

}  // namespace

ElementOutlines outlinesOf(const Document& document, ElementId element) {
    const std::uint32_t row = document.elements.geometry[element.row()];
    switch (document.elements.kind[element.row()]) {
        case ElementKind::Line: {
            const LineGeometry& line = document.lines[row];
            return oneRegion(lineOutline(line, (document.elements.flags[element.row()] & kSquarePen) != 0), line.width);
        }
        case ElementKind::Arc: return arcOutlines(document.arcs[row]);
        case ElementKind::Circle:
            return oneRegion(circleOutline(document.circles[row]), document.circles[row].diameter);
        case ElementKind::Trail: {
            const TrailGeometry& trail = document.trails[row];
            std::vector<EdgeLoops> tracks = trackOutlines(document, trail);
            return {std::move(tracks), trail.width <= 0 ? kNoWidth : std::string_view{}};
        }
        case ElementKind::Area: return placedArea(document, document.areas[row]);
    }
    return {};
}

ZRange solidHeightsOf(const Document& document, ElementId element) {
    if (!isPlatedHole(document.elements.flags[element.row()])) {
        return document.heightsOf(element);
    }
    const PlatedSpan span = document.platedSpanOf(element);
    if (!span.top.isValid() || !span.bottom.isValid()) {
        return {};
    }
    const Layer& top = document.layer(span.top);
    return {document.layer(span.bottom).z, top.z + top.thickness};
}

ElementShells shellsOf(const Document& document, ElementId element) {
    const ZRange z = solidHeightsOf(document, element);
    ElementShells result;
    if (z.top <= z.bottom) {
        return result;
    }
    ElementOutlines outlines = outlinesOf(document, element);
    result.problem = outlines.problem;
    for (EdgeLoops& region : outlines.regions) {
        result.shells.push_back({std::move(region), z});
    }
    return result;
}

}  // namespace model
