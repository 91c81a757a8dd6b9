#include "ui/nets/net_commands.h"

#include <algorithm>

#include "ui/nets/nets_panel.h"

namespace ui {

NetCommands::NetCommands(const ActionSet& actions, SelectionModel& selection, NetStyles& styles, NetsPanel& panel,
                         QObject* parent)
    : QObject(parent), m_selection(selection), m_styles(styles) {
    const auto on = [&](ActionId id, auto slot) { connect(&actions[id], &QAction::triggered, this, slot); };
    on(ActionId::HighlightNet, [this] { highlightNet(); });
    on(ActionId::ColourNet, [this] { colour(); });
    on(ActionId::ChooseNetColour, [this, &panel] { panel.chooseColour(targets()); });
    on(ActionId::HideNet, [this] { hide(); });
    on(ActionId::ShowAllNets, [this] { m_styles.showAll(); });
    on(ActionId::ClearNetColours, [this] { m_styles.clearColours(); });
}

void NetCommands::highlightNet() {
    const auto at = m_selection.hovered() ? m_selection.hovered() : m_selection.current();
    if (const auto net = at ? m_selection.netOf(*at) : std::nullopt) {
        m_selection.toggleNet(*net);
    } else {
        emit missed(QStringLiteral("Point at an element of a net, or select one, to highlight its net"));
    }
}

std::vector<model::BoardNet> NetCommands::targets() {
    std::vector<model::BoardNet> nets = m_selection.nets();
    const auto at = m_selection.hovered() ? m_selection.hovered() : m_selection.current();
    const auto net = nets.empty() && at ? m_selection.netOf(*at) : std::nullopt;
    if (net) {
        nets.push_back(*net);
    }
    if (nets.empty()) {
        emit missed(QStringLiteral("Highlight a net, point at an element of one, or select one"));
    }
    return nets;
}

void NetCommands::colour() {
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

void NetCommands::hide() {
    const std::vector<model::BoardNet> nets = targets();
    if (!nets.empty()) {
        m_styles.hide(nets, true);
        m_selection.hover(std::nullopt);
    }
}

}  // namespace ui
