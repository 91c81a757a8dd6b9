#pragma once

#include <QImage>
#include <QObject>
#include <QTimer>
#include <QTransform>
#include <memory>
#include <optional>

#include "model/clearance/board_distances.h"
#include "ui/views/board_position.h"
#include "ui/views/board_view.h"
#include "ui/workspace/background_result.h"

namespace ui {

/// A clearance map painted over one view, in the plane of its layer; in 3D under what covers that. What the view shows
/// is worked out in the background once the view rests, a cell per pixel; until then the last picture moves along with
/// the board.
class ClearanceMapPicture : public QObject {
    Q_OBJECT

public:
    explicit ClearanceMapPicture(BoardView& view, QObject* parent = nullptr);

    /// From now on the map of this field, of what lies within `board`; null: nothing.
    void setField(std::shared_ptr<const model::BoardDistances> field, const model::Box& board);
    /// Colours go from 0 to this (nm); what is farther is only darkened a little.
    void setReach(double nm);

    /// Is what the view shows still to be worked out?
    [[nodiscard]] bool isPending() const { return m_rest.isActive() || m_work.isRunning(); }
    /// Null before the first one.
    [[nodiscard]] const model::ClearanceMap* map() const { return m_map ? &*m_map : nullptr; }
    [[nodiscard]] const QImage& image() const { return m_image; }  ///< row 0 is the lowest, as in the map
    /// The cells that lie under what the view shows now; none if that misses the board.
    [[nodiscard]] std::optional<model::MapFrame> shownFrame() const;

    static constexpr int kSpacingAlpha = 235;   ///< between nets there is nothing but the map
    static constexpr int kDistanceAlpha = 150;  ///< copper is to be seen through it

signals:
    /// There is no picture, and why.
    void failed(const QString& reason);

private:
    void paint(QPainter& painter);
    void clipToBoard(QPainter& painter) const;
    void follow();
    void work();
    void deliver();
    void colour();
    [[nodiscard]] float height() const;
    [[nodiscard]] QTransform canvasFromCells() const;

    BoardView& m_view;
    std::shared_ptr<const model::BoardDistances> m_field;
    model::Box m_board;
    double m_reach = 1e6;
    std::optional<model::MapFrame> m_asked;
    std::optional<model::ClearanceMap> m_map;
    QImage m_image;
    QTimer m_rest;
    BackgroundResult<model::ClearanceMap> m_work;
};

}  // namespace ui
