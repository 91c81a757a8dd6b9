#include "ui/nets/nets_feature.h"

#include <QSlider>
#include <QStatusBar>
#include <algorithm>

#include "ui/nets/hidden_nets_badge.h"
#include "ui/workspace/read_anew.h"

namespace ui {

NetsFeature::NetsFeature(FeatureContext& context)
    : QObject(&context.window),
      m_workspace(context.workspace),
      m_selection(context.workspace.selection()),
      m_hint(context.workspace),
      m_styles(context.netStyles),
      m_editing(context.netStyles, context.workspace),
      m_highlights(context.workspace),
      m_nets(this) {
    m_nets.setStyles(m_styles);
    m_panel = new NetsPanel(m_nets, m_selection, m_styles, context.actions);
    context.addPanel({ActionId::ShowNetsDock, "nets", tr("Nets"), Qt::LeftDockWidgetArea}, *m_panel);
    context.window.statusBar()->addPermanentWidget(
        new HiddenNetsBadge(m_styles, context.actions[ActionId::ShowAllNets]));
    connectCommands(context);
    connectPanel(context);
    connectDimming(context);
}

void NetsFeature::connectCommands(FeatureContext& context) {
    const auto on = [&](ActionId id, auto slot) { context.on(id, this, slot); };
    on(ActionId::HighlightNet, [this] { highlightNets(); });
    on(ActionId::AddNet, [this] { addNets(); });
    on(ActionId::ColourNet, [this] { colour(); });
    on(ActionId::ChooseNetColour, [this] { m_panel->chooseColour(targets()); });
    on(ActionId::HideNet, [this] { hide(); });
    on(ActionId::IsolateNet, [this] { isolate(); });
    on(ActionId::ShowAllNets, [this] { m_styles.showAll(); });
    on(ActionId::ClearNetColours, [this] { m_styles.clearColours(); });
    on(ActionId::InferNets,
       [this](bool isOn) { m_workspace.reload([isOn](model::OpenRequest& request) { request.inferNets = isOn; }); });
    QAction& inferNets = context.actions[ActionId::InferNets];
    connect(&m_workspace, &Workspace::idle, &inferNets, [this, &inferNets] {  // also undoes what was not loaded
        inferNets.setChecked(m_workspace.board() != nullptr && m_workspace.board()->request.inferNets);
    });
}

void NetsFeature::connectPanel(FeatureContext& context) {
    context.on(ActionId::FollowInTables, m_panel, [this](bool isOn) { m_panel->setFollows(isOn); });
    context.on(ActionId::FollowFromTables, m_panel, [this](bool isOn) { m_panel->setShowsChosen(isOn); });
    context.actions[ActionId::FollowInTables].setChecked(true);
    connect(m_panel, &NetsPanel::showRequested, &m_workspace, &Workspace::showNets);
    connect(&m_nets, &NetModel::failed, &m_workspace, &Workspace::reportError);
    connect(&m_workspace, &Workspace::unitChanged, m_panel, &NetsPanel::setUnit);
    connect(&m_workspace, &Workspace::boardLeaves, this,
            [this](const LoadedBoard& next) { m_isReadAnew = isReadAnew(m_workspace, next); });
    connect(&m_workspace, &Workspace::boardOpened, this, [this](const LoadedBoard& board) {
        m_editing.setBoard(board);
        m_panel->setBoard(board.document, board.nets, m_isReadAnew);
    });
}

void NetsFeature::connectDimming(FeatureContext& context) {
    QAction& dimOthers = context.actions[ActionId::DimOthers];
    Settings& settings = context.settings;
    QSlider& slider = m_panel->dimSlider();
    slider.setValue(qRound(m_styles.dim() * 100.0F));
    context.restorers.emplace_back(
        [&settings, &slider, first = slider.value()] { slider.setValue(settings.dimPercent(first)); });
    connect(&slider, &QSlider::valueChanged, this, [this, &settings](int percent) {
        settings.setDimPercent(percent);
        m_styles.setDim(static_cast<float>(percent) / 100.0F);
    });
    // Whoever moves it wants to see what it does.
    connect(&slider, &QSlider::sliderMoved, &dimOthers, [&dimOthers] {
        if (!dimOthers.isChecked()) {
            dimOthers.trigger();
        }
    });
}

std::vector<model::BoardNet> NetsFeature::netsToChoose() {
    const auto pointed = m_selection.pointed();
    const auto net = pointed ? m_selection.netOf(*pointed) : std::nullopt;
    const std::vector<model::BoardNet> nets = net ? std::vector{*net} : m_selection.selectionNets();
    if (nets.empty()) {
        m_hint.show(tr("Point at an element of a net, or select one, to highlight its net"));
    } else {
        m_hint.end();
    }
    return nets;
}

void NetsFeature::highlightNets() {
    if (std::vector<model::BoardNet> nets = netsToChoose(); nets == m_selection.nets()) {
        m_selection.setNets({});
    } else if (!nets.empty()) {
        m_selection.setNets(std::move(nets));
    }
}

void NetsFeature::addNets() {
    if (const std::vector<model::BoardNet> nets = netsToChoose(); !nets.empty()) {
        m_selection.toggleNets(nets);
    }
}

std::vector<model::BoardNet> NetsFeature::targets() {
    std::vector<model::BoardNet> nets = m_selection.selectionNets();
    const auto hovered = m_selection.isEmpty() ? m_selection.hovered() : std::nullopt;
    if (const auto net = hovered ? m_selection.netOf(*hovered) : std::nullopt) {
        nets.push_back(*net);
    }
    if (nets.empty()) {
        m_hint.show(m_selection.isEmpty() ? tr("Select an element of a net or highlight a net, or point at one")
                                          : tr("What is selected has no net"));
    } else {
        m_hint.end();
    }
    return nets;
}

void NetsFeature::colour() {
    const std::vector<model::BoardNet> nets = targets();
    const bool haveAll =
        std::ranges::all_of(nets, [&](const model::BoardNet& net) { return m_styles.of(net).colour.has_value(); });
    if (nets.empty()) {
        return;
    }
    if (haveAll) {
        m_styles.colour(nets, std::nullopt);
    } else {
        m_styles.colourAnew(nets);
    }
}

void NetsFeature::hide() {
    const std::vector<model::BoardNet> nets = targets();
    if (!nets.empty()) {
        m_styles.hide(nets, true);
        m_selection.hover(std::nullopt);
    }
}

void NetsFeature::isolate() {
    if (const std::vector<model::BoardNet> nets = targets(); !nets.empty()) {
        m_styles.isolate(nets, m_selection.tree());
    }
}

}  // namespace ui
