#pragma once

#include <optional>
#include <span>
#include <string>

#include "model/formats/gerber/board_groups.h"

namespace model::gerber {

/// The outline of a board and the file that draws it.
struct BoardOutline {
    ShapeSketch shape;  ///< islands and cut-outs
    std::string path;
};

/// Where the copper lies that an outline has to enclose.
struct CopperPlaces {
    std::span<const Point> pads;  ///< the middles of flashes
    Box box;                      ///< around everything that the copper layers draw
};

/// Finds the board's outline: the file of that role; else a drawing whose loops enclose the copper closely, as
/// Allegro's fabrication films do; else the loop that films of different kinds draw alike, as OrCAD's do, or that
/// silkscreen draws. What was assumed, and what is wrong with the outline, is reported. Nothing if no file draws one:
/// pours of copper alone (PADS) are none.
[[nodiscard]] std::optional<BoardOutline> findOutline(std::span<const ReadFile> files, const BoardFiles& board,
                                                      const CopperPlaces& copper, Diagnostics& diagnostics);

}  // namespace model::gerber
