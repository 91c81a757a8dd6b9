#include "ui/views/outline_strokes.h"

#include <algorithm>

#include "model/base/units.h"

namespace ui {

namespace {

constexpr double kPixel = 1.0;
constexpr double kCoarsest = 64.0;  // pixels

double manhattan(QPointF a, QPointF b) {
    return (a - b).manhattanLength();
}

glm::dvec2 nmOf(base::Point point) {
    return {static_cast<double>(point.x), static_cast<double>(point.y)};
}

/// The line without points that are nearer to the one before them; its ends stay.
QPolygonF thinned(const QPolygonF& line, double least) {
    QPolygonF kept{line.front()};
    for (qsizetype i = 1; i + 1 < line.size(); ++i) {
        if (manhattan(line[i], kept.back()) >= least) {
            kept += line[i];
        }
    }
    kept += line.back();
    return kept;
}

}  // namespace

OutlineRuns::OutlineRuns(model::PolygonSet loops) : m_points(std::move(loops.points)) {
    for (const model::PolygonSet::Polygon& polygon : loops.polygons) {
        for (std::uint32_t i = 0; i < polygon.loopCount; ++i) {
            const std::size_t loop = polygon.firstLoop + i;
            addLoop(loops.loopStart[loop], loops.loopStart[loop + 1] - loops.loopStart[loop], i > 0);
        }
    }
}

void OutlineRuns::addLoop(std::uint32_t first, std::uint32_t count, bool isOpening) {
    Loop loop{static_cast<std::uint32_t>(m_runs.size()), 0, first, count, isOpening, {}};
    for (std::uint32_t at = 0; at < count; at += kPointsPerRun) {
        Run run{at, std::min(kPointsPerRun, count - at), {}};
        for (std::uint32_t i = 0; i <= run.count; ++i) {
            run.box.include(point(loop, at + i));
        }
        loop.box.include(run.box);
        m_runs.push_back(run);
        ++loop.runCount;
    }
    m_openings += isOpening ? 1 : 0;
    m_loops.push_back(loop);
}

void OutlineStrokes::add(const OutlineRuns& outline, float z, int ink) {
    m_projection = projectionAt(static_cast<double>(z));
    m_ink = ink;
    for (const OutlineRuns::Loop& loop : outline.loops()) {
        const OnScreen at = screenBox(loop.box);
        if (isSeen(at) && (!loop.isOpening || isWanted(outline, at))) {
            addLoop(outline, loop);
        }
    }
}

OutlineStrokes::Projection OutlineStrokes::projectionAt(double z) const {
    const glm::dmat4 clip(m_sight.clipFromBoard);
    const auto rowOf = [&](int row) {
        const glm::dvec2 perNm = glm::dvec2(clip[0][row], clip[1][row]) / base::kNmPerMm;
        const double offset = clip[2][row] * z + clip[3][row];
        return glm::dvec3(perNm, offset - perNm.x * m_sight.position.origin.x - perNm.y * m_sight.position.origin.y);
    };
    const glm::dvec3 w = rowOf(3);
    return {(rowOf(0) + w) * (m_sight.viewport.width() / 2.0), (rowOf(1) + w) * (m_sight.viewport.height() / 2.0), w};
}

OutlineStrokes::OnScreen OutlineStrokes::screenBox(const model::Box& box) {
    ++m_visited;
    OnScreen at;
    QPointF low(1e9, 1e9);
    QPointF high(-1e9, -1e9);
    for (const base::Point corner : {box.min, box.max, base::Point{box.min.x, box.max.y}, {box.max.x, box.min.y}}) {
        const std::optional<QPointF> pixel = onScreen(nmOf(corner));
        at.isAhead = at.isAhead && pixel.has_value();
        const QPointF p = pixel.value_or(QPointF());
        low = {std::min(low.x(), p.x()), std::min(low.y(), p.y())};
        high = {std::max(high.x(), p.x()), std::max(high.y(), p.y())};
    }
    at.box = {low, high};
    return at;
}

bool OutlineStrokes::isSeen(const OnScreen& at) const {
    const QSizeF size = m_sight.viewport;
    return !at.isAhead || (at.box.right() >= 0.0 && at.box.bottom() >= 0.0 && at.box.left() <= size.width() &&
                           at.box.top() <= size.height());
}

bool OutlineStrokes::isWanted(const OutlineRuns& outline, const OnScreen& at) const {
    const double size = at.isAhead ? std::max(at.box.width(), at.box.height()) : kLargeOpening;
    if (size < kLeastOpening || size >= kLargeOpening || !outline.isPerforated()) {
        return size >= kLeastOpening;
    }
    return m_sight.pointer && at.box.adjusted(-kNear, -kNear, kNear, kNear).contains(*m_sight.pointer);
}

void OutlineStrokes::addLoop(const OutlineRuns& outline, const OutlineRuns::Loop& loop) {
    breakLine();
    m_before.reset();
    for (const OutlineRuns::Run& run : outline.runsOf(loop)) {
        const OnScreen at = screenBox(run.box);
        if (!isSeen(at)) {
            breakLine();
            m_before.reset();
            continue;
        }
        const bool isDot = at.isAhead && at.box.width() < kPixel && at.box.height() < kPixel;
        for (std::uint32_t i = 0; i < run.count; i += isDot ? run.count : 1) {
            addPoint(nmOf(outline.point(loop, run.first + i)));
        }
        addPoint(nmOf(outline.point(loop, run.first + run.count)));
    }
}

void OutlineStrokes::addPoint(const glm::dvec2& nm) {
    ++m_visited;
    m_sight.cut ? addCut(nm) : lineTo(nm);
}

/// Only what is on this side of the cut.
void OutlineStrokes::addCut(const glm::dvec2& nm) {
    const double beyond = beyondCut(nm);
    if (m_before) {
        const double before = beyondCut(*m_before);
        if ((before > 0.0) != (beyond > 0.0)) {
            lineTo(*m_before + (nm - *m_before) * (before / (before - beyond)));
        }
    }
    m_before = nm;
    beyond > 0.0 ? breakLine() : lineTo(nm);
}

void OutlineStrokes::lineTo(const glm::dvec2& nm) {
    const std::optional<QPointF> pixel = onScreen(nm);
    if (!pixel) {
        return breakLine();
    }
    if (!m_isOpen) {
        m_lines.push_back({{}, m_ink});
        m_isOpen = true;
    }
    QPolygonF& line = m_lines.back().points;
    if (line.isEmpty() || manhattan(line.back(), *pixel) >= kPixel) {
        line += *pixel;
    }
}

std::optional<QPointF> OutlineStrokes::onScreen(const glm::dvec2& nm) const {
    const auto& [x, y, w] = m_projection;
    const double depth = w.x * nm.x + w.y * nm.y + w.z;
    if (depth <= 0.0) {
        return std::nullopt;
    }
    return QPointF((x.x * nm.x + x.y * nm.y + x.z) / depth, (y.x * nm.x + y.y * nm.y + y.z) / depth);
}

/// Above 0 where the board is cut away.
double OutlineStrokes::beyondCut(const glm::dvec2& nm) const {
    const glm::dvec2 origin(m_sight.position.origin.x, m_sight.position.origin.y);
    const glm::dvec2 along = m_sight.cut->direction;
    return glm::dot((nm - origin) / base::kNmPerMm - m_sight.cut->start, glm::dvec2(-along.y, along.x));
}

void OutlineStrokes::thin() {
    std::erase_if(m_lines, [](const Line& line) { return line.points.size() < 2; });
    for (double least = 2.0 * kPixel; segmentCount() > kMostSegments && least <= kCoarsest; least *= 2.0) {
        for (Line& line : m_lines) {
            line.points = thinned(line.points, least);
        }
    }
    std::size_t left = kMostSegments;
    const auto isTooMuch = [&left](const Line& line) {
        const auto segments = static_cast<std::size_t>(line.points.size() - 1);
        left -= std::min(left, segments);
        return left == 0;
    };
    m_lines.erase(std::ranges::find_if(m_lines, isTooMuch), m_lines.end());
}

QRect OutlineStrokes::box(double width) const {
    QRectF box;
    for (const Line& line : m_lines) {
        box |= line.points.boundingRect().adjusted(-width, -width, width, width);  // joins may be as long
    }
    return (box & QRectF({0.0, 0.0}, m_sight.viewport)).toAlignedRect();
}

std::size_t OutlineStrokes::segmentCount() const {
    std::size_t segments = 0;
    for (const Line& line : m_lines) {
        segments += static_cast<std::size_t>(std::max<qsizetype>(line.points.size() - 1, 0));
    }
    return segments;
}

}  // namespace ui
