#include "ui/stackup/stackup_panel.h"

#include <QHBoxLayout>
#include <QHeaderView>
#include <QItemSelectionModel>
#include <QLabel>
#include <QScrollArea>
#include <QSplitter>
#include <QVBoxLayout>
#include <numeric>

#include "ui/common/table_view.h"
#include "ui/common/tool_button.h"
#include "ui/stackup/stackup_view.h"
#include "ui/workspace/actions.h"

namespace ui {

namespace {

/// A row of buttons over a widget.
QWidget* halfOf(QHBoxLayout* row, QWidget* widget) {
    auto* half = new QWidget;
    auto* layout = new QVBoxLayout(half);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(2);
    layout->addLayout(row);
    layout->addWidget(widget);
    return half;
}

}  // namespace

StackupPanel::StackupPanel(StackupModel& model, const ActionSet& actions, QWidget* parent)
    : QWidget(parent),
      m_model(model),
      m_view(new StackupView),
      m_table(new TableView),
      m_halves(new QSplitter),
      m_summary(new QLabel) {
    m_table->setModel(&model);
    m_table->setEditTriggers(QAbstractItemView::EditKeyPressed | QAbstractItemView::DoubleClicked |
                             QAbstractItemView::AnyKeyPressed);
    m_table->horizontalHeader()->setSectionResizeMode(StackupModel::MaterialName, QHeaderView::Stretch);
    connect(&model, &QAbstractItemModel::modelReset, m_table, &QTableView::resizeColumnsToContents);
    connect(&model, &QAbstractItemModel::modelReset, this, &StackupPanel::updateSummary);
    connect(&model, &QAbstractItemModel::dataChanged, this, &StackupPanel::updateSummary);

    m_halves->addWidget(drawingHalf(actions));
    m_halves->addWidget(tableHalf());
    m_halves->setStretchFactor(0, 3);
    m_halves->setStretchFactor(1, 2);
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(2, 2, 2, 2);
    layout->addWidget(m_halves);
}

QWidget* StackupPanel::drawingHalf(const ActionSet& actions) {
    auto* row = new QHBoxLayout;
    for (const ActionId id : {ActionId::ExaggerateCopper, ActionId::ExportStackup}) {
        row->addWidget(toolButton(actions[id]));
    }
    row->addStretch();
    auto* scroll = new QScrollArea;
    scroll->setWidget(m_view);
    scroll->setWidgetResizable(true);
    scroll->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    return halfOf(row, scroll);
}

QWidget* StackupPanel::tableHalf() {
    auto* row = new QHBoxLayout;
    row->addWidget(button(QStringLiteral("resetSelected"), QStringLiteral("Reset"),
                          QStringLiteral("The selected layers as thick as the job says"),
                          &StackupPanel::resetSelected));
    row->addWidget(button(QStringLiteral("resetAll"), QStringLiteral("Reset all"),
                          QStringLiteral("All layers as thick as the job says"), &StackupPanel::resetAll));
    m_summary->setMinimumWidth(1);  // the panel is not made wider for it
    row->addWidget(m_summary, 1);
    return halfOf(row, m_table);
}

QAbstractButton* StackupPanel::button(const QString& name, const QString& text, const QString& tip,
                                      void (StackupPanel::*pressed)()) {
    auto* made = new QToolButton;
    made->setObjectName(name);
    made->setText(text);
    made->setToolTip(tip);
    made->setAutoRaise(true);
    connect(made, &QToolButton::clicked, this, pressed);
    return made;
}

void StackupPanel::resetSelected() {
    std::vector<int> rows;
    for (const QModelIndex& row : m_table->selectionModel()->selectedRows()) {
        rows.push_back(row.row());
    }
    m_model.reset(rows);
}

void StackupPanel::resetAll() {
    std::vector<int> rows(static_cast<std::size_t>(m_model.rowCount()));
    std::iota(rows.begin(), rows.end(), 0);
    m_model.reset(rows);
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
    m_summary->setText(m_model.rowCount() == 0 ? QStringLiteral("This board states its heights itself")
                       : assumed == 0
                           ? QString()
                           : QStringLiteral("%1 of %2 thicknesses assumed").arg(assumed).arg(m_model.rowCount()));
}

QString StackupPanel::summary() const {
    return m_summary->text();
}

}  // namespace ui
