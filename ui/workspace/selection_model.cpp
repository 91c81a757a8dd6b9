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
    m_isHoveredNewer = false;
    m_current.reset();
    m_selected.clear();
    m_title.clear();
    m_nets.clear();
    m_nearby.clear();
    m_marked.clear();
    emit hoverChanged();
    emit selectionChanged();
    emit netsChanged();
    emit highlightChanged();
}

void SelectionModel::hover(std::optional<model::BoardElement> element) {
    if (element != m_hovered) {
        m_hovered = element;
        m_isHoveredNewer = element.has_value();
        emit hoverChanged();
    }
}

void SelectionModel::selectAs(const QString& title, const std::vector<model::BoardElement>& elements) {
    m_nextTitle = title;
    select(elements);
}

void SelectionModel::select(const std::vector<model::BoardElement>& elements, Mode mode) {
    m_title = std::exchange(m_nextTitle, QString());
    m_isHoveredNewer = false;
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
    m_isHoveredNewer = false;
    const bool isUnselecting = !nets.empty() && !m_selected.empty();
    const bool isOther = nets != m_nets;
    m_nets = std::move(nets);
    if (isUnselecting) {
        m_selected.clear();
        m_current.reset();
        m_title.clear();
        emit selectionChanged();
    }
    if (isOther) {
        emit netsChanged();
    }
    if (isUnselecting || isOther) {
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

void SelectionModel::mark(std::vector<model::BoardElement> elements) {
    if (elements != m_marked) {
        m_marked = std::move(elements);
        emit marksChanged();
    }
}

void SelectionModel::toggleNets(const std::vector<model::BoardNet>& nets) {
    setNets(toggled(m_nets, nets));
}

std::vector<model::BoardNet> SelectionModel::selectionNets() const {
    if (m_selected.empty()) {
        return m_nets;
    }
    std::vector<std::vector<bool>> isOf(m_tree.steps.size());
    for (const model::BoardElement& element : m_selected) {
        if (const auto net = netOf(element)) {
            isOf[net->step].resize(m_tree.steps[net->step]->nets.size());
            isOf[net->step][net->net.row()] = true;
        }
    }
    std::vector<model::BoardNet> nets;
    for (std::uint32_t step = 0; step < isOf.size(); ++step) {
        for (std::size_t row = 0; row < isOf[step].size(); ++row) {
            if (isOf[step][row]) {
                nets.push_back({step, model::NetId{row}});
            }
        }
    }
    return nets;
}

std::vector<model::BoardElement> SelectionModel::selectionElements() const {
    return m_selected.empty() ? elementsOf(m_nets) : m_selected;
}

std::optional<model::BoardElement> SelectionModel::pointed() const {
    return m_isHoveredNewer || isEmpty() ? m_hovered : std::nullopt;
}

std::optional<model::BoardElement> SelectionModel::pointedOrCurrent() const {
    if (const auto element = pointed()) {
        return element;
    }
    return m_current ? m_current : m_hovered;
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

model::LayerId SelectionModel::layerOf(const model::BoardElement& element) const {
    const model::Document& step = stepOf(element);
    return step.layerOfCopy(step.elements.layer[element.element.row()], m_tree.copies[element.copy].isFlipped);
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
