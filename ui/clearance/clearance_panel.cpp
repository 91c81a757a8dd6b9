#include "ui/clearance/clearance_panel.h"

#include <QAction>
#include <QComboBox>
#include <QHeaderView>
#include <QLabel>
#include <QMenu>
#include <QMouseEvent>
#include <QScrollBar>
#include <QSlider>
#include <QSplitter>
#include <QToolButton>
#include <algorithm>
#include <iterator>

#include "ui/clearance/notes_area.h"
#include "ui/common/elided_label.h"
#include "ui/common/panel_parts.h"
#include "ui/common/sorted_rows.h"
#include "ui/common/table_view.h"
#include "ui/workspace/actions.h"

namespace ui {

namespace {

constexpr int kLensSteps = 200;
constexpr double kLensStepNm = 5'000.0;  // up to a millimetre
constexpr int kLensStart = 30;
constexpr double kMapReachesUm[] = {20,  25,  30,  40,   50,   60,   80,   100,  125,  150,  200,  250,  300,  400,
                                    500, 600, 800, 1000, 1250, 1500, 2000, 2500, 3000, 4000, 5000, 6000, 8000, 10'000};
constexpr double kFirstMapReachUm = 500;
constexpr int kWhereLetters = 12;  ///< a choice has room for at least so many
constexpr int kNarrowLines = 35;   ///< in heights of a line: a panel that is narrower is a column
constexpr int kSummaryLines = 2;   ///< so that the verdict is whole in a column

QSlider* sliderTo(int least, int most, const char* name, const QString& tip) {
    auto* slider = new QSlider(Qt::Horizontal);
    slider->setRange(least, most);
    slider->setObjectName(QLatin1String(name));
    slider->setMaximumWidth(220);
    slider->setToolTip(tip);
    return slider;
}

/// Names of rules and reasons may be sentences: the columns behind them would be out of sight.
void fit(TableView& table, std::initializer_list<int> longColumns) {
    constexpr int kLetters = 18;
    table.resizeColumnsToContents();
    const int most = kLetters * table.fontMetrics().averageCharWidth();
    for (const int column : longColumns) {
        table.setColumnWidth(column, std::min(table.columnWidth(column), most));
    }
}

}  // namespace

ClearancePanel::ClearancePanel(ClearanceModel& locations, RuleModel& rules, const ActionSet& actions, QWidget* parent)
    : QWidget(parent),
      m_locations(locations),
      m_rules(rules),
      m_what(new QComboBox),
      m_where(new QComboBox),
      m_summary(new ElidedLabel),
      m_table(new TableView(locations)),
      m_ruleTable(new TableView(rules)),
      m_lens(sliderTo(1, kLensSteps, "lensReach", tr("How near copper must come for the lens to highlight it"))),
      m_lensText(new ElidedLabel),
      m_map(sliderTo(0, static_cast<int>(std::size(kMapReachesUm)) - 1, "mapReach",
                     tr("The map is coloured up to this distance; what is farther is darkened a little"))),
      m_mapReach(new QLabel),
      m_mapText(new ElidedLabel),
      m_notes(new NotesArea),
      m_searchRow(searchRow(actions)),
      m_sliderRow(sliderRow(actions)),
      m_tables(new QSplitter) {
    m_rows = &m_table->makeSortable();
    addWaiverCommands();
    m_table->horizontalHeader()->moveSection(ClearanceModel::Waived, ClearanceModel::Layer);  // beside the rule
    m_table->setSelectionMode(QAbstractItemView::SingleSelection);
    m_ruleTable->horizontalHeader()->setStretchLastSection(true);
    for (int column = RuleModel::Kind; column <= RuleModel::Layer; ++column) {
        m_ruleTable->setColumnHidden(column, true);  // the title says them
    }
    m_tables->addWidget(m_ruleTable);
    m_ruleTable->setSelectionMode(QAbstractItemView::SingleSelection);
    m_ruleTable->setObjectName(QStringLiteral("rules"));
    m_ruleTable->setToolTip(tr("A click lists the locations of a rule alone, another one those of all rules"));
    m_ruleTable->viewport()->installEventFilter(this);
    connect(m_ruleTable->selectionModel(), &QItemSelectionModel::selectionChanged, this, [this] {
        listRule();
        showFirst();
    });
    m_tables->addWidget(m_table);
    m_tables->setStretchFactor(0, 1);
    m_tables->setStretchFactor(1, 1);
    m_tables->setChildrenCollapsible(false);
    setMinimumWidth(1);  // what lies side by side goes below each other
    auto* all = columnIn(*this, 4);
    all->addLayout(m_searchRow);
    all->addLayout(m_sliderRow);
    all->addWidget(m_tables, 1);
    all->addWidget(m_notes);

    connect(m_what, &QComboBox::currentIndexChanged, this, &ClearancePanel::onWhat);
    connect(m_table->selectionModel(), &QItemSelectionModel::currentRowChanged, m_table, &TableView::choose);
    connect(m_table, &TableView::rowChosen, this, [this](int at) { emit chosen(m_locations.location(at)); });
    connect(&locations, &QAbstractItemModel::modelReset, this, &ClearancePanel::onReset);
    connect(&rules, &QAbstractItemModel::dataChanged, this, &ClearancePanel::fitTables);
    connect(&rules, &QAbstractItemModel::dataChanged, this, &ClearancePanel::listRule);
    connect(&rules, &QAbstractItemModel::modelReset, this, &ClearancePanel::fitTables);
    connect(&rules, &QAbstractItemModel::modelReset, this, &ClearancePanel::listRule);
    onWhat();
    onReset();
    onMapReach();
}

QBoxLayout* ClearancePanel::searchRow(const ActionSet& actions) {
    m_what->addItems({tr("Smallest clearances"), tr("Rules"), tr("Through the stackup")});
    m_what->setObjectName(QStringLiteral("what"));
    m_where->addItems(
        {tr("of the board"), tr("of the current layer"), tr("in the 2D view"), tr("between the two highlighted nets")});
    m_where->setObjectName(QStringLiteral("where"));
    m_where->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
    m_where->setMinimumContentsLength(kWhereLetters);
    QToolBar* tools = toolBar(
        {&actions[ActionId::SearchClearances], &actions[ActionId::ExportClearances], &actions[ActionId::EditRules]});
    auto* search = qobject_cast<QToolButton*>(tools->widgetForAction(&actions[ActionId::SearchClearances]));
    search->setObjectName(QStringLiteral("search"));
    // The command is one for all questions; its button can say what it does here.
    const auto nameSearch = [this, search] {
        search->setText(what() == What::Rules ? tr("Check rules") : search->defaultAction()->iconText());
    };
    connect(m_what, &QComboBox::currentIndexChanged, search, nameSearch);
    connect(search->defaultAction(), &QAction::changed, search, nameSearch);  // which has renamed its button
    m_openRules = tools->addAction(tr("Open rules…"), this, &ClearancePanel::rulesAsked);
    m_saveRules = tools->addAction(tr("Save rules…"), this, &ClearancePanel::rulesSaved);
    m_waivers = waiverMenu()->menuAction();  // an action: what has no room folds into a menu, which widgets do not
    tools->addAction(m_waivers);
    auto* waivers = qobject_cast<QToolButton*>(tools->widgetForAction(m_waivers));
    waivers->setObjectName(QStringLiteral("waivers"));
    waivers->setPopupMode(QToolButton::InstantPopup);
    m_summary->setObjectName(QStringLiteral("summary"));
    m_summary->setMostLines(kSummaryLines);
    auto* choices = new QHBoxLayout;
    choices->addWidget(m_what);
    choices->addWidget(m_where, 1);
    auto* row = new QBoxLayout(QBoxLayout::LeftToRight);
    row->addLayout(choices);
    row->addWidget(tools, 3);
    row->addWidget(m_summary, 2);
    return row;
}

QMenu* ClearancePanel::waiverMenu() {
    auto* menu = new QMenu(tr("Waivers"), this);
    m_showWaived = menu->addAction(tr("&Show waived locations"), this, &ClearancePanel::listRule);
    m_showWaived->setCheckable(true);
    m_showWaived->setChecked(true);
    menu->addSeparator();
    menu->addAction(tr("&Open waivers…"), this, &ClearancePanel::waiversAsked);
    menu->addAction(tr("Save &waivers…"), this, &ClearancePanel::waiversSaved);
    menu->addAction(tr("Withdraw waivers without a &finding"), this, &ClearancePanel::goneWaiversAsked);
    return menu;
}

void ClearancePanel::addWaiverCommands() {
    m_waive = m_table->addAction(tr("Waive…"), this, [this] { emit waiverAsked(currentRow()); });
    m_waive->setObjectName(QStringLiteral("waive"));
    m_withdraw = m_table->addAction(tr("Withdraw waiver"), this, [this] { emit withdrawalAsked(currentRow()); });
    m_withdraw->setObjectName(QStringLiteral("withdraw"));
    connect(m_table->selectionModel(), &QItemSelectionModel::currentRowChanged, this, &ClearancePanel::onCurrent);
}

int ClearancePanel::currentRow() const {
    return m_rows->mapToSource(m_table->currentIndex()).row();
}

void ClearancePanel::setCurrentRow(int row) {
    const QModelIndex at = m_rows->mapFromSource(m_locations.index(row, 0));
    if (at.isValid()) {
        m_table->setCurrentIndex(at);
        m_table->goToRow(at);  // is there already where Qt made it the current row, as those before it were left out
    }
}

ClearancePanel::Place ClearancePanel::place() const {
    return {m_table->currentIndex().row(), m_table->verticalScrollBar()->value()};
}

void ClearancePanel::returnTo(const Place& place) {
    const QModelIndex index = m_rows->index(std::min(place.row, m_rows->rowCount() - 1), 0);
    if (index.isValid()) {
        m_table->setCurrentIndex(index);
        m_table->verticalScrollBar()->setValue(place.scrolled);
        m_table->goToRow(index);  // the list may be shorter than it was
    }
}

void ClearancePanel::listRule() {
    const std::vector<int> selected = m_ruleTable->selectedRows();
    // Rules that were edited since have other rows.
    const bool isOfThese = m_locations.isOfRules() && m_locations.rules() == m_rules.rules();
    m_locations.showRule(selected.empty() || !isOfThese ? std::nullopt
                                                        : std::optional(static_cast<std::size_t>(selected.front())));
    m_rows->setLeastRank(m_showWaived->isChecked() ? 0 : 1);
    m_summary->setText(m_locations.summary());
}

void ClearancePanel::showFirst() {
    const std::vector<int> selected = m_ruleTable->selectedRows();
    const int row = selected.empty() ? -1 : m_locations.firstOf(static_cast<std::size_t>(selected.front()));
    if (row >= 0) {
        setCurrentRow(row);
    }
}

bool ClearancePanel::eventFilter(QObject* watched, QEvent* event) {
    if (event->type() == QEvent::MouseButtonPress) {
        const auto& press = static_cast<const QMouseEvent&>(*event);
        const QModelIndex at = m_ruleTable->indexAt(press.position().toPoint());
        const bool isOfRow = at.isValid() && at.column() != RuleModel::On && press.button() == Qt::LeftButton;
        if (isOfRow && m_ruleTable->selectionModel()->isRowSelected(at.row())) {
            m_ruleTable->clearSelection();
            return true;
        }
    }
    return QWidget::eventFilter(watched, event);
}

void ClearancePanel::onCurrent() {
    const int row = currentRow();
    const bool isOfRules = row >= 0 && m_locations.isOfRules();
    m_waive->setEnabled(isOfRules && !m_locations.location(row).waiver);
    m_withdraw->setEnabled(isOfRules && m_locations.location(row).waiver);
}

QBoxLayout* ClearancePanel::sliderRow(const ActionSet& actions) {
    m_lens->setValue(kLensStart);
    m_map->setPageStep(3);
    m_map->setValue(static_cast<int>(std::ranges::find(kMapReachesUm, kFirstMapReachUm) - std::begin(kMapReachesUm)));
    m_mapText->setObjectName(QStringLiteral("map"));
    auto* map = new QHBoxLayout;
    map->addWidget(toolButton(actions[ActionId::ClearanceMap]));
    map->addWidget(m_map, 1);
    map->addWidget(m_mapReach);
    map->addSpacing(fontMetrics().averageCharWidth());
    map->addWidget(m_mapText, 2);
    auto* lens = new QHBoxLayout;
    lens->addWidget(toolButton(actions[ActionId::Lens]));
    lens->addWidget(m_lens, 1);
    lens->addWidget(m_lensText, 1);
    auto* row = new QBoxLayout(QBoxLayout::LeftToRight);
    row->addLayout(lens, 1);
    row->addLayout(map, 2);
    connect(m_lens, &QSlider::valueChanged, this, [this] { emit lensMoved(lensReach()); });
    connect(m_map, &QSlider::valueChanged, this, &ClearancePanel::onMapReach);
    return row;
}

void ClearancePanel::resizeEvent(QResizeEvent* event) {
    const bool isNarrow = width() < fontMetrics().height() * kNarrowLines;
    for (QBoxLayout* row : {m_searchRow, m_sliderRow}) {
        row->setDirection(isNarrow ? QBoxLayout::TopToBottom : QBoxLayout::LeftToRight);
    }
    m_tables->setOrientation(isNarrow ? Qt::Vertical : Qt::Horizontal);
    QWidget::resizeEvent(event);
}

ClearancePanel::What ClearancePanel::what() const {
    return static_cast<What>(m_what->currentIndex());
}

ClearancePanel::Where ClearancePanel::where() const {
    return static_cast<Where>(m_where->currentIndex());
}

void ClearancePanel::showRules() {
    m_what->setCurrentIndex(static_cast<int>(What::Rules));
}

double ClearancePanel::lensReach() const {
    return m_lens->value() * kLensStepNm;
}

double ClearancePanel::mapReach() const {
    return kMapReachesUm[m_map->value()] * base::kNmPerUm;
}

void ClearancePanel::showLens(const QString& text) {
    m_lensText->setText(text);
}

void ClearancePanel::showMap(const QString& text) {
    m_mapText->setText(text);
}

void ClearancePanel::setNotes(const QString& notes) {
    m_notes->setText(notes);
}

void ClearancePanel::setUnit(LengthUnit unit) {
    m_unit = unit;
    m_mapReach->setText(lengthText(mapReach(), unit));
    m_summary->setText(m_locations.summary());
    fitTables();
}

void ClearancePanel::fitTables() {
    fit(*m_table, {ClearanceModel::Rule, ClearanceModel::Waived});
    fit(*m_ruleTable, {RuleModel::Title});
}

void ClearancePanel::onWhat() {
    const bool isOfRules = what() == What::Rules;
    m_where->setVisible(!isOfRules);
    m_ruleTable->setVisible(isOfRules);
    m_openRules->setVisible(isOfRules);
    m_saveRules->setVisible(isOfRules);
    m_waivers->setVisible(isOfRules);
    fitTables();
    emit whatChanged();
}

void ClearancePanel::onReset() {
    listRule();
    m_table->setColumnHidden(ClearanceModel::Rule, !m_locations.isOfRules());
    m_table->setColumnHidden(ClearanceModel::Waived, !m_locations.hasWaived());
    onCurrent();
    fitTables();
}

void ClearancePanel::onMapReach() {
    m_mapReach->setText(lengthText(mapReach(), m_unit));
    emit mapReachChanged(mapReach());
}

}  // namespace ui
