#pragma once

#include "ui/comparison/comparison_panel.h"
#include "ui/comparison/difference_marks.h"
#include "ui/findings/shown_finding.h"
#include "ui/workspace/background_result.h"
#include "ui/workspace/feature.h"

namespace ui {

/// Compares the board with another one, like its next revision, in the background: differences in a panel, and in both
/// views while that is open. A difference of a layer is shown on it, all others being faint, with what only either
/// board draws there.
class ComparisonFeature : public QObject {
    Q_OBJECT

public:
    /// Frames are painted around so many of the listed differences, from the first on.
    static constexpr std::size_t kMostFrames = 400;

    explicit ComparisonFeature(FeatureContext& context);

    /// Reads that board and compares it with the one on the screen.
    void start(const QString& path);

private:
    void connectCommands(FeatureContext& context);
    void connectWork();
    void deliver();
    void clear();
    void frameListed();
    void show(int row);
    void showLayer(model::LayerId layer);
    void showOnly(const model::Comparison& comparison, const model::Box& place);
    /// False if nothing was shown.
    bool endShown();

    Workspace& m_workspace;
    Probing& m_probing;
    ShownFinding m_shown;
    DifferenceMarks m_marks;
    ComparisonModel m_differences;
    ComparisonPanel* m_panel;
    BackgroundResult<ComparedBoards> m_compared;
    BackgroundResult<std::array<model::PolygonSet, 2>> m_only;  ///< of what is shown
};

}  // namespace ui
