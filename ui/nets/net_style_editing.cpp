#include "ui/nets/net_style_editing.h"

#include <algorithm>
#include <utility>

namespace ui {

namespace session = model::session;

NetStyleEditing::NetStyleEditing(NetStyles& styles, Workspace& workspace)
    : m_styles(styles),
      m_part(
          workspace, NetStyles::tr("The colours of nets"), [this](const auto& state) { m_styles.setState(state); },
          session::saveNets, [this](const NetStyles::State& state) { return kept(state); }) {
    QObject::connect(&styles, &NetStyles::asked, &workspace,
                     [this](const QString& what, const NetStyles::State& after) {
                         if (after != m_styles.state()) {
                             m_part.edit(what, m_styles.state(), after);
                         }
                     });
}

void NetStyleEditing::setBoard(const LoadedBoard& board) {
    // What is in no file is taken along by name, like what a file holds.
    std::vector<session::SavedNet> nets = kept(m_styles.state());
    if (m_part.open()) {
        nets = board.session.nets;
    }
    m_tree = model::unfoldCopies(*board.document);
    m_elsewhere.clear();
    const auto found = session::findNets(m_tree, nets);
    NetStyles::State state;
    for (std::size_t i = 0; i < nets.size(); ++i) {
        if (found[i]) {
            const std::optional<QRgb> colour =
                nets[i].colour ? std::optional<QRgb>(0xff000000U | *nets[i].colour) : std::nullopt;
            state.push_back({*found[i], colour, nets[i].isHidden});
        } else {
            m_elsewhere.push_back(nets[i]);
        }
    }
    std::ranges::sort(state, {}, &NetStyle::net);
    const auto isSame = [](const NetStyle& a, const NetStyle& b) { return a.net == b.net; };
    state.erase(std::unique(state.begin(), state.end(), isSame), state.end());
    m_styles.setState(std::move(state));
}

std::vector<session::SavedNet> NetStyleEditing::kept(const NetStyles::State& state) const {
    std::vector<session::SavedNet> nets = m_elsewhere;
    for (const NetStyle& look : state) {
        const model::Document& step = *m_tree.steps[look.net.step];
        const std::optional<std::uint32_t> colour =
            look.colour ? std::optional<std::uint32_t>(*look.colour & 0xffffffU) : std::nullopt;
        nets.push_back({step.nets[look.net.net.row()].name, step.job.step, colour, look.isHidden});
    }
    return nets;
}

}  // namespace ui
