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
    return PartPicking::tr("Component %1").arg(parts.nameOf(chosen.front()));
}

/// A pin in a hole is on both sides, whichever its component is on.
bool isThroughBoard(const PartPicking& parts, const BoardPin& pin) {
    const model::ElementTable& elements = parts.document(pin.step).elements;
    return std::ranges::any_of(parts.finderOf(pin.step).elementsOf(pin.pin), [&](model::ElementId element) {
        return (elements.flags[element.row()] & model::kHole) != 0;
    });
}

/// Are they the pads of one?
bool isOnePin(const PartPicking& parts, const std::vector<BoardPin>& chosen) {
    const BoardPin& first = chosen.front();
    const std::vector<model::PinId> pads = model::pinsNamedAs(parts.document(first.step), first.pin);
    return std::ranges::all_of(chosen, [&](const BoardPin& pin) {
        return pin.step == first.step && std::ranges::binary_search(pads, pin.pin);
    });
}

QString pinsTitle(const PartPicking& parts, const std::vector<BoardPin>& chosen) {
    if (chosen.empty() || !isOnePin(parts, chosen)) {
        return PartPicking::tr("%L1 pins").arg(chosen.size());
    }
    const auto [step, pin] = chosen.front();
    const model::Document& document = parts.document(step);
    const bool isOnBottom =
        parts.isOnBottom({step, document.pins[pin.row()].component}) && !isThroughBoard(parts, chosen.front());
    return (isOnBottom ? PartPicking::tr("Pin %1 (bottom)") : PartPicking::tr("Pin %1"))
        .arg(QString::fromStdString(model::fullPinName(document, pin)));
}

void add(std::uint32_t copy, const std::vector<model::ElementId>& elements, std::vector<model::BoardElement>& all) {
    for (const model::ElementId element : elements) {
        all.push_back({copy, element});
    }
}

}  // namespace

PartPicking::PartPicking(const ActionSet& actions, Workspace& workspace, QObject* parent)
    : QObject(parent), m_workspace(workspace), m_selection(workspace.selection()), m_hint(workspace) {
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

const model::BoardIndex& PartPicking::index() const {
    return *m_workspace.board()->index;
}

std::optional<BoardPart> PartPicking::wholePart() const {
    return m_parts.size() == 1 && m_pins.empty() && !m_selection.title().isEmpty() ? std::optional(m_parts.front())
                                                                                   : std::nullopt;
}

bool PartPicking::isOnBottom(const BoardPart& part) const {
    if (!part.component.isValid()) {
        return false;
    }
    const bool isFlipped = m_selection.tree().copies[m_selection.firstCopyOf(part.step)].isFlipped;
    const model::LayerSide side = document(part.step).components[part.component.row()].side;
    return side == (isFlipped ? model::LayerSide::Top : model::LayerSide::Bottom);
}

QString PartPicking::nameOf(const BoardPart& part) const {
    const QString name = QString::fromStdString(document(part.step).components[part.component.row()].refdes);
    return isOnBottom(part) ? tr("%1 (bottom)").arg(name) : name;
}

std::optional<model::BoardElement> PartPicking::target() {
    const auto hasNone = [](const model::Document* step) { return step->components.empty(); };
    if (std::ranges::all_of(m_selection.tree().steps, hasNone)) {
        m_hint.show(tr("The job has no components"));
        return std::nullopt;
    }
    const auto at = m_selection.pointedOrCurrent();
    if (at) {
        m_hint.end();
    } else {
        m_hint.show(tr("Point at a pad or a body, or select one"));
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
    m_workspace.report(tr("%1 is selected").arg(partsTitle(*this, parts)));
}

void PartPicking::selectPinOf(const model::BoardElement& at) {
    const std::uint32_t step = m_selection.tree().copies[at.copy].step;
    const std::vector<model::PinId> found = finderOf(step).pinsOf(at.element);
    if (found.empty()) {
        m_workspace.report(tr("This element is no pad or hole of a pin"));
        return;
    }
    const std::vector<BoardPin> pins = padsOf({step, found.front()});
    std::vector<model::BoardElement> elements;
    for (const BoardPin& pin : pins) {
        add(at.copy, finderOf(step).elementsOf(pin.pin), elements);
    }
    elements.push_back(at);
    select({pinsTitle(*this, pins), {{step, document(step).pins[found.front().row()].component}}, pins}, elements);
    m_workspace.report(tr("%1 is selected").arg(pinsTitle(*this, pins)));
}

std::vector<BoardPin> PartPicking::padsOf(const BoardPin& pin) const {
    std::vector<BoardPin> pads;
    for (const model::PinId pad : model::pinsNamedAs(document(pin.step), pin.pin)) {
        pads.push_back({pin.step, pad});
    }
    return pads;
}

void PartPicking::selectPinNamedAs(const BoardPin& pin) {
    select(padsOf(pin));
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
    endWithCopper(elements);
    if (elements.empty() && !pins.empty()) {
        m_workspace.report(tr("%1: no pads or holes to show").arg(pinsTitle(*this, pins)));
    }
    select({pinsTitle(*this, pins), parts, pins}, elements);
}

/// The last one is what the element panel shows: of pads on copper, solder mask and paste it is the copper.
void PartPicking::endWithCopper(std::vector<model::BoardElement>& elements) const {
    const auto isCopper = [&](const model::BoardElement& at) {
        const model::Document& step = m_selection.stepOf(at);
        return step.layer(step.elements.layer[at.element.row()]).isCopper();
    };
    if (const auto found = std::ranges::find_if(elements, isCopper); found != elements.end()) {
        std::rotate(found, found + 1, elements.end());
    }
}

void PartPicking::showSelected() {
    if (m_parts.size() == 1 && isOnBottom(m_parts.front())) {
        m_hint.show(tr("%1 is on the bottom of the board")
                        .arg(QString::fromStdString(
                            document(m_parts.front().step).components[m_parts.front().component.row()].refdes)));
    } else {
        m_hint.end();
    }
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
    m_hint.end();
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
