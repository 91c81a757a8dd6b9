#pragma once

#include "tests/unit/model/hand_made.h"

/// Small boards for what measures them.
namespace measuring {

using namespace hand_made;

/// Layers of the stack below: copper of 0.1 mm, 1 mm apart, drilled through; and a drawing.
enum BoardLayer : std::size_t { Top, Inner, Bottom, Drill, Drawing };

/// Adds those layers; the laminate between top and inner is of an assumed thickness.
inline void addLayers(model::DocumentBuilder& builder) {
    using namespace model;
    hand_made::addLayers(builder, std::array{StackLayer{"top", LayerType::Signal, 2'200'000, 100'000, Bottom},
                                             StackLayer{"inner", LayerType::Signal, 1'100'000, 100'000, Inner},
                                             StackLayer{"bottom", LayerType::Signal, 0, 100'000, Top},
                                             StackLayer{"drill", LayerType::Drill, 0, 2'300'000, Drill},
                                             StackLayer{"drawing", LayerType::Document, 5'000'000, 0, Drawing}});
    Stackup stack;
    stack.rows.push_back({"top", LayerId{Top}, LayerType::Signal, 2'200'000, 100'000, Source::Job, {}});
    stack.rows.push_back({"below top", {}, LayerType::Dielectric, 1'200'000, 1'000'000, Source::Assumed, {}});
    stack.rows.push_back({"inner", LayerId{Inner}, LayerType::Signal, 1'100'000, 100'000, Source::Job, {}});
    stack.rows.push_back({"below inner", {}, LayerType::Dielectric, 100'000, 1'000'000, Source::Job, {}});
    stack.rows.push_back({"bottom", LayerId{Bottom}, LayerType::Signal, 0, 100'000, Source::Job, {}});
    builder.setStackup(std::move(stack));
    builder.setBoardThickness(2'300'000);
}

}  // namespace measuring
