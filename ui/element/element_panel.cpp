#include "ui/element/element_panel.h"

#include <QEvent>
#include <QHeaderView>
#include <QLabel>
#include <QVBoxLayout>
#include <algorithm>

#include "ui/common/net_name.h"
#include "ui/common/table_view.h"
#include "ui/element/component_facts.h"
#include "ui/element/element_picture.h"
#include "ui/element/net_facts.h"
#include "ui/parts/pin_text.h"

namespace ui {

namespace {

constexpr double kMostOfNames = 0.45;  // of the table

/// Attributes have long names: these are cut where a value would have no room for them.
void fitNames(TableView& table) {
    const QAbstractItemView& cells = table;
    const int room = table.viewport()->width();
    const int besideValues = room - cells.sizeHintForColumn(FactModel::Value);
    const int most = std::max(static_cast<int>(room * kMostOfNames), besideValues);
    table.setColumnWidth(FactModel::Name, std::min(cells.sizeHintForColumn(FactModel::Name) + 1, most));
}

}  // namespace

ElementPanel::ElementPanel(PartPicking& parts, SelectionModel& selection, ElementPicture* picture, QWidget* parent)
    : QWidget(parent), m_parts(parts), m_selection(selection), m_heading(new QLabel), m_table(new TableView(m_facts)) {
    m_heading->setObjectName(QStringLiteral("elementHeading"));
    m_heading->setWordWrap(true);
    m_table->horizontalHeader()->hide();
    m_table->horizontalHeader()->setStretchLastSection(true);
    m_table->installEventFilter(this);
    connect(m_table, &TableView::clicked, this, [this](const QModelIndex& at) {
        if (at.column() == FactModel::Value) {
            follow(at);
        }
    });
    connect(m_table, &TableView::enterPressed, this, &ElementPanel::follow);
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
    fill(current ? factsOf(m_parts.index(), *current, m_unit) : Facts());
}

void ElementPanel::fill(Facts facts) {
    m_facts.setFacts(std::move(facts), palette().link().color());
    fitNames(*m_table);
}

void ElementPanel::follow(const QModelIndex& at) {
    if (const auto link = at.isValid() ? m_facts.linkOf(at.row()) : std::nullopt) {
        emit followed(*link, at.siblingAtColumn(FactModel::Value).data().toString());
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
    return QWidget::eventFilter(watched, event);
}

}  // namespace ui
