#pragma once

#include <string>
#include <unordered_map>
#include <unordered_set>
#include <vector>

#include "model/formats/kicad/canvas.h"
#include "model/formats/kicad/graphics.h"
#include "model/formats/kicad/shapes/chains.h"
#include "model/formats/kicad/text/tree.h"
#include "model/formats/kicad/unused_pads.h"

namespace model::kicad {

/// The edges of a graphic, for chains.
void addEdges(const Graphic& graphic, std::vector<ChainEdge>& edges);

/// Draws footprints, with a component and its package for each. The value of a footprint is its part, and an attribute
/// called "Value" as in ODB++ that KiCad writes. What they draw on Edge.Cuts is part of the board's
/// outline and goes to `outline`. The body of a package is the largest outline that its fabrication layer draws
/// (shapes/largest_outline.h), else its courtyard's.
///
/// Packages are as seen from the top, so what lies on the back is flipped over its horizontal axis; the part is then
/// mirrored, and turned clockwise as seen from below by 180° more than the file's angle. The first one is reported.
class Footprints {
public:
    /// All must live as long as this.
    Footprints(Canvas& canvas, UnusedPads& unused, std::vector<ChainEdge>& outline)
        : m_canvas(canvas), m_unused(unused), m_outline(outline) {}

    /// (footprint …), before KiCad 6 (module …).
    void draw(const Item& footprint);

private:
    void reportFlipped();
    void reportSharedName();

    Canvas& m_canvas;
    UnusedPads& m_unused;
    std::vector<ChainEdge>& m_outline;
    std::unordered_map<std::string, std::int32_t> m_packages;  ///< by all that they hold
    std::unordered_set<std::string> m_designators;             ///< of footprints with pads
    bool m_hasFlipped = false;                                 ///< has one on the back been reported?
};

}  // namespace model::kicad
