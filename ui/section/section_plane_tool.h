#pragma once

#include <optional>

#include "ui/views/board_views.h"

namespace ui {

/// The section plane of the 3D view, which cuts the board open. It is where the pointer was, may be moved across itself
/// and rotated, and every change shows at once: a cut takes milliseconds, and nothing of the board goes to the device
/// again.
class SectionPlaneTool {
public:
    explicit SectionPlaneTool(BoardViews& views) : m_views(views) {}

    /// Another board: it is whole. The same one read anew is cut where it was.
    void setBoard(const LoadedBoard& board, bool isReadAnew);
    /// The same board with other heights.
    void setHeights(std::shared_ptr<const model::BoardIndex> index);
    /// Shows also what is milled away beyond the board outline, as the 3D view then does.
    void setAsDesigned(bool isOn);
    /// Where the pointer is, nm of the board; none: beside the board.
    void pointAt(std::optional<base::PointD> location) { m_pointer = location; }
    /// Cuts through the pointer, or where that is not over the board through its middle, or that of what is seen of it
    /// if its own is out of sight; what is in front of an isometric view goes. Or makes the board whole again.
    void setOn(bool isOn);
    [[nodiscard]] bool isOn() const { return m_isOn; }
    /// Cuts through two places of the board; what is to the right on the way from one to the other goes.
    void cutAlong(base::PointD from, base::PointD to);
    /// Whether it is where `cutAlong` has put it, and was not rotated since.
    [[nodiscard]] bool isAlongLine() const { return m_isOn && m_isAlongLine; }
    /// Only while it is on: by 45 degrees, seen from above to the left. Around the place it was put through.
    void rotate();
    /// Likewise: towards what is left (negative: towards what was cut away), by a part of the board's larger side.
    void move(double part);
    /// Through another place, as it is turned, but no farther than the board reaches. nm of the board.
    void put(base::PointD through);
    /// Only while it is on: the board it cuts, the place on it that is nearest to the middle of the board, and the way
    /// towards what is left, of length 1.
    [[nodiscard]] const model::Document& board() const { return *m_index->board; }
    [[nodiscard]] base::PointD middle() const;
    /// The place on it that is nearest to another one.
    [[nodiscard]] base::PointD nearestTo(base::PointD location) const;
    [[nodiscard]] base::PointD forward() const;

private:
    [[nodiscard]] static bool isOver(const model::Document& board, base::PointD location);
    [[nodiscard]] base::PointD seenMiddle() const;
    [[nodiscard]] base::PointD direction() const;
    void apply();

    BoardViews& m_views;
    std::shared_ptr<const model::BoardIndex> m_index;
    base::Point m_origin;
    std::optional<base::PointD> m_pointer;
    base::PointD m_through;
    double m_angle = 0.0;  ///< of the cut as it was put; radians, 0: along x
    int m_eighths = 0;     ///< of a full turn, on top of that
    bool m_isAlongLine = false;
    bool m_isOn = false;
    bool m_isAsDesigned = false;
    std::vector<std::vector<model::ElementId>> m_milled;  ///< model::SectionRequest::milled
};

}  // namespace ui
