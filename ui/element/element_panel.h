#pragma once

#include <QWidget>

#include "ui/common/display_units.h"
#include "ui/element/fact_model.h"
#include "ui/parts/part_picking.h"
#include "ui/workspace/selection_model.h"

class QLabel;

namespace ui {

class ElementPicture;
class TableView;

/// Everything known of the component that is selected as a whole, or else of the element selected last, one line per
/// fact. Says how many are selected when there are several, and shows it by itself. A click on its layer, net, pin or
/// component, or Enter there, goes on to that; of a net that is highlighted alone a click on one of its pins does.
class ElementPanel : public QWidget {
    Q_OBJECT

public:
    /// Takes the picture over.
    ElementPanel(PartPicking& parts, SelectionModel& selection, ElementPicture* picture, QWidget* parent = nullptr);

    void setUnit(LengthUnit unit);

signals:
    /// Of the element selected last, or of the net; `value` is what the fact says.
    void followed(ui::FactLink link, const QString& value);

protected:
    void changeEvent(QEvent* event) override;
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    void update();
    void fill(Facts facts);
    void follow(const QModelIndex& at);

    PartPicking& m_parts;
    SelectionModel& m_selection;
    LengthUnit m_unit = LengthUnit::Millimetre;
    FactModel m_facts;
    QLabel* m_heading;
    TableView* m_table;
};

}  // namespace ui
