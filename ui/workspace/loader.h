#pragma once

#include <QObject>
#include <functional>
#include <memory>
#include <vector>

#include "model/index/board_index.h"
#include "model/nets/net_statistics.h"
#include "model/opening/open_board.h"
#include "render/modelling/board_model.h"
#include "ui/workspace/background_result.h"

namespace ui {

/// An opened board with what the window needs besides. Where one of several forms is to be chosen first it has these
/// and nothing else.
struct LoadedBoard : model::OpenedBoard {
    std::shared_ptr<const render::BoardModel> model{};
    std::shared_ptr<const model::BoardIndex> index{};  ///< may be null: then nothing can be picked
    /// Per row of model::StepTree::steps, or empty.
    std::vector<std::shared_ptr<const model::NetStatistics>> nets{};
    /// Likewise: by PinId the place of the name "U5.3" among all of the step, in the order people count.
    std::vector<std::vector<std::uint32_t>> pinRanks{};
    std::vector<double> copperNm2{};  ///< per layer (model::copperAreas), or empty
    double seconds = 0.0;
};

/// Opens the board, models it and measures its nets and copper. Errors: those of model::openBoard and
/// render::buildBoardModel.
[[nodiscard]] base::Result<LoadedBoard> loadBoard(const model::OpenRequest& request, base::Progress& progress);

/// Loads boards in the background. Opening another board cancels the one being loaded. Exactly one of loaded, asked,
/// failed and cancelled follows each started.
class Loader : public QObject {
    Q_OBJECT

public:
    /// What runs on the thread; tests put their own in.
    using Work = std::function<base::Result<LoadedBoard>(const model::OpenRequest&, base::Progress&)>;

    explicit Loader(Work work = loadBoard, QObject* parent = nullptr);

    void open(model::OpenRequest request);
    void cancel() { m_load.cancel(); }
    [[nodiscard]] bool isLoading() const { return m_load.isRunning(); }
    [[nodiscard]] Background& background() { return m_load.background(); }
    /// The one being loaded, or the last one.
    [[nodiscard]] const model::OpenRequest& request() const { return m_request; }

signals:
    void started(const model::OpenRequest& request);
    void loaded(const ui::LoadedBoard& board);
    /// The request only asks, and there are several forms to choose from.
    void asked(const model::OpenRequest& request, const std::vector<model::BoardForm>& forms);
    void failed(const model::OpenRequest& request, const QString& reason);
    void cancelled(const model::OpenRequest& request);

private:
    void deliver();

    Work m_work;
    BackgroundResult<LoadedBoard> m_load;
    model::OpenRequest m_request;
};

}  // namespace ui
