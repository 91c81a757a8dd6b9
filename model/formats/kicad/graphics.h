#pragma once

#include <optional>
#include <string_view>
#include <vector>

#include "model/formats/kicad/canvas.h"
#include "model/formats/kicad/shapes/dashes.h"
#include "model/formats/kicad/text/tree.h"
#include "model/geometry/loops/edge_loops.h"
#include "model/geometry/shapes.h"

namespace model::kicad {

/// A drawn shape on the board's grid: a path, its pen, and whether its inside is filled. Edges of closed paths return
/// to the first node; the last node of an open one has none.
struct Graphic {
    std::vector<PathNode> nodes;
    bool isClosed = false;
    bool isFilled = false;
    bool isHatched = false;  ///< filled with lines, which are not part of it
    double width = 0.0;
    LineStyle style = LineStyle::Solid;

    [[nodiscard]] std::size_t edgeCount() const {
        return isClosed ? nodes.size() : nodes.size() - std::min<std::size_t>(nodes.size(), 1);
    }
    [[nodiscard]] Point endOf(std::size_t edge) const { return nodes[edge + 1 < nodes.size() ? edge + 1 : 0].point; }
};

/// Is it a line, arc, circle, rectangle, polygon or curve, by the end of its name: "gr_line", "fp_line"?
[[nodiscard]] bool isGraphic(std::string_view head);

/// What such an item draws. Arcs in both of KiCad's ways (three points; centre, start and angle), Bézier curves as
/// chords within 1 µm. None, with a message, where coordinates are missing or out of range.
/// `isPrimitive`: of a custom pad, where an old file fills what has no width.
[[nodiscard]] std::optional<Graphic> graphicOf(Canvas& canvas, const Item& item, const Frame& frame,
                                               bool isPrimitive = false);
/// The points of (pts …), arcs included, as nodes of a closed path.
[[nodiscard]] std::vector<PathNode> pathOf(Canvas& canvas, const Item& pts, const Frame& frame);

/// The arc through three points; a line where they are nearly on one. None if out of range.
[[nodiscard]] std::optional<PathNode> arcThrough(Canvas& canvas, std::uint32_t line, PointD start, PointD middle,
                                                 PointD end);

/// Draws it on all layers of the item. A width of 0 is drawn as KiCad plots it, 0.1 mm, unless it is filled. On a mask
/// that is listed besides copper it is an opening: filled where it is hatched, and wider by the margin of the item,
/// else the board's.
void drawGraphic(Canvas& canvas, const Item& item, const Frame& frame, Origin origin);
void drawGraphic(Canvas& canvas, std::int32_t row, const Graphic& graphic, const Origin& origin);

/// What (stroke … (type …)) of an item says.
[[nodiscard]] LineStyle styleOfLine(const Item& item);
/// Draws an edge in a style, as KiCad breaks it; solid, with a message, where a layer holds too much already.
void drawStyled(Canvas& canvas, std::int32_t row, const Origin& origin, const ChainEdge& edge, double width,
                LineStyle style);

/// (target plus …), (target x …): a cross and a circle, for those who align films.
void drawTarget(Canvas& canvas, const Item& item, const Origin& origin);

/// All that it covers.
[[nodiscard]] std::vector<EdgeLoops> coverOf(const Graphic& graphic);

}  // namespace model::kicad
