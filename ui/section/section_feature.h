#pragma once

#include <QObject>
#include <QTimer>

#include "ui/section/section_handle.h"
#include "ui/section/section_line.h"
#include "ui/section/section_list_model.h"
#include "ui/section/section_panel.h"
#include "ui/section/section_plane_tool.h"
#include "ui/workspace/feature.h"
#include "ui/workspace/hint.h"
#include "ui/workspace/session_part.h"

namespace ui {

/// Cross-sections, from the line in the 2D view to the cut in its panel, where every move of the line cuts anew; those
/// that are saved in the session file; and the section plane of the 3D view.
class SectionFeature : public QObject {
    Q_OBJECT

public:
    explicit SectionFeature(FeatureContext& context);

    /// The next drag or clicks in the 2D view draw the line, or do not: the line is then what it was.
    void draw(bool isOn);
    /// Cuts along a line, corners in nm of the board; none: no section. `runs`, `net`: of an unrolled net, and its
    /// name. A saved section is that section, and has its dimensions.
    void cutAlong(std::vector<base::PointD> line, std::vector<model::LayerRun> runs = {}, std::string net = {});
    /// Cuts along the highlighted net, unrolled; of a net of a step that is placed often, along its first copy.
    void followNet();
    /// What is shown as a file of that name holds it: a PDF, or else an SVG. Errors: BadUsage if nothing is.
    [[nodiscard]] base::Result<std::string> drawing(const QString& path) const;
    [[nodiscard]] const std::vector<model::session::SavedSection>& saved() const { return m_saved.entries(); }

private:
    /// What is shown of a board that is being read anew, or before a corner is moved.
    struct Kept {
        std::vector<base::PointD> line;
        std::vector<model::SectionDimension> dimensions;
        std::string net;  ///< that the line follows; empty: none
    };

    void connectLine();
    void connectCommands(FeatureContext& context);
    void connectPlane(FeatureContext& context);
    void connectPlaneMoves(FeatureContext& context);
    [[nodiscard]] QString keyOf(ActionId id) const;
    /// Keeps what is shown if the next board is the same one, read anew.
    void keep(const LoadedBoard& next);
    void setBoard(const LoadedBoard& board);
    /// Cuts the board that was read anew where the one before was cut.
    void restoreKept();
    /// What belongs to a line that is as it was.
    void setMarks(const Kept& kept);
    void connectMeasuring(FeatureContext& context);
    void showPrompt(const QString& prompt);
    /// The ends of the line, if it is straight.
    [[nodiscard]] std::optional<std::pair<base::PointD, base::PointD>> straightLine() const;
    /// Where the net of this name runs, if the line still follows it; empty: it does not.
    [[nodiscard]] std::vector<model::LayerRun> runsAlong(const std::string& net) const;
    /// The line was drawn or moved, and is in place.
    void onPlaced();
    /// Cuts the board of the 3D view along the straight line.
    void showIn3D();
    /// The same, if the plane follows the line already.
    void followIn3D();
    void saveSection();
    void listSaved(const std::vector<model::session::SavedSection>& saved);
    /// Cuts along the saved line of this row, in both views.
    void goTo(int row);
    void cut();
    /// The saved section with the line that is shown, if there is one.
    [[nodiscard]] std::optional<int> shownRow() const;
    /// Dimensions belong to a saved section as its line does.
    void saveDimensions();
    void showDimensions();
    /// Brings the line to the middle of both views; 3D looks at the face of the cut.
    void showLine();

    Workspace& m_workspace;
    BoardViews& m_views;
    Hint m_hint;
    Hint m_measuringHint;
    const ActionSet& m_actions;
    SelectionModel& m_selection;
    SectionLine m_line;
    SectionPlaneTool m_plane;
    SectionHandle m_handle;
    SectionListModel m_list;
    SavedList<model::session::SavedSection> m_saved;
    SectionPanel* m_panel;
    std::shared_ptr<const model::BoardIndex> m_index;
    std::string m_net;  ///< that the line follows; empty: none
    std::optional<Kept> m_kept;
    std::optional<Kept> m_beforeMove;  ///< of a corner of the line, which takes away what belongs to it
    std::vector<QColor> m_colours;
    QTimer m_due;  ///< runs out once all moves of the line that are under way have come
};

}  // namespace ui
