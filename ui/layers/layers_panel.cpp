#include "ui/layers/layers_panel.h"

#include <QColorDialog>
#include <QHeaderView>
#include <QKeyEvent>
#include <algorithm>

#include "ui/common/panel_parts.h"
#include "ui/common/table_view.h"
#include "ui/workspace/actions.h"

namespace ui {

LayersPanel::LayersPanel(LayerModel& model, const ActionSet& actions, QWidget* parent)
    : QWidget(parent), m_model(model), m_table(new TableView(model)) {
    m_table->setTextElideMode(Qt::ElideMiddle);  // long names differ at their ends
    m_table->installEventFilter(this);
    connect(m_table, &QTableView::clicked, this, &LayersPanel::chooseColour);
    connect(&model, &QAbstractItemModel::modelReset, this, &LayersPanel::fitColumns);
    connect(m_table->selectionModel(), &QItemSelectionModel::currentRowChanged, this, &LayersPanel::currentChanged);
    auto* column = columnIn(*this);
    column->addLayout(buttonRow({&actions[ActionId::ShowAllLayers], &actions[ActionId::HideAllLayers],
                                 &actions[ActionId::ShowCopperOnly], &actions[ActionId::RestoreLayers]}));
    column->addWidget(m_table);
    fitColumns();
}

void LayersPanel::fitColumns() {
    m_table->resizeColumnsToContents();
    QHeaderView& header = *m_table->horizontalHeader();
    const int letter = fontMetrics().horizontalAdvance('0');
    header.setMinimumSectionSize(letter * 5);
    // Names come first, up to a length; types take what is left and are in the tips.
    m_table->setColumnWidth(LayerModel::Name, std::min(m_table->columnWidth(LayerModel::Name), letter * 16));
    header.setSectionResizeMode(LayerModel::Type, QHeaderView::Stretch);
    m_table->setColumnWidth(LayerModel::Opacity, fontMetrics().horizontalAdvance("  " + tr("Opacity") + "  "));
}

model::LayerId LayersPanel::currentLayer() const {
    const QModelIndex current = m_table->currentIndex();
    return current.isValid() ? model::LayerId{static_cast<std::size_t>(current.row())} : model::LayerId{};
}

void LayersPanel::selectRow(int row) {
    m_table->selectRow(row);
}

void LayersPanel::step(int by) {
    const bool isSolo = m_model.soloLayer().isValid();
    const QModelIndex current = m_table->currentIndex();
    for (int row = current.isValid() ? current.row() + by : 0; row >= 0 && row < m_model.rowCount(); row += by) {
        const bool isShown = m_model.index(row, LayerModel::Visible).data(Qt::CheckStateRole).toInt() == Qt::Checked;
        if (isShown || isSolo) {
            selectRow(row);
            if (isSolo) {
                m_model.toggleSolo(currentLayer());
            }
            return;
        }
    }
}

bool LayersPanel::eventFilter(QObject* watched, QEvent* event) {
    if (watched == m_table && event->type() == QEvent::KeyPress) {
        const QModelIndex current = m_table->currentIndex();
        const int key = static_cast<QKeyEvent*>(event)->key();
        const bool isEnter = key == Qt::Key_Return || key == Qt::Key_Enter;
        if (key == Qt::Key_Space && current.column() != LayerModel::Solo) {
            toggleSelected();
            return true;
        }
        if (isEnter && current.column() == LayerModel::Colour) {
            chooseColour(current);
            return true;
        }
        // The Enter that ends an editor arrives here too.
        if (isEnter && current.column() == LayerModel::Opacity && !m_table->isPersistentEditorOpen(current)) {
            m_table->edit(current);
            return true;
        }
    }
    return QWidget::eventFilter(watched, event);
}

void LayersPanel::toggleSelected() {
    const QModelIndexList rows = m_table->selectionModel()->selectedRows(LayerModel::Visible);
    if (rows.isEmpty()) {
        return;
    }
    // All follow the first, so that a mixed selection becomes uniform.
    const bool wasShown = rows.first().data(Qt::CheckStateRole).toInt() == Qt::Checked;
    for (const QModelIndex& row : rows) {
        m_model.setData(row, wasShown ? Qt::Unchecked : Qt::Checked, Qt::CheckStateRole);
    }
}

void LayersPanel::chooseColour(const QModelIndex& index) {
    if (index.column() != LayerModel::Colour || findChild<QColorDialog*>() != nullptr) {
        return;
    }
    const QPersistentModelIndex cell = index;  // the board may be replaced while the dialog is open
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
