#include "ui/parts/part_picking.h"

namespace ui {

namespace {

QString componentTitle(const model::Document& step, model::ComponentId component) {
    return PartPicking::tr("Component %1").arg(QString::fromStdString(step.components[component.row()].refdes));
}

QString pinTitle(const model::Document& step, model::PinId pin) {
    const model::Pin& row = step.pins[pin.row()];
    return PartPicking::tr("Pin %1.%2")
        .arg(QString::fromStdString(step.components[row.component.row()].refdes),
             QString::fromStdString(step.text(row.name)));
}

}  // namespace

PartPicking::PartPicking(const ActionSet& actions, Workspace& workspace, QObject* parent)
    : QObject(parent), m_workspace(workspace), m_selection(workspace.selection()) {
    connect(&workspace, &Workspace::boardShown, this, [this] { m_finders.clear(); });
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

const model::PinFinder& PartPicking::finderOf(std::uint32_t step) {
    m_finders.resize(m_selection.tree().steps.size());
    if (m_finders[step] == nullptr) {
        m_finders[step] = std::make_unique<model::PinFinder>(*m_selection.tree().steps[step]);
    }
    return *m_finders[step];
}

std::optional<model::BoardElement> PartPicking::target() {
    const auto at = m_selection.hovered() ? m_selection.hovered() : m_selection.current();
    if (!at) {
        m_workspace.report(tr("Point at a pad or a body, or select one"));
    }
    return at;
}

bool PartPicking::select(const QString& title, std::uint32_t copy, const std::vector<model::ElementId>& elements,
                         std::optional<model::ElementId> last) {
    std::vector<model::BoardElement> all;
    for (const model::ElementId element : elements) {
        all.push_back({copy, element});
    }
    if (last) {
        all.push_back({copy, *last});  // stays the one that the element panel shows
    }
    if (!all.empty()) {
        m_selection.selectAs(title, all);
    }
    return !all.empty();
}

void PartPicking::selectComponentOf(const model::BoardElement& at) {
    const std::uint32_t step = m_selection.tree().copies[at.copy].step;
    const model::ComponentId component = finderOf(step).componentOf(at.element);
    if (!component.isValid()) {
        m_workspace.report(tr("This element is neither a pad of a component nor its body"));
        return;
    }
    select(componentTitle(m_selection.stepOf(at), component), at.copy, finderOf(step).elementsOf(component),
           at.element);
}

void PartPicking::selectPinOf(const model::BoardElement& at) {
    const std::uint32_t step = m_selection.tree().copies[at.copy].step;
    const std::vector<model::PinId> pins = finderOf(step).pinsOf(at.element);
    if (pins.empty()) {
        m_workspace.report(tr("This element is no pad or hole of a pin"));
        return;
    }
    select(pinTitle(m_selection.stepOf(at), pins.front()), at.copy, finderOf(step).elementsOf(pins.front()),
           at.element);
}

bool PartPicking::selectComponent(std::uint32_t copy, model::ComponentId component) {
    const std::uint32_t step = m_selection.tree().copies[copy].step;
    return select(componentTitle(*m_selection.tree().steps[step], component), copy,
                  finderOf(step).elementsOf(component));
}

bool PartPicking::selectPin(std::uint32_t copy, model::PinId pin) {
    const std::uint32_t step = m_selection.tree().copies[copy].step;
    return select(pinTitle(*m_selection.tree().steps[step], pin), copy, finderOf(step).elementsOf(pin));
}

}  // namespace ui
