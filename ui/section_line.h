#pragma once

#include <QObject>
#include <optional>
#include <vector>

#include "ui/board_place.h"
#include "ui/board_view.h"

namespace ui {

/// The line along which a board is cut, over the 2D view: drawn by a drag once that is asked for, and moved by its
/// corners afterwards. Shift keeps a leg to multiples of 45 degrees.
class SectionLine : public QObject {
    Q_OBJECT

public:
    explicit SectionLine(BoardView& flat, QObject* parent = nullptr);

    /// Another board has no line.
    void setBoard(const BoardPlace& place);
    /// Corners in nm of the board; none: no line.
    void setLine(std::vector<base::PointD> line);
    [[nodiscard]] const std::vector<base::PointD>& line() const { return m_line; }
    /// Whether the next drag draws a line. Ends by itself when one was drawn.
    void setDrawing(bool isOn) { m_isDrawing = isOn; }
    [[nodiscard]] bool isDrawing() const { return m_isDrawing; }

signals:
    /// The hand has changed the line; it may have no length yet.
    void moved();
    /// The hand has let go.
    void finished();

private:
    bool take(QEvent& event);
    bool press(const QMouseEvent& event);
    void drag(const QMouseEvent& event);
    void release();
    [[nodiscard]] std::optional<std::size_t> cornerAt(QPointF position) const;
    void paint(QPainter& painter) const;

    BoardView& m_view;
    BoardPlace m_place;
    std::vector<base::PointD> m_line;
    std::optional<std::size_t> m_held;  ///< corner in the hand
    bool m_isDrawing = false;
};

}  // namespace ui
