#pragma once

#include <string>

#include "app/common/open_board.h"

namespace app {

struct MeasureArguments {
    BoardArguments board;
    std::string from;  ///< see app/commands/item_spec.h
    std::string to;
    std::string path;             ///< a net: the way along its copper instead of the distance
    std::string below;            ///< with a unit; exit code 4 if the distance is less
    std::string format = "text";  ///< text, json or csv
};

/// `copperscope measure BOARD --from THING --to THING`: how far they are apart, on stdout. Answers an exit code.
///
/// JSON: {"from", "to", "on_layer", "through_stack", "in_plane", "angle_deg", "remarks": []}; the three ways are null
/// or
/// {"distance_nm", "gap_nm", "dx_nm", "dy_nm", "dz_nm", "relation", "overlap_nm", "is_overlap_exact", "ends": [{"copy",
/// "element", "layer", "net", "x_nm", "y_nm"}, …]}. With `--path`: {"net", "length_nm", "area_length_nm", "hole_count",
/// "hole_height_nm", "layers": [{"layer", "length_nm"}], "legs": [{"kind", "layer", "element", "length_nm", "from_nm",
/// "to_nm"}], "remarks"}.
int runMeasure(const MeasureArguments& arguments);

}  // namespace app
