#pragma once

#include <QObject>
#include <memory>
#include <optional>

#include "model/index/pin_finder.h"
#include "ui/workspace/actions.h"
#include "ui/workspace/workspace.h"

namespace ui {

/// From an element to the component or pin it belongs to: all its pads and holes, and the body of a component, become
/// the selection. P and Shift+P do it for what is under the pointer or selected, Ctrl+Shift and a click for what is
/// clicked.
class PartPicking : public QObject {
    Q_OBJECT

public:
    PartPicking(const ActionSet& actions, Workspace& workspace, QObject* parent = nullptr);

    void selectComponentOf(const model::BoardElement& at);
    void selectPinOf(const model::BoardElement& at);
    /// Of one copy of a step. False if nothing there is of it.
    bool selectComponent(std::uint32_t copy, model::ComponentId component);
    bool selectPin(std::uint32_t copy, model::PinId pin);

private:
    [[nodiscard]] const model::PinFinder& finderOf(std::uint32_t step);
    bool select(const QString& title, std::uint32_t copy, const std::vector<model::ElementId>& elements,
                std::optional<model::ElementId> last = std::nullopt);
    [[nodiscard]] std::optional<model::BoardElement> target();

    Workspace& m_workspace;
    SelectionModel& m_selection;
    std::vector<std::unique_ptr<model::PinFinder>> m_finders;  ///< per row of model::StepTree::steps, made when needed
};

}  // namespace ui
