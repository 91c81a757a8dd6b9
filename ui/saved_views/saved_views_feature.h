#pragma once

#include "ui/saved_views/view_list_model.h"
#include "ui/workspace/feature.h"
#include "ui/workspace/session_part.h"

namespace ui {

/// Ways of looking at the board that the user saves by name: where both cameras are and which layers are visible; and
/// selections. They are saved in the session file beside the job; saving, renaming and deleting are undone like every
/// other edit. What the window shows is saved there too, on request, and shown again when the board is opened.
class SavedViewsFeature : public QObject {
    Q_OBJECT

public:
    explicit SavedViewsFeature(FeatureContext& context);

    /// Saves what is seen now under a name of its own, "View 1" and so on.
    void saveView();
    /// Saves what is selected and which nets are highlighted, as "Selection 1" and so on.
    void saveSelection();
    /// Looks at the board as saved. Of a view of another step only the name counts, and which step to open is reported.
    void goTo(int row);
    /// Saves what the window shows: cameras, layers and unit.
    void saveDesk();

private:
    /// A click on a row, or Enter, restores it; F2 or a double click renames it, Del deletes it.
    void addPanel(FeatureContext& context);
    /// Lists the views, and offers their layers to whoever shows layers.
    void take(const std::vector<model::session::SavedView>& views);
    /// Shows what was saved for this step of the board.
    void restoreDesk(const LoadedBoard& board);
    void setCameras(const model::session::Pose& flat, const model::session::Pose& solid);
    void select(const model::session::SavedView& saved);

    Workspace& m_workspace;
    BoardViews& m_views;
    LayerModel& m_layers;
    QAction& m_orthographic;
    ViewListModel m_list;
    SavedList<model::session::SavedView> m_saved;
};

}  // namespace ui
