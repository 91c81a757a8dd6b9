#pragma once

#include <QObject>
#include <optional>
#include <vector>

#include "ui/views/board_position.h"
#include "ui/views/board_view.h"

namespace ui {

/// The line of a cross-section, over the 2D view. While drawing is on, a drag draws one leg; a click begins
/// a line of many: every further click is a corner, a double click or Enter ends it, Backspace takes the last corner
/// back. Corners are moved afterwards by their handles; where many lie close together, zooming in brings the handles of
/// all; Esc puts the one that is being moved back. Shift keeps a leg to multiples of 45 degrees.
class SectionLine : public QObject {
    Q_OBJECT

public:
    explicit SectionLine(BoardView& flat, QObject* parent = nullptr);

    /// For another board: there is no line, and none is being drawn.
    void clear();
    /// Corners in nm of the board; none: no line. A corner that is being moved is let go.
    void setLine(std::vector<base::PointD> line);
    [[nodiscard]] const std::vector<base::PointD>& line() const { return m_line; }
    /// Whether it is there for the eye and for clicks: not while its panel is closed, unless it is being drawn.
    void setShown(bool isShown);
    /// Whether the next drag or clicks draw a line. Ends by itself when one was drawn; ended before, the line is what
    /// it was.
    void setDrawing(bool isOn);
    [[nodiscard]] bool isDrawing() const { return m_isDrawing; }

signals:
    /// The user has changed the line; it may have no length yet.
    void moved();
    /// The line is drawn or moved, or given up.
    void finished();
    /// A corner that was being moved is where it was before.
    void putBack();

private:
    [[nodiscard]] bool isThere() const { return m_isShown || m_isDrawing; }
    bool take(QEvent& event);
    bool press(const QMouseEvent& event);
    void moveCorner(std::size_t corner, const QMouseEvent& event);
    void release();
    bool takeEscape(QKeyEvent& event);
    bool lay(QEvent& event);
    bool layPress(const QMouseEvent& event);
    static bool keepKey(QKeyEvent& event);
    bool layKey(const QKeyEvent& event);
    void endLaying();
    [[nodiscard]] bool isClick(base::PointD from, base::PointD to) const;
    /// Corners that have a handle: both ends, the one that is held, and of the others as many as are clearly apart on
    /// the screen.
    [[nodiscard]] std::vector<std::size_t> handles() const;
    [[nodiscard]] std::optional<std::size_t> cornerAt(QPointF position) const;
    void paint(QPainter& painter) const;

    BoardView& m_view;
    std::vector<base::PointD> m_line;
    std::optional<std::size_t> m_held;  ///< corner being dragged
    bool m_isShown = true;
    bool m_isDrawing = false;
    bool m_isLaying = false;             ///< corner by corner; the last one of the line follows the cursor
    std::vector<base::PointD> m_before;  ///< the line when drawing or a move of a corner began
};

}  // namespace ui
