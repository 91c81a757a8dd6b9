#pragma once

#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "model/export/stackup_sheet.h"
#include "model/measure/section_dimension.h"
#include "model/section/net_line.h"
#include "model/section/section.h"

/// A section as one sheet of polygons, lines and texts, true to scale: millimetres of paper, y down. Everything that
/// writes it (SVG here, PDF in the window) writes the same.
namespace model {

struct SheetDimension {
    SectionDimension dimension;
    std::string text;  ///< what is written beside it
    bool isStale = false;
};

struct SectionPicture {
    std::vector<std::uint32_t> colours;  ///< of the layers of the board, 0xRRGGBB
    double heightTimes = 0.0;            ///< heights are drawn so many times larger than lengths; 0: as reads well
    double scale = 0.0;                  ///< so many mm of paper for a mm of the line; 0: as fits on a sheet
    std::vector<SheetDimension> dimensions{};
    std::vector<LayerRun> runs{};  ///< of an unrolled net
    std::string net{};             ///< its name
};

/// Contours that all wind the same way: what lies within any of them is filled, as one, so that nothing shines through
/// between neighbours.
struct SheetPolygon {
    std::vector<std::vector<std::pair<double, double>>> contours;
    std::uint32_t fill = 0;  ///< 0xRRGGBB
};

struct SheetLine {
    double x0 = 0.0;
    double y0 = 0.0;
    double x1 = 0.0;
    double y1 = 0.0;
    bool isDashed = false;
    bool hasArrows = false;  ///< at both ends
};

struct SectionSheet {
    double width = 0.0;
    double height = 0.0;
    double fontSize = 3.0;
    double scale = 1.0;  ///< as drawn
    double heightTimes = 1.0;
    std::vector<SheetPolygon> polygons;  ///< later ones lie on earlier ones
    std::vector<SheetLine> lines;
    std::vector<SheetText> texts;
};

/// Scales are those of drawings: 1, 2 or 5 times a power of ten. The sheet says which, and how much larger heights are.
/// Parts are drawn as far as the board's thickness above and below it; beyond they end in a break line. Names of the
/// stackup's rows point to where they end.
[[nodiscard]] SectionSheet sectionSheet(const Document& board, const Section& section, const SectionPicture& how);

}  // namespace model
