#pragma once

#include <string>
#include <vector>

#include "app/common/exit_code.h"
#include "app/common/open_board.h"

namespace app {

struct SectionArguments {
    BoardArguments board;
    std::vector<double> line;         ///< x0, y0, x1, y1, … in millimetres of the board
    std::vector<std::string> layers;  ///< only these; empty: all that are made of something
    bool isAsDesigned = false;        ///< with what is milled away beyond the board outline
    std::string format = "svg";       ///< svg, json or csv
    double scale = 0.0;               ///< SVG: mm of paper for a mm of the line; 0: as fits
    double heightTimes = 0.0;         ///< SVG: heights so many times larger; 0: as reads well
};

/// `copperscope section BOARD --line x0,y0,x1,y1[,…]`: what a cut along the line shows, on stdout.
///
/// JSON: {"line_mm": [[x, y]], "stations_nm": [], "pieces": [{"layer", "copy", "element", "net", "from_nm", "to_nm",
/// "bottom_nm", "top_nm", "upper_from_nm", "upper_to_nm", "material", "dielectric", "dielectric_thickness_nm"}],
/// "bores": [the same], "notes": []} ("remarks": the old name of the notes); `stations_nm` are the corners' places
/// along the line. `element` is null for films that the job does not draw. `dielectric` is the row of the stackup that
/// a piece is of, with its own thickness; the piece is higher where it fills the space beside copper too. Null: no
/// dielectric.
[[nodiscard]] Outcome runSection(const SectionArguments& arguments);

}  // namespace app
