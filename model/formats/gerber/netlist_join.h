#pragma once

#include <optional>
#include <string>
#include <vector>

#include "model/formats/drawing/drawn_job.h"
#include "model/formats/gerber/netlist/d356.h"
#include "model/formats/gerber/pad_index.h"

namespace model::gerber {

/// By net of the netlist: its name in full among `nets`, for which the format has 14 characters only: the last or the
/// first ones, perhaps in upper case and without blanks. Names that fit none or several stay as they are.
[[nodiscard]] std::vector<std::string> fullNames(const std::vector<std::string>& names,
                                                 const std::vector<formats::DrawnNet>& nets);

/// What has to be added to the points of a netlist, which may count from another origin than the images; none if the
/// copper does not tell.
[[nodiscard]] std::optional<Point> shiftOf(const D356& netlist, const PadIndex& pads);

/// The points of a netlist as the document takes them, moved by `shift`.
[[nodiscard]] formats::DrawnNetlist drawnNetlist(const D356& netlist, const std::vector<std::string>& names,
                                                 Point shift, std::string file);

}  // namespace model::gerber
