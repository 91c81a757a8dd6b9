#pragma once

#include <optional>
#include <span>

#include "model/formats/gerber/job_files.h"
#include "model/formats/gerber/pad_index.h"

namespace model::gerber {

/// What has to be added to the places of a drill file that counts from another origin than the images, as programs can
/// be told to write it: the shift that lays its holes, which lie beside the copper, on pads. Nothing if there are too
/// few holes to tell, or none is needed.
[[nodiscard]] std::optional<Point> originShift(const ReadFile& drills, const PadIndex& pads, const Box& copper);
/// Moves the holes of a file by the shift of another file of its job, and reports it. False if they do not lie beside
/// the copper, or would not lie on it.
bool moveHoles(ReadFile& drills, Point shift, const Box& copper);
/// Reads a drill file again in another format where the one it states, or that was assumed, does not put its holes on
/// the board and another does; what was done is reported. False if most holes lie beside the copper in any format, or
/// if nothing tells the format of a file that does not say its unit: on the board alone, tenths of lengths lie too.
bool fitToCopper(ReadFile& drills, const PadIndex& pads, const Box& copper);
/// Reads a file of which that was false in the format of a file of the same job, if it does not say otherwise and more
/// of it lies on the board then, or as much of a file that does not say its unit; or reports where it lies.
void fitAsSibling(ReadFile& drills, const std::optional<CoordinateFormat>& sibling, const Box& copper);
/// How many holes that may be plated lie in the middle of pads, as a share; nothing if there are too few to tell.
[[nodiscard]] std::optional<double> shareOnPads(const Image& image, const PadIndex& pads);
/// Leaves out of a file what others drill too, if that is nine of ten holes or more: then it lists the same board.
/// Files round places, and the origin they count from. True if nothing is left to drill: then the file is a document.
/// Both are reported.
bool drillOnce(std::span<const Image* const> others, ReadFile& file);

}  // namespace model::gerber
