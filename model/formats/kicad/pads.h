#pragma once

#include <cstdint>
#include <optional>

#include "model/formats/kicad/canvas.h"
#include "model/formats/kicad/text/tree.h"
#include "model/formats/kicad/unused_pads.h"

namespace model::kicad {

/// What a footprint says for all of its pads.
struct PadOwner {
    Frame frame;
    bool isOnBack = false;
    std::int32_t component = formats::kNoRow;
    std::optional<double> maskMargin;
    std::optional<double> pasteMargin;
    std::optional<double> pasteRatio;
};

/// (pad …) with its hole and back-drills, its pin, and its openings in mask and paste, which KiCad does not store but
/// computes: the shape grown by the margin of the pad, else the footprint's, else the board's, on the mask and paste
/// layers that the pad lists. The hole is where the pad is; its copper is moved by the offset of the drill. Holes
/// without plating have no copper where it would be no larger than they are.
void drawPad(Canvas& canvas, UnusedPads& waiting, const Item& pad, const PadOwner& owner);

}  // namespace model::kicad
