#pragma once

#include <QObject>
#include <QUndoStack>
#include <functional>

#include "model/measure/local_spacing.h"
#include "ui/clearance/clearance_checker.h"
#include "ui/clearance/clearance_map_overlay.h"
#include "ui/clearance/clearance_panel.h"
#include "ui/clearance/lens.h"
#include "ui/views/plan_painter.h"
#include "ui/views/probing.h"

namespace ui {

/// Where copper is narrow, from the question to the place on the screen: searches in the background, a panel to step
/// through what was found, rules with their files and on the history, the lens and the distance map. While a place is
/// shown both views are there, and the layers of its two sides stand out, whatever is checked and whatever covers them;
/// all is as before once something else is selected, or nothing.
class Clearances : public QObject {
    Q_OBJECT

public:
    Clearances(BoardViews& views, Probing& probing, SelectionModel& selection, const PlanPainter& plan,
               const ActionSet& actions, QUndoStack& history, QObject* parent = nullptr);

    void setBoard(const LoadedBoard& board);
    void setUnit(LengthUnit unit);
    /// Asked when the current layer is searched or mapped.
    void setCurrentLayer(std::function<model::LayerId()> layer) { m_currentLayer = std::move(layer); }

    /// Looks for what the panel asks for.
    void measure();
    void cancel() { m_checker.cancel(); }
    [[nodiscard]] bool isMeasuring() const { return m_checker.isChecking(); }
    /// Shows the next place of the table, or with -1 the one before.
    void step(int by);
    /// Opens a dialog; what is accepted counts.
    void editRules(QWidget& parent);
    /// Writes what the last search found, as the command line does, in the format of the name's ending (.txt, .csv,
    /// .json). Errors: BadUsage for another ending or without a search, OutputFailed.
    [[nodiscard]] base::Status exportReport(const QString& path) const;
    /// Errors: BadInput, OutputFailed; the rules are then what they were.
    [[nodiscard]] base::Status openRules(const QString& path);
    [[nodiscard]] base::Status saveRules(const QString& path) const;

    /// Belongs to whoever shows it.
    [[nodiscard]] ClearancePanel& panel() { return *m_panel; }
    [[nodiscard]] ClearanceModel& locations() { return m_locations; }
    [[nodiscard]] RuleModel& rules() { return m_rules; }
    [[nodiscard]] Lens& lens() { return m_lens; }
    [[nodiscard]] ClearanceMapOverlay& distances() { return m_distances; }

signals:
    void started();
    void progressed(const QString& phase, double fraction);
    /// A search is over: what came out, in words.
    void finished(const QString& summary);
    void failed(const QString& reason);
    /// The gap of a place is to be drawn; none: no longer.
    void spacingShown(const std::optional<model::LocalSpacing>& gap);

private:
    /// None if the question cannot be asked; that was told.
    [[nodiscard]] std::optional<ClearanceRequest> request();
    void take(const std::shared_ptr<const model::Document>& board, const ClearanceRequest& request,
              const ClearanceResult& answer);
    /// Until something else is selected.
    void show(const ClearanceModel::Location& location);
    void endShowing();
    /// On the history, that the rules are others than before.
    void remember(const model::RuleTable& before);
    void connectDistances();
    [[nodiscard]] model::LayerId mappedLayer() const;

    BoardViews& m_views;
    Probing& m_probing;
    SelectionModel& m_selection;
    const PlanPainter& m_plan;
    QUndoStack& m_history;
    ClearanceModel m_locations;
    RuleModel m_rules;
    ClearanceChecker m_checker;
    Lens m_lens;
    ClearanceMapOverlay m_distances;
    ClearancePanel* m_panel;
    std::function<model::LayerId()> m_currentLayer;
    std::shared_ptr<const model::Document> m_board;
    std::optional<ClearanceRequest> m_asked;  ///< what was searched for last, and what was found in m_board
    ClearanceResult m_result;
    bool m_isShowing = false;
    std::vector<model::BoardElement> m_sides;  ///< of what is shown, as they are selected
    LengthUnit m_unit = LengthUnit::Millimetre;
};

}  // namespace ui
