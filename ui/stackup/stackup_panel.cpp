#include "ui/stackup/stackup_panel.h"

#include <QAction>
#include <QHeaderView>
#include <QLabel>
#include <QScrollArea>
#include <QScrollBar>
#include <QSplitter>

#include "ui/common/elided_label.h"
#include "ui/common/panel_parts.h"
#include "ui/common/table_view.h"
#include "ui/common/thickness_text.h"
#include "ui/stackup/stackup_view.h"
#include "ui/workspace/actions.h"

namespace ui {

namespace {

/// So many findings are seen at once.
constexpr int kFindingLines = 4;

}  // namespace

StackupPanel::StackupPanel(StackupModel& model, const ActionSet& actions, QWidget* parent)
    : QWidget(parent),
      m_model(model),
      m_view(new StackupView),
      m_drawing(new QScrollArea),
      m_table(new TableView(model)),
      m_findingTable(new TableView(m_findings)),
      m_halves(new QSplitter),
      m_commands(toolBar({&actions[ActionId::ExaggerateCopper], &actions[ActionId::ExportStackup]})),
      m_controls(new QBoxLayout(QBoxLayout::LeftToRight)),
      m_total(new QLabel),
      m_summary(new ElidedLabel) {
    m_table->setEditTriggers(m_table->editTriggers() | QAbstractItemView::AnyKeyPressed);
    m_table->fitColumns();
    m_table->horizontalHeader()->setStretchLastSection(true);
    // Beside the name, where a narrow panel still shows it.
    m_table->horizontalHeader()->moveSection(StackupModel::Thickness, StackupModel::Type);
    connect(&model, &QAbstractItemModel::modelReset, this, &StackupPanel::refresh);
    connect(&model, &QAbstractItemModel::dataChanged, this, &StackupPanel::refresh);
    connectRows();

    m_halves->addWidget(drawingHalf());
    m_halves->addWidget(tableHalf());
    m_halves->setStretchFactor(0, 1);
    m_halves->setStretchFactor(1, 1);
    m_halves->setSizes({1'000, 1'000});  // halves, whatever their contents want
    m_halves->setMinimumWidth(1);        // side by side only where there is room, which they do not ask for
    columnIn(*this)->addWidget(m_halves);
    refresh();
}

void StackupPanel::connectRows() {
    connect(m_view, &StackupView::rowChosen, this,
            [this](std::size_t row) { m_table->selectRow(static_cast<int>(row)); });
    connect(m_findingTable, &TableView::rowChosen, this, [this](int row) { selectRows(m_findings.finding(row).rows); });
    connect(m_table->selectionModel(), &QItemSelectionModel::currentRowChanged, this, [this](const QModelIndex& now) {
        const bool isLayer = now.isValid() && !m_model.isTotal(now.row());
        m_view->setSelected(isLayer ? now.row() : -1);
        if (isLayer) {
            emit rowSelected(now.row());
        }
    });
}

/// All that a finding is about; the first of them becomes the current one.
void StackupPanel::selectRows(const std::vector<std::size_t>& rows) {
    QItemSelection selection;
    for (const std::size_t row : rows) {
        const QModelIndex index = m_model.index(static_cast<int>(row), 0);
        selection.select(index, index);
    }
    if (rows.empty()) {
        m_table->clearSelection();
        return;
    }
    const QModelIndex first = m_model.index(static_cast<int>(rows.front()), 0);
    m_table->selectionModel()->setCurrentIndex(first, QItemSelectionModel::NoUpdate);
    m_table->selectionModel()->select(selection, QItemSelectionModel::ClearAndSelect | QItemSelectionModel::Rows);
    m_table->scrollTo(first);
}

void StackupPanel::clearSelection() {
    m_table->setCurrentIndex({});
    m_table->clearSelection();
    m_view->setSelected(-1);  // where the table had none any more, it has not said so
}

void StackupPanel::scrollToTop() {
    m_table->scrollToTop();
    m_findingTable->scrollToTop();
    m_drawing->verticalScrollBar()->setValue(0);
}

void StackupPanel::selectLayer(model::LayerId layer) {
    const int row = m_model.rowOf(layer);
    if (row >= 0 && row != m_table->currentIndex().row()) {
        m_table->selectRow(row);
    }
}

QWidget* StackupPanel::drawingHalf() {
    m_drawing->setWidget(m_view);
    m_drawing->setWidgetResizable(true);
    m_drawing->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    m_controls->addWidget(m_commands, 1);
    m_total->setObjectName(QStringLiteral("stackupTotal"));
    m_total->setSizePolicy(QSizePolicy::Preferred, QSizePolicy::Maximum);  // the height is for the drawing
    m_commands->setSizePolicy(QSizePolicy::Preferred, QSizePolicy::Maximum);
    m_controls->addWidget(m_total);
    return panelOf(m_controls, m_drawing, 0);
}

QWidget* StackupPanel::tableHalf() {
    QAction* selected =
        command(*this, "resetSelected", tr("Reset"), tr("Reset the selected layers to the job's thickness"),
                [this] { m_model.reset(m_table->selectedRows()); });
    QAction* all = command(*this, "resetAll", tr("Reset all"), tr("Reset all layers to the job's thickness"),
                           [this] { m_model.resetAll(); });
    auto* row = buttonRow({selected, all});
    m_summary->setObjectName(QStringLiteral("stackupSummary"));
    row->addWidget(m_summary, 1);
    return panelOf(row, tables(), 0);
}

QWidget* StackupPanel::tables() {
    m_findingTable->setObjectName(QStringLiteral("stackupFindings"));
    m_findingTable->horizontalHeader()->hide();
    m_findingTable->horizontalHeader()->setSectionResizeMode(QHeaderView::Stretch);
    m_findingTable->setWordWrap(true);
    m_findingTable->verticalHeader()->setSectionResizeMode(QHeaderView::ResizeToContents);
    m_findingTable->setSizeAdjustPolicy(QAbstractScrollArea::AdjustToContents);
    m_findingTable->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Maximum);
    m_findingTable->setMaximumHeight(kFindingLines * (fontMetrics().height() + 6) + 4);
    auto* both = new QWidget;
    auto* column = columnIn(*both, 0);
    column->addWidget(m_table, 1);
    column->addWidget(m_findingTable);
    return both;
}

void StackupPanel::resizeEvent(QResizeEvent* event) {
    m_halves->setOrientation(width() > 2 * height() ? Qt::Horizontal : Qt::Vertical);
    arrangeControls();
    QWidget::resizeEvent(event);
}

void StackupPanel::arrangeControls() {
    const int room = m_halves->orientation() == Qt::Horizontal ? width() / 2 : width();
    // The other commands fold into a menu.
    const QWidget& first = *m_commands->widgetForAction(m_commands->actions().front());
    const QWidget& more = *m_commands->findChild<QToolButton*>(QStringLiteral("qt_toolbar_ext_button"));
    const int least = first.sizeHint().width() + more.sizeHint().width() + m_total->sizeHint().width();
    const bool isNarrow = room < least + 3 * fontMetrics().averageCharWidth();
    m_controls->setDirection(isNarrow ? QBoxLayout::TopToBottom : QBoxLayout::LeftToRight);
}

void StackupPanel::refresh() {
    m_findings.setFindings(m_model.findings());
    m_findingTable->setVisible(!m_model.findings().empty());
    updateTotal();
    updateSummary();
}

void StackupPanel::updateTotal() {
    const std::vector<model::Substack>& parts = m_model.substacks();
    QStringList lines;
    for (const model::Substack& part : parts) {
        const QString copper = heightText(part.copperToCopper, m_model.unit());
        const QString overall = heightText(part.overall, m_model.unit());
        lines +=
            part.name.empty()
                ? tr("Copper to copper %1, overall %2").arg(copper, overall)
                : tr("%1: copper to copper %2, overall %3").arg(QString::fromStdString(part.name), copper, overall);
    }
    m_total->setToolTip(lines.join('\n'));
    m_total->setText(parts.empty()       ? QString()
                     : parts.size() == 1 ? tr("Cu to Cu %1").arg(heightText(parts[0].copperToCopper, m_model.unit()))
                                         : tr("%1 zones").arg(parts.size()));
    arrangeControls();
}

void StackupPanel::updateSummary() {
    int assumed = 0;
    for (int row = 0; row < m_model.layerCount(); ++row) {
        assumed += m_model.row(row).source == model::Source::Assumed ? 1 : 0;
    }
    m_summary->setText(m_model.layerCount() == 0 ? tr("This board states its heights itself")
                       : assumed == 0            ? QString()
                                      : tr("%1 of %2 thicknesses assumed").arg(assumed).arg(m_model.layerCount()));
}

}  // namespace ui
