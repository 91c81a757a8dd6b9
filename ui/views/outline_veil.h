#pragma once

#include <QObject>
#include <QPainterPath>
#include <QTransform>
#include <optional>

#include "ui/views/board_view.h"
#include "ui/workspace/workspace.h"

namespace ui {

/// The board outline in a 2D view, as a thin line. What lies beyond it fades into the background: drawing frames, stray
/// texts, and all else that a fabricator mills away (model/solids/milling.h), as is what lies in the cut-outs of the
/// boards of a panel. Nothing fades where 3D mills nothing.
class OutlineVeil : public QObject {
public:
    /// Paints over `view` from now on, which must live as long.
    OutlineVeil(BoardView& view, Workspace& workspace, QObject* parent = nullptr);

    /// Whether it fades.
    void setOn(bool isOn);

private:
    void setBoard(const LoadedBoard& board);
    void paint(QPainter& painter) const;
    /// From mm of the board model to the canvas; none where the view has no camera yet.
    [[nodiscard]] std::optional<QTransform> toCanvas() const;
    void fadeBeyond(QPainter& painter, const QPainterPath& outline, const QPainterPath& cutouts) const;

    BoardView& m_view;
    QPainterPath m_outline;           ///< mm of the board model
    QPainterPath m_cutouts;           ///< likewise, of all copies of steps
    bool m_isAnythingMilled = false;  ///< beyond the outline
    bool m_isOn = true;
};

}  // namespace ui
