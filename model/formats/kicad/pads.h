#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "model/formats/kicad/canvas.h"
#include "model/formats/kicad/text/tree.h"

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

/// Pads and vias of a board with their holes and their openings in mask and paste, which KiCad does not store but
/// computes: the shape grown by the margin of the pad, else the footprint's, else the board's, on the mask and paste
/// layers that the pad lists. The hole is where the pad is; its copper is moved by the offset of the drill. Holes
/// without plating have no copper where it would be no larger than they are.
///
/// Copper on inner layers that a pad or via keeps only where something ends there (remove_unused_layers) waits for
/// finish().
class Pads {
public:
    explicit Pads(Canvas& canvas) : m_canvas(canvas) {}

    void drawPad(const Item& pad, const PadOwner& owner);
    void drawVia(const Item& via);
    /// When all tracks are drawn.
    void finish();

private:
    struct Waiting {
        std::int32_t row = 0;
        Origin origin;
        std::int32_t symbol = 0;
        PointD at;
        double clockwiseDeg = 0.0;
        double reach = 0.0;
    };

    void drawWaiting(std::vector<Waiting> pads, std::int32_t row);

    Canvas& m_canvas;
    std::vector<Waiting> m_waiting;
};

}  // namespace model::kicad
