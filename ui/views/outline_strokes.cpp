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
    m_z = z;
    m_ink = ink;
    for (const OutlineRuns::Loop& loop : outline.loops()) {
        const OnScreen at = screenBox(loop.box);
        if (isSeen(at) && (!loop.isOpening || isWanted(outline, at))) {
            addLoop(outline, loop);
        }
    }
}

OutlineStrokes::OnScreen OutlineStrokes::screenBox(const model::Box& box) {
    ++m_visited;
    OnScreen at;
    QPointF low(1e9, 1e9);
    QPointF high(-1e9, -1e9);
    for (const base::Point corner : {box.min, box.max, base::Point{box.min.x, box.max.y}, {box.max.x, box.min.y}}) {
        const std::optional<QPointF> pixel = onScreen(onModel(corner));
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
            addPoint(outline.point(loop, run.first + i));
        }
        addPoint(outline.point(loop, run.first + run.count));
    }
}

/// With a cut, only what is on this side of it.
void OutlineStrokes::addPoint(base::Point point) {
    ++m_visited;
    const glm::dvec2 mm = onModel(point);
    const double beyond = beyondCut(mm);
    if (m_before) {
        const double before = beyondCut(*m_before);
        if ((before > 0.0) != (beyond > 0.0)) {
            lineTo(*m_before + (mm - *m_before) * (before / (before - beyond)));
        }
    }
    m_before = mm;
    beyond > 0.0 ? breakLine() : lineTo(mm);
}

void OutlineStrokes::lineTo(const glm::dvec2& mm) {
    const std::optional<QPointF> pixel = onScreen(mm);
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

glm::dvec2 OutlineStrokes::onModel(base::Point point) const {
    return {(double(point.x) - m_sight.position.origin.x) / base::kNmPerMm,
            (double(point.y) - m_sight.position.origin.y) / base::kNmPerMm};
}

std::optional<QPointF> OutlineStrokes::onScreen(const glm::dvec2& mm) const {
    const glm::vec4 clip = m_sight.clipFromBoard * glm::vec4(glm::vec2(mm), m_z, 1.0F);
    if (clip.w <= 0.0F) {
        return std::nullopt;
    }
    return QPointF((clip.x / clip.w + 1.0) / 2.0 * m_sight.viewport.width(),
                   (clip.y / clip.w + 1.0) / 2.0 * m_sight.viewport.height());
}

/// Above 0 where the board is cut away.
double OutlineStrokes::beyondCut(const glm::dvec2& mm) const {
    if (!m_sight.cut) {
        return 0.0;
    }
    const glm::dvec2 along = m_sight.cut->direction;
    return glm::dot(mm - m_sight.cut->start, glm::dvec2(-along.y, along.x));
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
