#pragma once

#include <QColor>
#include <QObject>
#include <QPolygonF>
#include <span>
#include <vector>

#include "model/geometry/discretise.h"
#include "ui/views/board_position.h"
#include "ui/views/board_views.h"
#include "ui/workspace/workspace.h"

namespace ui {

/// Draws the outlines of the element under the pointer, and of what is selected or near it, over both views. They are
/// painted, not drawn by the device, so that they need not wait for a frame of the board: where frames are slow they
/// would lag behind the pointer. They also show where something lies that other layers cover.
class ElementOutlines : public QObject {
    Q_OBJECT

public:
    /// More elements than these are not outlined: that would take too long, and they are seen as it is.
    static constexpr std::size_t kMostOutlined = 500;

    /// Of one element.
    struct Outline {
        model::PolygonSet loops;  ///< in nanometres of the board
        model::LayerId layer;     ///< of the board, where the element is drawn
    };

    ElementOutlines(BoardViews& views, Workspace& workspace, QObject* parent = nullptr);

    /// No loops while nothing is hovered.
    [[nodiscard]] const Outline& hovered() const { return m_hovered; }
    /// Of the elements selected and those near them.
    [[nodiscard]] const std::vector<Outline>& selected() const { return m_selected; }

private:
    void updateHovered();
    void updateSelected();
    [[nodiscard]] Outline outlineOf(const model::BoardElement& at) const;
    void paint(QPainter& painter, const BoardView& view) const;
    void paintOutline(QPainter& painter, const BoardView& view, const Outline& outline, const QColor& ink) const;

    [[nodiscard]] QPolygonF onScreen(const BoardView& view, std::span<const base::Point> loop, float z) const;

    BoardViews& m_views;
    SelectionModel& m_selection;
    Outline m_hovered;
    std::vector<Outline> m_selected;
};

}  // namespace ui
