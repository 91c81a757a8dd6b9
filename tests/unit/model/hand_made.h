#pragma once

#include <array>
#include <memory>
#include <span>

#include "model/board/document_builder.h"
#include "model/index/board_index.h"

/// What tests make small boards from, by hand.
namespace hand_made {

inline constexpr model::Nm kUm = 1'000;
inline constexpr model::Nm kMm = 1'000'000;

[[nodiscard]] inline model::DocumentBuilder::Origin of(model::NetId net, int flags = 0) {
    model::DocumentBuilder::Origin origin;
    origin.net = net;
    origin.flags = static_cast<std::uint8_t>(flags);
    return origin;
}
/// Of no net.
[[nodiscard]] inline model::DocumentBuilder::Origin flagged(int flags) {
    return of({}, flags);
}

[[nodiscard]] inline model::ShapeSketch rectangle(model::Point min, model::Point max) {
    model::ShapeSketch sketch;
    sketch.addPolygon(std::array<model::Point, 4>{{min, {max.x, min.y}, max, {min.x, max.y}}}, false);
    return sketch;
}

inline model::LayerId addLayer(model::DocumentBuilder& builder, const char* name,
                               model::LayerType type = model::LayerType::Signal) {
    model::Layer layer;
    layer.name = name;
    layer.type = type;
    return builder.addLayer(layer);
}

inline model::LayerId addLayer(model::DocumentBuilder& builder, model::LayerType type, model::LayerSide side,
                               model::Nm z, model::Nm thickness) {
    model::Layer layer;
    layer.type = type;
    layer.side = side;
    layer.z = z;
    layer.thickness = thickness;
    return builder.addLayer(layer);
}

inline model::LayerId addDrill(model::DocumentBuilder& builder, model::LayerId top, model::LayerId bottom) {
    model::Layer layer;
    layer.name = "drill";
    layer.type = model::LayerType::Drill;
    layer.spanTop = top;
    layer.spanBottom = bottom;
    return builder.addLayer(layer);
}

/// A layer of a stack whose heights are given; drills go from the layer 0 to the layer 2.
struct StackLayer {
    const char* name;
    model::LayerType type;
    model::Nm z, thickness;
    std::size_t opposite;
};
inline void addLayers(model::DocumentBuilder& builder, std::span<const StackLayer> rows) {
    for (const StackLayer& row : rows) {
        model::Layer layer;
        layer.name = row.name;
        layer.type = row.type;
        layer.z = row.z;
        layer.thickness = row.thickness;
        layer.thicknessSource = model::Source::Job;
        layer.opposite = model::LayerId{row.opposite};
        if (layer.type == model::LayerType::Drill) {
            layer.spanTop = model::LayerId{0};
            layer.spanBottom = model::LayerId{2};
        }
        builder.addLayer(layer);
    }
}

[[nodiscard]] inline std::shared_ptr<const model::BoardIndex> indexed(std::shared_ptr<const model::Document> board) {
    base::Progress progress;
    return *model::indexBoard(std::move(board), progress);
}

}  // namespace hand_made
