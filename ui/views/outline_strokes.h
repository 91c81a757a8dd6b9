#pragma once

#include <QPointF>
#include <QPolygonF>
#include <QRect>
#include <QSizeF>
#include <cstdint>
#include <glm/glm.hpp>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "model/geometry/discretise.h"
#include "render/scene/section_plane.h"
#include "ui/views/board_position.h"

namespace ui {

/// The loops of an element's outline, made so that a frame costs what is seen of them: each is cut into runs of a few
/// points with a box around them, and runs beside the canvas or smaller than a pixel are passed over whole.
class OutlineRuns {
public:
    OutlineRuns() = default;
    /// `loops` in nanometres of the board.
    explicit OutlineRuns(model::PolygonSet loops);

    struct Run {
        std::uint32_t first = 0;  ///< point; the run ends with the first point of the next one
        std::uint32_t count = 0;
        model::Box box;
    };
    struct Loop {
        std::uint32_t firstRun = 0;
        std::uint32_t runCount = 0;
        std::uint32_t firstPoint = 0;
        std::uint32_t pointCount = 0;
        bool isOpening = false;
        model::Box box;
    };
    [[nodiscard]] const std::vector<Loop>& loops() const { return m_loops; }
    [[nodiscard]] std::span<const Run> runsOf(const Loop& loop) const {
        return std::span(m_runs).subspan(loop.firstRun, loop.runCount);
    }
    /// Of a loop, which closes.
    [[nodiscard]] base::Point point(const Loop& loop, std::uint32_t index) const {
        return m_points[loop.firstPoint + (index < loop.pointCount ? index : index - loop.pointCount)];
    }
    [[nodiscard]] std::size_t pointCount() const { return m_points.size(); }
    [[nodiscard]] bool isEmpty() const { return m_points.empty(); }
    /// It has so many openings that outlines around all of them would cover it.
    [[nodiscard]] bool isPerforated() const { return m_openings > kFewOpenings; }

private:
    static constexpr std::size_t kFewOpenings = 16;
    static constexpr std::uint32_t kPointsPerRun = 32;

    void addLoop(std::uint32_t first, std::uint32_t count, bool isOpening);

    std::vector<base::Point> m_points;
    std::vector<Run> m_runs;
    std::vector<Loop> m_loops;
    std::size_t m_openings = 0;
};

/// How a view looks at outlines.
struct OutlineSight {
    glm::mat4 clipFromBoard{1.0F};
    QSizeF viewport;  ///< logical pixels
    BoardPosition position;
    std::optional<render::SectionPlane> cut;  ///< what lies beyond is gone
    std::optional<QPointF> pointer;           ///< over this view
};

/// What is painted of outlines: lines on the canvas, at most kMostSegments in all, whatever the outlines are. Outer
/// contours come whole. Openings that are small on the screen are left out; where an element has many of them, so are
/// all but the large ones and those near the pointer. Points nearer to each other than a pixel are one; when that is
/// still too many, the pixel grows.
class OutlineStrokes {
public:
    static constexpr std::size_t kMostSegments = 2000;
    static constexpr double kLeastOpening = 12.0;   ///< pixels; the rims of smaller ones would cover what is around
    static constexpr double kLargeOpening = 120.0;  ///< pixels; seen wherever the pointer is
    static constexpr double kNear = 60.0;           ///< pixels from the pointer

    explicit OutlineStrokes(OutlineSight sight) : m_sight(std::move(sight)) {}

    /// `z` in millimetres of the board model. `ink` is handed back with its lines.
    void add(const OutlineRuns& outline, float z, int ink);
    /// To be called once, after all were added.
    void thin();

    struct Line {
        QPolygonF points;
        int ink = 0;
    };
    [[nodiscard]] const std::vector<Line>& lines() const { return m_lines; }
    [[nodiscard]] std::size_t segmentCount() const;
    /// Of the canvas, what pens of this width paint.
    [[nodiscard]] QRect box(double width) const;
    /// How many points and boxes were looked at: what the work is proportional to.
    [[nodiscard]] std::size_t visited() const { return m_visited; }

private:
    struct OnScreen {
        QRectF box;
        bool isAhead = true;  ///< all of it; else the box says nothing
    };
    /// Where a location in nm of the board, at the height of the outline being added, lies on the canvas: rows of a
    /// matrix, as thousands of points go through it in every frame.
    struct Projection {
        glm::dvec3 x{0.0};
        glm::dvec3 y{0.0};
        glm::dvec3 w{0.0};
    };
    [[nodiscard]] Projection projectionAt(double z) const;
    [[nodiscard]] OnScreen screenBox(const model::Box& box);
    [[nodiscard]] bool isSeen(const OnScreen& at) const;
    [[nodiscard]] bool isWanted(const OutlineRuns& outline, const OnScreen& at) const;
    void addLoop(const OutlineRuns& outline, const OutlineRuns::Loop& loop);
    void addPoint(const glm::dvec2& nm);
    void addCut(const glm::dvec2& nm);
    void lineTo(const glm::dvec2& nm);
    void breakLine() { m_isOpen = false; }
    [[nodiscard]] std::optional<QPointF> onScreen(const glm::dvec2& nm) const;
    [[nodiscard]] double beyondCut(const glm::dvec2& nm) const;

    OutlineSight m_sight;
    std::vector<Line> m_lines;
    std::size_t m_visited = 0;
    Projection m_projection;  ///< of the outline being added
    int m_ink = 0;
    bool m_isOpen = false;               ///< the last line goes on
    std::optional<glm::dvec2> m_before;  ///< with a cut, the point before, seen or not; none at the start of a loop
};

}  // namespace ui
