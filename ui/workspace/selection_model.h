#pragma once

#include <QObject>
#include <memory>
#include <optional>
#include <vector>

#include "model/board/copies.h"

namespace ui {

/// What the user works on: one for the whole window. Views, tables, search and tools change it here and follow it here,
/// so that what is chosen in one is chosen in all. From what passes to what stays it holds
///
///     hovered    the element under the pointer
///     selected   elements; a pin or a component is all its elements, with a title
///     nets       highlighted as a whole, several each in a colour of its own
///
/// The selection that commands work on (colour, hide, isolate, show in both views, follow, save, section along a net)
/// is what was chosen last: the selected elements, or if there are none the highlighted nets. `selectionNets` and
/// `selectionElements` say it in nets and in elements; nobody works it out anew. What lies under the pointer counts
/// while nothing is chosen, and for the commands that choose (N, P, Shift+P) once the pointer has come to another
/// element: `pointed`.
///
///     gesture                                               changes
///     the pointer moves                                     hovered
///     click, box, Tab; P, search for a part                 selected; nets stay highlighted
///     Ctrl + click, Ctrl + box                              selected, added or taken away
///     N, search for a net, row of Nets, link in Element     nets; no elements are selected any more
///     Ctrl+N, Ctrl + row of Nets                            nets, one added or taken away; the same
///     right click on something that is not chosen           selected, as a click does
///     Esc                                                   one step back: the elements, then the nets
///     Undo                                                  nets, as they were before their last change
class SelectionModel : public QObject {
    Q_OBJECT

public:
    using QObject::QObject;

    /// Forgets everything; a null tree is an empty board. The document behind the tree must live as long as it is set.
    void setBoard(std::shared_ptr<const model::Document> board);

    /// None when the pointer is over nothing.
    void hover(std::optional<model::BoardElement> element);
    [[nodiscard]] std::optional<model::BoardElement> hovered() const { return m_hovered; }

    enum class Mode { Replace, Toggle };
    /// Nothing selected when `elements` is empty and they replace. Toggled ones change sides. Nets stay highlighted.
    void select(const std::vector<model::BoardElement>& elements, Mode mode = Mode::Replace);
    /// Elements that are one item together, and what it is: "Component U1".
    void selectAs(const QString& title, const std::vector<model::BoardElement>& elements);
    /// What is selected, if it is more than its elements; else empty.
    [[nodiscard]] const QString& title() const { return m_title; }
    /// In rising order.
    [[nodiscard]] const std::vector<model::BoardElement>& selected() const { return m_selected; }
    /// The one selected last; none when nothing is selected.
    [[nodiscard]] std::optional<model::BoardElement> current() const { return m_current; }

    /// These and no others. Where there are any, they are the selection: no elements are selected any more.
    void setNets(std::vector<model::BoardNet> nets);
    /// Each of them changes sides.
    void toggleNets(const std::vector<model::BoardNet>& nets);
    /// In rising order. A net of a step that is placed often is highlighted in all its copies.
    [[nodiscard]] const std::vector<model::BoardNet>& nets() const { return m_nets; }
    /// What lies near what is selected or highlighted (the clearance lens); in rising order.
    void setNearby(std::vector<model::BoardElement> elements);
    [[nodiscard]] const std::vector<model::BoardElement>& nearby() const { return m_nearby; }
    /// What a tool has taken and waits with: outlined, and nothing else.
    void mark(std::vector<model::BoardElement> elements);
    [[nodiscard]] const std::vector<model::BoardElement>& marked() const { return m_marked; }
    /// The nets of the selection, in rising order: those of the selected elements, or if there are none all that are
    /// highlighted. Time of one pass over what is selected.
    [[nodiscard]] std::vector<model::BoardNet> selectionNets() const;
    /// The elements of the selection: the selected ones, or if there are none those of the highlighted nets.
    [[nodiscard]] std::vector<model::BoardElement> selectionElements() const;
    [[nodiscard]] bool isEmpty() const { return m_selected.empty() && m_nets.empty(); }
    /// The element under the pointer if it came there after the last choice, or nothing is chosen: so that a choice is
    /// not lost to a pointer that rests somewhere.
    [[nodiscard]] std::optional<model::BoardElement> pointed() const;
    /// What a command that chooses more of an element goes on from.
    [[nodiscard]] std::optional<model::BoardElement> pointedOrCurrent() const;
    /// The net of an element; none if it has none.
    [[nodiscard]] std::optional<model::BoardNet> netOf(const model::BoardElement& element) const;

    /// Clears the selection, or if there is none the highlighted nets. False when there was nothing to clear.
    bool clearStep();

    [[nodiscard]] const model::StepTree& tree() const { return m_tree; }
    /// The document an element is a row of.
    [[nodiscard]] const model::Document& stepOf(const model::BoardElement& element) const {
        return *m_tree.steps[m_tree.copies[element.copy].step];
    }
    /// The same for work in the background, which may outlive the board.
    [[nodiscard]] std::shared_ptr<const model::Document> sharedStepOf(const model::BoardElement& element) const {
        return {m_board, &stepOf(element)};
    }
    /// The layer of the board that an element is on: of a flipped copy not the one that it has in its step.
    [[nodiscard]] model::LayerId layerOf(const model::BoardElement& element) const;
    /// Row of `tree().copies`: the first copy of a step.
    [[nodiscard]] std::uint32_t firstCopyOf(std::uint32_t step) const;
    /// Of steps that are placed often, in the first copy.
    [[nodiscard]] std::vector<model::BoardElement> elementsOf(const std::vector<model::BoardNet>& nets) const;
    /// Elements of the board itself that are selected or of a highlighted net, in no order; those of copies of other
    /// steps are left out.
    [[nodiscard]] std::vector<model::ElementId> ownElements() const;
    /// All that stands out, per row of `tree().steps`: selected, nearby, and the elements of the nets; in rising
    /// order.
    [[nodiscard]] std::vector<std::vector<model::ElementId>> highlight() const;

signals:
    void hoverChanged();
    /// Once per change, however many elements it concerns.
    void selectionChanged();
    void netsChanged();
    /// What `highlight` returns is another.
    void highlightChanged();
    void marksChanged();

private:
    std::shared_ptr<const model::Document> m_board;
    model::StepTree m_tree;
    std::optional<model::BoardElement> m_hovered;
    bool m_isHoveredNewer = false;  ///< than what was chosen
    std::vector<model::BoardElement> m_selected;
    QString m_title;
    QString m_nextTitle;  ///< of the selection that is being made
    std::optional<model::BoardElement> m_current;
    std::vector<model::BoardNet> m_nets;
    std::vector<model::BoardElement> m_nearby;
    std::vector<model::BoardElement> m_marked;
};

}  // namespace ui
