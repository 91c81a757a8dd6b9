#pragma once

#include <string>
#include <vector>

#include "model/base/length_writer.h"
#include "model/board/document.h"
#include "model/board/holes.h"
#include "model/board/stackup_table.h"

/// The stackup of a board as a drawing from the side: where every layer and every kind of hole begins and ends, and
/// where there is room to write beside it. Zones stand side by side, each with the layers that it has at the heights of
/// the stackup. Whoever draws chooses the unit; y goes down from 0, x from 0 to 1 over the width of the layers.
namespace model {

struct StackupLayout {
    double height = 0.0;         ///< of all layers together; grows where the labels need more
    double lineHeight = 0.0;     ///< of a label
    bool isExaggerated = false;  ///< copper is drawn as thick as the substrate, all together; else all is to scale
};

/// A row of the stackup.
struct StackupBand {
    double top = 0.0;
    double bottom = 0.0;
    double label = 0.0;  ///< middle of its label; labels do not overlap
};

/// A part of the board, side by side with the others.
struct StackupColumn {
    Substack part;
    double left = 0.0;
    double right = 1.0;
};

/// The holes of one layer that are plated, or those that are not.
struct StackupBarrel {
    LayerId layer;
    HoleSpan span = HoleSpan::Through;
    bool isPlated = false;
    double top = 0.0;
    double bottom = 0.0;
    double x = 0.5;        ///< middle; with zones they are beside them: a span is no statement about a zone
    double breadth = 0.0;  ///< room for it
    std::uint32_t count = 0;
    Nm least = 0;  ///< diameters; 0 if only areas are routed
    Nm most = 0;
};

struct StackupDrawing {
    std::vector<StackupBand> bands;      ///< rows as in Stackup::rows
    std::vector<StackupColumn> columns;  ///< at least one where there are rows
    std::vector<StackupBarrel> bores;
    double height = 0.0;
    double copperTimes = 1.0;  ///< by how much copper is drawn thicker than everything else
};

/// Empty for boards that have no stackup rows. Holes whose ends are no rows of the stackup are left out.
[[nodiscard]] StackupDrawing drawStackup(const Document& document, const StackupLayout& layout);

/// Moves the labels of bands, which are listed from the top, apart as little as needed to keep each within `height`.
void spreadLabels(double lineHeight, StackupDrawing& drawing);

/// "DRILL: through, plated, 1204 holes of 0.2 to 3.2 mm", or as `write` says diameters.
[[nodiscard]] std::string boreText(const Document& document, const StackupBarrel& bore, const LengthWriter& write = {});

}  // namespace model
