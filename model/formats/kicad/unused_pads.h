#pragma once

#include <cstdint>
#include <vector>

#include "model/formats/kicad/canvas.h"

namespace model::kicad {

/// Copper that a pad or via keeps only where something ends there (remove_unused_layers), on inner layers or on all: it
/// waits until all tracks are drawn.
class UnusedPads {
public:
    struct Waiting {
        std::int32_t row = 0;
        Origin origin;
        std::int32_t symbol = 0;
        PointD at;
        double clockwiseDeg = 0.0;
        double reach = 0.0;  ///< how far from `at` a track may end; below 0: it is kept in any case
    };

    explicit UnusedPads(Canvas& canvas) : m_canvas(canvas) {}

    void add(const Waiting& pad) { m_waiting.push_back(pad); }
    /// When all tracks are drawn: draws those that are kept.
    void draw();

private:
    void drawOn(std::int32_t row, const std::vector<Waiting>& pads);

    Canvas& m_canvas;
    std::vector<Waiting> m_waiting;
};

}  // namespace model::kicad
