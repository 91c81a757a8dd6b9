#pragma once

#include <QObject>
#include <QTimer>
#include <optional>

#include "ui/views/board_views.h"
#include "ui/workspace/workspace.h"

namespace ui {

/// What draws, in words.
[[nodiscard]] QString backendText(render::Backend backend);

/// How much there is to draw. What a panel places several times is stored once.
struct BoardCounts {
    std::uint64_t elements = 0;   ///< in all copies
    std::uint64_t copies = 0;     ///< of steps that are placed on the board
    std::uint64_t lets = 0;       ///< stored
    std::uint64_t triangles = 0;  ///< stored: the upper faces of areas; lower faces and walls are made from them

    bool operator==(const BoardCounts&) const = default;
};
[[nodiscard]] BoardCounts countsOf(const model::Document& document, const render::BoardModel& model);

/// In the lower left corner of the 3D view: how long its last frame took, what drew it, and of how much. Not in
/// pictures that are saved.
class FrameDisplay : public QObject {
    Q_OBJECT

public:
    /// Is painted over the 3D view from now on, once it is on.
    FrameDisplay(BoardViews& views, Workspace& workspace, QObject* parent = nullptr);

    void setOn(bool isOn);
    /// What is written, a name and a value per line; empty without a board.
    [[nodiscard]] QList<std::pair<QString, QString>> lines() const;

private:
    void setBoard(const LoadedBoard& board);
    void onTimed(const render::FrameStats& stats);
    void showTimes();
    void paint(QPainter& painter) const;

    BoardViews& m_views;
    bool m_isOn = false;
    BoardCounts m_counts;
    std::optional<render::FrameStats> m_last;
    QTimer m_rest;         ///< runs out when no frame has come for a while
    bool m_isOwn = false;  ///< the next frame is drawn only to show the times of the one before
};

}  // namespace ui
