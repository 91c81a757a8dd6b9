#pragma once

#include <QObject>
#include <QUndoStack>

#include "ui/board_views.h"
#include "ui/models/view_list_model.h"

namespace ui {

/// Ways of looking at the board that the user keeps by name: where both cameras are and which layers are visible. They
/// are kept in the session file beside the job; keeping, renaming and forgetting are undone like every other edit.
class ViewKeeping : public QObject {
    Q_OBJECT

public:
    ViewKeeping(BoardViews& views, models::LayerModel& layers, QUndoStack& history, QObject* parent = nullptr);

    [[nodiscard]] models::ViewListModel& list() { return m_list; }
    void setBoard(const LoadedBoard& board);
    /// Keeps what is seen now under a name of its own, "View 1" and so on.
    void keep();
    void rename(int row, const QString& name);
    void forget(int row);
    /// Looks at the board as kept. Of a view of another step only the name counts: `otherStep` says which step to open.
    void goTo(int row);

signals:
    /// A kept view is shown: cameras and layers have changed.
    void shown(const QString& name);
    void otherStep(const QString& name, const QString& step);
    void notSaved(const QString& reason);

private:
    using List = std::vector<model::session::KeptView>;

    void change(const QString& what, List after);
    void apply(const List& views);
    [[nodiscard]] std::string freeName() const;

    BoardViews& m_views;
    models::LayerModel& m_layers;
    QUndoStack& m_history;
    models::ViewListModel m_list;
    LoadRequest m_request;
    std::shared_ptr<const model::Document> m_document;
    bool m_isSaved = true;
};

}  // namespace ui
