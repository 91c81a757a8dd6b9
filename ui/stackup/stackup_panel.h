#pragma once

#include <QWidget>

#include "ui/stackup/finding_model.h"
#include "ui/stackup/stackup_model.h"

class QBoxLayout;
class QLabel;
class QScrollArea;
class QSplitter;
class QToolBar;

namespace ui {

class ActionSet;
class StackupView;
class TableView;

/// The stackup of the board from the top, drawn and as a table: what every layer is, of what, how thick and how that is
/// known; below it what the checks found. Thicknesses are edited in the table, and taken back to the job's. The table
/// holds which row is selected; drawing and findings select there.
class StackupPanel : public QWidget {
    Q_OBJECT

public:
    StackupPanel(StackupModel& model, const ActionSet& actions, QWidget* parent = nullptr);

    [[nodiscard]] TableView& table() { return *m_table; }
    [[nodiscard]] StackupView& view() { return *m_view; }
    [[nodiscard]] TableView& findings() { return *m_findingTable; }

    /// Selects the row of a layer, if it is in the stackup; the current row is not moved within its layer.
    void selectLayer(model::LayerId layer);
    /// No row is current: those of another board are about to be shown.
    void clearSelection();
    /// Drawing and tables begin at their top: rows of another board would else stay scrolled as those before.
    void scrollToTop();

signals:
    /// Another row is current, by whichever way; never a total.
    void rowSelected(int row);

protected:
    /// Drawing and table side by side where there is width, else one above the other.
    void resizeEvent(QResizeEvent* event) override;

private:
    [[nodiscard]] QWidget* drawingHalf();
    [[nodiscard]] QWidget* tableHalf();
    [[nodiscard]] QWidget* tables();
    void connectRows();
    void selectRows(const std::vector<std::size_t>& rows);
    void refresh();
    void updateTotal();
    /// Commands and total side by side, or below each other in a panel that would cut the commands.
    void arrangeControls();
    void updateSummary();

    StackupModel& m_model;
    FindingModel m_findings;
    StackupView* m_view;
    QScrollArea* m_drawing;  ///< around it
    TableView* m_table;
    TableView* m_findingTable;
    QSplitter* m_halves;
    QToolBar* m_commands;
    QBoxLayout* m_controls;  ///< of the drawing: the commands and the total
    QLabel* m_total;         ///< copper to copper, or how many zones there are
    QLabel* m_summary;       ///< what the table cannot say: why it is empty, or how much of it is assumed
};

}  // namespace ui
