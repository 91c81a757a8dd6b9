#include "ui/element/element_panel.h"

#include <QClipboard>
#include <QGuiApplication>
#include <QHeaderView>
#include <QKeyEvent>
#include <QLabel>
#include <QShortcut>
#include <QTableWidget>
#include <QVBoxLayout>
#include <algorithm>

#include "ui/common/net_name.h"
#include "ui/element/component_facts.h"
#include "ui/element/element_picture.h"
#include "ui/element/net_facts.h"
#include "ui/parts/pin_text.h"

namespace ui {

namespace {

constexpr std::pair<const char*, ElementPanel::Link> kLinks[] = {
    {QT_TRANSLATE_NOOP("ui::Facts", "Layer"), ElementPanel::Link::Layer},
    {QT_TRANSLATE_NOOP("ui::Facts", "Net"), ElementPanel::Link::Net},
    {QT_TRANSLATE_NOOP("ui::Facts", "Pin"), ElementPanel::Link::Pin},
    {QT_TRANSLATE_NOOP("ui::Facts", "Component"), ElementPanel::Link::Component}};

std::optional<ElementPanel::Link> linkOf(const QString& fact) {
    const auto* found = std::ranges::find_if(
        kLinks, [&](const auto& link) { return fact == QCoreApplication::translate("ui::Facts", link.first); });
    return found != std::end(kLinks) ? std::optional(found->second) : std::nullopt;
}

constexpr double kMostOfNames = 0.45;  // of the table

/// Attributes have long names: these are cut where a value would have no room for them.
void fitNames(QTableWidget& table) {
    const QAbstractItemView& cells = table;
    const int room = table.viewport()->width();
    const int besideValues = room - cells.sizeHintForColumn(1);
    const int most = std::max(static_cast<int>(room * kMostOfNames), besideValues);
    table.setColumnWidth(0, std::min(cells.sizeHintForColumn(0) + 1, most));
}

}  // namespace

ElementPanel::ElementPanel(PartPicking& parts, SelectionModel& selection, ElementPicture* picture, QWidget* parent)
    : QWidget(parent), m_parts(parts), m_selection(selection), m_heading(new QLabel), m_table(new QTableWidget(0, 2)) {
    m_heading->setObjectName(QStringLiteral("elementHeading"));
    m_heading->setWordWrap(true);
    m_table->horizontalHeader()->hide();
    m_table->horizontalHeader()->setStretchLastSection(true);
    m_table->verticalHeader()->hide();
    m_table->verticalHeader()->setDefaultSectionSize(fontMetrics().height() + 6);
    m_table->setEditTriggers(QAbstractItemView::NoEditTriggers);
    m_table->setSelectionBehavior(QAbstractItemView::SelectRows);
    m_table->setShowGrid(false);
    m_table->setWordWrap(false);          // a row is one line high
    m_table->setTabKeyNavigation(false);  // Tab leaves the table, as everywhere else
    m_table->setAlternatingRowColors(true);
    auto* copy = new QShortcut(QKeySequence::Copy, m_table, nullptr, nullptr, Qt::WidgetShortcut);
    connect(copy, &QShortcut::activated, this, [this] {
        if (const QTableWidgetItem* value = m_table->item(m_table->currentRow(), 1)) {
            QGuiApplication::clipboard()->setText(value->text());
        }
    });
    m_table->installEventFilter(this);
    connect(m_table, &QTableWidget::cellClicked, this, [this](int row, int column) {
        if (column == 1) {
            follow(row);
        }
    });
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(2, 2, 2, 2);
    layout->addWidget(m_heading);
    layout->addWidget(picture);
    layout->addWidget(m_table);
    connect(&parts, &PartPicking::changed, this, &ElementPanel::update);
    connect(&selection, &SelectionModel::netsChanged, this, &ElementPanel::update);
    update();
}

void ElementPanel::setUnit(LengthUnit unit) {
    m_unit = unit;
    update();
}

void ElementPanel::update() {
    if (const auto part = m_parts.wholePart()) {
        m_heading->setText(tr("Component %1").arg(pinsOfPartsText(m_parts)));
        fill(
            componentFacts(m_parts.document(part->step), part->component, m_unit, m_selection.tree().steps.size() > 1));
        return;
    }
    const std::size_t count = m_selection.selected().size();
    if (const auto& nets = m_selection.nets(); count == 0 && !nets.empty()) {
        const model::Document& step = *m_selection.tree().steps[nets.front().step];
        m_heading->setText(nets.size() == 1 ? tr("Net %1").arg(netName(step, nets.front().net))
                                            : tr("%L1 highlighted nets").arg(nets.size()));
        fill(nets.size() == 1 ? netFacts(m_selection.tree(), nets.front()) : Facts());
        return;
    }
    const QString& title = m_selection.title();
    m_heading->setText(count == 0         ? tr("Click an element in a view to see its properties")
                       : !title.isEmpty() ? tr("%1, %L2 elements; one of them:").arg(title).arg(count)
                       : count == 1       ? tr("One element")
                                          : tr("%L1 elements; of the last one:").arg(count));
    const auto current = m_selection.current();
    fill(current ? factsOf(m_selection.tree(), *current, m_unit) : Facts());
}

void ElementPanel::fill(const Facts& facts) {
    m_table->setRowCount(static_cast<int>(facts.size()));
    for (int row = 0; row < m_table->rowCount(); ++row) {
        const auto& [name, value] = facts[static_cast<std::size_t>(row)];
        m_table->setItem(row, 0, new QTableWidgetItem(name));
        m_table->item(row, 0)->setToolTip(name);
        auto* item = new QTableWidgetItem(value);
        item->setToolTip(value);
        if (linkOf(name)) {
            item->setForeground(palette().link());
            item->setToolTip(value + '\n' + tr("Click to select it"));
        }
        m_table->setItem(row, 1, item);
    }
    fitNames(*m_table);
}

void ElementPanel::follow(int row) {
    const QTableWidgetItem* name = m_table->item(row, 0);
    if (const auto link = name != nullptr ? linkOf(name->text()) : std::nullopt) {
        emit followed(*link);
    }
}

/// The colour of links is that of the theme.
void ElementPanel::changeEvent(QEvent* event) {
    QWidget::changeEvent(event);
    if (event->type() == QEvent::PaletteChange) {
        update();
    }
}

bool ElementPanel::eventFilter(QObject* watched, QEvent* event) {
    if (watched == m_table && event->type() == QEvent::Resize) {
        QMetaObject::invokeMethod(
            this, [this] { fitNames(*m_table); }, Qt::QueuedConnection);
    }
    if (watched == m_table && event->type() == QEvent::KeyPress) {
        const int key = static_cast<QKeyEvent*>(event)->key();
        if (key == Qt::Key_Return || key == Qt::Key_Enter) {
            follow(m_table->currentRow());
            return true;
        }
    }
    return QWidget::eventFilter(watched, event);
}

}  // namespace ui
