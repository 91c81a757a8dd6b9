#pragma once

#include <QObject>
#include <QPolygonF>
#include <QRectF>
#include <array>
#include <optional>

#include "ui/views/board_view.h"

namespace ui {

/// A cube in the upper right corner of a 3D view that is turned as the board is. A click on one of its faces, edges or
/// corners looks at the board from there, a drag turns it; what is pressed on the cube does not reach the board. Where
/// the view is too small to spare the room there is no cube, and pictures that are saved do not have it.
class ViewCube : public QObject {
    Q_OBJECT

public:
    /// A face, an edge or a corner, as the direction to it from the middle of the cube: one, two or three of the
    /// components are 1 or -1 and the others 0. x goes right on the board's top, y up, z to the top.
    using Part = glm::ivec3;

    /// Is painted over `view` and gets its mouse first, from now on.
    explicit ViewCube(BoardView& view, QObject* parent = nullptr);

    void setOn(bool isOn);
    /// The square the cube turns in, in logical pixels of the canvas; empty while there is none.
    [[nodiscard]] QRectF place() const;
    /// What is seen of the cube at a place of the canvas.
    [[nodiscard]] std::optional<Part> partAt(QPointF position) const;
    /// Where the middle of a part is on the canvas.
    [[nodiscard]] QPointF positionOf(const Part& part) const;
    [[nodiscard]] std::optional<Part> hovered() const { return m_hovered; }

private:
    struct Face;
    static const std::array<Face, 6> kFaces;

    bool take(QEvent& event);
    bool press(const QMouseEvent& event);
    bool move(const QMouseEvent& event);
    bool release(const QMouseEvent& event);
    void setHovered(const std::optional<Part>& part);
    void paint(QPainter& painter) const;
    void paintHovered(QPainter& painter, const Face& face) const;
    void paintFace(QPainter& painter, const Face& face) const;
    [[nodiscard]] QPolygonF cell(const Face& face, int column, int row) const;
    [[nodiscard]] glm::vec3 seen(const glm::vec3& direction) const;
    [[nodiscard]] QPointF onCanvas(const glm::vec3& point) const;

    BoardView& m_view;
    bool m_isOn = true;
    std::optional<Part> m_hovered;
    std::optional<Part> m_pressed;
    bool m_isDrag = false;
    QPointF m_pressedAt;
    QPointF m_last;
};

}  // namespace ui
