#include "model/formats/odb/profile.h"

#include <array>
#include <numeric>

#include "model/formats/common/region.h"

namespace model::odb {

namespace {

Box boxOf(const ShapeSketch& sketch) {
    Box box;
    for (std::size_t i = 0; i < sketch.contourCount(); ++i) {
        box.include(boxOfPath(sketch.contour(i), true));
    }
    return box;
}

bool isBoardCopper(const Layer& layer) {
    return layer.isCopper() && layer.context == LayerContext::Board;
}

std::uint64_t copperElements(const Document& step) {
    std::uint64_t count = 0;
    for (const Layer& layer : step.layers) {
        if (isBoardCopper(layer)) {
            count = std::accumulate(layer.countsWithCopies.begin(), layer.countsWithCopies.end(), count);
        }
    }
    return count;
}

/// Calls `visit(box, count)` for every element on a copper layer, and for every copy of a step with all its copper.
template <class Visit>
void forEachCopper(const Document& document, Visit visit) {
    for (const Layer& layer : document.layers) {
        for (std::uint32_t i = 0; i < layer.elements.count && isBoardCopper(layer); ++i) {
            visit(document.boxOf(ElementId{layer.elements.first + i}), 1);
        }
    }
    for (const StepInstance& instance : document.instances) {
        const Document& step = *document.steps[instance.step];
        visit(instance.placement.boxOf(step.board), copperElements(step));
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
    std::uint64_t inside = 0;
    std::uint64_t all = 0;
    forEachCopper(soFar, [&](const Box& element, std::uint64_t count) {
        all += count;
        inside += contains(box, element) ? count : 0;
    });
    return 2 * inside >= all;
}

std::optional<ShapeSketch> profileFromCopper(const Document& soFar) {
    Box box;
    forEachCopper(soFar, [&](const Box& element, std::uint64_t) { box.include(element); });
    if (box.isEmpty() || box.width() == 0 || box.height() == 0) {
        return std::nullopt;
    }
    ShapeSketch sketch;
    sketch.addPolygon(std::array<Point, 4>{{box.min, {box.max.x, box.min.y}, box.max, {box.min.x, box.max.y}}}, false);
    return sketch;
}

}  // namespace model::odb
