#pragma once

#include <QObject>
#include <memory>
#include <optional>
#include <vector>

#include "model/board/copies.h"

namespace ui {

/// What the user points at: the element under the pointer, the selected elements, the highlighted nets. Views, tables
/// and tools share one of these, so that what is chosen in one is seen in all.
///
/// Hovering is fleeting, selecting replaces or adds, nets stay highlighted until they are cleared. `clearStep` takes
/// back one of them at a time, the most fleeting first.
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
    /// Nothing selected when `elements` is empty and they replace. Toggled ones change sides.
    void select(const std::vector<model::BoardElement>& elements, Mode mode = Mode::Replace);
    /// Elements that are one item together, and what it is: "Component U1".
    void selectAs(const QString& title, const std::vector<model::BoardElement>& elements);
    /// What is selected, if it is more than its elements; else empty.
    [[nodiscard]] const QString& title() const { return m_title; }
    /// In rising order.
    [[nodiscard]] const std::vector<model::BoardElement>& selected() const { return m_selected; }
    /// The one selected last; none when nothing is selected.
    [[nodiscard]] std::optional<model::BoardElement> current() const { return m_current; }

    void setNets(std::vector<model::BoardNet> nets);
    void toggleNet(const model::BoardNet& net);
    /// In rising order. A net of a step that is placed often is highlighted in all its copies.
    [[nodiscard]] const std::vector<model::BoardNet>& nets() const { return m_nets; }
    /// What lies near what is selected or highlighted (the clearance lens); in rising order.
    void setNearby(std::vector<model::BoardElement> elements);
    [[nodiscard]] const std::vector<model::BoardElement>& nearby() const { return m_nearby; }
    /// The net of an element; none if it has none.
    [[nodiscard]] std::optional<model::BoardNet> netOf(const model::BoardElement& element) const;

    /// Clears the selection, or if there is none the highlighted nets. False when there was nothing to clear.
    bool clearStep();

    [[nodiscard]] const model::StepTree& tree() const { return m_tree; }
    /// The document an element is a row of.
    [[nodiscard]] const model::Document& stepOf(const model::BoardElement& element) const {
        return *m_tree.steps[m_tree.copies[element.copy].step];
    }
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

private:
    std::shared_ptr<const model::Document> m_board;
    model::StepTree m_tree;
    std::optional<model::BoardElement> m_hovered;
    std::vector<model::BoardElement> m_selected;
    QString m_title;
    QString m_nextTitle;  ///< of the selection that is being made
    std::optional<model::BoardElement> m_current;
    std::vector<model::BoardNet> m_nets;
    std::vector<model::BoardElement> m_nearby;
};

}  // namespace ui
