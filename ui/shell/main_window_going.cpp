// How the window goes to what a table or the search has named.

#include <QStatusBar>
#include <algorithm>

#include "ui/layers/layers_panel.h"
#include "ui/messages/message_location.h"
#include "ui/parts/part_picking.h"
#include "ui/shell/main_window.h"
#include "ui/views/probing.h"

namespace ui {

void MainWindow::goTo(const model::Diagnostic& message) {
    const std::optional<render::Box3> location =
        locationOf(message, *m_board->document, render::frameOf(*m_board->document));
    if (!location) {
        statusBar()->showMessage(QStringLiteral("This message is not about one place on the board"));
        return;
    }
    m_selection.select({});
    if (message.element.isValid()) {
        m_selection.select({{0, message.element}});
        showLayer(m_board->document->elements.layer[message.element.row()]);
    }
    for (BoardView* view : m_views->both()) {
        view->controller().show(location->min, location->max);
    }
}

void MainWindow::goTo(const NetCheckModel::Finding& finding) {
    const model::StepTree& tree = m_selection.tree();
    const auto copy = std::ranges::find(tree.copies, finding.step, &model::StepCopy::step);
    const auto row = static_cast<std::uint32_t>(copy - tree.copies.begin());
    std::vector<model::BoardElement> elements;
    for (const model::ElementId element : m_netCheckModel.elementsOf(finding)) {
        elements.push_back({row, element});
    }
    const model::LayerId layer =
        tree.steps[finding.step]->layerOfCopy(m_netCheckModel.layerOf(finding), copy->isFlipped);
    showLayer(layer);
    m_selection.select(elements);
    m_probing->showPosition(copy->placement.apply(m_netCheckModel.locationOf(finding)), layer);
}

void MainWindow::goTo(const Found& found) {
    switch (found.kind) {
        case FoundKind::Location: m_probing->showPosition(found.location, {}); break;
        case FoundKind::Layer:
            showLayer(model::LayerId{std::size_t{found.row}});
            m_layersPanel->selectRow(static_cast<int>(found.row));
            break;
        case FoundKind::Net:
            m_selection.setNets({{found.step, model::NetId{std::size_t{found.row}}}});
            m_probing->showNets(m_selection.nets());
            break;
        case FoundKind::Component:
        case FoundKind::Pin: goToPart(found); break;
    }
}

/// In the first copy of its step.
void MainWindow::goToPart(const Found& found) {
    const model::StepTree& tree = m_selection.tree();
    const auto copy = std::ranges::find(tree.copies, found.step, &model::StepCopy::step);
    const auto at = static_cast<std::uint32_t>(copy - tree.copies.begin());
    const std::size_t row = found.row;
    const bool isPin = found.kind == FoundKind::Pin;
    m_selection.select({});
    if (isPin ? m_parts->selectPin(at, model::PinId{row}) : m_parts->selectComponent(at, model::ComponentId{row})) {
        m_probing->showInBoth(m_selection.selected());
        return;
    }
    const model::Document& step = *tree.steps[found.step];
    const model::Point location = isPin ? step.pins[row].position : step.components[row].placement.origin;
    m_probing->showPosition(copy->placement.apply(base::toDouble(location)), {});
}

void MainWindow::showLayer(model::LayerId layer) {
    const QModelIndex visible = m_layerModel.index(static_cast<int>(layer.row()), LayerModel::Visible);
    m_layerModel.setData(visible, Qt::Checked, Qt::CheckStateRole);
}

}  // namespace ui
