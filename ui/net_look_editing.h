#pragma once

#include <QUndoStack>

#include "ui/models/net_looks.h"
#include "ui/session_part.h"

namespace ui {

/// The user's colours and hiding of nets while a board is shown: edits that are undone like every other, kept in the
/// session file beside the job. What the file says of nets that this board does not have stays in it.
class NetLookEditing : public QObject {
    Q_OBJECT

public:
    NetLookEditing(models::NetLooks& looks, QUndoStack& history, QObject* parent = nullptr);

    void setBoard(const LoadedBoard& board);

signals:
    void notSaved(const QString& reason);

private:
    void apply(const models::NetLooks::State& state);
    [[nodiscard]] std::vector<model::session::KeptNet> kept(const models::NetLooks::State& state) const;

    models::NetLooks& m_looks;
    QUndoStack& m_history;
    SessionPart m_session;
    model::StepTree m_tree;
    std::vector<model::session::KeptNet> m_elsewhere;  ///< of the file, but not of this board
};

}  // namespace ui
