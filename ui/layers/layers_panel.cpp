#include "ui/layers/layers_panel.h"

#include <QColorDialog>
#include <QHeaderView>
#include <QKeyEvent>
#include <QMenu>
#include <QMouseEvent>
#include <QStyleOptionToolButton>
#include <QToolButton>
#include <algorithm>
#include <iterator>

#include "model/board/layers.h"
#include "ui/common/panel_parts.h"
#include "ui/common/table_view.h"
#include "ui/layers/layer_name_delegate.h"
#include "ui/layers/layer_sets.h"
#include "ui/workspace/actions.h"

namespace ui {

namespace {

/// Pixels of a button beside its text.
constexpr int kButtonEdges = 8;
/// In letters: what a name has at least, whatever the width of the panel.
constexpr int kLeastName = 8;

/// Leaves out the middle of a text it has no room for.
class MenuButton : public QToolButton {
    void initStyleOption(QStyleOptionToolButton* option) const override {
        QToolButton::initStyleOption(option);
        option->text =
            fontMetrics().elidedText(option->text, Qt::ElideMiddle, width() - kButtonEdges, Qt::TextShowMnemonic);
    }
};

QToolButton* menuButton(const char* name, const QString& text, const QString& tip) {
    auto* button = new MenuButton;
    button->setObjectName(QLatin1String(name));
    button->setText(text);
    button->setToolTip(tip);
    button->setFocusPolicy(Qt::NoFocus);  // who comes to the panel by keys comes for the layers
    button->setPopupMode(QToolButton::InstantPopup);
    return button;
}

}  // namespace

LayersPanel::LayersPanel(LayerModel& model, const ActionSet& actions, QWidget* parent)
    : QWidget(parent),
      m_model(model),
      m_actions(actions),
      m_rows(new GroupedLayers(model, this)),
      m_table(new TableView(model)),
      m_names(new LayerNameDelegate(m_table)),
      m_sets(menuButton("layerSets", tr("Layer set"),
                        tr("Show a set of layers; save the visible ones as a set of your own"))),
      m_boardColours(menuButton("boardColours", tr("Colours"),
                                tr("Colours of solder mask and silkscreen and the surface finish, in 3D"))) {
    setUpTable();
    m_sets->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
    m_sets->setMinimumWidth(1);  // the panel is not made wider for a long name
    auto* controls = new QHBoxLayout;
    controls->addWidget(m_sets);
    controls->addWidget(m_boardColours);
    controls->addLayout(buttonRow({&actions[ActionId::ShowAllLayers], &actions[ActionId::HideAllLayers]}));
    auto* column = columnIn(*this);
    column->addLayout(controls);
    column->addWidget(m_table);
    fitColumns();
}

void LayersPanel::setUpTable() {
    m_table->setModel(m_rows);
    m_table->setButtonColumns({LayerModel::Visible, LayerModel::Colour, LayerModel::Solo});
    m_table->setTextElideMode(Qt::ElideMiddle);
    m_table->setItemDelegateForColumn(LayerModel::Name, m_names);
    m_table->setContextMenuPolicy(Qt::CustomContextMenu);
    m_table->installEventFilter(this);
    m_table->viewport()->installEventFilter(this);
    connect(m_table, &QWidget::customContextMenuRequested, this, &LayersPanel::showMenu);
    connect(m_table, &QTableView::clicked, this, &LayersPanel::chooseColour);
    connect(m_table, &QTableView::clicked, this, &LayersPanel::toggleFold);
    connect(m_rows, &QAbstractItemModel::modelReset, this, &LayersPanel::fitColumns);
    connect(m_table->selectionModel(), &QItemSelectionModel::currentRowChanged, this, &LayersPanel::currentChanged);
    connect(m_table->selectionModel(), &QItemSelectionModel::selectionChanged, this, &LayersPanel::currentChanged);
}

void LayersPanel::setSets(LayerSets& sets) {
    m_sets->setMenu(&sets.menu());
    const auto showName = [this, &sets] {
        m_sets->setEnabled(m_model.document() != nullptr);
        QString name = sets.shownName();
        m_sets->setText(name.isEmpty() ? tr("Layer set") : name.replace('&', QLatin1String("&&")));
    };
    connect(&sets, &LayerSets::changed, m_sets, showName);
    showName();
}

void LayersPanel::setBoardColours(QMenu& menu) {
    m_boardColours->setMenu(&menu);
    const auto enable = [this] { m_boardColours->setEnabled(m_model.document() != nullptr); };
    connect(&m_model, &QAbstractItemModel::modelReset, m_boardColours, enable);
    enable();
}

void LayersPanel::fitColumns() {
    QHeaderView& header = *m_table->horizontalHeader();
    const QFontMetrics letters = fontMetrics();
    header.setMinimumSectionSize(letters.horizontalAdvance('0') * 4);
    m_table->resizeColumnsToContents();
    m_nameWidth = letters.horizontalAdvance('0') * kLeastName;
    m_typeWidth = 0;
    QStringList names;
    for (int row = 0; row < m_model.rowCount(); ++row) {
        names += m_model.index(row, LayerModel::Name).data().toString();
        const auto widthOf = [&](int column) {
            return letters.horizontalAdvance(m_model.index(row, column).data().toString() + QStringLiteral("MM"));
        };
        m_nameWidth = std::max(m_nameWidth, widthOf(LayerModel::Name));
        m_typeWidth = std::max(m_typeWidth, widthOf(LayerModel::Type));
    }
    m_names->setNames(std::move(names));
    // Names take what is left: they are what is looked for. Types are also in the headings and tips.
    header.setSectionResizeMode(LayerModel::Name, QHeaderView::Stretch);
    m_table->setColumnWidth(LayerModel::Type, m_typeWidth);
    m_table->setColumnWidth(LayerModel::Opacity, letters.horizontalAdvance(" " + tr("Opacity") + " "));
    showTypesIfThereIsRoom();
    widenHeadings();
}

/// A heading has no opacity and no solo: it takes their room. The table moves what is wide along with its row.
void LayersPanel::widenHeadings() {
    m_table->clearSpans();
    for (int row = 0; row < m_rows->rowCount(); ++row) {
        if (m_rows->isHeading(row)) {
            m_table->setSpan(row, LayerModel::Name, 1, LayerModel::Solo - LayerModel::Name + 1);
        }
    }
}

void LayersPanel::showTypesIfThereIsRoom() {
    int taken = m_nameWidth + m_typeWidth;
    for (const int column : {LayerModel::Visible, LayerModel::Colour, LayerModel::Opacity, LayerModel::Solo}) {
        taken += m_table->columnWidth(column);
    }
    m_table->setColumnHidden(LayerModel::Type, taken > m_table->viewport()->width());
}

model::LayerId LayersPanel::currentLayer() const {
    const QItemSelectionModel& selection = *m_table->selectionModel();
    QModelIndex row = m_table->currentIndex();
    if (!row.isValid() || !selection.isRowSelected(row.row())) {
        // A click into a box moves the cursor there and leaves the selection.
        const QModelIndexList rows = selection.selectedRows();
        row = rows.isEmpty() ? QModelIndex() : rows.first();
    }
    const bool isLayer = row.isValid() && !m_rows->isHeading(row.row());
    return isLayer ? m_rows->layersAt(row.row()).front() : model::LayerId{};
}

void LayersPanel::select(model::LayerId layer) {
    const QModelIndex row = m_rows->index(m_rows->reveal(layer), LayerModel::Name);
    // Not QTableView::selectRow, which extends the selection while Shift is held, as it is for +.
    m_table->selectionModel()->setCurrentIndex(row, QItemSelectionModel::ClearAndSelect | QItemSelectionModel::Rows);
    m_table->scrollTo(row);
}

void LayersPanel::deselect() {
    m_table->selectionModel()->clear();
}

void LayersPanel::makeCurrent(model::LayerId layer) {
    const bool isSolo = m_model.soloLayer().isValid();
    select(layer);
    if (isSolo && m_model.soloLayer() != layer) {
        m_model.toggleSolo(layer);
    }
}

void LayersPanel::step(int by) {
    if (!currentLayer().isValid()) {
        goToOuterCopper(true);
        return;
    }
    const bool isSolo = m_model.soloLayer().isValid();
    const std::vector<bool> isVisible = m_model.visibility();
    const auto count = static_cast<int>(isVisible.size());
    for (int row = static_cast<int>(currentLayer().row()) + by; row >= 0 && row < count; row += by) {
        const model::LayerId layer{static_cast<std::size_t>(row)};
        if ((isVisible[layer.row()] || isSolo) && !drawsNothing(m_model.document()->layer(layer))) {
            makeCurrent(layer);
            return;
        }
    }
}

void LayersPanel::goToOuterCopper(bool isTop) {
    if (m_model.document() == nullptr) {
        return;
    }
    const auto face = isTop ? model::LayerSide::Top : model::LayerSide::Bottom;
    if (const model::LayerId outer = model::outerCopper(*m_model.document(), face); outer.isValid()) {
        if (!m_model.soloLayer().isValid()) {
            m_model.show(outer);  // else it is shown alone
        }
        makeCurrent(outer);
    }
}

bool LayersPanel::eventFilter(QObject* watched, QEvent* event) {
    if (watched == m_table->viewport() && event->type() == QEvent::Resize) {
        showTypesIfThereIsRoom();
    } else if (watched == m_table->viewport() && event->type() == QEvent::MouseButtonPress) {
        // Another current layer would be the one that is shown alone; who opens a menu has chosen nothing yet.
        const bool isMenu = static_cast<QMouseEvent*>(event)->button() == Qt::RightButton;
        return (isMenu && m_model.soloLayer().isValid()) || QWidget::eventFilter(watched, event);
    } else if (watched == m_table && event->type() == QEvent::KeyPress) {
        return handleKey(static_cast<QKeyEvent*>(event)->key()) || QWidget::eventFilter(watched, event);
    }
    return QWidget::eventFilter(watched, event);
}

bool LayersPanel::handleKey(int key) {
    if (m_table->isEditing()) {
        return false;  // the Enter that ends an editor arrives here too
    }
    const QModelIndex current = m_table->currentIndex();
    if (key == Qt::Key_Space && current.column() != LayerModel::Solo) {
        toggleSelected();
        return true;
    }
    if ((key != Qt::Key_Return && key != Qt::Key_Enter) || !current.isValid()) {
        return false;
    }
    if (m_rows->isHeading(current.row())) {
        toggleFold(current);
    } else if (current.column() == LayerModel::Colour) {
        chooseColour(current);
    } else if (current.column() == LayerModel::Opacity) {
        m_table->edit(current);
    } else {
        return false;
    }
    return true;
}

void LayersPanel::toggleFold(const QModelIndex& index) {
    if (index.isValid() && m_rows->isHeading(index.row()) && index.column() != LayerModel::Visible) {
        const model::LayerGroup group = m_rows->groupAt(index.row());
        m_rows->fold(group, !m_rows->isFolded(group));
    }
}

void LayersPanel::toggleSelected() {
    std::vector<model::LayerId> layers;
    for (const QModelIndex& row : m_table->selectionModel()->selectedRows()) {
        std::ranges::copy(m_rows->layersAt(row.row()), std::back_inserter(layers));
    }
    if (!layers.empty()) {
        // All follow the first, so that a mixed selection becomes uniform.
        m_model.setVisible(layers, !m_model.visibility()[layers.front().row()]);
    }
}

void LayersPanel::showMenu(const QPoint& at) {
    QMenu menu;
    const QModelIndex index = m_table->indexAt(at);
    if (index.isValid()) {
        const std::vector<model::LayerId> layers = m_rows->layersAt(index.row());
        menu.addAction(m_rows->isHeading(index.row()) ? tr("Show &only this group") : tr("Show &only this layer"), this,
                       [this, layers] { m_model.showLayers(layers); });
        if (!m_rows->isHeading(index.row())) {
            menu.addAction(tr("&Colour…"), this,
                           [this, index] { chooseColour(index.siblingAtColumn(LayerModel::Colour)); });
        }
        menu.addAction(&m_actions[ActionId::Contrast]);
        menu.addSeparator();
    }
    for (const ActionId id : {ActionId::ShowDefaultLayers, ActionId::ShowAllLayers, ActionId::HideAllLayers,
                              ActionId::SaveLayerSet, ActionId::RestoreLayers}) {
        menu.addAction(&m_actions[id]);
    }
    menu.addMenu(m_boardColours->menu());
    m_table->addCopying(menu);
    menu.exec(m_table->viewport()->mapToGlobal(at));
}

void LayersPanel::chooseColour(const QModelIndex& index) {
    if (index.column() != LayerModel::Colour || m_rows->isHeading(index.row()) ||
        findChild<QColorDialog*>() != nullptr) {
        return;
    }
    const QPersistentModelIndex cell =
        m_rows->mapToSource(index);  // the board may be replaced while the dialog is open
    const QColor before = index.data(Qt::EditRole).value<QColor>();
    const auto set = [this, cell](const QColor& colour) {
        if (cell.isValid()) {
            m_model.setData(cell, colour, Qt::EditRole);
        }
    };
    auto* dialog = new QColorDialog(before, this);
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    dialog->setWindowTitle(tr("Colour of the layer"));
    connect(dialog, &QColorDialog::currentColorChanged, this, set);
    connect(dialog, &QColorDialog::rejected, this, [set, before] { set(before); });
    dialog->open();
}

}  // namespace ui
