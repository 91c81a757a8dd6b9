#include "ui/parts/parts_panel.h"

#include <QComboBox>
#include <QHeaderView>
#include <QLabel>
#include <QScopedValueRollback>

#include "ui/common/panel_parts.h"

namespace ui {

namespace {

/// In letters; together they fit under the views of a window of 1280 pixels.
constexpr std::pair<PartModel::Column, int> kWidths[] = {
    {PartModel::Designator, 9}, {PartModel::Part, 13}, {PartModel::Attributes, 14}, {PartModel::Package, 13},
    {PartModel::Side, 7},       {PartModel::X, 12},    {PartModel::Y, 12},          {PartModel::Rotation, 8},
    {PartModel::Height, 10},    {PartModel::Pins, 5},  {PartModel::Fitted, 6},
};

/// What most people look for first.
constexpr const char* kFirstAttribute = "value";

}  // namespace

PartsPanel::PartsPanel(PartModel& model, PartPicking& parts, QWidget* parent)
    : QWidget(parent),
      m_model(model),
      m_parts(parts),
      m_table(new LinkedTable(model)),
      m_attribute(new QComboBox),
      m_count(new QLabel) {
    setUpTable();
    layOut();
    connect(m_table, &LinkedTable::rowsSelected, this, &PartsPanel::takeRows);
    connect(m_table, &LinkedTable::filtered, this, &PartsPanel::showCount);
    connect(m_table, &QTableView::activated, this, [this] {
        if (const std::vector<int> rows = m_table->selectedRows(); !rows.empty()) {
            m_parts.showSelected();
        }
    });
    connect(m_attribute, &QComboBox::currentIndexChanged, this,
            [this] { m_model.setAttribute(m_attribute->currentData().toString()); });
    connect(&parts, &PartPicking::changed, this, &PartsPanel::markChosen);
}

void PartsPanel::setUpTable() {
    const int letter = fontMetrics().horizontalAdvance('0');
    for (const auto& [column, letters] : kWidths) {
        m_table->setColumnWidth(column, letter * letters);
    }
    m_table->setColumnHidden(PartModel::Step, true);
    m_table->horizontalHeader()->setStretchLastSection(true);
}

void PartsPanel::layOut() {
    m_attribute->setObjectName(QStringLiteral("partAttribute"));
    m_attribute->setToolTip(tr("Which attribute of the components the table shows"));
    m_attribute->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
    m_attribute->setMinimumContentsLength(14);
    m_count->setObjectName(QStringLiteral("partsShown"));
    QLineEdit* filter = m_table->makeFilter(tr("Filter by designator, part, package or any attribute"));
    filter->setObjectName(QStringLiteral("partFilter"));
    auto* controls = new QHBoxLayout;
    controls->addWidget(filter, 1);
    controls->addWidget(m_attribute);
    controls->addWidget(toolButton(*command(*this, "exportParts", tr("Export…"),
                                            tr("Export the rows as they are shown, as a table (CSV)"),
                                            [this] { emit exportRequested(); })));
    controls->addWidget(m_count);
    auto* column = columnIn(*this);
    column->addLayout(controls);
    column->addWidget(m_table);
}

void PartsPanel::setBoard(std::shared_ptr<const model::Document> board) {
    m_model.setBoard(std::move(board));
    m_table->setColumnHidden(PartModel::Step, !m_model.hasSeveralSteps());
    m_table->setColumnHidden(PartModel::Height, !m_model.hasHeights());
    listAttributes();
    showCount();
    markChosen();
}

void PartsPanel::listAttributes() {
    const QString before = m_attribute->currentData().toString();
    const QSignalBlocker blocker(m_attribute);
    m_attribute->clear();
    m_attribute->addItem(tr("All attributes"));
    for (const QString& name : m_model.attributeNames()) {
        m_attribute->addItem(name, name);
    }
    const int same = before.isEmpty() ? -1 : m_attribute->findData(before);
    const int first = m_attribute->findData(QLatin1String(kFirstAttribute), Qt::UserRole, Qt::MatchFixedString);
    m_attribute->setCurrentIndex(same >= 0 ? same : std::max(first, 0));
    m_model.setAttribute(m_attribute->currentData().toString());
}

void PartsPanel::showCount() {
    const QString count = tr("%L1 of %L2").arg(m_table->model()->rowCount()).arg(m_model.rowCount());
    QStringList texts = m_model.missing();
    if (m_model.rowCount() > 0) {
        texts.prepend(count);
    }
    m_count->setText(texts.join(QStringLiteral(" · ")));
}

void PartsPanel::takeRows(const std::vector<int>& rows) {
    const QScopedValueRollback guard(m_isTaking, true);
    std::vector<BoardPart> parts;
    for (const int row : rows) {
        parts.push_back(m_model.partAt(row));
    }
    m_parts.select(parts);
    if (m_showsChosen && parts.size() == 1) {
        m_parts.showSelected();
    }
}

void PartsPanel::markChosen() {
    if (m_isTaking) {
        return;
    }
    std::vector<int> rows;
    for (const BoardPart& part : m_parts.parts()) {
        if (const std::optional<int> row = m_model.rowOf(part)) {
            rows.push_back(*row);
        }
    }
    m_table->mark(std::move(rows));
}

}  // namespace ui
