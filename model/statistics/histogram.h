#pragma once

#include <vector>

#include "model/board/document.h"

/// How lengths are spread over the elements of a board: track widths, hole diameters, annular rings.
namespace model {

enum class Measure : std::uint8_t {
    TrackWidth,    ///< of tracks on copper layers of the board that are no pads
    HoleDiameter,  ///< as drilled, round holes
    AnnularRing    ///< of plated round holes: the smallest round pad of the same centre, less the hole, halved
};

struct HistogramBar {
    Nm least = 0;  ///< of its elements
    Nm most = 0;
    Range elements;  ///< of Histogram::elements
};

/// A bar per length while there are few, else bars of one width each. Bars without elements are left out.
struct Histogram {
    std::vector<HistogramBar> bars;   ///< rising
    std::vector<ElementId> elements;  ///< by length, then by row
};

/// Of the document's own elements, not those of copies. `mostBars` at least 1.
[[nodiscard]] Histogram histogramOf(const Document& document, Measure measure, std::size_t mostBars);

}  // namespace model
