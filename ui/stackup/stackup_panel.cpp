#include "ui/stackup/stackup_panel.h"

#include <QAction>
#include <QLabel>
#include <QScrollArea>
#include <QSplitter>
#include <numeric>

#include "ui/common/panel_parts.h"
#include "ui/common/table_view.h"
#include "ui/stackup/stackup_view.h"
#include "ui/workspace/actions.h"

namespace ui {

StackupPanel::StackupPanel(StackupModel& model, const ActionSet& actions, QWidget* parent)
    : QWidget(parent),
      m_model(model),
      m_view(new StackupView),
      m_table(new TableView(model)),
      m_halves(new QSplitter),
      m_summary(new QLabel) {
    m_table->setEditTriggers(m_table->editTriggers() | QAbstractItemView::AnyKeyPressed);
    m_table->fitColumns(StackupModel::MaterialName);
    connect(&model, &QAbstractItemModel::modelReset, this, &StackupPanel::updateSummary);
    connect(&model, &QAbstractItemModel::dataChanged, this, &StackupPanel::updateSummary);

    m_halves->addWidget(drawingHalf(actions));
    m_halves->addWidget(tableHalf());
    m_halves->setStretchFactor(0, 3);
    m_halves->setStretchFactor(1, 2);
    columnIn(*this)->addWidget(m_halves);
}

QWidget* StackupPanel::drawingHalf(const ActionSet& actions) {
    auto* scroll = new QScrollArea;
    scroll->setWidget(m_view);
    scroll->setWidgetResizable(true);
    scroll->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    return panelOf(buttonRow({&actions[ActionId::ExaggerateCopper], &actions[ActionId::ExportStackup]}), scroll, 0);
}

QWidget* StackupPanel::tableHalf() {
    QAction* selected =
        command(*this, "resetSelected", tr("Reset"), tr("Reset the selected layers to the job's thickness"),
                [this] { m_model.reset(m_table->selectedRows()); });
    QAction* all = command(*this, "resetAll", tr("Reset all"), tr("Reset all layers to the job's thickness"), [this] {
        std::vector<int> rows(static_cast<std::size_t>(m_model.rowCount()));
        std::iota(rows.begin(), rows.end(), 0);
        m_model.reset(rows);
    });
    auto* row = buttonRow({selected, all});
    m_summary->setObjectName(QStringLiteral("stackupSummary"));
    m_summary->setMinimumWidth(1);  // the panel is not made wider for it
    row->addWidget(m_summary, 1);
    return panelOf(row, m_table, 0);
}

void StackupPanel::resizeEvent(QResizeEvent* event) {
    m_halves->setOrientation(width() > 2 * height() ? Qt::Horizontal : Qt::Vertical);
    QWidget::resizeEvent(event);
}

void StackupPanel::updateSummary() {
    int assumed = 0;
    for (int row = 0; row < m_model.rowCount(); ++row) {
        assumed += m_model.row(row).source == model::Source::Assumed ? 1 : 0;
    }
    m_summary->setText(m_model.rowCount() == 0 ? tr("This board states its heights itself")
                       : assumed == 0          ? QString()
                                      : tr("%1 of %2 thicknesses assumed").arg(assumed).arg(m_model.rowCount()));
}

}  // namespace ui
