#include "ui/views/label_placing.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace ui {

namespace {

constexpr double kBeside = 12.0;  // from the place to its label
constexpr double kApart = 2.0;    // between two labels
constexpr int kRings = 8;         // how many labels away one may lie
constexpr double kCell = 64.0;    // of the grid: most labels touch one or two cells

/// Where a label lies from its place, the most wanted first.
constexpr std::array<QPointF, 8> kSides = {{{1, 1}, {1, -1}, {-1, 1}, {-1, -1}, {1, 0}, {-1, 0}, {0, 1}, {0, -1}}};

QRectF boxAt(QPointF beside, QSizeF size, QPointF side, double distance) {
    const QPointF middle =
        beside + QPointF(side.x() * (distance + size.width() / 2.0), side.y() * (distance + size.height() / 2.0));
    return {middle - QPointF(size.width() / 2.0, size.height() / 2.0), size};
}

}  // namespace

std::optional<QLineF> partWithin(const QLineF& line, const QRectF& box) {
    // Liang and Barsky's clipping.
    double begin = 0.0;
    double end = 1.0;
    const std::array<std::array<double, 3>, 2> axes = {{{line.dx(), box.left() - line.x1(), box.right() - line.x1()},
                                                        {line.dy(), box.top() - line.y1(), box.bottom() - line.y1()}}};
    for (const auto& [way, low, high] : axes) {
        if (way == 0.0) {
            end = low <= 0.0 && high >= 0.0 ? end : -1.0;
            continue;
        }
        begin = std::max(begin, std::min(low / way, high / way));
        end = std::min(end, std::max(low / way, high / way));
    }
    return begin <= end ? std::optional(QLineF(line.pointAt(begin), line.pointAt(end))) : std::nullopt;
}

QList<QPolygonF> partsWithin(const QPolygonF& line, const QRectF& box) {
    QList<QPolygonF> chains;
    for (qsizetype i = 0; i + 1 < line.size(); ++i) {
        const auto part = partWithin({line[i], line[i + 1]}, box);
        if (!part) {
            continue;
        }
        if (chains.isEmpty() || chains.back().back() != part->p1()) {
            chains += QPolygonF({part->p1()});
        }
        chains.back() += part->p2();
    }
    return chains;
}

std::optional<QPointF> middleWithin(const QPolygonF& line, const QRectF& box) {
    std::vector<QLineF> parts;
    double length = 0.0;
    for (qsizetype i = 0; i + 1 < line.size(); ++i) {
        if (const auto part = partWithin({line[i], line[i + 1]}, box)) {
            parts.push_back(*part);
            length += part->length();
        }
    }
    double left = length / 2.0;
    for (const QLineF& part : parts) {
        if (left <= part.length()) {
            return part.length() > 0.0 ? part.pointAt(left / part.length()) : part.p1();
        }
        left -= part.length();
    }
    return parts.empty() ? std::nullopt : std::optional(parts.back().p2());
}

std::pair<LabelPlacing::Covered, QRectF> LabelPlacing::bestOf(QPointF beside, QSizeF size, int ring,
                                                              std::pair<Covered, QRectF> best) const {
    for (const QPointF side : kSides) {
        const QRectF box = inside(boxAt(beside, size, side, kBeside + ring * (size.height() + kApart)));
        const Covered covered{overlapOf(box), crossedBy(box)};
        if (covered < best.first) {
            best = {covered, box};
        }
    }
    return best;
}

QRectF LabelPlacing::place(QPointF beside, QSizeF size) {
    std::pair<Covered, QRectF> best;
    for (int ring = 0; ring < kRings && best.first.labels > 0.0; ++ring) {
        best = bestOf(beside, size, ring, best);
    }
    m_taken.push_back(best.second);
    return best.second;
}

std::optional<QRectF> LabelPlacing::placeNear(QPointF beside, QSizeF size) {
    const auto [covered, box] = bestOf(beside, size, 0, {});
    if (covered.labels > 0.0) {
        return std::nullopt;
    }
    m_taken.push_back(box);
    return box;
}

QRectF LabelPlacing::inside(QRectF box) const {
    box.moveLeft(std::max(0.0, std::min(box.left(), m_canvas.width() - box.width())));
    box.moveTop(std::max(0.0, std::min(box.top(), m_canvas.height() - box.height())));
    return box;
}

double LabelPlacing::overlapOf(const QRectF& box) const {
    double area = 0.0;
    for (const QRectF& taken : m_taken) {
        const QRectF both = taken.adjusted(-kApart, -kApart, kApart, kApart).intersected(box);
        area += both.width() * both.height();
    }
    return area;
}

double LabelPlacing::crossedBy(const QRectF& box) const {
    double length = 0.0;
    for (const QLineF& line : m_lines) {
        const std::optional<QLineF> part = partWithin(line, box);
        length += part ? part->length() : 0.0;
    }
    return length;
}

std::array<QPointF, 4> RotatedBox::corners() const {
    const double angle = angleDeg * std::numbers::pi / 180.0;
    const QPointF along = QPointF(std::cos(angle), std::sin(angle)) * (size.width() / 2.0);
    const QPointF across = QPointF(-std::sin(angle), std::cos(angle)) * (size.height() / 2.0);
    return {middle - along - across, middle + along - across, middle + along + across, middle - along + across};
}

bool RotatedBox::meets(const RotatedBox& other) const {
    const std::array<QPointF, 4> own = corners();
    const std::array<QPointF, 4> others = other.corners();
    // Two convex shapes lie apart if a side of one of them parts them.
    const auto isParted = [&](QPointF axis) {
        const auto rangeOf = [axis](const std::array<QPointF, 4>& corners) {
            std::pair range(std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity());
            for (const QPointF corner : corners) {
                const double at = QPointF::dotProduct(axis, corner);
                range = {std::min(range.first, at), std::max(range.second, at)};
            }
            return range;
        };
        const auto [low, high] = rangeOf(own);
        const auto [otherLow, otherHigh] = rangeOf(others);
        return high <= otherLow || otherHigh <= low;
    };
    return !isParted(own[1] - own[0]) && !isParted(own[3] - own[0]) && !isParted(others[1] - others[0]) &&
           !isParted(others[3] - others[0]);
}

LabelRoom::Cells LabelRoom::cellsOf(const RotatedBox& box) {
    const std::array<QPointF, 4> corners = box.corners();
    const auto [left, right] = std::ranges::minmax(corners, {}, &QPointF::x);
    const auto [top, bottom] = std::ranges::minmax(corners, {}, &QPointF::y);
    const auto cell = [](double at) { return static_cast<int>(std::floor(at / kCell)); };
    return {cell(left.x()), cell(right.x()), cell(top.y()), cell(bottom.y())};
}

bool LabelRoom::take(const RotatedBox& box) {
    const Cells cells = cellsOf(box);
    const auto each = [&cells](const auto& visit) {
        for (int column = cells.left; column <= cells.right; ++column) {
            for (int row = cells.top; row <= cells.bottom; ++row) {
                visit(qMakePair(column, row));
            }
        }
    };
    bool isFree = true;
    each([&](const QPair<int, int>& cell) {
        if (const auto found = m_cells.constFind(cell); found != m_cells.constEnd()) {
            isFree = isFree && std::ranges::none_of(*found, [&](std::size_t row) { return m_taken[row].meets(box); });
        }
    });
    if (isFree) {
        each([&](const QPair<int, int>& cell) { m_cells[cell].push_back(m_taken.size()); });
        m_taken.push_back(box);
    }
    return isFree;
}

}  // namespace ui
