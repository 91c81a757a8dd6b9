#include "ui/comparison/comparison_panel.h"

#include <QLabel>

#include "ui/common/elided_label.h"
#include "ui/common/panel_parts.h"
#include "ui/common/sorted_rows.h"
#include "ui/common/table_view.h"
#include "ui/comparison/difference_marks.h"
#include "ui/findings/finding_table.h"

namespace ui {

namespace {

/// "■ only in A  ■ only in B", in the colours of the marks.
QString legend() {
    const auto entry = [](const QColor& colour, const QString& text) {
        return QStringLiteral("<span style=\"color:%1\">■</span>&nbsp;%2").arg(colour.name(), text);
    };
    return QStringLiteral("%1&nbsp;&nbsp;%2")
        .arg(entry(DifferenceMarks::kOnlyColours[0], ComparisonPanel::tr("only in A")),
             entry(DifferenceMarks::kOnlyColours[1], ComparisonPanel::tr("only in B")));
}

}  // namespace

ComparisonPanel::ComparisonPanel(ComparisonModel& differences, const ActionSet& actions, QWidget* parent)
    : QWidget(parent), m_differences(differences) {
    TableView* table = makeTable();
    QVBoxLayout* column = columnIn(*this);
    column->addLayout(makeControls(actions));
    column->addWidget(table, 1);
    m_listing.setSingleShot(true);
    connect(&m_listing, &QTimer::timeout, this, &ComparisonPanel::listed);
    const auto listSoon = [this] { m_listing.start(0); };
    connect(m_rows, &QAbstractItemModel::modelReset, this, listSoon);
    connect(m_rows, &QAbstractItemModel::layoutChanged, this, listSoon);
    connect(m_rows, &QAbstractItemModel::rowsInserted, this, listSoon);
    connect(m_rows, &QAbstractItemModel::rowsRemoved, this, listSoon);
}

TableView* ComparisonPanel::makeTable() {
    auto* table = new TableView(m_differences);
    m_rows = &table->makeSortable();
    table->fitColumns(ComparisonModel::What);
    walkWithArrows(*table);
    connect(table, &TableView::rowChosen, this, &ComparisonPanel::rowChosen);
    return table;
}

QLayout* ComparisonPanel::makeControls(const ActionSet& actions) {
    auto* buttons = buttonRow({&actions[ActionId::CompareFile], &actions[ActionId::CompareFolder]});
    buttons->addWidget(filterEdit(*m_rows, tr("Filter by layer or text")), 1);
    buttons->addWidget(new QLabel(legend()));
    auto* summary = new ElidedLabel;
    summary->setObjectName("summary");
    summary->setText(m_differences.summary());
    connect(&m_differences, &QAbstractItemModel::modelReset, summary,
            [this, summary] { summary->setText(m_differences.summary()); });
    auto* controls = new QVBoxLayout;
    controls->addLayout(buttons);
    controls->addWidget(summary);
    return controls;
}

std::vector<int> ComparisonPanel::listedRows(std::size_t most) const {
    std::vector<int> listed;
    for (int row = 0; row < m_rows->rowCount() && listed.size() < most; ++row) {
        listed.push_back(m_rows->mapToSource(m_rows->index(row, 0)).row());
    }
    return listed;
}

}  // namespace ui
