#pragma once

#include <QObject>
#include <QPainterPath>

#include "ui/views/board_view.h"
#include "ui/workspace/workspace.h"

namespace ui {

/// Lets what lies beyond the board outline fade into the background of a 2D view: drawing frames, stray texts, and all
/// else that a fabricator mills away (model/solids/milling.h). Nothing fades where 3D mills nothing.
class OutlineVeil : public QObject {
public:
    /// Paints over `view` from now on, which must live as long.
    OutlineVeil(BoardView& view, Workspace& workspace, QObject* parent = nullptr);

    void setOn(bool isOn);

private:
    void setBoard(const LoadedBoard& board);
    void paint(QPainter& painter) const;

    BoardView& m_view;
    QPainterPath m_outline;  ///< mm of the board model
    bool m_isOn = true;
};

}  // namespace ui
