#include "render/modelling/board_frame.h"

#include <algorithm>

#include "model/board/board_heights.h"
#include "shaders/shared/board.h"

namespace render {

namespace {

std::uint32_t growthOf(const model::Layer& layer) {
    const bool isEven = layer.type != model::LayerType::ComponentBody;
    return isEven ? 0 : layer.side == model::LayerSide::Bottom ? shader::kLayerGrowsDown : shader::kLayerGrowsUp;
}

void setHeights(const model::Document& document, BoardFrame& out) {
    const model::ZRange faces = model::boardHeights(document);
    auto low = static_cast<float>(base::toMm(faces.bottom));
    auto high = static_cast<float>(base::toMm(faces.top));
    out.facesMm = {low, high};
    for (const model::Layer& layer : document.layers) {
        out.layers.push_back({static_cast<float>(base::toMm(layer.z)),
                              static_cast<float>(base::toMm(double(layer.z) + layer.thickness)),
                              layer.counts[static_cast<std::size_t>(model::ElementKind::Area)] > 0, layer.isCopper(),
                              growthOf(layer), layer.opposite});
        if (layer.isCopper() || layer.type == model::LayerType::Body) {
            low = std::min(low, out.layers.back().z0);
            high = std::max(high, out.layers.back().z1);
        }
    }
    const model::Box& box = document.board.isEmpty() ? document.extent : document.board;
    if (!box.isEmpty()) {
        out.boxMin = {toGpu(base::toDouble(box.min), out.origin), low};
        out.boxMax = {toGpu(base::toDouble(box.max), out.origin), high};
    }
}

}  // namespace

ModelTimes& ModelTimes::operator+=(const ModelTimes& other) {
    createMs += other.createMs;
    discretiseMs += other.discretiseMs;
    triangulateMs += other.triangulateMs;
    return *this;
}

model::Point centreOf(const model::Box& box) {
    if (box.isEmpty()) {
        return {};
    }
    return {static_cast<model::Nm>(box.min.x + box.width() / 2), static_cast<model::Nm>(box.min.y + box.height() / 2)};
}

BoardFrame frameOf(const model::Document& document) {
    BoardFrame frame;
    frame.origin = centreOf(document.board.isEmpty() ? document.extent : document.board);
    setHeights(document, frame);
    return frame;
}

std::vector<ModelCopy> placeCopies(const model::StepTree& tree) {
    std::vector<model::Point> origins;
    for (const model::Document* step : tree.steps) {
        origins.push_back(frameOf(*step).origin);
    }
    std::vector<ModelCopy> copies;
    for (const model::StepCopy& copy : tree.copies) {
        const model::PointD origin = copy.placement.apply(base::toDouble(origins[copy.step]));
        const model::Placement rotation{{}, copy.placement.clockwiseDeg, copy.placement.isMirrored};
        const model::PointD x = rotation.apply(model::PointD{1.0, 0.0});
        const model::PointD y = rotation.apply(model::PointD{0.0, 1.0});
        copies.push_back({copy.step,
                          {base::toMm(origin.x - origins[0].x), base::toMm(origin.y - origins[0].y)},
                          {{x.x, x.y}, {y.x, y.y}},
                          copy.placement.isMirrored,
                          copy.isFlipped});
    }
    return copies;
}

}  // namespace render
