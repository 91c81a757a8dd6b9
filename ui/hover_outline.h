#pragma once

#include <QObject>
#include <vector>

#include "model/geometry/discretise.h"
#include "ui/board_place.h"
#include "ui/board_views.h"
#include "ui/models/selection_model.h"

namespace ui {

/// Draws the outline of the element under the cursor over both views. It is painted, not drawn by the device, so that
/// the eye need not wait for a frame of the board: where frames are slow the cursor would drag them behind it.
class HoverOutline : public QObject {
    Q_OBJECT

public:
    HoverOutline(BoardViews& views, models::SelectionModel& selection, QObject* parent = nullptr);

    void setOrigin(base::Point origin) { m_place.origin = origin; }
    /// Loops of the outline in nanometres of the board; empty while nothing is hovered.
    [[nodiscard]] const model::PolygonSet& outline() const { return m_outline; }

private:
    void update();
    void paint(QPainter& painter, const BoardView& view) const;

    BoardViews& m_views;
    models::SelectionModel& m_selection;
    BoardPlace m_place;
    model::PolygonSet m_outline;
    model::LayerId m_layer;  ///< of the board, where the element is drawn
};

}  // namespace ui
