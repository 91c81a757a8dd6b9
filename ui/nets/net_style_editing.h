#pragma once

#include "ui/nets/net_styles.h"
#include "ui/workspace/session_part.h"

namespace ui {

/// The user's colours and hiding of nets while a board is shown: edits that are undone like every other, kept in the
/// session file beside the job. What the file says of nets that this board does not have stays in it.
class NetStyleEditing {
public:
    NetStyleEditing(NetStyles& styles, Workspace& workspace);

    void setBoard(const LoadedBoard& board);

private:
    [[nodiscard]] std::vector<model::session::SavedNet> kept(const NetStyles::State& state) const;

    NetStyles& m_styles;
    SessionPart<NetStyles::State, std::vector<model::session::SavedNet>> m_part;
    model::StepTree m_tree;
    std::vector<model::session::SavedNet> m_elsewhere;  ///< of the file, but not of this board
};

}  // namespace ui
