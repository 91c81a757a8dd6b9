#pragma once

#include <QObject>
#include <QTimer>
#include <optional>

#include "ui/measure/measurement_making.h"
#include "ui/measure/measurement_model.h"
#include "ui/measure/measurement_painter.h"
#include "ui/workspace/background_result.h"
#include "ui/workspace/feature.h"
#include "ui/workspace/hint.h"
#include "ui/workspace/session_part.h"

namespace ui {

/// Measuring with the mouse, in both views: from point to point, from edge to edge of two elements, angles of three
/// points or of two lines, radii, and lengths along nets; and the gap at the cursor in one stroke. While a tool is in
/// use, clicks measure instead of selecting, and the status line says what the next one is for. What was measured goes
/// to the list and stays on the canvas.
class MeasureFeature : public QObject {
    Q_OBJECT

public:
    enum class Tool { None, Points, Objects, Angle, Lines, Radius, Length };

    explicit MeasureFeature(FeatureContext& context);

    void setTool(Tool tool);
    [[nodiscard]] Tool tool() const { return m_tool; }
    /// Gives up the length that is being followed, or else the last click, or else the tool. False if there is nothing.
    bool stepBack();
    /// From the copper nearest to the cursor to the next copper on its layer, see model::spacingAt.
    void measureSpacingAtCursor();
    /// A spacing that somebody else found is drawn with the measurements, but not saved; none: no longer.
    void showSpacing(const std::optional<ShownSpacing>& spacing);
    /// Brings a saved measurement to the middle of both views.
    void goTo(int row);

signals:
    void toolChanged();
    /// One was added to the list.
    void measuredNew();

private:
    void connectCommands(FeatureContext& context);
    /// Of measuring and another tool that takes the clicks in the views the one that comes ends the other.
    void alternateWith(QAction& drawing);
    void addPanel(FeatureContext& context);
    void setBoard(const LoadedBoard& board);
    void setHeights(const LoadedBoard& board);
    void deleteAll();
    void exportTable(FeatureContext& context);
    void watch(BoardView& view);
    void hover(BoardView& view, QPointF position, Qt::KeyboardModifiers modifiers);
    /// Tab.
    void stepBeneath(int by);
    /// Highlights the element that a click takes, which need not be the uppermost under the pointer.
    void highlightCaught();
    void correctHighlight();
    void click(BoardView& view, QPointF position, Qt::KeyboardModifiers modifiers);
    [[nodiscard]] std::optional<Caught> catchAt(BoardView& view, QPointF position, Qt::KeyboardModifiers modifiers);
    void reportWhyNothing(const BoardView& view, QPointF position);
    [[nodiscard]] QString layerNameOf(const model::BoardElement& at) const;
    /// Why a click cannot go with the ones before; empty if it can.
    [[nodiscard]] QString refusalOf(const Caught& caught) const;
    void reportNextClick();
    void clearClicks();
    void measure(const std::vector<Caught>& clicked);
    void noteOnNets(const std::vector<Caught>& clicked, model::Measurement& measurement) const;
    /// What so many clicks measure. Not for lengths.
    [[nodiscard]] base::Result<model::Measurement> measured(const std::vector<Caught>& clicked) const;
    /// What it will be if the cursor is clicked; nothing if that is not known yet, or takes too long to find out.
    [[nodiscard]] std::optional<model::Measurement> preview() const;
    [[nodiscard]] bool isQuick(const std::vector<Caught>& clicked) const;
    void updatePreview();
    void markClicked();
    void followNet(const Caught& from, const Caught& to);
    void takePath();
    /// The length from the first click to where the cursor rests.
    void followAhead();
    void takePathAhead();
    void save(const base::Result<model::Measurement>& measurement);
    void paint(QPainter& painter, const BoardView& view) const;
    void paintClicks(MeasurementPainter& on, const BoardView& view) const;

    Workspace& m_workspace;
    Hint m_hint;  ///< what to click next
    BoardViews& m_views;
    Probing& m_probing;
    PositionReadout& m_readout;
    MeasurementModel m_list;
    SavedList<model::Measurement> m_saved;
    MeasuringCursor m_cursor;
    std::shared_ptr<const model::BoardIndex> m_index;
    Tool m_tool = Tool::None;
    std::vector<Caught> m_clicked;
    std::optional<Caught> m_under;  ///< the cursor, while a tool is in use
    std::optional<model::Measurement> m_coming;
    std::optional<model::BoardElement> m_highlighted;  ///< by highlightCaught, last
    BoardView* m_hoverView = nullptr;                  ///< null: the cursor is on no view
    QPointF m_hoverAt;
    QAction* m_showing = nullptr;  ///< whether the list is drawn
    bool m_isLatestFull = false;   ///< the last of the list was measured just now: all is told of it
    std::optional<ShownSpacing> m_shownSpacing;

    /// A length being followed.
    struct Following {
        std::shared_ptr<const model::BoardIndex> index;
        Caught from;
        Caught to;
    };
    [[nodiscard]] static BackgroundResult<model::NetPath>::Work pathOf(const Following& work);
    Following m_following;  ///< what the path under way is for
    BackgroundResult<model::NetPath> m_path;
    QTimer m_restBeforePath;
    Following m_ahead;
    BackgroundResult<model::NetPath> m_pathAhead;
};

}  // namespace ui
