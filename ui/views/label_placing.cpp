#include "ui/views/label_placing.h"

#include <algorithm>
#include <array>

namespace ui {

namespace {

constexpr double kBeside = 12.0;  // from the place to its label
constexpr double kApart = 2.0;    // between two labels
constexpr int kRings = 8;         // how many labels away one may lie

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

}  // namespace ui
