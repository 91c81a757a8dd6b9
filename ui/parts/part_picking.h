#pragma once

#include <QObject>
#include <optional>

#include "model/index/pin_finder.h"
#include "ui/workspace/actions.h"
#include "ui/workspace/hint.h"
#include "ui/workspace/workspace.h"

namespace ui {

/// One component of the board: its row inside a document of the tree. It lies wherever that document is placed.
struct BoardPart {
    std::uint32_t step = 0;  ///< row of model::StepTree::steps
    model::ComponentId component;
    constexpr auto operator<=>(const BoardPart&) const = default;
};

/// One pin of the board, as BoardPart.
struct BoardPin {
    std::uint32_t step = 0;
    model::PinId pin;
    constexpr auto operator<=>(const BoardPin&) const = default;
};

/// From elements to the components and pins they belong to, and back: what is selected is known as elements
/// (SelectionModel) and here as components and pins. Choosing a component or pin selects all its pads and holes, and
/// the body of a component, in the first copy of its step. P and Shift+P do it for what is under the pointer or
/// selected, Ctrl+Shift and a click for what is clicked.
class PartPicking : public QObject {
    Q_OBJECT

public:
    PartPicking(const ActionSet& actions, Workspace& workspace, QObject* parent = nullptr);

    void selectComponentOf(const model::BoardElement& at);
    /// With all its pads.
    void selectPinOf(const model::BoardElement& at);
    /// All pads of the pin that is called as this one is; `select` takes only what is given.
    void selectPinNamedAs(const BoardPin& pin);
    void select(std::vector<BoardPart> parts);
    void select(std::vector<BoardPin> pins);
    /// Brings what is selected to the middle of the views, or where the first chosen one is placed if that has no
    /// elements, and reports that it is on the bottom: a view from the top shows it through the board.
    void showSelected();

    /// Of what is selected, in rising order; both empty while more elements are selected than kMostElements.
    [[nodiscard]] const std::vector<BoardPart>& parts() const { return m_parts; }
    /// Empty if whole components were chosen: then it is all of theirs.
    [[nodiscard]] const std::vector<BoardPin>& pins() const { return m_pins; }
    /// The one component that was chosen as a whole.
    [[nodiscard]] std::optional<BoardPart> wholePart() const;
    /// "R100", or "R100 (bottom)", as its first copy lies.
    [[nodiscard]] QString nameOf(const BoardPart& part) const;
    [[nodiscard]] bool isOnBottom(const BoardPart& part) const;
    static constexpr std::size_t kMostElements = 100'000;

    /// Of a board that has elements.
    [[nodiscard]] const model::BoardIndex& index() const;
    /// Of a row of model::StepTree::steps, of such a board.
    [[nodiscard]] const model::PinFinder& finderOf(std::uint32_t step) const { return index().pins[step]; }
    [[nodiscard]] const model::Document& document(std::uint32_t step) const { return *m_selection.tree().steps[step]; }

signals:
    /// What is selected is another; `parts` and `pins` are known.
    void changed();

private:
    struct Chosen {
        QString title;
        std::vector<BoardPart> parts;
        std::vector<BoardPin> pins;
    };
    void select(const Chosen& chosen, const std::vector<model::BoardElement>& elements);
    void onSelectionChanged();
    [[nodiscard]] std::vector<BoardPin> padsOf(const BoardPin& pin) const;
    void findParts(const model::BoardElement& at);
    void endWithCopper(std::vector<model::BoardElement>& elements) const;
    [[nodiscard]] std::optional<model::BoardElement> target();

    Workspace& m_workspace;
    SelectionModel& m_selection;
    Hint m_hint;  ///< what a command lacks, or where the selected part is
    std::vector<BoardPart> m_parts;
    std::vector<BoardPin> m_pins;
    bool m_isChoosing = false;  ///< the selection becomes what was chosen here
};

}  // namespace ui
