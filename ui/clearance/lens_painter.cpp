#include "ui/clearance/lens_painter.h"

#include <QFontMetricsF>
#include <unordered_set>

#include "ui/views/label_placing.h"

namespace ui {

namespace {

constexpr double kWidth = 2.0;
constexpr double kEdgeWidth = 4.5;  ///< of both edges and the line between them
constexpr double kDot = 4.0;        ///< lines shorter than this are dots
constexpr double kMargin = 3.0;
constexpr QColor kBox{10, 12, 16, 225};

/// Lines with both ends in the same pixels cover each other.
std::uint64_t pixelsOf(const LensPainter::Line& line) {
    const auto word = [](double pixel) { return static_cast<std::uint64_t>(static_cast<std::uint16_t>(pixel)); };
    return word(line.from.x()) << 48U | word(line.from.y()) << 32U | word(line.to.x()) << 16U | word(line.to.y());
}

bool isDot(const LensPainter::Line& line) {
    return (line.to - line.from).manhattanLength() < kDot;
}

}  // namespace

std::vector<LensPainter::Number> LensPainter::paint(std::span<const Line> lines, LengthUnit unit) {
    const std::vector<std::size_t> rows = seen(lines);
    drawLines(lines, rows);
    return drawNumbers(lines, rows, unit);
}

std::vector<std::size_t> LensPainter::seen(std::span<const Line> lines) const {
    std::vector<std::size_t> rows;
    std::unordered_set<std::uint64_t> taken;
    for (std::size_t row = 0; row < lines.size() && rows.size() < kMostLines; ++row) {
        if (partWithin({lines[row].from, lines[row].to}, m_canvas) && taken.insert(pixelsOf(lines[row])).second) {
            rows.push_back(row);
        }
    }
    return rows;
}

void LensPainter::drawLines(std::span<const Line> lines, std::span<const std::size_t> rows) {
    std::vector<QLineF> strokes;
    std::vector<QPointF> dots;
    for (const std::size_t row : rows) {
        if (isDot(lines[row])) {
            dots.push_back(lines[row].from);
        } else {
            strokes.emplace_back(lines[row].from, lines[row].to);
        }
    }
    const auto count = static_cast<int>(strokes.size());
    for (const auto& [colour, width] : {std::pair(kEdge, kEdgeWidth), std::pair(kLine, kWidth)}) {
        m_painter.setPen(QPen(colour, width, Qt::SolidLine, Qt::RoundCap));
        m_painter.drawLines(strokes.data(), count);
    }
    drawDots(dots);
}

/// Filled rectangles are much quicker than strokes.
void LensPainter::drawDots(std::span<const QPointF> dots) {
    for (const auto& [colour, reach] : {std::pair(kEdge, 2), std::pair(kLine, 1)}) {
        for (const QPointF& dot : dots) {
            m_painter.fillRect(QRect(dot.toPoint() - QPoint(reach, reach), QSize(2 * reach, 2 * reach)), colour);
        }
    }
}

std::vector<LensPainter::Number> LensPainter::drawNumbers(std::span<const Line> lines,
                                                          std::span<const std::size_t> rows, LengthUnit unit) {
    const QFontMetricsF metrics(m_painter.font());
    LabelPlacing placing(m_canvas.size());
    std::ranges::for_each(m_free, [&placing](const QRectF& box) { placing.keepFree(box); });
    std::vector<std::size_t> wanted;
    for (std::size_t i = 0; i < rows.size() && wanted.size() < kMostNumbers; ++i) {
        if (!isDot(lines[rows[i]])) {
            placing.avoid({lines[rows[i]].from, lines[rows[i]].to});
            wanted.push_back(rows[i]);
        }
    }
    std::vector<Number> numbers;
    for (const std::size_t row : wanted) {
        const std::optional<QPointF> beside = middleWithin({lines[row].from, lines[row].to}, m_canvas);
        const QString text = lengthText(lines[row].nm, unit);
        const QSizeF size(metrics.horizontalAdvance(text) + 2 * kMargin, metrics.height() + kMargin);
        if (const auto box = beside ? placing.placeNear(*beside, size) : std::nullopt) {
            drawNumber(*box, text);
            numbers.push_back({*box, row});
        }
    }
    return numbers;
}

void LensPainter::drawNumber(const QRectF& box, const QString& text) {
    m_painter.setPen(Qt::NoPen);
    m_painter.setBrush(kBox);
    m_painter.drawRoundedRect(box, 3.0, 3.0);
    m_painter.setPen(kLine);
    m_painter.drawText(box, Qt::AlignCenter, text);
}

}  // namespace ui
