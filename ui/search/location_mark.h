#pragma once

#include <QObject>
#include <optional>

#include "ui/views/board_views.h"
#include "ui/workspace/workspace.h"

namespace ui {

/// A cross at the location that was searched for, in both views: in 2D on it, in 3D on the face of the board that is
/// seen. It goes with a click in a view, and with another board.
class LocationMark : public QObject {
    Q_OBJECT

public:
    /// Paints over `views` from now on, which must live as long.
    LocationMark(BoardViews& views, Workspace& workspace, QObject* parent = nullptr);

    void set(base::PointD nm);
    /// False if there was none.
    bool clear();
    [[nodiscard]] const std::optional<base::PointD>& location() const { return m_location; }

private:
    void paint(QPainter& painter, const BoardView& view) const;

    BoardViews& m_views;
    Workspace& m_workspace;
    std::optional<base::PointD> m_location;  ///< in the board's coordinates, nm
};

}  // namespace ui
