#include "ui/nets/nets_panel.h"

#include <QColorDialog>
#include <QComboBox>
#include <QHeaderView>
#include <QKeyEvent>
#include <QLabel>
#include <QScopedValueRollback>
#include <QSlider>
#include <algorithm>
#include <iterator>

#include "ui/common/cell_delegate.h"
#include "ui/common/panel_parts.h"
#include "ui/common/table_view.h"
#include "ui/nets/net_text.h"
#include "ui/workspace/actions.h"

namespace ui {

namespace {

/// In the order of the box.
constexpr std::optional<model::NetGrouping> kGroupings[] = {std::nullopt,
                                                            model::NetGrouping::Class,
                                                            model::NetGrouping::DifferentialPair,
                                                            model::NetGrouping::Bus,
                                                            model::NetGrouping::Supply,
                                                            model::NetGrouping::Sheet};
constexpr int kBySheet = 5;  // of these

constexpr int kNameWidth = 17;  // in letters
constexpr int kLeastNameWidth = 10;
constexpr int kLeastOfBothEnds = 12;

/// In letters.
constexpr std::pair<NetModel::Column, int> kWidths[] = {
    {NetModel::Name, kNameWidth}, {NetModel::Pins, 6},  {NetModel::Vias, 6},   {NetModel::Elements, 8},
    {NetModel::Length, 12},       {NetModel::Area, 12}, {NetModel::Colour, 6}, {NetModel::Shown, 5},
};

/// Of the context menu, for the selected rows.
constexpr ActionId kMenu[] = {ActionId::HighlightNet,   ActionId::AddNet,          ActionId::ShowSelection,
                              ActionId::ColourNet,      ActionId::ChooseNetColour, ActionId::HideNet,
                              ActionId::IsolateNet,     ActionId::ShowAllNets,     ActionId::ClearNetColours,
                              ActionId::SectionAlongNet};

/// Of sheets within sheets the last name tells nets apart, of pairs and buses the first as well: where there is room
/// for some of both, what lies between goes, of headings too.
class NetNameDelegate : public CellDelegate {
public:
    explicit NetNameDelegate(QObject* parent) : CellDelegate(parent) {}

protected:
    void initStyleOption(QStyleOptionViewItem* option, const QModelIndex& index) const override {
        CellDelegate::initStyleOption(option, index);
        const int least = kLeastOfBothEnds * option->fontMetrics.horizontalAdvance('0');
        option->textElideMode = option->rect.width() < least ? Qt::ElideLeft : Qt::ElideMiddle;
    }
};

/// Rows that follow each other become one range: a million of them would be slow.
void addRow(QItemSelection& rows, const NetModel& model, int row) {
    const int last = model.columnCount() - 1;
    if (!rows.empty() && rows.back().bottom() == row - 1) {
        rows.back() = QItemSelectionRange(rows.back().topLeft(), model.index(row, last));
    } else {
        rows.select(model.index(row, 0), model.index(row, last));
    }
}

}  // namespace

NetsPanel::NetsPanel(NetModel& model, SelectionModel& selection, NetStyles& styles, const ActionSet& actions,
                     QWidget* parent)
    : QWidget(parent),
      m_model(model),
      m_selection(selection),
      m_styles(styles),
      m_filter(ui::filterEdit(tr("Filter nets by name"))),
      m_kind(new QComboBox),
      m_group(new QComboBox),
      m_step(new QComboBox),
      m_dim(new QSlider(Qt::Horizontal)),
      m_summary(new QLabel),
      m_details(new QLabel),
      m_table(new TableView(model)) {
    m_detailsDue.setSingleShot(true);
    m_detailsDue.setInterval(0);
    connect(&m_detailsDue, &QTimer::timeout, this, &NetsPanel::showDetails);
    setUpTable();
    for (const ActionId id : kMenu) {
        m_table->addAction(&actions[id]);
    }
    layOutControls(actions);
    connect(m_filter, &QLineEdit::textChanged, this, &NetsPanel::applyFilter);
    connect(m_kind, &QComboBox::currentIndexChanged, this, &NetsPanel::applyFilter);
    connect(m_group, &QComboBox::currentIndexChanged, this, &NetsPanel::applyGrouping);
    connect(m_group, &QComboBox::activated, this, [this] { m_isGroupingChosen = true; });
    connect(m_step, &QComboBox::currentIndexChanged, this, [this] {
        m_isToBegin = true;
        applyStep();
    });
    connect(&model, &NetModel::arranged, this, &NetsPanel::onArranged);
    connect(&selection, &SelectionModel::netsChanged, &model, [this] { m_model.setHighlighted(m_selection.nets()); });
    connect(&selection, &SelectionModel::netsChanged, this, &NetsPanel::onSelectionChanged);
    connect(&selection, &SelectionModel::selectionChanged, this, &NetsPanel::onSelectionChanged);
}

void NetsPanel::setUpTable() {
    m_table->setButtonColumns({NetModel::Shown, NetModel::Colour});
    m_table->setItemDelegateForColumn(NetModel::Name, new NetNameDelegate(m_table));
    m_table->setSortingEnabled(true);
    m_table->sortByColumn(NetModel::Name, Qt::AscendingOrder);
    const int letter = fontMetrics().horizontalAdvance('0');
    for (const auto& [column, letters] : kWidths) {
        m_table->setColumnWidth(column, letter * letters);
    }
    m_table->horizontalHeader()->moveSection(NetModel::Colour, 0);
    m_table->horizontalHeader()->moveSection(NetModel::Shown, 0);
    // Beside the name, where a narrow panel still shows it.
    QHeaderView& header = *m_table->horizontalHeader();
    header.moveSection(header.visualIndex(NetModel::Length), header.visualIndex(NetModel::Name) + 1);
    header.setStretchLastSection(true);
    connect(&header, &QHeaderView::sortIndicatorChanged, this, [this] { m_isToBegin = true; });
    connect(&header, &QHeaderView::sectionResized, this, [this](int column) {
        if (!m_isFitting) {
            m_setColumns.insert(column);
        }
    });
    m_table->installEventFilter(this);
    m_table->viewport()->installEventFilter(this);
    connect(m_table->selectionModel(), &QItemSelectionModel::selectionChanged, this, &NetsPanel::takeFromTable);
    connect(m_table, &QTableView::clicked, this, &NetsPanel::onClicked);
    connect(m_table, &QTableView::activated, this, [this](const QModelIndex& index) {
        if (index.column() != NetModel::Shown && index.column() != NetModel::Colour) {
            emit showRequested(m_model.netsAt(index.row()));
        }
    });
}

void NetsPanel::layOutControls(const ActionSet& actions) {
    m_kind->addItems({tr("Text"), tr("Wildcard"), tr("Regex")});  // in the order of FilterKind
    m_group->addItems({tr("No groups"), tr("By class"), tr("By pair"), tr("By bus"), tr("By supply"), tr("By sheet")});
    m_group->setObjectName(QStringLiteral("netGroups"));
    m_group->setToolTip(
        tr("Groups by what the job says of its nets; pairs, buses, supplies and sheets also by their names"));
    m_step->setObjectName(QStringLiteral("netSteps"));
    m_step->setToolTip(tr("Whose nets are listed: the board's own, or those of a step it places"));
    m_step->hide();
    m_dim->setRange(0, 100);
    m_dim->setToolTip(tr("How far everything else is darkened while nets or elements are highlighted"));
    m_summary->setObjectName(QStringLiteral("netsShown"));
    m_details->setObjectName(QStringLiteral("netDetails"));
    m_details->setWordWrap(true);
    m_details->setTextInteractionFlags(Qt::TextSelectableByMouse);
    m_details->hide();
    auto* filter = new QHBoxLayout;
    filter->addWidget(m_filter, 1);
    filter->addWidget(m_kind);
    auto* groups = new QHBoxLayout;
    groups->addWidget(m_step);
    groups->addWidget(m_group);
    groups->addStretch();
    groups->addWidget(m_summary);
    auto* styles = new QHBoxLayout;
    styles->addWidget(toolBar({&actions[ActionId::ShowAllNets], &actions[ActionId::ClearNetColours]}), 2);
    styles->addWidget(new QLabel(tr("Dim")));
    styles->addWidget(m_dim, 1);
    auto* column = columnIn(*this);
    for (QHBoxLayout* row : {filter, groups, styles}) {
        column->addLayout(row);
    }
    column->addWidget(m_table);
    column->addWidget(m_details);
}

bool NetsPanel::eventFilter(QObject* watched, QEvent* event) {
    if ((watched == m_table->viewport() && event->type() == QEvent::Resize) ||
        (watched == m_table && event->type() == QEvent::Show)) {
        fitName();
    }
    const bool isTaken =
        (watched == m_table && event->type() == QEvent::KeyPress && takeKey(static_cast<QKeyEvent*>(event)->key())) ||
        (watched == m_table->viewport() && event->type() == QEvent::MouseButtonPress &&
         foldAt(static_cast<QMouseEvent*>(event)->position().toPoint()));
    return isTaken || QWidget::eventFilter(watched, event);
}

bool NetsPanel::takeKey(int key) {
    const QModelIndex current = m_table->currentIndex();
    const bool isEnter = key == Qt::Key_Return || key == Qt::Key_Enter;
    const bool isHeading = current.isValid() && m_model.isHeading(current.row());
    if (key == Qt::Key_Space) {
        toggleSelected();
    } else if (isEnter && current.column() == NetModel::Colour) {
        chooseColour(m_model.netsAt(current.row()));
    } else if (isHeading && (key == Qt::Key_Left || key == Qt::Key_Right)) {
        fold(current.row(), key == Qt::Key_Left);
    } else {
        return false;
    }
    return true;
}

/// A click on the triangle of a heading; anywhere else on it its nets are chosen.
bool NetsPanel::foldAt(const QPoint& at) {
    const QModelIndex index = m_table->indexAt(at);
    if (!index.isValid() || index.column() != NetModel::Name || !m_model.isHeading(index.row())) {
        return false;
    }
    constexpr int kAround = 8;  // what is easily hit beside the triangle, pixels
    const int triangle = index.data(Qt::DecorationRole).value<QImage>().width();
    if (at.x() > m_table->visualRect(index).left() + triangle + kAround) {
        return false;
    }
    fold(index.row(), !m_model.arrangement().isFolded(index.row()));
    return true;
}

void NetsPanel::fold(int heading, bool isFolded) {
    m_model.fold(heading, isFolded);
    m_table->goToRow(m_model.index(heading, NetModel::Name));
}

void NetsPanel::toggleSelected() {
    // All follow the first, so that a mixed selection becomes uniform.
    const std::vector<model::BoardNet> nets = m_selection.selectionNets();
    if (!nets.empty()) {
        m_styles.hide(nets, !m_styles.isHidden(nets.front()));
    }
}

void NetsPanel::onClicked(const QModelIndex& index) {
    if (index.column() != NetModel::Colour) {
        chooseAgain(index);
        return;
    }
    const std::vector<model::BoardNet> nets = m_model.netsAt(index.row());
    const bool isColoured = nets.size() == 1 && m_styles.of(nets.front()).colour.has_value();
    if (isColoured) {
        chooseColour(nets);
    } else {
        m_styles.colourAnew(nets);
    }
}

void NetsPanel::chooseColour(std::vector<model::BoardNet> nets) {
    if (nets.empty() || findChild<QColorDialog*>() != nullptr) {
        return;
    }
    const QColor before = QColor(m_styles.of(nets.front()).colour.value_or(0xffffffffU));
    auto* dialog = new QColorDialog(before, this);
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    dialog->setWindowTitle(tr("Colour of the net"));
    // The board may be replaced while the dialog is open.
    connect(dialog, &QColorDialog::colorSelected, this,
            [this, nets = std::move(nets), board = std::weak_ptr(m_board)](const QColor& colour) {
                if (board.lock() == m_board) {
                    m_styles.colour(nets, colour.rgb());
                }
            });
    dialog->open();
}

void NetsPanel::setBoard(std::shared_ptr<const model::Document> board, Statistics statistics, bool isReadAnew) {
    m_isToBegin = !isReadAnew;
    m_isToScroll = true;
    m_board = std::move(board);
    m_statistics = std::move(statistics);
    const QSignalBlocker blocker(m_step);
    m_step->clear();
    const auto& steps = m_selection.tree().steps;
    for (std::uint32_t row = 0; row < steps.size(); ++row) {
        if (!steps[row]->nets.empty()) {
            m_step->addItem(QString::fromStdString(steps[row]->job.step), row);
        }
    }
    m_step->setVisible(m_step->count() > 1 || step() > 0);
    groupBySheet();
    applyStep();
}

/// Until the user has chosen how nets are grouped, those of schematics with several sheets are by sheet.
void NetsPanel::groupBySheet() {
    if (!m_isGroupingChosen) {
        const bool hasSheets = m_board && model::hasSheets(*m_board);
        m_group->setCurrentIndex(hasSheets ? kBySheet : 0);
    }
}

void NetsPanel::setUnit(LengthUnit unit) {
    m_unit = unit;
    m_model.setUnit(unit);
    fitNumbers();
    m_detailsDue.start();
}

std::uint32_t NetsPanel::step() const {
    return m_step->currentData().toUInt();  // 0 while there is none
}

void NetsPanel::applyStep() {
    if (m_board) {
        const std::shared_ptr<const model::Document> listed(m_board, m_selection.tree().steps[step()]);
        m_model.setNets(listed, step() < m_statistics.size() ? m_statistics[step()] : nullptr, step());
        m_isNameDue = true;
        fitNumbers();
    }
    m_detailsDue.start();
}

int NetsPanel::widthFor(NetModel::Column column) const {
    int widest = 0;
    for (QString text : m_model.widestTexts(column)) {
        std::ranges::replace_if(
            text, [](QChar letter) { return letter.isDigit(); }, QLatin1Char('0'));
        widest = std::max(widest, m_table->fontMetrics().horizontalAdvance(text));
    }
    const int margin =
        style()->pixelMetric(QStyle::PM_FocusFrameHMargin, nullptr, m_table) + 1;  // as delegates have it
    return std::max(widest + 2 * margin + 1, m_table->horizontalHeader()->sectionSizeHint(column));
}

/// No column is too narrow for the largest of its numbers. The length, which stands beside the name, is no wider either
/// until the user sets its width.
void NetsPanel::fitNumbers() {
    {
        const QScopedValueRollback guard(m_isFitting, true);
        for (const NetModel::Column column :
             {NetModel::Pins, NetModel::Vias, NetModel::Elements, NetModel::Length, NetModel::Area}) {
            const bool isExact = column == NetModel::Length && !m_setColumns.contains(column);
            const int least = isExact ? 0 : m_table->columnWidth(column);
            m_table->setColumnWidth(column, std::max(least, widthFor(column)));
        }
    }
    fitName();
}

/// The name takes what room the length beside it leaves, as far as it needs it, until the user sets its width.
void NetsPanel::fitName() {
    if (m_setColumns.contains(NetModel::Name)) {
        return;
    }
    if (m_isNameDue && m_table->isVisible() && m_model.isArranged() && m_model.rowCount() > 0) {
        m_nameNeeded = static_cast<const QAbstractItemView&>(*m_table).sizeHintForColumn(NetModel::Name) + 1;
        m_isNameDue = false;
    }
    int room = m_table->viewport()->width();
    for (const NetModel::Column column : {NetModel::Shown, NetModel::Colour, NetModel::Length}) {
        room -= m_table->columnWidth(column);
    }
    const int letter = fontMetrics().horizontalAdvance('0');
    const QScopedValueRollback guard(m_isFitting, true);
    const int most = std::max(kNameWidth * letter, m_nameNeeded);
    m_table->setColumnWidth(NetModel::Name, std::clamp(room, kLeastNameWidth * letter, most));
}

void NetsPanel::applyFilter() {
    const bool isValid = m_model.setFilter(m_filter->text(), static_cast<NetModel::FilterKind>(m_kind->currentIndex()));
    m_filter->setToolTip(isValid ? QString() : tr("This is not a regular expression; all nets are shown"));
    QPalette colours = palette();
    if (!isValid) {
        colours.setColor(QPalette::Text, Qt::red);
    }
    m_filter->setPalette(colours);
}

void NetsPanel::applyGrouping() {
    m_isNameDue = true;
    m_model.setGrouping(kGroupings[m_group->currentIndex()]);
}

void NetsPanel::onArranged() {
    m_summary->setText(tr("%L1 of %L2").arg(m_model.shown()).arg(m_model.total()));
    fitName();
    showInTable();
    if (std::exchange(m_isToBegin, false)) {
        m_table->scrollToTop();
    }
    if (std::exchange(m_isToScroll, false)) {
        scrollToSelected();
    }
}

void NetsPanel::takeFromTable(const QItemSelection& selected, const QItemSelection& deselected) {
    if (m_isSyncing) {
        return;
    }
    std::vector<model::BoardNet> nets;
    for (const QItemSelectionRange& range : m_table->selectionModel()->selection()) {
        for (int row = range.top(); row <= range.bottom(); ++row) {
            // A heading that was selected before means what is left of its group.
            if (!m_model.isHeading(row) || selected.contains(m_model.index(row, 0))) {
                std::ranges::copy(m_model.netsAt(row), std::back_inserter(nets));
            }
        }
    }
    // A heading taken back takes its nets with it; one that something else was chosen instead of does not.
    const int row = m_table->currentIndex().row();
    const bool isTakenBack = deselected.size() == 1 && deselected.front().height() == 1 &&
                             deselected.front().top() == row && m_model.isHeading(row);
    if (isTakenBack) {
        std::vector<model::BoardNet> gone = m_model.netsAt(row);
        std::ranges::sort(gone);
        std::erase_if(nets, [&](const model::BoardNet& net) { return std::ranges::binary_search(gone, net); });
    }
    const bool isOne = nets.size() == 1;
    {
        const QScopedValueRollback guard(m_isSyncing, true);  // the table stays where the user is
        m_selection.setNets(std::move(nets));
    }
    showInTable();  // a heading and its nets go together
    m_detailsDue.start();
    if (m_showsChosen && isOne) {
        emit showRequested(m_selection.nets());
    }
}

/// A row that is selected already, for the net of an element, becomes the choice where it is clicked.
void NetsPanel::chooseAgain(const QModelIndex& index) {
    if (!m_selection.selected().empty() && m_table->selectionModel()->isSelected(index)) {
        takeFromTable({}, {});
    }
}

void NetsPanel::onSelectionChanged() {
    if (!m_isSyncing) {
        showInTable();
        m_detailsDue.start();
        scrollToSelected();
    }
}

void NetsPanel::showInTable() {
    if (m_isSyncing) {
        return;
    }
    const QScopedValueRollback guard(m_isSyncing, true);
    const std::vector<model::BoardNet> nets = m_selection.selectionNets();
    const auto isSelected = [&](const model::BoardNet& net) { return std::ranges::binary_search(nets, net); };
    QItemSelection rows;
    for (int row = 0; !nets.empty() && row < m_model.rowCount(); ++row) {
        if (!m_model.isHeading(row)) {
            if (isSelected({step(), m_model.netAt(row)})) {
                addRow(rows, m_model, row);
            }
            continue;
        }
        // Counted first: a group may have a million nets.
        if (m_model.netCountAt(row) <= nets.size() && std::ranges::all_of(m_model.netsAt(row), isSelected)) {
            addRow(rows, m_model, row);
        }
    }
    m_table->selectionModel()->select(rows, QItemSelectionModel::ClearAndSelect);
}

void NetsPanel::showDetails() {
    std::vector<model::NetId> nets;
    for (const model::BoardNet& net : m_selection.selectionNets()) {
        if (net.step == step()) {
            nets.push_back(net.net);
        }
    }
    QString text;
    if (m_board && !nets.empty()) {
        const auto statistics = step() < m_statistics.size() ? m_statistics[step()] : nullptr;
        text = netsText(*m_selection.tree().steps[step()], statistics.get(), nets, m_unit);
    }
    m_details->setText(text);
    m_details->setVisible(!text.isEmpty());
}

void NetsPanel::scrollToSelected() {
    const auto current = m_selection.current();
    const std::vector<model::BoardNet>& nets = m_selection.nets();
    const auto net = current ? m_selection.netOf(*current) : nets.empty() ? std::nullopt : std::optional(nets.front());
    if (!net || !m_follows) {
        return;
    }
    if (net->step != step()) {
        m_isToScroll = true;
        m_step->setCurrentIndex(m_step->findData(net->step));
        return;
    }
    m_model.reveal(net->net);
    if (const std::optional<int> row = m_model.rowOf(net->net)) {
        m_table->goToRow(m_model.index(*row, NetModel::Name));
    }
}

}  // namespace ui
