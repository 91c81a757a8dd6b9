#include "ui/parts/parts_panel.h"

#include <QComboBox>
#include <QHeaderView>
#include <QLabel>
#include <QScopedValueRollback>
#include <QSortFilterProxyModel>
#include <algorithm>
#include <iterator>

#include "ui/common/panel_parts.h"
#include "ui/common/table_text.h"

namespace ui {

namespace {

/// In letters; together they fit under the views of a window of 1280 pixels.
constexpr std::pair<int, int> kWidths[] = {
    {PartModel::Designator, 8}, {PartModel::Part, 12}, {PartModel::Attributes, 13}, {PartModel::Package, 11},
    {PartModel::Side, 6},       {PartModel::X, 12},    {PartModel::Y, 12},          {PartModel::Rotation, 8},
    {PartModel::Height, 9},     {PartModel::Pins, 5},  {PartModel::Fitted, 6},
};
constexpr std::pair<int, int> kGroupWidths[] = {
    {PartGroupModel::Quantity, 8},     {PartGroupModel::Part, 20},       {PartGroupModel::Value, 14},
    {PartGroupModel::Package, 18},     {PartGroupModel::Attributes, 14}, {PartGroupModel::Fitted, 6},
    {PartGroupModel::Designators, 20},
};

/// What most people look for first.
constexpr const char* kFirstAttribute = "value";

/// The rows of a table, in their order.
class WithoutColumn : public QSortFilterProxyModel {
public:
    explicit WithoutColumn(int column) : m_column(column) {}

protected:
    [[nodiscard]] bool filterAcceptsColumn(int column, const QModelIndex&) const override { return column != m_column; }

private:
    int m_column;
};

}  // namespace

PartsPanel::PartsPanel(PartModel& model, PartPicking& parts, const ActionSet& actions, QWidget* parent)
    : QWidget(parent),
      m_model(model),
      m_parts(parts),
      m_groups(model),
      m_table(new LinkedTable(model)),
      m_groupTable(new LinkedTable(m_groups)),
      m_attribute(new QComboBox),
      m_count(new QLabel) {
    setUp(*m_table, kWidths, {PartModel::Part, PartModel::Package, PartModel::Attributes});
    setUp(*m_groupTable, kGroupWidths, {PartGroupModel::Part, PartGroupModel::Package, PartGroupModel::Value});
    for (LinkedTable* table : {m_table, m_groupTable}) {
        addRowCommands(*table, actions);
    }
    layOut();
    connect(m_table, &LinkedTable::rowsSelected, this, &PartsPanel::takeParts);
    connect(m_groupTable, &LinkedTable::rowsSelected, this, &PartsPanel::takeGroups);
    connect(m_attribute, &QComboBox::currentIndexChanged, this, [this] {
        m_model.setAttribute(chosenAttribute());
        showColumns();
    });
    connect(&parts, &PartPicking::changed, this, &PartsPanel::markChosen);
}

void PartsPanel::setUp(LinkedTable& table, std::span<const std::pair<int, int>> widths, const std::vector<int>& names) {
    const int letter = fontMetrics().horizontalAdvance('0');
    for (const auto& [column, letters] : widths) {
        table.setColumnWidth(column, letter * letters);
    }
    table.keepNumbersWhole();
    table.giveRoom(names);
    table.horizontalHeader()->setStretchLastSection(true);
    connect(&table, &LinkedTable::filtered, this, &PartsPanel::showCount);
}

/// Enter and a double click do the first of them.
void PartsPanel::addRowCommands(LinkedTable& table, const ActionSet& actions) {
    QAction* show = table.addAction(tr("Show"), this, [this, &table] {
        if (!table.selectedRows().empty()) {
            m_parts.showSelected();
        }
    });
    show->setObjectName(QStringLiteral("show"));
    connect(&table, &QTableView::activated, show, &QAction::trigger);
    table.addAction(&actions[ActionId::HighlightNet]);
    table.addAction(&actions[ActionId::SaveSelection]);
}

void PartsPanel::layOut() {
    m_attribute->setObjectName(QStringLiteral("partAttribute"));
    m_attribute->setToolTip(tr("Which attribute of the components the table shows"));
    m_attribute->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
    m_attribute->setMinimumContentsLength(14);
    m_count->setObjectName(QStringLiteral("partsShown"));
    QLineEdit* filter = m_table->makeFilter(tr("Filter by designator, part, package or any attribute"));
    m_groupTable->filterBy(*filter);
    filter->setObjectName(QStringLiteral("partFilter"));
    auto* grouped = new QAction(tr("Group equal parts"), this);
    grouped->setObjectName(QStringLiteral("groupParts"));
    grouped->setToolTip(tr(
        "Bill of materials: a row with quantity and designators for all components whose part, value and package the "
        "job says alike"));
    grouped->setCheckable(true);
    connect(grouped, &QAction::toggled, this, &PartsPanel::setGrouped);
    auto* controls = new QHBoxLayout;
    controls->addWidget(filter, 1);
    controls->addWidget(m_attribute);
    controls->addWidget(toolButton(*grouped));
    controls->addWidget(toolButton(*command(*this, "exportParts", tr("Export…"),
                                            tr("Export the rows as they are shown, as a table (CSV)"),
                                            [this] { emit exportRequested(); })));
    controls->addWidget(m_count);
    auto* column = columnIn(*this);
    column->addLayout(controls);
    column->addWidget(m_table);
    column->addWidget(m_groupTable);
    m_groupTable->hide();
}

void PartsPanel::setFollows(bool isOn) {
    m_table->setFollows(isOn);
    m_groupTable->setFollows(isOn);
}

void PartsPanel::setGrouped(bool isOn) {
    m_groups.setOn(isOn);
    m_table->setVisible(!isOn);
    m_groupTable->setVisible(isOn);
    showColumns();
    showCount();
    markChosen();
}

void PartsPanel::setBoard(std::shared_ptr<const model::Document> board) {
    const QStringList before = m_model.designators();
    m_model.setBoard(std::move(board));
    listAttributes();
    showColumns();
    showCount();
    if (m_model.designators() != before) {
        m_table->scrollToTop();  // Qt leaves it as it was with the rows before
        m_groupTable->scrollToTop();
    }
    markChosen();
}

void PartsPanel::showEvent(QShowEvent* event) {
    QWidget::showEvent(event);
    if (m_isMarkDue) {
        markChosen();
    }
}

/// Columns that say nothing, or the same as another one, are left out.
void PartsPanel::showColumns() {
    m_table->setColumnHidden(PartModel::Step, !m_model.hasSeveralSteps());
    m_table->setColumnHidden(PartModel::Height, !m_model.hasHeights());
    m_groupTable->setColumnHidden(PartGroupModel::Step, !m_model.hasSeveralSteps());
    m_groupTable->setColumnHidden(PartGroupModel::Value, !m_groups.hasValues());
    m_groupTable->setColumnHidden(PartGroupModel::Attributes, isValueChosen());
}

void PartsPanel::listAttributes() {
    const QString before = chosenAttribute();
    const QSignalBlocker blocker(m_attribute);
    m_attribute->clear();
    m_attribute->addItem(tr("All attributes"));
    m_attribute->addItems(m_model.attributeNames());
    const int same = before.isEmpty() ? -1 : m_attribute->findText(before);
    const int first = m_attribute->findText(QLatin1String(kFirstAttribute), Qt::MatchFixedString);
    m_attribute->setCurrentIndex(same >= 0 ? same : std::max(first, 0));
    m_model.setAttribute(chosenAttribute());
}

/// Empty: all.
QString PartsPanel::chosenAttribute() const {
    return m_attribute->currentIndex() > 0 ? m_attribute->currentText() : QString();
}

bool PartsPanel::isValueChosen() const {
    return chosenAttribute().compare(QLatin1String(kFirstAttribute), Qt::CaseInsensitive) == 0;
}

QString PartsPanel::csv() {
    if (!isGrouped() || !isValueChosen()) {
        return tableCsv(*table().model());
    }
    WithoutColumn rows(PartGroupModel::Attributes);
    rows.setSourceModel(table().model());
    return tableCsv(rows);
}

/// Rows of the PartModel that the filter leaves, or whose groups it leaves.
std::vector<int> PartsPanel::shownParts() const {
    if (!isGrouped()) {
        return m_table->shownRows();
    }
    std::vector<int> parts;
    for (const int group : m_groupTable->shownRows()) {
        std::ranges::copy(m_groups.partsOf(group), std::back_inserter(parts));
    }
    return parts;
}

void PartsPanel::showCount() {
    const std::vector<int> shown = shownParts();
    QStringList texts;
    if (isGrouped() && m_model.rowCount() > 0) {
        texts += tr("%L1 of %L2 parts").arg(m_groupTable->model()->rowCount()).arg(m_groups.rowCount());
        texts += tr("%L1 of %L2 components").arg(shown.size()).arg(m_model.rowCount());
        if (const QString leftOut = m_groups.leftOutText(); !leftOut.isEmpty()) {
            texts += leftOut;
        }
        if (!m_groups.hasValues()) {
            texts += tr("no values");  // what looks equal may not be
        }
    } else {
        if (m_model.rowCount() > 0) {
            texts += tr("%L1 of %L2").arg(shown.size()).arg(m_model.rowCount());
        }
        texts += m_model.missing(shown);
    }
    m_count->setText(texts.join(QStringLiteral(" · ")));
}

void PartsPanel::takeGroups(const std::vector<int>& rows) {
    std::vector<int> parts;
    for (const int group : rows) {
        std::ranges::copy(m_groups.partsOf(group), std::back_inserter(parts));
    }
    takeParts(parts);
}

void PartsPanel::takeParts(const std::vector<int>& rows) {
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

/// Once it is seen: a hidden table would stay scrolled to what is no longer chosen. A group is marked if any of its
/// components is chosen.
void PartsPanel::markChosen() {
    if (m_isTaking) {
        return;
    }
    m_isMarkDue = !isVisible();
    if (m_isMarkDue) {
        return;
    }
    std::vector<int> rows;
    std::vector<int> groups;
    for (const BoardPart& part : m_parts.parts()) {
        if (const std::optional<int> row = m_model.rowOf(part)) {
            rows.push_back(*row);
            groups.push_back(m_groups.groupOf(*row).value_or(-1));
        }
    }
    m_table->mark(std::move(rows));
    if (isGrouped()) {
        std::ranges::sort(groups);
        groups.erase(std::ranges::unique(groups).begin(), groups.end());
        m_groupTable->mark(std::move(groups));
    }
}

}  // namespace ui
