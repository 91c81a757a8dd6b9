#include "ui/views/element_styles.h"

#include <QAction>
#include <algorithm>

#include "model/board/single_element.h"
#include "ui/views/element_outlines.h"
#include "ui/views/nearby_highlight.h"

namespace ui {

namespace {

std::vector<glm::vec3> coloursOf(const std::vector<QRgb>& palette) {
    constexpr float kMost = 255.0F;
    std::vector<glm::vec3> colours;
    for (const QRgb colour : palette) {
        colours.emplace_back(static_cast<float>(qRed(colour)) / kMost, static_cast<float>(qGreen(colour)) / kMost,
                             static_cast<float>(qBlue(colour)) / kMost);
    }
    return colours;
}

/// A plane, or a pour of a good part of the board.
bool isWide(const model::Document& step, model::ElementId element) {
    constexpr double kWide = 0.25;  // of the board
    const auto areaOf = [](const model::Box& box) {
        return static_cast<double>(box.width()) * static_cast<double>(box.height());
    };
    return step.elements.kind[element.row()] == model::ElementKind::Area && !step.board.isEmpty() &&
           areaOf(step.boxOf(element)) >= kWide * areaOf(step.board);
}

}  // namespace

ElementStyles::ElementStyles(BoardViews& views, SelectionModel& selection, NetStyles& nets, const QAction& dimOthers,
                             QObject* parent)
    : QObject(parent), m_views(views), m_selection(selection), m_nets(nets), m_dimOthers(dimOthers) {
    connect(&selection, &SelectionModel::highlightChanged, this, &ElementStyles::onHighlightChanged);
    connect(&nets, &NetStyles::changed, this, &ElementStyles::onNetsChanged);
    connect(&nets, &NetStyles::dimChanged, this, &ElementStyles::onDimChanged);
    connect(&dimOthers, &QAction::triggered, this, &ElementStyles::onDimChanged);
}

void ElementStyles::onDimChanged() {
    apply();
    m_views.requestFrame();
}

void ElementStyles::onNetsChanged() {
    const model::StepTree& tree = m_selection.tree();
    const std::vector<QRgb> palette = m_nets.palette();
    m_ofNets.assign(tree.steps.size(), {});
    for (const NetStyle& style : m_nets.state()) {
        render::ElementState state = style.isHidden ? render::kHidden : render::kPlain;
        if (style.colour) {
            state |= render::inColour(static_cast<std::uint32_t>(nearestColour(palette, *style.colour)));
        }
        m_ofNets[style.net.step].add(tree.steps[style.net.step]->elementsOf(style.net.net), state);
    }
    m_views.setElementColours(coloursOf(palette));
    apply();
    m_views.requestFrame();
}

/// The outlines of what is selected are seen at once (ui/views/element_outlines.h).
void ElementStyles::onHighlightChanged() {
    apply();
    m_views.requestFrameAtRest();
}

/// Of several; one alone has the colour of all that is highlighted. `highlightColour` says the same to the table.
void ElementStyles::addColoursOfHighlightedNets(ElementStateLists& states) const {
    const std::vector<model::BoardNet>& nets = m_selection.nets();
    for (std::size_t i = 0; nets.size() > 1 && i < nets.size(); ++i) {
        if (!m_nets.of(nets[i]).colour) {
            const model::Document& step = *m_selection.tree().steps[nets[i].step];
            states[nets[i].step].add(step.elementsOf(nets[i].net), render::highlightedAs(i));
        }
    }
}

/// Other than what is selected, and than the highlighted nets. Colours of their own give way.
void ElementStyles::addColourOfNearby(ElementStateLists& states) const {
    std::vector<std::vector<model::ElementId>> nearby(states.size());
    for (const model::BoardElement& at : m_selection.nearby()) {
        nearby[m_selection.tree().copies[at.copy].step].push_back(at.element);
    }
    for (std::size_t step = 0; step < states.size(); ++step) {
        states[step].recolour(nearby[step], render::highlightedAs(nearbyHighlight(m_selection.nets().size())));
    }
}

/// Filled, a plane that was clicked would cover all that lies over it: its outline (ui/views/element_outlines.h) shows
/// it well enough. That of a highlighted net is filled, as somebody asks where all of it goes.
void ElementStyles::leaveOutlinesAlone(std::vector<std::vector<model::ElementId>>& highlighted) const {
    const auto& selected = m_selection.selected();
    for (std::size_t i = 0; selected.size() <= ElementOutlines::kMostOutlined && i < selected.size(); ++i) {
        const model::Document& step = m_selection.stepOf(selected[i]);
        const model::ElementId element = selected[i].element;
        const auto net = m_selection.netOf(selected[i]);
        const bool isOfNet = net && std::ranges::find(m_selection.nets(), *net) != m_selection.nets().end();
        if (!isOfNet && isWide(step, element) && model::nodeCountOf(step, element) <= ElementOutlines::kMostNodes) {
            std::erase(highlighted[m_selection.tree().copies[selected[i].copy].step], element);
        }
    }
}

void ElementStyles::apply() {
    auto highlighted = m_selection.highlight();
    leaveOutlinesAlone(highlighted);
    ElementStateLists states = m_ofNets;
    states.resize(highlighted.size());
    for (std::size_t step = 0; step < highlighted.size(); ++step) {
        states[step].add(highlighted[step], render::kHighlighted);
    }
    addColoursOfHighlightedNets(states);
    addColourOfNearby(states);
    m_views.setStates(std::move(states));
    const bool isAny = std::ranges::any_of(highlighted, [](const auto& ofStep) { return !ofStep.empty(); });
    const bool standsOut = isAny || m_nets.hasColours();
    m_views.setDim(m_dimOthers.isChecked() && standsOut ? m_nets.dim() : 0.0F);
}

}  // namespace ui
