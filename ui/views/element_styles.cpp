#include "ui/views/element_styles.h"

#include <QAction>
#include <QSlider>

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

}  // namespace

ElementStyles::ElementStyles(BoardViews& views, SelectionModel& selection, NetStyles& nets, QObject* parent)
    : QObject(parent), m_views(views), m_selection(selection), m_nets(nets) {
    connect(&selection, &SelectionModel::highlightChanged, this, &ElementStyles::onHighlightChanged);
    connect(&nets, &NetStyles::changed, this, &ElementStyles::onNetsChanged);
}

void ElementStyles::obey(QAction& isOn, QSlider& amount) {
    connect(&isOn, &QAction::triggered, this, &ElementStyles::setDimming);
    connect(&amount, &QSlider::valueChanged, this,
            [this](int percent) { setDim(static_cast<float>(percent) / 100.0F); });
    amount.setValue(qRound(render::kDimRest * 100.0F));
    // Whoever moves it wants to see what it does.
    connect(&amount, &QSlider::sliderMoved, &isOn, [&isOn] {
        if (!isOn.isChecked()) {
            isOn.trigger();
        }
    });
}

void ElementStyles::setDimming(bool isOn) {
    m_isDimming = isOn;
    apply();
    m_views.requestFrame();
}

void ElementStyles::setDim(float dim) {
    m_dim = dim;
    apply();
    m_views.requestFrame();
}

void ElementStyles::onNetsChanged() {
    const model::StepTree& tree = m_selection.tree();
    const std::vector<QRgb> palette = m_nets.palette();
    m_ofNets.assign(tree.steps.size(), {});
    for (const NetStyle& look : m_nets.state()) {
        render::ElementState state = look.isHidden ? render::kHidden : render::kPlain;
        if (look.colour) {
            state |= render::inColour(static_cast<std::uint32_t>(nearestColour(palette, *look.colour)));
        }
        m_ofNets[look.net.step].add(tree.steps[look.net.step]->elementsOf(look.net.net), state);
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

void ElementStyles::apply() {
    const auto highlighted = m_selection.highlight();
    ElementStateLists states = m_ofNets;
    states.resize(highlighted.size());
    for (std::size_t step = 0; step < highlighted.size(); ++step) {
        states[step].add(highlighted[step], render::kHighlighted);
    }
    m_views.setStates(std::move(states));
    const bool standsOut = !m_selection.selected().empty() || !m_selection.nets().empty() || m_nets.hasColours();
    m_views.setDim(m_isDimming && standsOut ? m_dim : 0.0F);
}

}  // namespace ui
