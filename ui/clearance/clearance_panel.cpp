#include "ui/clearance/clearance_panel.h"

#include <QAction>
#include <QComboBox>
#include <QHeaderView>
#include <QHelpEvent>
#include <QLabel>
#include <QMenu>
#include <QMouseEvent>
#include <QScrollBar>
#include <QSlider>
#include <QSplitter>
#include <QToolButton>
#include <QToolTip>
#include <algorithm>
#include <iterator>

#include "ui/clearance/notes_area.h"
#include "ui/common/cell_delegate.h"
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
constexpr int kNarrowLines = 35;   ///< in heights of a line: what is narrower has its controls in a column
constexpr int kTablesLines = 56;   ///< likewise: from here on both tables have room side by side
constexpr int kSummaryLines = 2;   ///< so that the verdict is whole in a column
constexpr int kLetters = 18;       ///< of a long text, before it is cut
constexpr int kLettersInColumn = 11;
constexpr int kTitleLetters = 36;  ///< of a rule, where the table of rules has room

QSlider* sliderTo(int least, int most, const char* name, const QString& tip) {
    auto* slider = new QSlider(Qt::Horizontal);
    slider->setRange(least, most);
    slider->setObjectName(QLatin1String(name));
    slider->setMaximumWidth(220);
    slider->setToolTip(tip);
    return slider;
}

/// What is cut is whole in the tip of its cell, unless that has another one.
class CutTextDelegate : public CellDelegate {
public:
    using CellDelegate::CellDelegate;

    bool helpEvent(QHelpEvent* event, QAbstractItemView* view, const QStyleOptionViewItem& option,
                   const QModelIndex& index) override {
        const bool isCut = index.isValid() && sizeHint(option, index).width() > option.rect.width();
        if (event->type() != QEvent::ToolTip || !isCut || !index.data(Qt::ToolTipRole).toString().isEmpty()) {
            return CellDelegate::helpEvent(event, view, option, index);
        }
        QToolTip::showText(event->globalPos(), index.data().toString(), view, view->visualRect(index));
        return true;
    }
};

/// Names of rules and nets and reasons may be sentences: the columns behind them would be out of sight.
void fit(TableView& table, int letters, std::initializer_list<int> longColumns) {
    table.resizeColumnsToContents();
    const int most = letters * table.fontMetrics().averageCharWidth();
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
    addRowCommands();
    m_ruleTable->horizontalHeader()->setStretchLastSection(true);
    for (TableView* table : {m_table, m_ruleTable}) {
        table->setItemDelegate(new CutTextDelegate(table));
        table->horizontalHeader()->setTextElideMode(Qt::ElideRight);
    }
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

void ClearancePanel::addRowCommands() {
    QAction* show = m_table->addAction(tr("Show"), m_table, [this] { m_table->choose(m_table->currentIndex()); });
    show->setObjectName(QStringLiteral("show"));
    m_waive = m_table->addAction(tr("Waive…"), this, [this] { emit waiverAsked(selectedOf(false)); });
    m_waive->setObjectName(QStringLiteral("waive"));
    m_withdraw = m_table->addAction(tr("Withdraw waiver"), this, [this] { emit withdrawalAsked(selectedOf(true)); });
    m_withdraw->setObjectName(QStringLiteral("withdraw"));
    connect(m_table->selectionModel(), &QItemSelectionModel::selectionChanged, this, &ClearancePanel::onSelection);
}

int ClearancePanel::currentRow() const {
    return m_rows->mapToSource(m_table->currentIndex()).row();
}

void ClearancePanel::setCurrentRow(int row) {
    // Of a column that is never left out: Qt scrolls to no other.
    const QModelIndex at = m_rows->mapFromSource(m_locations.index(row, ClearanceModel::First));
    if (at.isValid()) {
        m_table->setCurrentIndex(at);
        m_table->goToRow(at);  // is there already where Qt made it the current row, as those before it were left out
    }
}

ClearancePanel::Place ClearancePanel::place() const {
    const int current = m_table->currentIndex().row();
    const auto before = std::ranges::count_if(m_table->selectionModel()->selectedRows(),
                                              [&](const QModelIndex& at) { return at.row() < current; });
    return {current - static_cast<int>(before), m_table->verticalScrollBar()->value()};
}

void ClearancePanel::returnTo(const Place& place) {
    const QModelIndex index = m_rows->index(std::min(place.row, m_rows->rowCount() - 1), ClearanceModel::First);
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

std::vector<int> ClearancePanel::selectedOf(bool isWaived) const {
    std::vector<int> rows = m_locations.isOfRules() ? m_table->selectedRows() : std::vector<int>();
    std::erase_if(rows, [&](int row) { return m_locations.location(row).waiver.has_value() != isWaived; });
    std::ranges::sort(rows);
    return rows;
}

void ClearancePanel::onSelection() {
    const std::size_t failing = selectedOf(false).size();
    const std::size_t waived = selectedOf(true).size();
    m_waive->setEnabled(failing > 0);
    m_waive->setText(failing > 1 ? tr("Waive %L1 locations…").arg(failing) : tr("Waive…"));
    m_withdraw->setEnabled(waived > 0);
    m_withdraw->setText(waived > 1 ? tr("Withdraw %L1 waivers").arg(waived) : tr("Withdraw waiver"));
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
    arrange();
    QWidget::resizeEvent(event);
}

void ClearancePanel::arrange() {
    for (QBoxLayout* row : {m_searchRow, m_sliderRow}) {
        row->setDirection(isNarrow(width()) ? QBoxLayout::TopToBottom : QBoxLayout::LeftToRight);
    }
    const bool haveRoom = width() >= fontMetrics().height() * kTablesLines;
    m_tables->setOrientation(haveRoom ? Qt::Horizontal : Qt::Vertical);
    if (areTablesNarrow() != m_areFitNarrow) {
        fitTables();
    }
}

bool ClearancePanel::isNarrow(int width) const {
    return width < fontMetrics().height() * kNarrowLines;
}

/// Beside the other table there is half of the room.
bool ClearancePanel::areTablesNarrow() const {
    const bool isHalf = what() == What::Rules && m_tables->orientation() == Qt::Horizontal;
    return isNarrow(isHalf ? width() / 2 : width());
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
    m_areFitNarrow = areTablesNarrow();
    fit(*m_table, m_areFitNarrow ? kLettersInColumn : kLetters,
        {ClearanceModel::Rule, ClearanceModel::Waived, ClearanceModel::First, ClearanceModel::Second});
    fit(*m_ruleTable, m_areFitNarrow ? kLetters : kTitleLetters, {RuleModel::Title});
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
    m_table->setColumnHidden(ClearanceModel::Required, !m_locations.isOfRules());
    m_table->setColumnHidden(ClearanceModel::Waived, !m_locations.hasWaived());
    onSelection();
    fitTables();
}

void ClearancePanel::onMapReach() {
    m_mapReach->setText(lengthText(mapReach(), m_unit));
    emit mapReachChanged(mapReach());
}

}  // namespace ui
