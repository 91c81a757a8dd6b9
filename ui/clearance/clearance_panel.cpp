#include "ui/clearance/clearance_panel.h"

#include <QAction>
#include <QComboBox>
#include <QHeaderView>
#include <QLabel>
#include <QSlider>
#include <QSplitter>

#include "ui/common/panel_parts.h"
#include "ui/common/table_view.h"
#include "ui/workspace/actions.h"

namespace ui {

namespace {

constexpr int kLensSteps = 200;
constexpr double kLensStepNm = 5'000.0;  // up to a millimetre
constexpr int kLensStart = 30;

}  // namespace

ClearancePanel::ClearancePanel(ClearanceModel& locations, RuleModel& rules, const ActionSet& actions, QWidget* parent)
    : QWidget(parent),
      m_locations(locations),
      m_what(new QComboBox),
      m_where(new QComboBox),
      m_summary(new QLabel),
      m_table(new TableView(locations)),
      m_ruleTable(new TableView(rules)),
      m_lens(new QSlider(Qt::Horizontal)),
      m_lensText(new QLabel),
      m_distances(new ClearanceMapBar(actions)),
      m_notes(new QLabel) {
    m_notes->setWordWrap(true);
    m_notes->hide();
    m_what->addItems({tr("Smallest clearances"), tr("Rules")});
    m_where->addItems(
        {tr("of the board"), tr("of the current layer"), tr("in the 2D view"), tr("between the two highlighted nets")});
    m_table->makeSortable();
    m_table->setSelectionMode(QAbstractItemView::SingleSelection);
    m_ruleTable->horizontalHeader()->setStretchLastSection(true);
    m_lens->setRange(1, kLensSteps);
    m_lens->setValue(kLensStart);
    m_lens->setMaximumWidth(220);
    m_lens->setToolTip(tr("How near copper must come for the lens to highlight it"));

    for (const int column : {RuleModel::Kind, RuleModel::First, RuleModel::Second}) {
        m_ruleTable->setColumnHidden(column, true);  // the title says them
    }

    QToolBar* tools = toolBar(
        {&actions[ActionId::SearchClearances], &actions[ActionId::ExportClearances], &actions[ActionId::EditRules]});
    m_openRules = tools->addAction(tr("Open rules…"), this, &ClearancePanel::rulesAsked);
    m_saveRules = tools->addAction(tr("Save rules…"), this, &ClearancePanel::rulesSaved);
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
    auto* all = columnIn(*this, 4);
    all->addLayout(row);
    all->addLayout(lenses);
    all->addWidget(tables, 1);
    all->addWidget(m_notes);

    connect(m_what, &QComboBox::currentIndexChanged, this, &ClearancePanel::onWhat);
    connect(m_table->selectionModel(), &QItemSelectionModel::currentRowChanged, m_table, &TableView::choose);
    connect(m_table, &TableView::rowChosen, this, [this](int at) { emit chosen(m_locations.location(at)); });
    connect(&locations, &QAbstractItemModel::modelReset, this, &ClearancePanel::onReset);
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

void ClearancePanel::setNotes(const QString& notes) {
    m_notes->setText(notes);
    m_notes->setVisible(!notes.isEmpty());
}

QString ClearancePanel::notes() const {
    return m_notes->text();
}

QString ClearancePanel::summary() const {
    return m_summary->text();
}

void ClearancePanel::setUnit(LengthUnit unit) {
    m_distances->setUnit(unit);
    m_summary->setText(m_locations.summary());
    m_table->resizeColumnsToContents();
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
    m_summary->setText(m_locations.summary());
    m_table->setColumnHidden(ClearanceModel::Rule, what() == What::Smallest);
    m_table->resizeColumnsToContents();
}

}  // namespace ui
