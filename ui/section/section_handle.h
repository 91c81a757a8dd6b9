#pragma once

#include <QObject>
#include <QPointF>
#include <optional>

#include "ui/section/section_plane_tool.h"
#include "ui/views/board_view.h"

namespace ui {

/// A two-headed arrow across the section plane, over the 3D view: a drag moves the plane with it, and what is pressed
/// on it does not reach the board. It is in the middle of the plane, on the face of the board that is seen. Pictures
/// that are saved do not have it.
class SectionHandle : public QObject {
    Q_OBJECT

public:
    /// Is painted over `solid` and gets its mouse before the board does, while there is a plane. All must live as long.
    SectionHandle(BoardView& solid, SectionPlaneTool& plane, QObject* parent = nullptr);

    /// Where it is on the canvas, in logical pixels; none without a plane, and behind the eye. It stands in the middle
    /// of the board, or where that is out of sight as near as possible to the middle of the view.
    [[nodiscard]] std::optional<QPointF> place() const;

private:
    /// The plane as it is dragged.
    struct Drag {
        QPointF from;          ///< where the handle was pressed
        base::PointD through;  ///< where the plane was
        base::PointD forward;  ///< that way, of length 1
        QPointF pixelsPerNm;   ///< on the canvas along it
    };

    bool take(QEvent& event);
    bool press(const QMouseEvent& event);
    bool move(const QMouseEvent& event);
    bool release(const QMouseEvent& event);
    void setHovered(bool isHovered);
    [[nodiscard]] bool isAt(QPointF position) const;
    [[nodiscard]] std::optional<QPointF> onCanvas(base::PointD location) const;
    [[nodiscard]] base::PointD foot() const;
    [[nodiscard]] QPointF pixelsPerNm() const;
    void paint(QPainter& painter) const;

    BoardView& m_view;
    SectionPlaneTool& m_plane;
    std::optional<Drag> m_drag;
    bool m_isHovered = false;
};

}  // namespace ui
