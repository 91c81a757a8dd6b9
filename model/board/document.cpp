#include "model/board/document.h"

#include <algorithm>

#include "model/base/ascii.h"
#include "model/geometry/outlines.h"
#include "model/geometry/region.h"

namespace model {

namespace {

Box boxOfArea(const Document& document, const AreaGeometry& area) {
    if (area.placement.clockwiseDeg == 0.0 && !area.placement.isMirrored) {
        const Box& own = document.shapes.shapes[area.shape.row()].box;
        const Point o = area.placement.origin;
        return {{own.min.x + o.x, own.min.y + o.y}, {own.max.x + o.x, own.max.y + o.y}};
    }
    // Rotated shapes are placed and measured again.
    return boxOf(sketchOf(document.shapes, area.shape, area.placement));
}

Box boxOfTrail(const Document& document, const TrailGeometry& trail) {
    const std::span<const PathNode> nodes = document.nodesOf(trail);
    const std::span<const Nm> widths = document.widthsOf(trail);
    Box box;
    for (std::size_t i = 0; i < widths.size(); ++i) {
        box.include(boxOfEdge(nodes[i], nodes[i + 1].point).grownBy(widths[i] / 2));
    }
    return box;
}

}  // namespace

std::span<const std::uint32_t> PaintedSources::of(ElementId element) const {
    const auto area = std::ranges::lower_bound(areas, element, {}, &PaintedArea::element);
    const bool isPainted = area != areas.end() && area->element == element;
    return isPainted ? std::span(features).subspan(area->firstFeature, area->featureCount)
                     : std::span<const std::uint32_t>{};
}

ZRange Document::heightsOf(ElementId element) const {
    const Layer& on = layer(elements.layer[element.row()]);
    const ZRange all{on.z, on.z + on.thickness};
    const Body* body = bodyOf(element);
    return body != nullptr ? body->heightsIn(all, on.side == LayerSide::Bottom) : all;
}

const Body* Document::bodyOf(ElementId element) const {
    const auto body = std::ranges::lower_bound(bodies, element, {}, &Body::element);
    return body != bodies.end() && body->element == element ? &*body : nullptr;
}

PlatedSpan Document::platedSpanOf(ElementId hole) const {
    const auto left = std::ranges::lower_bound(platedSpans, hole, {}, &PlatedSpan::hole);
    if (left != platedSpans.end() && left->hole == hole) {
        return *left;
    }
    const Layer& drill = layer(elements.layer[hole.row()]);
    return {hole, drill.spanTop, drill.spanBottom};
}

LayerId Document::findLayer(std::string_view name) const {
    auto found = std::ranges::find(layers, name, &Layer::name);
    if (found == layers.end()) {
        found = std::ranges::find_if(layers, [&](const Layer& l) { return base::equalsIgnoringCase(l.name, name); });
    }
    return found == layers.end() ? LayerId{} : LayerId{static_cast<std::size_t>(found - layers.begin())};
}

NetId Document::findNet(std::string_view name) const {
    const auto found = std::ranges::find(nets, name, &Net::name);
    return found == nets.end() ? NetId{} : NetId{static_cast<std::size_t>(found - nets.begin())};
}

std::span<const ElementId> Document::elementsOf(NetId net) const {
    return std::span(netElements).subspan(netStart[net.row()], netStart[net.row() + 1] - netStart[net.row()]);
}

const AttributeValues& Document::attributesOf(ElementId element) const {
    static const AttributeValues kNothing;
    const AttributeSetId set = elements.attributes[element.row()];
    return set.isValid() ? attributeSets[set.row()] : kNothing;
}

Box Document::boxOf(ElementId element) const {
    const std::uint32_t row = elements.geometry[element.row()];
    switch (elements.kind[element.row()]) {
        case ElementKind::Line: {
            Box box;
            box.include(lines[row].a);
            box.include(lines[row].b);
            return box.grownBy(lines[row].width / 2);
        }
        case ElementKind::Arc: return boxOfEdge(arcs[row].node, arcs[row].end).grownBy(arcs[row].width / 2);
        case ElementKind::Circle: {
            Box box;
            box.include(circles[row].centre);
            return box.grownBy(circles[row].diameter / 2);
        }
        case ElementKind::Trail: return boxOfTrail(*this, trails[row]);
        case ElementKind::Area: return boxOfArea(*this, areas[row]);
    }
    return {};
}

namespace {

template <class Counts>
Counts sumOfJobLayers(const std::vector<Layer>& layers, Counts Layer::*counts) {
    Counts total{};
    for (const Layer& l : layers) {
        for (std::size_t kind = 0; kind < total.size() && !l.isSynthetic; ++kind) {
            total[kind] += (l.*counts)[kind];
        }
    }
    return total;
}

}  // namespace

std::array<std::uint32_t, kElementKindCount> Document::elementCounts() const {
    return sumOfJobLayers(layers, &Layer::counts);
}

std::array<std::uint64_t, kElementKindCount> Document::elementCountsWithCopies() const {
    return sumOfJobLayers(layers, &Layer::countsWithCopies);
}

const char* toString(ElementKind kind) {
    constexpr const char* kNames[] = {"line", "arc", "circle", "trail", "area"};
    return kNames[static_cast<std::size_t>(kind)];
}

const char* toString(LayerType type) {
    constexpr const char* kNames[] = {
        "SIGNAL",      "POWER_GROUND", "MIXED", "DIELECTRIC",     "SOLDER_MASK", "SOLDER_PASTE",
        "SILK_SCREEN", "DRILL",        "ROUT",  "COMPONENT",      "MASK",        "CONDUCTIVE_PASTE",
        "DOCUMENT",    "PROFILE",      "BODY",  "COMPONENT_BODY", "OTHER"};
    return kNames[static_cast<std::size_t>(type)];
}

const char* toString(LayerSide side) {
    constexpr const char* kNames[] = {"none", "top", "inner", "bottom", "through"};
    return kNames[static_cast<std::size_t>(side)];
}

const char* toString(LayerUse use) {
    constexpr const char* kNames[] = {"plain",    "flex",      "coverlay",      "stiffener",
                                      "adhesive", "backdrill", "dual_diameter", "other"};
    return kNames[static_cast<std::size_t>(use)];
}

const char* toString(HoleKind kind) {
    constexpr const char* kNames[] = {"via", "component", "plated", "non_plated"};
    return kNames[static_cast<std::size_t>(kind)];
}

const char* toString(MountType mount) {
    constexpr const char* kNames[] = {"unknown", "other", "smt", "through_hole", "press_fit"};
    return kNames[static_cast<std::size_t>(mount)];
}

const char* toString(Source source) {
    constexpr const char* kNames[] = {"job", "derived", "assumed", "session"};
    return kNames[static_cast<std::size_t>(source)];
}

}  // namespace model
