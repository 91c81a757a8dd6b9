#pragma once

#include <QWidget>

#include "ui/stackup/stackup_model.h"

class QLabel;
class QSplitter;

namespace ui {

class ActionSet;
class StackupView;
class TableView;

/// The stackup of the board from the top, drawn and as a table: what every layer is, of what, how thick and how that is
/// known. Thicknesses are edited in the table, and taken back to the job's.
class StackupPanel : public QWidget {
    Q_OBJECT

public:
    StackupPanel(StackupModel& model, const ActionSet& actions, QWidget* parent = nullptr);

    [[nodiscard]] TableView& table() { return *m_table; }
    [[nodiscard]] StackupView& view() { return *m_view; }

protected:
    /// Drawing and table side by side where there is width, else one above the other.
    void resizeEvent(QResizeEvent* event) override;

private:
    [[nodiscard]] QWidget* drawingHalf(const ActionSet& actions);
    [[nodiscard]] QWidget* tableHalf();
    void updateSummary();

    StackupModel& m_model;
    StackupView* m_view;
    TableView* m_table;
    QSplitter* m_halves;
    QLabel* m_summary;  ///< what the table cannot say: why it is empty, or how much of it is assumed
};

}  // namespace ui
