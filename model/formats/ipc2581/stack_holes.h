#pragma once

#include <span>
#include <string_view>
#include <vector>

#include "model/formats/drawing/drawn_job.h"
#include "model/formats/ipc2581/layer_list.h"
#include "model/formats/ipc2581/reading.h"
#include "model/formats/ipc2581/shapes/turn.h"

namespace model::ipc2581 {

/// A LayerHole of a PadStack.
struct StackHole {
    XmlCursor start;  ///< at its start tag
    Turn turn;        ///< where it lies on the board
    std::int32_t net = formats::kNoRow;
    std::string_view from;  ///< its Span, as written; empty: not said
    std::string_view to;
};

/// Some writers (Altium) draw the holes of PadStacks once more on a layer of holes, without net and span: these are one
/// hole each. What a layer draws gets the net of its PadStack, and a layer without a span that of its holes, if it is
/// one. Returns which holes no layer draws, rising. To be called when all layers of the step are read.
[[nodiscard]] std::vector<std::size_t> joinDrawnHoles(Reading& reading, std::span<const StackHole> holes,
                                                      formats::DrawnStep& step, LayerList& layers);

}  // namespace model::ipc2581
