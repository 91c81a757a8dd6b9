#pragma once

#include <QTemporaryDir>
#include <filesystem>
#include <optional>
#include <set>
#include <vector>

#include "model/formats/gerber/layer_proposals.h"
#include "ui/workspace/background_result.h"
#include "ui/workspace/feature.h"

namespace ui {

/// Asks what the files of a Gerber job draw: when one was opened with files that nothing tells it of and no layer map
/// says it, and on demand. The answer is a layer map, in the file that the board was opened with or beside the job, and
/// the board is read again as it says.
class AssignmentFeature : public QObject {
    Q_OBJECT

public:
    explicit AssignmentFeature(FeatureContext& context);

private:
    struct Found {
        std::vector<model::gerber::LayerProposal> proposals;  ///< as the job is open
        std::vector<model::gerber::LayerProposal> unmapped;   ///< as it would be without a layer map
    };

    void onOpened(const LoadedBoard& board);
    void look(bool isAsked);
    void onFound();
    void ask(Found found);
    void take(const model::gerber::LayerMap& map);
    /// As a file of the window's own: beside the job it could not be written.
    void takeForNow(const model::gerber::LayerMap& map, const QString& why);
    /// The map that the open board has or would have.
    [[nodiscard]] std::filesystem::path mapPath() const;

    QWidget& m_window;
    Workspace& m_workspace;
    BackgroundResult<Found> m_search;
    bool m_isAsked = false;                     ///< by the user: the dialog is shown, whatever is found
    std::set<std::filesystem::path> m_offered;  ///< jobs that were asked for by themselves, each once
    QString m_notice;                           ///< to be said when the board is there again
    std::optional<QTemporaryDir> m_temporary;   ///< for maps that could not be written beside their jobs
};

}  // namespace ui
