#pragma once

#include <QUndoStack>

#include "ui/nets/net_styles.h"
#include "ui/workspace/session_part.h"

namespace ui {

/// The user's colours and hiding of nets while a board is shown: edits that are undone like every other, kept in the
/// session file beside the job. What the file says of nets that this board does not have stays in it.
class NetStyleEditing : public QObject {
    Q_OBJECT

public:
    NetStyleEditing(NetStyles& styles, QUndoStack& history, QObject* parent = nullptr);

    void setBoard(const LoadedBoard& board);

signals:
    void notSaved(const QString& reason);

private:
    void apply(const NetStyles::State& state);
    [[nodiscard]] std::vector<model::session::SavedNet> kept(const NetStyles::State& state) const;

    NetStyles& m_styles;
    QUndoStack& m_history;
    SessionPart m_session;
    model::StepTree m_tree;
    std::vector<model::session::SavedNet> m_elsewhere;  ///< of the file, but not of this board
};

}  // namespace ui
