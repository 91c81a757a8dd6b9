#pragma once

#include <string>

#include "app/common/exit_code.h"
#include "app/common/open_board.h"

namespace app {

struct MeasureArguments {
    BoardArguments board;
    std::string from;  ///< see app/commands/measure_item_text.h
    std::string to;
    std::string path;               ///< a net: the path along its copper instead of the distance
    std::string below;              ///< with a unit; exit code 4 if the distance is less
    bool allowsIncomplete = false;  ///< `below` also decides where not all of the job could be read
    std::string format = "text";    ///< text, json or csv
};

/// `copperscope measure BOARD --from ITEM --to ITEM`: how far they are apart, on stdout.
///
/// JSON: {"from", "to", "on_layer", "through_stackup", "in_plane", "angle_deg", "notes": []}; the three distances are
/// null or {"distance_nm", "spacing_nm", "dx_nm", "dy_nm", "dz_nm", "relation", "overlap_nm", "is_overlap_exact",
/// "ends": [{"copy", "element", "layer", "net", "x_nm", "y_nm"}, …]}. With `--path`: {"net", "length_nm",
/// "area_length_nm", "pad_length_nm", "hole_count", "hole_height_nm", "layers": [{"layer", "length_nm"}], "legs":
/// [{"kind", "layer", "element", "length_nm", "from_nm", "to_nm"}], "notes"}. Under their old names too:
/// "through_stack", "gap_nm", "remarks".
[[nodiscard]] Outcome runMeasure(const MeasureArguments& arguments);

}  // namespace app
