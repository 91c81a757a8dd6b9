#pragma once

#include <QObject>
#include <memory>
#include <optional>

#include "model/index/pin_finder.h"
#include "ui/element/element_panel.h"
#include "ui/workspace/actions.h"
#include "ui/workspace/selection_model.h"

namespace ui {

/// From an element to the component or pin it belongs to: all its pads and holes, and the body of a component, become
/// the selection. P and Shift+P do it for what is under the cursor or selected, Ctrl+Shift and a click for what is
/// clicked.
class PartPicking : public QObject {
    Q_OBJECT

public:
    PartPicking(const ActionSet& actions, SelectionModel& selection, QObject* parent = nullptr);

    /// The selection must be of another board already.
    void clearBoard() { m_finders.clear(); }
    void selectComponentOf(const model::BoardElement& at);
    void selectPinOf(const model::BoardElement& at);
    /// Of one copy of a step. False if nothing there is of it.
    bool selectComponent(std::uint32_t copy, model::ComponentId component);
    bool selectPin(std::uint32_t copy, model::PinId pin);
    /// Goes on from the element selected last to what it belongs to.
    void follow(ElementPanel::Link link);

signals:
    void layerChosen(model::LayerId layer);
    void missed(const QString& what);

private:
    [[nodiscard]] const model::PinFinder& finderOf(std::uint32_t step);
    bool select(const QString& title, std::uint32_t copy, const std::vector<model::ElementId>& elements,
                std::optional<model::ElementId> last = std::nullopt);
    [[nodiscard]] std::optional<model::BoardElement> target();

    SelectionModel& m_selection;
    std::vector<std::unique_ptr<model::PinFinder>> m_finders;  ///< per row of model::StepTree::steps, made when needed
};

}  // namespace ui
