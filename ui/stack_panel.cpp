#include "ui/stack_panel.h"

#include <QHBoxLayout>
#include <QHeaderView>
#include <QItemSelectionModel>
#include <QLabel>
#include <QToolButton>
#include <QVBoxLayout>
#include <numeric>

#include "ui/table_view.h"

namespace ui {

using models::StackModel;

StackPanel::StackPanel(StackModel& model, QWidget* parent)
    : QWidget(parent), m_model(model), m_table(new TableView), m_summary(new QLabel) {
    m_table->setModel(&model);
    m_table->setEditTriggers(QAbstractItemView::EditKeyPressed | QAbstractItemView::DoubleClicked |
                             QAbstractItemView::AnyKeyPressed);
    m_table->horizontalHeader()->setSectionResizeMode(StackModel::MaterialName, QHeaderView::Stretch);
    connect(&model, &QAbstractItemModel::modelReset, m_table, &QTableView::resizeColumnsToContents);
    connect(&model, &QAbstractItemModel::modelReset, this, &StackPanel::updateSummary);
    connect(&model, &QAbstractItemModel::dataChanged, this, &StackPanel::updateSummary);

    auto* row = new QHBoxLayout;
    row->addWidget(button(QStringLiteral("resetSelected"), QStringLiteral("Reset selected"),
                          QStringLiteral("The selected layers as thick as the job says"), &StackPanel::resetSelected));
    row->addWidget(button(QStringLiteral("resetAll"), QStringLiteral("Reset all"),
                          QStringLiteral("All layers as thick as the job says"), &StackPanel::resetAll));
    row->addStretch();
    row->addWidget(m_summary);
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(2, 2, 2, 2);
    layout->setSpacing(2);
    layout->addLayout(row);
    layout->addWidget(m_table);
}

QAbstractButton* StackPanel::button(const QString& name, const QString& text, const QString& tip,
                                    void (StackPanel::*pressed)()) {
    auto* made = new QToolButton;
    made->setObjectName(name);
    made->setText(text);
    made->setToolTip(tip);
    made->setAutoRaise(true);
    connect(made, &QToolButton::clicked, this, pressed);
    return made;
}

void StackPanel::resetSelected() {
    std::vector<int> rows;
    for (const QModelIndex& row : m_table->selectionModel()->selectedRows()) {
        rows.push_back(row.row());
    }
    m_model.reset(rows);
}

void StackPanel::resetAll() {
    std::vector<int> rows(static_cast<std::size_t>(m_model.rowCount()));
    std::iota(rows.begin(), rows.end(), 0);
    m_model.reset(rows);
}

void StackPanel::updateSummary() {
    int assumed = 0;
    for (int row = 0; row < m_model.rowCount(); ++row) {
        assumed += m_model.row(row).source == model::Source::Assumed ? 1 : 0;
    }
    m_summary->setText(m_model.rowCount() == 0 ? QStringLiteral("This board states its heights itself")
                       : assumed == 0
                           ? QString()
                           : QStringLiteral("%1 of %2 thicknesses assumed").arg(assumed).arg(m_model.rowCount()));
}

QString StackPanel::summary() const {
    return m_summary->text();
}

}  // namespace ui
