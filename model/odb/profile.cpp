#include "model/odb/profile.h"

#include <array>

#include "model/odb/region.h"

namespace model::odb {

namespace {

Box boxOf(const ShapeSketch& sketch) {
    Box box;
    for (std::size_t i = 0; i < sketch.contourCount(); ++i) {
        box.include(boxOfPath(sketch.contour(i), true));
    }
    return box;
}

/// Calls `visit(box)` for every element on a copper layer.
template <class Visit>
void forEachCopper(const Document& document, Visit visit) {
    for (const Layer& layer : document.layers) {
        if (!layer.isCopper() || layer.context != LayerContext::Board) {
            continue;
        }
        for (std::uint32_t i = 0; i < layer.elements.count; ++i) {
            visit(document.boxOf(ElementId{layer.elements.first + i}));
        }
    }
}

bool contains(const Box& box, const Box& other) {
    const std::int64_t x = (std::int64_t{other.min.x} + other.max.x) / 2;
    const std::int64_t y = (std::int64_t{other.min.y} + other.max.y) / 2;
    return x >= box.min.x && x <= box.max.x && y >= box.min.y && y <= box.max.y;
}

}  // namespace

std::optional<ShapeSketch> profileOf(const FeatureFile& file) {
    ShapeSketch all;
    for (const Feature& feature : file.features) {
        if (feature.kind != FeatureKind::Surface) {
            continue;
        }
        for (const Contour& contour : file.surfaces.contoursOf(ShapeId{std::size_t{feature.index}})) {
            all.beginContour(contour.isHole);
            for (const PathNode& node : file.surfaces.nodesOf(contour)) {
                all.addNode(node);
            }
        }
    }
    return all.isEmpty() ? std::nullopt : std::optional(std::move(all));
}

bool fitsCopper(const ShapeSketch& profile, const Document& soFar) {
    const Box box = boxOf(profile).grownBy(1'000'000);
    std::size_t inside = 0;
    std::size_t all = 0;
    forEachCopper(soFar, [&](const Box& element) {
        ++all;
        inside += contains(box, element) ? 1 : 0;
    });
    return 2 * inside >= all;
}

std::optional<ShapeSketch> profileFromCopper(const Document& soFar) {
    Box box;
    forEachCopper(soFar, [&](const Box& element) { box.include(element); });
    if (box.isEmpty() || box.width() == 0 || box.height() == 0) {
        return std::nullopt;
    }
    ShapeSketch sketch;
    sketch.addPolygon(std::array<Point, 4>{{box.min, {box.max.x, box.min.y}, box.max, {box.min.x, box.max.y}}}, false);
    return sketch;
}

}  // namespace model::odb
