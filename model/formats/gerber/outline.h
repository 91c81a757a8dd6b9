#pragma once

#include <span>
#include <string>
#include <vector>

#include "model/formats/gerber/image/image.h"

namespace model::gerber {

struct Outline {
    ShapeSketch shape;              ///< islands and cut-outs; empty if nothing closes
    Box box;                        ///< around it
    std::size_t openTracks = 0;     ///< tracks that are part of no closed loop
    bool isDrawing = false;         ///< loops inside were taken for a drawing, not for cut-outs
    Nm widestJoint = 0;             ///< between ends that were taken as one
    std::vector<std::string> gaps;  ///< what was closed that the file leaves open, by loop (formats::gapsText)
};

/// The board's outline from the middle lines of what a file draws, chained end to end in whatever order and direction
/// they come, and from its regions. Loops within loops are cut-outs, loops within those islands again. `copper` are
/// places of copper: a frame around a loop that holds all of them is no outline, and neither are islands without any.
///
/// `isBridged`: where no loop holds most of the copper, lines that would if their gaps were closed are one
/// (formats::bridgedLoops).
[[nodiscard]] Outline outlineOf(const Image& image, std::span<const Point> copper, bool isBridged = false);

}  // namespace model::gerber
