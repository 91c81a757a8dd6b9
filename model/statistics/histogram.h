#pragma once

#include <vector>

#include "model/board/copies.h"

/// How lengths are spread over the elements of a board: track widths, hole diameters, annular rings.
namespace model {

enum class Measure : std::uint8_t {
    TrackWidth,    ///< of tracks on copper layers of the board that are no pads
    HoleDiameter,  ///< as drilled, round holes
    AnnularRing    ///< of plated round holes: the smallest round pad of the same centre, less the hole, halved
};

/// One element of a step, wherever that is placed.
struct StepElement {
    std::uint32_t step = 0;  ///< row of StepTree::steps
    ElementId element;
    constexpr auto operator<=>(const StepElement&) const = default;
};

struct HistogramBar {
    Nm least = 0;  ///< of its elements
    Nm most = 0;
    Range elements;           ///< of Histogram::elements
    std::uint64_t count = 0;  ///< of those in all copies
};

/// A bar per length while there are few, else bars of one width each. Bars without elements are left out.
struct Histogram {
    std::vector<HistogramBar> bars;     ///< rising
    std::vector<StepElement> elements;  ///< by length, then by step and row
};

/// Of the elements of a board with all copies of steps on it, each as often as it is placed. `mostBars` at least 1.
[[nodiscard]] Histogram histogramOf(const Document& board, Measure measure, std::size_t mostBars);

/// The elements that a bar of this histogram of the board counts, in rising order.
[[nodiscard]] std::vector<BoardElement> elementsOf(const Document& board, const Histogram& histogram,
                                                   const HistogramBar& bar);

}  // namespace model
