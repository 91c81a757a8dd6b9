#pragma once

#include "model/board/document_builder.h"
#include "model/index/board_index.h"

/// Small boards for what measures them.
namespace measuring {

inline constexpr model::Nm kMm = 1'000'000;

/// Layers of the stack below: copper of 0.1 mm, 1 mm apart, drilled through; and a drawing.
enum BoardLayer : std::size_t { Top, Inner, Bottom, Drill, Drawing };

/// Adds those layers; the laminate between top and inner is of an assumed thickness.
inline void addLayers(model::DocumentBuilder& builder) {
    using namespace model;
    struct Row {
        const char* name;
        LayerType type;
        Nm z, thickness;
        std::size_t opposite;
    };
    for (const Row& row :
         {Row{"top", LayerType::Signal, 2'200'000, 100'000, Bottom},
          Row{"inner", LayerType::Signal, 1'100'000, 100'000, Inner}, Row{"bottom", LayerType::Signal, 0, 100'000, Top},
          Row{"drill", LayerType::Drill, 0, 2'300'000, Drill},
          Row{"drawing", LayerType::Document, 5'000'000, 0, Drawing}}) {
        Layer layer;
        layer.name = row.name;
        layer.type = row.type;
        layer.z = row.z;
        layer.thickness = row.thickness;
        layer.thicknessSource = Source::Job;
        layer.opposite = LayerId{row.opposite};
        if (layer.type == LayerType::Drill) {
            layer.spanTop = LayerId{Top};
            layer.spanBottom = LayerId{Bottom};
        }
        builder.addLayer(layer);
    }
    Stackup stack;
    stack.rows.push_back({"top", LayerId{Top}, LayerType::Signal, 2'200'000, 100'000, Source::Job, {}});
    stack.rows.push_back({"below top", {}, LayerType::Dielectric, 1'200'000, 1'000'000, Source::Assumed, {}});
    stack.rows.push_back({"inner", LayerId{Inner}, LayerType::Signal, 1'100'000, 100'000, Source::Job, {}});
    stack.rows.push_back({"below inner", {}, LayerType::Dielectric, 100'000, 1'000'000, Source::Job, {}});
    stack.rows.push_back({"bottom", LayerId{Bottom}, LayerType::Signal, 0, 100'000, Source::Job, {}});
    builder.setStackup(std::move(stack));
    builder.setBoardThickness(2'300'000);
}

inline model::DocumentBuilder::Origin of(model::NetId net, int flags = 0) {
    model::DocumentBuilder::Origin origin;
    origin.net = net;
    origin.flags = static_cast<std::uint8_t>(flags);
    return origin;
}

inline model::ShapeSketch rectangle(model::Point min, model::Point max) {
    model::ShapeSketch sketch;
    sketch.addPolygon(std::array<model::Point, 4>{{min, {max.x, min.y}, max, {min.x, max.y}}}, false);
    return sketch;
}

inline std::shared_ptr<const model::BoardIndex> indexed(std::shared_ptr<const model::Document> board) {
    base::Progress progress;
    return *model::indexBoard(std::move(board), progress);
}

}  // namespace measuring
