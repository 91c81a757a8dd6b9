#pragma once

#include <QObject>
#include <optional>

#include "model/measure/separation.h"
#include "model/measure/snapping.h"
#include "ui/measurement_keeping.h"
#include "ui/probing.h"

namespace ui {

/// Measuring with the mouse, in both views: from point to point, where the cursor catches centres, ends, middles and
/// edges within 14 pixels; from edge to edge of two elements; and the gap at the cursor in one stroke. While a tool is
/// in use, clicks measure instead of selecting. With Shift held the second point lies straight beside or above the
/// first one, with Ctrl in steps of 45 degrees; with Alt nothing is caught. What was measured goes to the list and
/// stays on the canvas.
class Measuring : public QObject {
    Q_OBJECT

public:
    enum class Tool { None, Points, Objects };
    static constexpr double kCatchPixels = 14.0;

    Measuring(BoardViews& views, Probing& probing, MeasurementKeeping& kept, QObject* parent = nullptr);

    void setBoard(const LoadedBoard& board);
    /// The same board with other thicknesses.
    void setHeights(std::shared_ptr<const model::Document> document);
    void setUnit(models::LengthUnit unit);
    void setTool(Tool tool);
    [[nodiscard]] Tool tool() const { return m_tool; }
    /// Gives up the measurement that was begun, or else the tool. False if there is neither.
    bool stepBack();
    /// From the copper nearest to the cursor to the next copper on its layer, see model::gapAt.
    void measureGapAtCursor();
    /// Brings a kept measurement to the middle of both views.
    void goTo(int row);

signals:
    void toolChanged();
    /// A measurement begins here (nm of the board), or does no longer.
    void begunAt(std::optional<base::PointD> place);
    void told(const QString& what);

private:
    /// What the cursor points at.
    struct Caught {
        model::session::MeasuredEnd end;
        model::SnapKind kind = model::SnapKind::Free;
        model::LayerId layer;
        std::optional<model::BoardElement> element;
    };
    /// A place of the board under the cursor, and the layers on which something may be caught there.
    struct Pointed {
        base::PointD place;
        std::vector<model::PickLayer> layers;
        model::LayerId layer;  ///< what is seen there in 3D; none in 2D
        bool isFromBelow = false;
    };

    void watch(BoardView& view);
    void hover(BoardView& view, QPointF position, Qt::KeyboardModifiers modifiers);
    void click(BoardView& view, QPointF position, Qt::KeyboardModifiers modifiers);
    void clickPoint(const Caught& caught);
    void clickObject(const Caught& caught);
    void forgetFirst();
    [[nodiscard]] std::optional<Pointed> pointedAt(BoardView& view, QPointF position);
    [[nodiscard]] std::optional<Caught> catchAt(BoardView& view, QPointF position, Qt::KeyboardModifiers modifiers);
    [[nodiscard]] std::optional<Caught> elementAt(BoardView& view, QPointF position);
    [[nodiscard]] model::session::MeasuredEnd endOf(base::PointD at, model::LayerId layer,
                                                    std::optional<model::BoardElement> element,
                                                    model::SnapKind kind) const;
    [[nodiscard]] model::session::Measurement between(const Caught& from, const Caught& to) const;
    void keep(model::session::Measurement measurement, const std::vector<std::string>& remarks);
    void paint(QPainter& painter, const BoardView& view) const;

    BoardViews& m_views;
    Probing& m_probing;
    MeasurementKeeping& m_kept;
    std::shared_ptr<const model::BoardIndex> m_index;
    std::optional<model::Snapper> m_snapper;
    std::optional<model::Picker> m_picker;
    BoardPlace m_place;
    models::LengthUnit m_unit = models::LengthUnit::Millimetre;
    Tool m_tool = Tool::None;
    std::optional<Caught> m_first;
    std::optional<Caught> m_under;     ///< the cursor, while a tool is in use
    BoardView* m_hoverView = nullptr;  ///< null: the cursor is on no view
    QPointF m_hoverAt;
    bool m_isLatestFull = false;  ///< the last of the list was measured just now: all is told of it
};

}  // namespace ui
