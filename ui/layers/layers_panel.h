#pragma once

#include <QWidget>

#include "ui/layers/layer_model.h"

namespace ui {

class ActionSet;
class TableView;

/// The layers of the board: visibility, colour, opacity, solo; with buttons for all of them at once.
class LayersPanel : public QWidget {
    Q_OBJECT

public:
    LayersPanel(LayerModel& model, const ActionSet& actions, QWidget* parent = nullptr);

    /// The row the cursor is on; none if there is none.
    [[nodiscard]] model::LayerId currentLayer() const;
    void selectRow(int row);
    /// Moves to the next visible layer `by` rows on (1 or -1), or stays at the last one. While a layer is shown alone,
    /// all layers of the board count, and the one moved to is shown alone instead.
    void step(int by);
    [[nodiscard]] TableView& table() { return *m_table; }

signals:
    void currentChanged();

protected:
    /// Space shows and hides the selected layers, Enter edits the colour.
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    void fitColumns();
    void toggleSelected();
    void chooseColour(const QModelIndex& index);

    LayerModel& m_model;
    TableView* m_table;
};

}  // namespace ui
