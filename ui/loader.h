#pragma once

#include <QObject>
#include <QTimer>
#include <filesystem>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "model/base/progress.h"
#include "model/base/result.h"
#include "model/board_index.h"
#include "model/document.h"
#include "model/net_statistics.h"
#include "render/board_model.h"

namespace ui {

struct LoadRequest {
    std::filesystem::path path;
    std::string step;  ///< empty: the job's first step
};

/// A board ready to be shown: frozen document and the arrays for the GPU.
struct LoadedBoard {
    LoadRequest request;
    std::shared_ptr<const model::Document> document;
    std::shared_ptr<const render::BoardModel> model;
    double seconds = 0.0;
    std::shared_ptr<const model::BoardIndex> index;    ///< may be null: then nothing can be picked
    std::shared_ptr<const model::NetStatistics> nets;  ///< may be null
};

/// Reads the board and models it. Errors: those of model::readBoard and render::buildBoardModel.
[[nodiscard]] base::Result<LoadedBoard> loadBoard(const LoadRequest& request, base::Progress& progress);

/// Loads boards on a thread of its own and reports on the thread it lives on. Opening another board cancels the one
/// being loaded; its thread winds down unseen. Exactly one of loaded, failed and cancelled follows each started.
class Loader : public QObject {
    Q_OBJECT

public:
    /// What runs on the thread; tests put their own in.
    using Work = std::function<base::Result<LoadedBoard>(const LoadRequest&, base::Progress&)>;

    explicit Loader(Work work = loadBoard, QObject* parent = nullptr);
    ~Loader() override;

    void open(LoadRequest request);
    void cancel();
    [[nodiscard]] bool isLoading() const { return m_current != nullptr; }

signals:
    void started(const ui::LoadRequest& request);
    /// `fraction` of the phase, 0 to 1; a phase is a few plain words.
    void progressed(const QString& phase, double fraction);
    void loaded(const ui::LoadedBoard& board);
    void failed(const ui::LoadRequest& request, const QString& reason);
    void cancelled(const ui::LoadRequest& request);

private:
    struct Job;

    void poll();
    void deliver(std::unique_ptr<Job> job);
    void retireCurrent();

    Work m_work;
    std::unique_ptr<Job> m_current;
    std::vector<std::unique_ptr<Job>> m_retiring;  ///< cancelled, still winding down
    QTimer m_timer;
};

}  // namespace ui
