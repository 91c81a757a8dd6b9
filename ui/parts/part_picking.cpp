#include "ui/parts/part_picking.h"

#include <QScopedValueRollback>
#include <algorithm>

#include "model/index/pin_names.h"

namespace ui {

namespace {

template <class T>
void sortUnique(std::vector<T>& values) {
    std::ranges::sort(values);
    values.erase(std::unique(values.begin(), values.end()), values.end());
}

QString partsTitle(const PartPicking& parts, const std::vector<BoardPart>& chosen) {
    if (chosen.size() != 1) {
        return PartPicking::tr("%L1 components").arg(chosen.size());
    }
    const model::Document& step = parts.document(chosen.front().step);
    return PartPicking::tr("Component %1")
        .arg(QString::fromStdString(step.components[chosen.front().component.row()].refdes));
}

QString pinsTitle(const PartPicking& parts, const std::vector<BoardPin>& chosen) {
    return chosen.size() != 1 ? PartPicking::tr("%L1 pins").arg(chosen.size())
                              : PartPicking::tr("Pin %1").arg(QString::fromStdString(
                                    model::fullPinName(parts.document(chosen.front().step), chosen.front().pin)));
}

void add(std::uint32_t copy, const std::vector<model::ElementId>& elements, std::vector<model::BoardElement>& all) {
    for (const model::ElementId element : elements) {
        all.push_back({copy, element});
    }
}

}  // namespace

PartPicking::PartPicking(const ActionSet& actions, Workspace& workspace, QObject* parent)
    : QObject(parent), m_workspace(workspace), m_selection(workspace.selection()) {
    connect(&m_selection, &SelectionModel::selectionChanged, this, &PartPicking::onSelectionChanged);
    connect(&actions[ActionId::SelectComponent], &QAction::triggered, this, [this] {
        if (const auto at = target()) {
            selectComponentOf(*at);
        }
    });
    connect(&actions[ActionId::SelectPin], &QAction::triggered, this, [this] {
        if (const auto at = target()) {
            selectPinOf(*at);
        }
    });
}

const model::PinFinder& PartPicking::finderOf(std::uint32_t step) const {
    return m_workspace.board()->index->pins[step];
}

std::optional<BoardPart> PartPicking::wholePart() const {
    return m_parts.size() == 1 && m_pins.empty() && !m_selection.title().isEmpty() ? std::optional(m_parts.front())
                                                                                   : std::nullopt;
}

std::optional<model::BoardElement> PartPicking::target() {
    const auto at = m_selection.pointedOrCurrent();
    if (!at) {
        m_workspace.report(tr("Point at a pad or a body, or select one"));
    }
    return at;
}

void PartPicking::select(const Chosen& chosen, const std::vector<model::BoardElement>& elements) {
    const QScopedValueRollback guard(m_isChoosing, true);
    m_parts = chosen.parts;
    m_pins = chosen.pins;
    m_selection.selectAs(chosen.parts.empty() ? QString() : chosen.title, elements);
}

void PartPicking::selectComponentOf(const model::BoardElement& at) {
    const std::uint32_t step = m_selection.tree().copies[at.copy].step;
    const model::ComponentId component = finderOf(step).componentOf(at.element);
    if (!component.isValid()) {
        m_workspace.report(tr("This element is neither a pad of a component nor its body"));
        return;
    }
    const std::vector<BoardPart> parts{{step, component}};
    std::vector<model::BoardElement> elements;
    add(at.copy, finderOf(step).elementsOf(component), elements);
    elements.push_back(at);  // stays the one that the element panel shows
    select({partsTitle(*this, parts), parts, {}}, elements);
}

void PartPicking::selectPinOf(const model::BoardElement& at) {
    const std::uint32_t step = m_selection.tree().copies[at.copy].step;
    const std::vector<model::PinId> found = finderOf(step).pinsOf(at.element);
    if (found.empty()) {
        m_workspace.report(tr("This element is no pad or hole of a pin"));
        return;
    }
    const std::vector<BoardPin> pins{{step, found.front()}};
    std::vector<model::BoardElement> elements;
    add(at.copy, finderOf(step).elementsOf(found.front()), elements);
    elements.push_back(at);
    select({pinsTitle(*this, pins), {{step, document(step).pins[found.front().row()].component}}, pins}, elements);
}

void PartPicking::select(std::vector<BoardPart> parts) {
    sortUnique(parts);
    std::vector<model::BoardElement> elements;
    for (const BoardPart& part : parts) {
        add(m_selection.firstCopyOf(part.step), finderOf(part.step).elementsOf(part.component), elements);
    }
    if (elements.empty() && !parts.empty()) {
        m_workspace.report(tr("%1: no pads, holes or body to show").arg(partsTitle(*this, parts)));
    }
    select({partsTitle(*this, parts), parts, {}}, elements);
}

void PartPicking::select(std::vector<BoardPin> pins) {
    sortUnique(pins);
    std::vector<model::BoardElement> elements;
    std::vector<BoardPart> parts;
    for (const BoardPin& pin : pins) {
        add(m_selection.firstCopyOf(pin.step), finderOf(pin.step).elementsOf(pin.pin), elements);
        parts.push_back({pin.step, document(pin.step).pins[pin.pin.row()].component});
    }
    sortUnique(parts);
    if (elements.empty() && !pins.empty()) {
        m_workspace.report(tr("%1: no pads or holes to show").arg(pinsTitle(*this, pins)));
    }
    select({pinsTitle(*this, pins), parts, pins}, elements);
}

void PartPicking::showSelected() {
    if (!m_selection.selected().empty()) {
        m_workspace.showElements(m_selection.selected());
        return;
    }
    const auto showPlace = [this](std::uint32_t step, model::Point location) {
        const model::StepCopy& copy = m_selection.tree().copies[m_selection.firstCopyOf(step)];
        m_workspace.showLocation(copy.placement.apply(base::toDouble(location)), {});
    };
    if (!m_pins.empty()) {
        showPlace(m_pins.front().step, document(m_pins.front().step).pins[m_pins.front().pin.row()].position);
    } else if (!m_parts.empty()) {
        const model::Component& part = document(m_parts.front().step).components[m_parts.front().component.row()];
        showPlace(m_parts.front().step, part.placement.origin);
    }
}

void PartPicking::onSelectionChanged() {
    if (!m_isChoosing) {
        m_parts.clear();
        m_pins.clear();
        if (m_selection.selected().size() <= kMostElements) {
            std::ranges::for_each(m_selection.selected(), [&](const model::BoardElement& at) { findParts(at); });
        }
        sortUnique(m_parts);
        sortUnique(m_pins);
    }
    emit changed();
}

void PartPicking::findParts(const model::BoardElement& at) {
    const std::uint32_t step = m_selection.tree().copies[at.copy].step;
    const auto addPart = [&](model::ComponentId component) {
        if (component.isValid()) {
            m_parts.push_back({step, component});
        }
    };
    if (const model::Body* body = document(step).bodyOf(at.element)) {
        addPart(body->component);
    }
    for (const model::PinId pin : finderOf(step).pinsOf(at.element)) {
        m_pins.push_back({step, pin});
        addPart(document(step).pins[pin.row()].component);
    }
}

}  // namespace ui
