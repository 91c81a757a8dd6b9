#include "ui/parts/pins_panel.h"

#include <QHeaderView>
#include <QLabel>
#include <QLineEdit>
#include <QScopedValueRollback>

#include "ui/common/panel_parts.h"
#include "ui/parts/pin_text.h"

namespace ui {

namespace {

/// In letters.
constexpr std::pair<PinModel::Column, int> kWidths[] = {
    {PinModel::Pin, 9}, {PinModel::Net, 13}, {PinModel::Layer, 12}, {PinModel::X, 10}, {PinModel::Y, 10},
};

}  // namespace

PinsPanel::PinsPanel(PinModel& model, PartPicking& parts, SelectionModel& selection, const ActionSet& actions,
                     QWidget* parent)
    : QWidget(parent),
      m_model(model),
      m_parts(parts),
      m_selection(selection),
      m_table(new LinkedTable(model)),
      m_whose(new QLabel) {
    const int letter = fontMetrics().horizontalAdvance('0');
    for (const auto& [column, letters] : kWidths) {
        m_table->setColumnWidth(column, letter * letters);
    }
    m_table->keepNumbersWhole();
    m_table->horizontalHeader()->setStretchLastSection(true);
    addRowCommands(actions);
    layOut();
    connect(m_table, &LinkedTable::rowsSelected, this, &PinsPanel::takeRows);
    connect(&parts, &PartPicking::changed, this, [this] { follow(Due::Parts); });
    connect(&selection, &SelectionModel::netsChanged, this, [this] { follow(Due::Nets); });
}

/// Enter and a double click do the first of them.
void PinsPanel::addRowCommands(const ActionSet& actions) {
    QAction* show = m_table->addAction(tr("Show"), this, [this] {
        if (!m_table->selectedRows().empty()) {
            m_parts.showSelected();
        }
    });
    show->setObjectName(QStringLiteral("show"));
    connect(m_table, &QTableView::activated, show, &QAction::trigger);
    m_table->addAction(&actions[ActionId::HighlightNet]);
    m_table->addAction(&actions[ActionId::SelectComponent]);
}

void PinsPanel::layOut() {
    m_whose->setObjectName(QStringLiteral("pinsOf"));
    m_whose->setWordWrap(true);
    m_whose->setToolTip(tr("Pins of the components or nets chosen last in a view, Parts, Nets or the search box"));
    QLineEdit* filter = m_table->makeFilter(tr("Filter by pin, net or layer"));
    filter->setObjectName(QStringLiteral("pinFilter"));
    auto* controls = new QHBoxLayout;
    controls->addWidget(filter, 1);
    controls->addWidget(toolButton(*command(*this, "exportPins", tr("Export…"),
                                            tr("Export the rows as they are shown, as a table (CSV)"),
                                            [this] { emit exportRequested(); })));
    auto* whose = new QHBoxLayout;
    whose->addWidget(m_whose, 1);
    whose->addWidget(toolButton(*command(*this, "highlightNetsOfPins", tr("Highlight nets"),
                                         tr("Highlight the nets of the selected pins, or of all that are listed"),
                                         [this] { highlightNets(); })));
    auto* column = columnIn(*this);
    column->addLayout(controls);
    column->addLayout(whose);
    column->addWidget(m_table);
}

void PinsPanel::setBoard(const LoadedBoard& board) {
    m_model.setBoard(board);
    m_table->setColumnHidden(PinModel::Step, !m_model.hasSeveralSteps());
    follow(Due::Parts);
}

void PinsPanel::follow(Due what) {
    if (m_isTaking) {
        return;
    }
    m_due = what;
    if (m_isSeen) {
        what == Due::Parts ? followParts() : followNets();
    }
}

void PinsPanel::setSeen(bool isSeen) {
    m_isSeen = isSeen;
    if (isSeen && m_due != Due::Nothing) {
        follow(m_due);
    }
}

void PinsPanel::followParts() {
    m_due = Due::Nothing;
    const std::size_t elements = m_selection.selected().size();
    if (!m_parts.parts().empty()) {
        listPinsOfParts();
    } else if (elements > PartPicking::kMostElements) {
        listAllPins();
    } else if (const auto nets = m_selection.selectionNets(); !nets.empty()) {
        listPinsOfNets(nets, elements);
    } else if (!m_selection.nets().empty()) {  // none of the elements is on a net
        listPinsOfNets(m_selection.nets(), 0);
    } else {
        listAllPins();
    }
    markChosen();
}

void PinsPanel::followNets() {
    m_due = Due::Nothing;
    if (m_selection.nets().empty()) {
        followParts();
        return;
    }
    listPinsOfNets(m_selection.nets(), 0);
    markChosen();
}

void PinsPanel::listPinsOfParts() {
    std::vector<BoardPin> pins;
    for (const BoardPart& part : m_parts.parts()) {
        const model::Component& component = m_parts.document(part.step).components[part.component.row()];
        for (std::size_t row = 0; row < component.pinCount; ++row) {
            pins.push_back({part.step, model::PinId{component.firstPin + row}});
        }
    }
    m_model.setPins(std::move(pins));
    m_whose->setText(pinsOfPartsText(m_parts));
}

void PinsPanel::listPinsOfNets(const std::vector<model::BoardNet>& nets, std::size_t elements) {
    std::vector<BoardPin> pins;
    for (const model::BoardNet& net : nets) {
        for (const model::PinId pin : m_parts.finderOf(net.step).pinsOf(net.net)) {
            pins.push_back({net.step, pin});
        }
    }
    m_whose->setText(pinsOfNetsText(m_parts, nets, pins, elements));
    m_model.setPins(std::move(pins));
}

void PinsPanel::listAllPins() {
    m_model.setAllPins();
    const std::size_t elements = m_selection.selected().size();
    const QString all = tr("All %L1 pins of the board").arg(m_model.rowCount());
    m_whose->setText(m_model.rowCount() == 0                 ? tr("The job has no pins of components")
                     : elements > PartPicking::kMostElements ? tr("%1; too many elements are selected (%L2) to list "
                                                                  "theirs alone")
                                                                   .arg(all)
                                                                   .arg(elements)
                                                             : all);
}

void PinsPanel::takeRows(const std::vector<int>& rows) {
    const QScopedValueRollback guard(m_isTaking, true);
    std::vector<BoardPin> pins;
    for (const int row : rows) {
        pins.push_back(m_model.pinAt(row));
    }
    m_parts.select(pins);
    if (m_showsChosen && pins.size() == 1) {
        m_parts.showSelected();
    }
}

void PinsPanel::markChosen() {
    m_table->mark(m_model.rowsOf(m_parts.pins()));
}

void PinsPanel::highlightNets() {
    const std::vector<int> selected = m_table->selectedRows();
    std::vector<model::BoardNet> nets;
    for (const int row : selected.empty() ? m_table->shownRows() : selected) {
        if (const auto net = m_model.netAt(row)) {
            nets.push_back(*net);
        }
    }
    const QScopedValueRollback guard(m_isTaking, true);  // the list stays as it is
    m_selection.setNets(std::move(nets));
    markChosen();
}

}  // namespace ui
