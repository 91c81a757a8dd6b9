#pragma once

#include <QColor>
#include <QPainter>
#include <QRectF>
#include <span>
#include <vector>

#include "ui/common/display_units.h"

namespace ui {

/// Draws the spacings of the clearance lens over a view: each a light line with a dark edge, one of which is seen on
/// any layer, and the nearest ones with their number. Logical pixels.
class LensPainter {
public:
    /// What is painted over a view while its slider moves: so many lines, the nearest ones, and so many numbers.
    static constexpr std::size_t kMostLines = 20'000;
    static constexpr std::size_t kMostNumbers = 40;
    static constexpr QColor kLine{255, 255, 255};
    static constexpr QColor kEdge{10, 12, 16};

    struct Line {
        QPointF from;
        QPointF to;
        double nm = 0.0;
    };
    /// The box of a number, and the row of its line.
    struct Number {
        QRectF box;
        std::size_t line = 0;
    };

    LensPainter(QPainter& painter, const QRectF& canvas) : m_painter(painter), m_canvas(canvas) {}

    /// No number is written there.
    void keepFree(std::vector<QRectF> boxes) { m_free = std::move(boxes); }
    /// `lines` in order of their length on the board, the nearest first. Lines beside the canvas are left out, and
    /// those that would be painted where a nearer one is already. Numbers are written in that order where there is
    /// room: none lies on another, and those that find none beside their line, or whose line is a dot, are left out.
    /// Returns what was written.
    std::vector<Number> paint(std::span<const Line> lines, LengthUnit unit);

private:
    [[nodiscard]] std::vector<std::size_t> seen(std::span<const Line> lines) const;
    void drawLines(std::span<const Line> lines, std::span<const std::size_t> rows);
    void drawDots(std::span<const QPointF> dots);
    std::vector<Number> drawNumbers(std::span<const Line> lines, std::span<const std::size_t> rows, LengthUnit unit);
    void drawNumber(const QRectF& box, const QString& text);

    QPainter& m_painter;
    QRectF m_canvas;
    std::vector<QRectF> m_free;
};

}  // namespace ui
