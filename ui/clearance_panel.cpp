#include "ui/clearance_panel.h"

#include <QAction>
#include <QComboBox>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QLabel>
#include <QSignalBlocker>
#include <QSlider>
#include <QSortFilterProxyModel>
#include <QSplitter>
#include <QToolBar>

#include "ui/actions.h"
#include "ui/choice_delegate.h"
#include "ui/table_view.h"
#include "ui/tool_button.h"

namespace ui {

namespace {

constexpr int kLensSteps = 200;
constexpr double kLensStepNm = 5'000.0;  // up to a millimetre
constexpr int kLensStart = 30;

}  // namespace

ClearancePanel::ClearancePanel(models::ClearanceModel& places, models::RuleModel& rules, const ActionSet& actions,
                               QWidget* parent)
    : QWidget(parent),
      m_places(places),
      m_sorted(new QSortFilterProxyModel(this)),
      m_what(new QComboBox),
      m_where(new QComboBox),
      m_summary(new QLabel),
      m_table(new TableView),
      m_ruleTable(new TableView),
      m_lens(new QSlider(Qt::Horizontal)),
      m_lensText(new QLabel),
      m_distances(new DistanceBar(actions)),
      m_remarks(new QLabel) {
    m_remarks->setWordWrap(true);
    m_remarks->hide();
    m_what->addItems({QStringLiteral("Narrowest gaps"), QStringLiteral("Rules")});
    m_where->addItems({QStringLiteral("of the board"), QStringLiteral("of the current layer"),
                       QStringLiteral("in the 2D view"), QStringLiteral("between the two highlighted nets")});
    m_sorted->setSourceModel(&places);
    m_sorted->setSortRole(Qt::EditRole);
    m_table->setModel(m_sorted);
    m_table->horizontalHeader()->setSortIndicator(-1, Qt::AscendingOrder);  // as found: by rule, narrowest first
    m_table->setSortingEnabled(true);
    m_table->setSelectionMode(QAbstractItemView::SingleSelection);
    m_ruleTable->setModel(&rules);
    m_ruleTable->setEditTriggers(QAbstractItemView::EditKeyPressed | QAbstractItemView::DoubleClicked);
    m_ruleTable->horizontalHeader()->setStretchLastSection(true);
    m_lens->setRange(1, kLensSteps);
    m_lens->setValue(kLensStart);
    m_lens->setMaximumWidth(220);
    m_lens->setToolTip(QStringLiteral("How near copper must come to be lit by the lens"));

    m_ruleTable->setItemDelegate(new ChoiceDelegate(models::RuleModel::ChoicesRole, m_ruleTable));
    for (const int column : {models::RuleModel::Kind, models::RuleModel::First, models::RuleModel::Second}) {
        m_ruleTable->setColumnHidden(column, true);  // the title says them
    }

    // A tool bar folds what has no room into a menu: the buttons do not widen the window.
    auto* tools = new QToolBar;
    tools->addAction(&actions[ActionId::FindGaps]);
    tools->addAction(&actions[ActionId::ExportGaps]);
    tools->addAction(&actions[ActionId::EditRules]);
    m_openRules = tools->addAction(QStringLiteral("Open rules…"), this, &ClearancePanel::rulesAsked);
    m_saveRules = tools->addAction(QStringLiteral("Save rules…"), this, &ClearancePanel::rulesSaved);
    m_summary->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Preferred);
    auto* row = new QHBoxLayout;
    row->addWidget(m_what);
    row->addWidget(m_where);
    row->addWidget(tools, 3);
    row->addWidget(m_summary, 2);
    auto* lenses = new QHBoxLayout;
    lenses->addWidget(toolButton(actions[ActionId::Lens]));
    lenses->addWidget(m_lens, 1);
    lenses->addWidget(m_lensText, 1);
    lenses->addWidget(m_distances, 3);
    auto* tables = new QSplitter;
    tables->addWidget(m_ruleTable);
    tables->addWidget(m_table);
    tables->setStretchFactor(0, 2);
    tables->setStretchFactor(1, 3);
    tables->setChildrenCollapsible(false);
    auto* all = new QVBoxLayout(this);
    all->setContentsMargins(4, 4, 4, 4);
    all->addLayout(row);
    all->addLayout(lenses);
    all->addWidget(tables, 1);
    all->addWidget(m_remarks);

    connect(m_what, &QComboBox::currentIndexChanged, this, &ClearancePanel::onWhat);
    connect(m_table->selectionModel(), &QItemSelectionModel::currentRowChanged, this, &ClearancePanel::choose);
    connect(m_table, &QTableView::clicked, this, &ClearancePanel::choose);
    connect(m_table, &TableView::enterPressed, this, &ClearancePanel::choose);
    connect(&places, &QAbstractItemModel::modelReset, this, &ClearancePanel::onReset);
    connect(&rules, &QAbstractItemModel::dataChanged, m_ruleTable, &QTableView::resizeColumnsToContents);
    connect(&rules, &QAbstractItemModel::modelReset, m_ruleTable, &QTableView::resizeColumnsToContents);
    connect(m_lens, &QSlider::valueChanged, this, [this] { emit lensMoved(lensReach()); });
    onWhat();
    onReset();
}

ClearancePanel::What ClearancePanel::what() const {
    return static_cast<What>(m_what->currentIndex());
}

ClearancePanel::Where ClearancePanel::where() const {
    return static_cast<Where>(m_where->currentIndex());
}

double ClearancePanel::lensReach() const {
    return m_lens->value() * kLensStepNm;
}

void ClearancePanel::showLens(const QString& text) {
    m_lensText->setText(text);
}

void ClearancePanel::setRemarks(const QString& remarks) {
    m_remarks->setText(remarks);
    m_remarks->setVisible(!remarks.isEmpty());
}

QString ClearancePanel::remarks() const {
    return m_remarks->text();
}

QString ClearancePanel::summary() const {
    return m_summary->text();
}

void ClearancePanel::setUnit(models::LengthUnit unit) {
    m_distances->setUnit(unit);
    m_summary->setText(m_places.summary());
    m_table->resizeColumnsToContents();
}

void ClearancePanel::choose(const QModelIndex& index) {
    if (index.isValid()) {
        emit chosen(m_places.place(m_sorted->mapToSource(index).row()));
    }
}

void ClearancePanel::onWhat() {
    const bool isOfRules = what() == What::Rules;
    m_where->setVisible(!isOfRules);
    m_ruleTable->setVisible(isOfRules);
    m_openRules->setVisible(isOfRules);
    m_saveRules->setVisible(isOfRules);
    m_ruleTable->resizeColumnsToContents();
}

void ClearancePanel::onReset() {
    m_summary->setText(m_places.summary());
    m_table->setColumnHidden(models::ClearanceModel::Rule, what() == What::Narrowest);
    m_table->resizeColumnsToContents();
}

}  // namespace ui
