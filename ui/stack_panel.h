#pragma once

#include <QWidget>

#include "ui/models/stack_model.h"

class QAbstractButton;
class QLabel;
class QSplitter;

namespace ui {

class ActionSet;
class StackView;
class TableView;

/// The stack of the board from the top, drawn and as a table: what every layer is, of what, how thick and how that is
/// known. Thicknesses are edited in the table, and taken back to the job's.
class StackPanel : public QWidget {
    Q_OBJECT

public:
    StackPanel(models::StackModel& model, const ActionSet& actions, QWidget* parent = nullptr);

    [[nodiscard]] TableView& table() { return *m_table; }
    [[nodiscard]] StackView& view() { return *m_view; }
    /// Says what the table cannot: why it is empty, or how much of it is assumed.
    [[nodiscard]] QString summary() const;

protected:
    /// Drawing and table side by side where there is width, else one above the other.
    void resizeEvent(QResizeEvent* event) override;

private:
    [[nodiscard]] QWidget* drawingHalf(const ActionSet& actions);
    [[nodiscard]] QWidget* tableHalf();
    [[nodiscard]] QAbstractButton* button(const QString& name, const QString& text, const QString& tip,
                                          void (StackPanel::*pressed)());
    void resetSelected();
    void resetAll();
    void updateSummary();

    models::StackModel& m_model;
    StackView* m_view;
    TableView* m_table;
    QSplitter* m_halves;
    QLabel* m_summary;
};

}  // namespace ui
