#include "ui/nets/net_style_editing.h"

#include <algorithm>
#include <utility>

#include "ui/workspace/state_edit.h"

namespace ui {

namespace session = model::session;

NetStyleEditing::NetStyleEditing(NetStyles& styles, QUndoStack& history, QObject* parent)
    : QObject(parent), m_styles(styles), m_history(history) {
    connect(&styles, &NetStyles::asked, this, [this](const QString& what, const NetStyles::State& after) {
        if (after != m_styles.state()) {
            m_history.push(new StateEdit<NetStyles::State>(what, m_styles.state(), after,
                                                           [this](const NetStyles::State& state) { apply(state); }));
        }
    });
}

void NetStyleEditing::setBoard(const LoadedBoard& board) {
    // What stands in no file is taken along by name, like what a file holds.
    std::vector<session::SavedNet> nets = m_session.document() != nullptr ? kept(m_styles.state()) : board.savedNets;
    if (m_session.open(board)) {
        nets = board.savedNets;
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

void NetStyleEditing::apply(const NetStyles::State& state) {
    m_styles.setState(state);
    const QString trouble = m_session.save(
        QStringLiteral("The colours of nets"),
        [&](const auto& path, const auto& document) { return session::saveNets(path, document, kept(state)); });
    if (!trouble.isEmpty()) {
        emit notSaved(trouble);
    }
}

}  // namespace ui
