#pragma once

#include <QWidget>

#include "ui/models/layer_model.h"

class QColorDialog;

namespace ui {

class ActionSet;
class TableView;

/// The layers of the board: visibility, colour, opacity, solo; with buttons for all of them at once.
class LayersPanel : public QWidget {
    Q_OBJECT

public:
    LayersPanel(models::LayerModel& model, const ActionSet& actions, QWidget* parent = nullptr);

    /// The row the cursor is on; none if there is none.
    [[nodiscard]] model::LayerId currentLayer() const;
    void selectRow(int row);
    [[nodiscard]] TableView& table() { return *m_table; }

protected:
    /// Space shows and hides the selected layers, Enter edits the colour.
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    void fitColumns();
    void toggleSelected();
    void chooseColour(const QModelIndex& index);

    models::LayerModel& m_model;
    TableView* m_table;
};

}  // namespace ui
