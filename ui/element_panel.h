#pragma once

#include <QWidget>

#include "ui/models/lengths.h"
#include "ui/models/selection_model.h"

class QLabel;
class QTableWidget;

namespace ui {

/// Everything known of the element selected last, one line per fact; a line copies with Ctrl+C. Says how many are
/// selected when there are several.
class ElementPanel : public QWidget {
    Q_OBJECT

public:
    explicit ElementPanel(models::SelectionModel& selection, QWidget* parent = nullptr);

    void setUnit(models::LengthUnit unit);
    /// Empty when there is no such line.
    [[nodiscard]] QString fact(const QString& name) const;
    [[nodiscard]] QString heading() const;

private:
    void update();

    models::SelectionModel& m_selection;
    models::LengthUnit m_unit = models::LengthUnit::Millimetre;
    QLabel* m_heading;
    QTableWidget* m_table;
};

}  // namespace ui
