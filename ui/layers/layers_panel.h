#pragma once

#include <QWidget>

#include "ui/layers/grouped_layers.h"

class QMenu;
class QToolButton;

namespace ui {

class ActionSet;
class LayerNameDelegate;
class LayerSets;
class TableView;

/// The layers of the board in groups: visibility, colour, opacity, solo; with a menu of sets to show at once.
class LayersPanel : public QWidget {
    Q_OBJECT

public:
    LayersPanel(LayerModel& model, const ActionSet& actions, QWidget* parent = nullptr);

    /// Lets the button above the table open the menu of `sets`, with the name of the one that is shown.
    void setSets(LayerSets& sets);
    /// Lets a button above the table, and a right click, open this menu.
    void setBoardColours(QMenu& menu);
    /// The one that is selected; of several the one the cursor is on. None if there is none.
    [[nodiscard]] model::LayerId currentLayer() const;
    /// Unfolds its group.
    void select(model::LayerId layer);
    /// None is the current one any more.
    void deselect();
    /// Moves to the next visible layer `by` rows on (1 or -1) in the order of the stackup, or stays at the last one.
    /// While a layer is shown alone, all layers of the board count, and the one moved to is shown alone instead. Layers
    /// that draw nothing are passed over.
    void step(int by);
    /// Goes to the uppermost or the lowest copper and shows it, alone where another layer is.
    void goToOuterCopper(bool isTop);
    [[nodiscard]] TableView& table() { return *m_table; }
    [[nodiscard]] GroupedLayers& rows() { return *m_rows; }

signals:
    void currentChanged();

protected:
    /// Space shows and hides the selected layers, Enter edits the colour or folds a group; keys of an open editor are
    /// its own. The table's room decides which columns there are.
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    void setUpTable();
    void fitColumns();
    void widenHeadings();
    void showTypesIfThereIsRoom();
    void makeCurrent(model::LayerId layer);
    [[nodiscard]] bool handleKey(int key);
    void toggleFold(const QModelIndex& index);
    void toggleSelected();
    void chooseColour(const QModelIndex& index);
    void showMenu(const QPoint& at);

    LayerModel& m_model;
    const ActionSet& m_actions;
    GroupedLayers* m_rows;
    TableView* m_table;
    LayerNameDelegate* m_names;
    QToolButton* m_sets;
    QToolButton* m_boardColours;
    int m_typeWidth = 0;  ///< pixels
    int m_nameWidth = 0;  ///< of the longest
};

}  // namespace ui
