#pragma once

#include <QHash>
#include <QLineF>
#include <QList>
#include <QPair>
#include <QPointF>
#include <QPolygonF>
#include <QRectF>
#include <QSizeF>
#include <array>
#include <cstddef>
#include <limits>
#include <optional>
#include <utility>
#include <vector>

namespace ui {

/// The part of a line that lies in a box; nothing if none does.
[[nodiscard]] std::optional<QLineF> partWithin(const QLineF& line, const QRectF& box);
/// What of a chain of lines lies in a box, as chains: no painter has to follow what leads far out of a view.
[[nodiscard]] QList<QPolygonF> partsWithin(const QPolygonF& line, const QRectF& box);
/// The middle of what of a chain of lines lies in a box; nothing if nothing does.
[[nodiscard]] std::optional<QPointF> middleWithin(const QPolygonF& line, const QRectF& box);

/// Finds room for labels on a canvas. Every label lies beside what it tells of, inside of the canvas, and not on an
/// earlier label as long as there is room; it keeps off the lines too where it can. Equal calls in equal order give
/// equal places. Logical pixels.
class LabelPlacing {
public:
    explicit LabelPlacing(QSizeF canvas) : m_canvas(canvas) {}

    /// A line that labels better leave free.
    void avoid(const QLineF& line) { m_lines.push_back(line); }
    /// What is painted there is to be seen, as if it were an earlier label.
    void keepFree(const QRectF& box) { m_taken.push_back(box); }
    /// The place of the next label, which is taken from then on.
    [[nodiscard]] QRectF place(QPointF beside, QSizeF size);
    /// The same right beside it, where no earlier label is; none if there is no room.
    [[nodiscard]] std::optional<QRectF> placeNear(QPointF beside, QSizeF size);

private:
    /// What a label covers at a place: of earlier labels and of lines.
    struct Covered {
        double labels = std::numeric_limits<double>::infinity();
        double lines = std::numeric_limits<double>::infinity();
        auto operator<=>(const Covered&) const = default;
    };
    /// The better of `best` and the sides of a ring.
    [[nodiscard]] std::pair<Covered, QRectF> bestOf(QPointF beside, QSizeF size, int ring,
                                                    std::pair<Covered, QRectF> best) const;
    [[nodiscard]] QRectF inside(QRectF box) const;
    [[nodiscard]] double overlapOf(const QRectF& box) const;
    [[nodiscard]] double crossedBy(const QRectF& box) const;

    QSizeF m_canvas;
    std::vector<QLineF> m_lines;
    std::vector<QRectF> m_taken;
};

/// A box about its middle, rotated.
struct RotatedBox {
    QPointF middle;
    QSizeF size;
    double angleDeg = 0.0;

    [[nodiscard]] std::array<QPointF, 4> corners() const;
    /// Have they more in common than an edge?
    [[nodiscard]] bool meets(const RotatedBox& other) const;
};

/// Which labels of many have room where they must be: one that meets an earlier one has none. A grid knows which may
/// meet, so thousands are told in a millisecond.
class LabelRoom {
public:
    /// Takes the room of a label; false if another one has some of it, and then nothing is taken.
    [[nodiscard]] bool take(const RotatedBox& box);

private:
    struct Cells {
        int left = 0;
        int right = 0;
        int top = 0;
        int bottom = 0;
    };
    [[nodiscard]] static Cells cellsOf(const RotatedBox& box);

    std::vector<RotatedBox> m_taken;
    QHash<QPair<int, int>, std::vector<std::size_t>> m_cells;  ///< rows of m_taken by column and row of the grid
};

}  // namespace ui
