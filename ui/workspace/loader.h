#pragma once

#include <QObject>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "model/base/result.h"
#include "model/board/document.h"
#include "model/index/board_index.h"
#include "model/nets/net_statistics.h"
#include "model/session/session.h"
#include "render/modelling/board_model.h"
#include "ui/workspace/background_result.h"

namespace ui {

struct LoadRequest {
    std::filesystem::path path;
    std::string step{};                      ///< empty: the job's first step
    std::vector<std::string> thicknesses{};  ///< LAYER=LENGTH over what job and session say, kept nowhere
    bool noSession = false;                  ///< as if there were no session file; none is written either
    bool inferNets = false;                  ///< nets by following the copper, instead of the job's
};

/// What thicknesses are set over those of the job: those of the session file, and over them those for this time only.
struct SetThicknesses {
    std::vector<model::ThicknessOverride> kept{};
    std::vector<model::ThicknessOverride> once{};

    /// Both, one entry per row of the stack.
    [[nodiscard]] std::vector<model::ThicknessOverride> all() const;
    bool operator==(const SetThicknesses&) const = default;
};

/// A board ready to be shown: frozen document and the arrays for the GPU.
struct LoadedBoard {
    LoadRequest request;
    std::shared_ptr<const model::Document> document;
    std::shared_ptr<const render::BoardModel> model;
    double seconds = 0.0;
    std::shared_ptr<const model::BoardIndex> index;  ///< may be null: then nothing can be picked
    /// Per row of model::StepTree::steps, or empty.
    std::vector<std::shared_ptr<const model::NetStatistics>> nets{};
    std::vector<double> copperNm2{};                       ///< per layer (model::copperAreas), or empty
    SetThicknesses thicknesses{};                          ///< worked into the document
    std::vector<model::session::SavedView> views{};        ///< kept in the session, those of other steps too
    std::vector<model::session::SavedNet> savedNets{};     ///< how nets look by the session, by name
    std::optional<model::session::Desk> desk{};            ///< what the window is to show, if that was saved
    std::vector<model::Measurement> measurements{};        ///< kept in the session, those of other steps too
    std::vector<model::session::SavedSection> sections{};  ///< kept in the session, those of other steps too
    std::vector<std::string> sessionNotes{};               ///< what of the session file is not used, a sentence each
};

/// Reads the board, stacks it as its session and the request say, and models it. Errors: those of model::readBoard and
/// render::buildBoardModel; BadUsage for thicknesses.
[[nodiscard]] base::Result<LoadedBoard> loadBoard(const LoadRequest& request, base::Progress& progress);

/// Loads boards in the background. Opening another board cancels the one being loaded. Exactly one of loaded, failed
/// and cancelled follows each started.
class Loader : public QObject {
    Q_OBJECT

public:
    /// What runs on the thread; tests put their own in.
    using Work = std::function<base::Result<LoadedBoard>(const LoadRequest&, base::Progress&)>;

    explicit Loader(Work work = loadBoard, QObject* parent = nullptr);

    void open(LoadRequest request);
    void cancel();
    [[nodiscard]] bool isLoading() const { return m_load.isRunning(); }

signals:
    void started(const ui::LoadRequest& request);
    /// As Background::progressed.
    void progressed(const QString& phase, double fraction);
    void loaded(const ui::LoadedBoard& board);
    void failed(const ui::LoadRequest& request, const QString& reason);
    void cancelled(const ui::LoadRequest& request);

private:
    void deliver();

    Work m_work;
    BackgroundResult<LoadedBoard> m_load;
    LoadRequest m_request;
};

}  // namespace ui
