#pragma once

#include <array>
#include <memory>

#include "model/formats/drawing/assembly.h"

/// What tests of drawn jobs make them from, by hand.
namespace drawn_testing {

using namespace model::formats;
using model::LayerType;
using model::Nm;
using model::Point;

inline constexpr Nm kMm = 1'000'000;

[[nodiscard]] inline Point mm(int x, int y) {
    return {x * kMm, y * kMm};
}

[[nodiscard]] inline model::ShapeSketch box(Point min, Point max) {
    model::ShapeSketch sketch;
    sketch.addPolygon(std::array<Point, 4>{{min, {max.x, min.y}, max, {min.x, max.y}}}, false);
    return sketch;
}

inline std::int32_t addLayer(DrawnJob& job, const char* name, LayerType type) {
    DrawnLayer layer;
    layer.name = name;
    layer.file = "job.txt";
    layer.type = type;
    job.layers.push_back(layer);
    return static_cast<std::int32_t>(job.layers.size() - 1);
}

inline std::int32_t addRound(DrawnStep& step, Nm diameter) {
    DrawnSymbol symbol;
    symbol.name = "r" + std::to_string(diameter / 1000);
    symbol.shape.kind = PadShape::Kind::Round;
    symbol.shape.width = symbol.shape.height = diameter;
    step.symbols.push_back(symbol);
    return static_cast<std::int32_t>(step.symbols.size() - 1);
}

inline std::int32_t addRegion(DrawnStep& step, const model::ShapeSketch& sketch) {
    step.regions.push_back(sketch);
    return static_cast<std::int32_t>(step.regions.size() - 1);
}

[[nodiscard]] inline DrawnFeature pad(std::int32_t symbol, Point at, std::int32_t net = kNoRow) {
    DrawnFeature feature;
    feature.kind = DrawnKind::Pad;
    feature.symbol = symbol;
    feature.a = at;
    feature.net = net;
    return feature;
}

[[nodiscard]] inline DrawnFeature line(std::int32_t symbol, Point a, Point b, std::int32_t net = kNoRow) {
    DrawnFeature feature = pad(symbol, a, net);
    feature.kind = DrawnKind::Line;
    feature.b = b;
    return feature;
}

[[nodiscard]] inline DrawnFeature region(std::int32_t row, std::int32_t net = kNoRow) {
    DrawnFeature feature;
    feature.kind = DrawnKind::Region;
    feature.region = row;
    feature.net = net;
    return feature;
}

/// Draws a feature on a layer, on the line after the last one.
inline DrawnFeature& draw(DrawnStep& step, std::int32_t layer, DrawnFeature feature) {
    const auto row = static_cast<std::size_t>(layer);
    step.features.resize(std::max(step.features.size(), row + 1));
    feature.line = static_cast<std::uint32_t>(100 * row + step.features[row].size() + 1);
    return step.features[row].emplace_back(feature);
}

/// Layers TOP, BOTTOM and DRILL (rows 0 to 2) and one step of 100 × 50 mm with the nets GND and SIG.
[[nodiscard]] inline DrawnJob boardOfTwoLayers() {
    DrawnJob job;
    addLayer(job, "TOP", LayerType::Signal);
    addLayer(job, "BOTTOM", LayerType::Signal);
    addLayer(job, "DRILL", LayerType::Drill);
    DrawnStep& step = job.steps.emplace_back();
    step.name = "board";
    step.nets = {{"GND", {}}, {"SIG", {{"class", "fast"}}}};
    step.profile = box(mm(0, 0), mm(100, 50));
    step.componentsFile = "parts.txt";
    step.copiesFile = "panel.txt";
    return job;
}

[[nodiscard]] inline std::shared_ptr<const model::Document> assembled(DrawnJob job) {
    base::Progress progress;
    return *assemble(std::move(job), 0.0, progress);
}

[[nodiscard]] inline const model::Diagnostic* findMessage(const model::Document& document, std::string_view text) {
    for (const model::Diagnostic& entry : document.diagnostics.entries()) {
        if (entry.text.find(text) != std::string::npos) {
            return &entry;
        }
    }
    return nullptr;
}

/// An element of a layer by its row there.
[[nodiscard]] inline model::ElementId elementOf(const model::Document& document, std::string_view layer,
                                                std::size_t row) {
    return model::ElementId{document.layer(document.findLayer(layer)).elements.first + row};
}

}  // namespace drawn_testing
