#pragma once

#include "ui/saved_views/view_list_model.h"
#include "ui/workspace/feature.h"
#include "ui/workspace/session_part.h"

namespace ui {

class TableView;

/// Ways of looking at the board that the user saves by name: where both cameras are, which layers are visible and what
/// is selected and highlighted; and selections alone. They are saved in the session file beside the job; saving,
/// renaming, updating and deleting are undone like every other edit. What the window shows is saved there too, on
/// request, and shown again when the board is opened.
class SavedViewsFeature : public QObject {
    Q_OBJECT

public:
    explicit SavedViewsFeature(FeatureContext& context);

    /// Saves what is seen now under a name of its own, "View 1" and so on; of more selected elements than can be saved
    /// none.
    void saveView();
    /// Saves what is seen now, or selected, in place of what is saved there, under the same name. One of another step
    /// stays as it is, and so does a selection while nothing is selected; that is reported.
    void update(int row);
    /// Saves what is selected and which nets are highlighted, as "Selection 1" and so on.
    void saveSelection();
    /// Looks at the board as saved. A view that marks neither nets nor elements leaves marked what is. Of a view of
    /// another step only the name counts, and which step to open is reported.
    void goTo(int row);
    /// Saves what the window shows: cameras, layers and unit.
    void saveDesk();

private:
    /// What the window showed of a board that is being read anew.
    struct Kept {
        model::session::Desk desk;
        model::session::SavedSelection selection;
        QString title;             ///< of the selection
        std::string currentLayer;  ///< its name; empty for none
    };

    /// A click on a row, or Enter, restores it; F2 renames it, Del deletes it; its menu does all that and updates it.
    void addPanel(FeatureContext& context);
    void addRowCommands(TableView& table);
    /// What is selected, if it is not too much to save, and highlighted.
    [[nodiscard]] model::session::SavedSelection marked() const;
    /// Without a name and a step.
    [[nodiscard]] model::session::SavedView shownView() const;
    /// The same of what is selected; none if that cannot be saved, which is reported.
    [[nodiscard]] std::optional<model::session::SavedView> shownSelection() const;
    void reportOtherStep(const model::session::SavedView& view) const;
    /// Lists the views, and offers their layers to whoever shows layers.
    void take(const std::vector<model::session::SavedView>& views);
    /// Shows what was saved for this step of the board, or what was shown before the same board was read anew.
    void restoreDesk(const LoadedBoard& board);
    [[nodiscard]] model::session::Desk desk() const;
    /// The middle of the board, that cameras count from, nm.
    [[nodiscard]] base::Point origin() const;
    /// Empty for none.
    [[nodiscard]] std::string nameOf(model::LayerId layer) const;
    /// Keeps what is shown and selected if the next board is the same one, read anew, and how layers are drawn if it is
    /// another step of the job, which has the same ones.
    void keep(const LoadedBoard& next);
    void restoreKept(const LoadedBoard& board);
    void restoreLayers(const model::Document& board, const model::session::Desk& desk);
    void showUnit(LengthUnit unit);
    void setCameras(const model::session::Pose& flat, const model::session::Pose& solid);
    /// What of it is not on this board is reported under the name of the view.
    void select(const QString& name, const model::session::SavedSelection& saved);

    Workspace& m_workspace;
    Settings& m_settings;
    BoardViews& m_views;
    LayerModel& m_layers;
    QAction& m_orthographic;
    ViewListModel m_list;
    std::optional<Kept> m_kept;
    std::optional<model::session::Desk> m_stepBefore;  ///< of the same job
    PartWriter m_savedDesk;  ///< begun when the board was opened first: read anew, it keeps its cameras
    SavedList<model::session::SavedView> m_saved;
};

}  // namespace ui
