#pragma once

#include <QObject>
#include <QUndoStack>

#include "ui/common/lengths.h"
#include "ui/layers/layer_model.h"
#include "ui/saved_views/view_list_model.h"
#include "ui/views/board_views.h"
#include "ui/workspace/selection_model.h"
#include "ui/workspace/session_part.h"

namespace ui {

/// Ways of looking at the board that the user keeps by name: where both cameras are and which layers are visible; and
/// selections. They are kept in the session file beside the job; keeping, renaming and forgetting are undone like every
/// other edit. What the window shows is saved there too, when it is asked for, and shown again when the board is
/// opened.
class SavedViews : public QObject {
    Q_OBJECT

public:
    SavedViews(BoardViews& views, LayerModel& layers, SelectionModel& selection, QUndoStack& history,
               QObject* parent = nullptr);

    [[nodiscard]] ViewListModel& list() { return m_list; }
    void setBoard(const LoadedBoard& board);
    /// Keeps what is seen now under a name of its own, "View 1" and so on.
    void keep();
    /// Keeps what is selected and which nets are highlighted, as "Selection 1" and so on.
    void saveSelection();
    void rename(int row, const QString& name);
    void remove(int row);
    /// Looks at the board as kept. Of a view of another step only the name counts: `otherStep` says which step to open.
    void goTo(int row);
    /// Saves what the window shows: cameras, layers, and the unit it is given.
    void saveDesk(LengthUnit unit);
    /// Shows what was saved for this step of the board; the answer is the unit, none if nothing was saved.
    std::optional<LengthUnit> restoreDesk(const LoadedBoard& board);

signals:
    /// A kept view is shown: cameras and layers have changed.
    void shown(const QString& name);
    void otherStep(const QString& name, const QString& step);
    void notSaved(const QString& reason);
    /// The desk was saved in this file.
    void deskSaved(const QString& path);
    /// Nothing was selected that could be kept, or too much.
    void notKept(const QString& reason);
    /// What of a selection is not on this board.
    void missed(const QString& what);

private:
    using List = std::vector<model::session::SavedView>;

    void change(const QString& what, List after);
    void select(const model::session::SavedView& kept);
    void apply(const List& views);
    [[nodiscard]] std::string freeName(const std::string& word) const;

    BoardViews& m_views;
    LayerModel& m_layers;
    SelectionModel& m_selection;
    QUndoStack& m_history;
    ViewListModel m_list;
    SessionPart m_session;
};

}  // namespace ui
