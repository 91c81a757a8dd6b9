#pragma once

#include <QWidget>

#include "ui/models/stack_model.h"

class QAbstractButton;
class QLabel;

namespace ui {

class TableView;

/// The stack of the board from the top: what every layer is, of what, how thick and how that is known. Thicknesses are
/// edited in the table, and taken back to the job's.
class StackPanel : public QWidget {
    Q_OBJECT

public:
    explicit StackPanel(models::StackModel& model, QWidget* parent = nullptr);

    [[nodiscard]] TableView& table() { return *m_table; }
    /// Says what the table cannot: why it is empty, or how much of it is assumed.
    [[nodiscard]] QString summary() const;

private:
    [[nodiscard]] QAbstractButton* button(const QString& name, const QString& text, const QString& tip,
                                          void (StackPanel::*pressed)());
    void resetSelected();
    void resetAll();
    void updateSummary();

    models::StackModel& m_model;
    TableView* m_table;
    QLabel* m_summary;
};

}  // namespace ui
