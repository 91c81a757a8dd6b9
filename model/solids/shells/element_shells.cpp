#include "model/solids/shells/element_shells.h"

#include <algorithm>
#include <iterator>
#include <utility>

#include "model/board/copies.h"
#include "model/board/laser_via.h"
#include "model/geometry/loops/edge_faults.h"
#include "model/geometry/loops/edge_union.h"
#include "model/solids/shells/arc_shell.h"
#include "model/solids/shells/area_shell.h"
#include "model/solids/shells/circle_shell.h"
#include "model/solids/shells/line_shell.h"
#include "model/solids/shells/trail_shell.h"

namespace model {

namespace {

constexpr std::string_view kNoWidth = "it has no width";
constexpr std::string_view kOverlapsItself = "the track overlaps itself";
constexpr std::string_view kNotJoined = "its tracks could not be joined and overlap";
constexpr std::string_view kCrossesItself = "its outline touches or crosses itself";
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

ElementOutlines arcRegions(const ArcGeometry& arc) {
    std::optional<std::vector<EdgeLoops>> regions = arcOutlines(arc);
    if (!regions) {
        return {{}, kOverlapsItself};
    }
    return {std::move(*regions), arc.width <= 0 ? kNoWidth : std::string_view{}};
}

ElementOutlines trailRegions(const Document& document, const TrailGeometry& trail) {
    if (trail.width <= 0) {
        return {{}, kNoWidth};
    }
    std::optional<std::vector<EdgeLoops>> regions = trailOutlines(document, trail);
    return regions ? ElementOutlines{std::move(*regions), {}}
                   : ElementOutlines{trackOutlines(document, trail), kNotJoined};
}

/// Regions that touch or cross themselves are replaced by what they cover. Returns false where that did not succeed.
bool clean(std::vector<EdgeLoops>& regions) {
    std::vector<EdgeLoops> sound;
    bool isClean = true;
    for (EdgeLoops& region : regions) {
        std::optional<std::vector<EdgeLoops>> parts;
        if (findFault(region)) {
            parts = cleaned(region);
            isClean = isClean && parts;
        }
        if (parts) {
            std::ranges::move(*parts, std::back_inserter(sound));
        } else {
            sound.push_back(std::move(region));
        }
    }
    regions = std::move(sound);
    return isClean;
}

ElementOutlines placedArea(const Document& document, const AreaGeometry& area) {
    ElementOutlines outlines = outlinesOf(document, area.shape);
    if (!isIdentity(area.placement)) {
        for (EdgeLoops& region : outlines.regions) {
            region = placed(region, area.placement);
        }
    }
    return outlines;
}

}  // namespace

ElementOutlines outlinesOf(const Document& document, ShapeId shape) {
    ElementOutlines outlines{areaOutlines(document.shapes, shape), {}};
    const bool isClean = clean(outlines.regions);
    outlines.problem = outlines.regions.empty() ? kNoArea : isClean ? std::string_view{} : kCrossesItself;
    return outlines;
}

ElementOutlines outlinesOf(const Document& document, ElementId element) {
    const std::uint32_t row = document.elements.geometry[element.row()];
    switch (document.elements.kind[element.row()]) {
        case ElementKind::Line: {
            const LineGeometry& line = document.lines[row];
            return oneRegion(lineOutline(line, (document.elements.flags[element.row()] & kSquarePen) != 0), line.width);
        }
        case ElementKind::Arc: return arcRegions(document.arcs[row]);
        case ElementKind::Circle:
            return oneRegion(circleOutline(document.circles[row]), document.circles[row].diameter);
        case ElementKind::Trail: return trailRegions(document, document.trails[row]);
        case ElementKind::Area: return placedArea(document, document.areas[row]);
    }
    return {};
}

ZRange solidHeightsOf(const Document& document, ElementId element, bool isFlipped) {
    if (!isPlatedHole(document.elements.flags[element.row()])) {
        return heightsInCopy(document, element, isFlipped);
    }
    PlatedSpan span = document.platedSpanOf(element);
    if (!span.top.isValid() || !span.bottom.isValid()) {
        return {};
    }
    ZRange top = heightsInCopy(document, span.top, isFlipped);
    ZRange bottom = heightsInCopy(document, span.bottom, isFlipped);
    if (bottom.bottom > top.bottom) {
        std::swap(span.top, span.bottom);
        std::swap(top, bottom);
    }
    const LayerId target = targetOf(document, element);
    if (target.isValid() && target == span.bottom) {
        return {bottom.top, top.top};
    }
    return {bottom.bottom, target.isValid() && target == span.top ? top.bottom : top.top};
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
