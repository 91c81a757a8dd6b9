#include "ui/net_look_editing.h"

#include <algorithm>
#include <utility>

#include "ui/state_edit.h"

namespace ui {

namespace session = model::session;
using models::NetLook;
using models::NetLooks;

NetLookEditing::NetLookEditing(NetLooks& looks, QUndoStack& history, QObject* parent)
    : QObject(parent), m_looks(looks), m_history(history) {
    connect(&looks, &NetLooks::asked, this, [this](const QString& what, const NetLooks::State& after) {
        if (after != m_looks.state()) {
            m_history.push(new StateEdit<NetLooks::State>(what, m_looks.state(), after,
                                                          [this](const NetLooks::State& state) { apply(state); }));
        }
    });
}

void NetLookEditing::setBoard(const LoadedBoard& board) {
    // What stands in no file is taken along by name, like what a file holds.
    std::vector<session::KeptNet> nets = m_session.document() != nullptr ? kept(m_looks.state()) : board.keptNets;
    if (m_session.open(board)) {
        nets = board.keptNets;
    }
    m_tree = model::unfoldCopies(*board.document);
    m_elsewhere.clear();
    const auto found = session::findNets(m_tree, nets);
    NetLooks::State state;
    for (std::size_t i = 0; i < nets.size(); ++i) {
        if (found[i]) {
            const std::optional<QRgb> colour =
                nets[i].colour ? std::optional<QRgb>(0xff000000U | *nets[i].colour) : std::nullopt;
            state.push_back({*found[i], colour, nets[i].isHidden});
        } else {
            m_elsewhere.push_back(nets[i]);
        }
    }
    std::ranges::sort(state, {}, &NetLook::net);
    const auto isSame = [](const NetLook& a, const NetLook& b) { return a.net == b.net; };
    state.erase(std::unique(state.begin(), state.end(), isSame), state.end());
    m_looks.setState(std::move(state));
}

std::vector<session::KeptNet> NetLookEditing::kept(const NetLooks::State& state) const {
    std::vector<session::KeptNet> nets = m_elsewhere;
    for (const NetLook& look : state) {
        const model::Document& step = *m_tree.steps[look.net.step];
        const std::optional<std::uint32_t> colour =
            look.colour ? std::optional<std::uint32_t>(*look.colour & 0xffffffU) : std::nullopt;
        nets.push_back({step.nets[look.net.net.row()].name, step.job.step, colour, look.isHidden});
    }
    return nets;
}

void NetLookEditing::apply(const NetLooks::State& state) {
    m_looks.setState(state);
    const QString trouble = m_session.save(
        QStringLiteral("The colours of nets"),
        [&](const auto& path, const auto& document) { return session::saveNets(path, document, kept(state)); });
    if (!trouble.isEmpty()) {
        emit notSaved(trouble);
    }
}

}  // namespace ui
