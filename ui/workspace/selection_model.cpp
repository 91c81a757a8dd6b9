#include "ui/workspace/selection_model.h"

#include <algorithm>
#include <iterator>
#include <utility>

namespace ui {

namespace {

template <class T>
void sortUnique(std::vector<T>& values) {
    std::ranges::sort(values);
    values.erase(std::unique(values.begin(), values.end()), values.end());
}

template <class T>
std::vector<T> toggled(const std::vector<T>& before, std::vector<T> changes) {
    sortUnique(changes);
    std::vector<T> after;
    std::ranges::set_symmetric_difference(before, changes, std::back_inserter(after));
    return after;
}

}  // namespace

void SelectionModel::setBoard(std::shared_ptr<const model::Document> board) {
    m_board = std::move(board);
    m_tree = m_board ? model::unfoldCopies(*m_board) : model::StepTree{};
    m_hovered.reset();
    m_current.reset();
    m_selected.clear();
    m_title.clear();
    m_nets.clear();
    m_nearby.clear();
    emit hoverChanged();
    emit selectionChanged();
    emit netsChanged();
    emit highlightChanged();
}

void SelectionModel::hover(std::optional<model::BoardElement> element) {
    if (element != m_hovered) {
        m_hovered = element;
        emit hoverChanged();
    }
}

void SelectionModel::selectAs(const QString& title, const std::vector<model::BoardElement>& elements) {
    m_nextTitle = title;
    select(elements);
}

void SelectionModel::select(const std::vector<model::BoardElement>& elements, Mode mode) {
    m_title = std::exchange(m_nextTitle, QString());
    m_selected = mode == Mode::Toggle ? toggled(m_selected, elements) : elements;
    sortUnique(m_selected);
    const auto isSelected = [&](const model::BoardElement& e) { return std::ranges::binary_search(m_selected, e); };
    if (!elements.empty() && isSelected(elements.back())) {
        m_current = elements.back();
    } else if (!m_current || !isSelected(*m_current)) {
        m_current = m_selected.empty() ? std::nullopt : std::optional(m_selected.back());
    }
    emit selectionChanged();
    emit highlightChanged();
}

void SelectionModel::setNets(std::vector<model::BoardNet> nets) {
    sortUnique(nets);
    if (nets != m_nets) {
        m_nets = std::move(nets);
        emit netsChanged();
        emit highlightChanged();
    }
}

void SelectionModel::setNearby(std::vector<model::BoardElement> elements) {
    sortUnique(elements);
    if (elements != m_nearby) {
        m_nearby = std::move(elements);
        emit highlightChanged();
    }
}

void SelectionModel::toggleNet(const model::BoardNet& net) {
    setNets(toggled(m_nets, {net}));
}

std::optional<model::BoardNet> SelectionModel::netOf(const model::BoardElement& element) const {
    const model::NetId net = stepOf(element).elements.net[element.element.row()];
    return net.isValid() ? std::optional(model::BoardNet{m_tree.copies[element.copy].step, net}) : std::nullopt;
}

bool SelectionModel::clearStep() {
    if (!m_selected.empty()) {
        select({});
        return true;
    }
    const bool hadNets = !m_nets.empty();
    setNets({});
    return hadNets;
}

std::uint32_t SelectionModel::firstCopyOf(std::uint32_t step) const {
    return static_cast<std::uint32_t>(std::ranges::find(m_tree.copies, step, &model::StepCopy::step) -
                                      m_tree.copies.begin());
}

std::vector<model::BoardElement> SelectionModel::elementsOf(const std::vector<model::BoardNet>& nets) const {
    std::vector<model::BoardElement> elements;
    for (const model::BoardNet& net : nets) {
        for (const model::ElementId element : m_tree.steps[net.step]->elementsOf(net.net)) {
            elements.push_back({firstCopyOf(net.step), element});
        }
    }
    return elements;
}

std::vector<model::ElementId> SelectionModel::ownElements() const {
    std::vector<model::ElementId> elements;
    for (const model::BoardElement& at : m_selected) {
        if (at.copy == 0) {
            elements.push_back(at.element);
        }
    }
    for (const model::BoardNet& net : m_nets) {
        if (net.step == 0) {
            const auto own = m_board->elementsOf(net.net);
            elements.insert(elements.end(), own.begin(), own.end());
        }
    }
    return elements;
}

std::vector<std::vector<model::ElementId>> SelectionModel::highlight() const {
    std::vector<std::vector<model::ElementId>> elements(m_tree.steps.size());
    const auto add = [&](const model::BoardElement& element) {
        elements[m_tree.copies[element.copy].step].push_back(element.element);
    };
    std::ranges::for_each(m_selected, add);
    std::ranges::for_each(m_nearby, add);
    for (const model::BoardNet& net : m_nets) {
        const auto members = m_tree.steps[net.step]->elementsOf(net.net);
        elements[net.step].insert(elements[net.step].end(), members.begin(), members.end());
    }
    for (std::vector<model::ElementId>& list : elements) {
        sortUnique(list);
    }
    return elements;
}

}  // namespace ui
