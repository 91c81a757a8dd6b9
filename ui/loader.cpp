#include "ui/loader.h"

#include <QElapsedTimer>
#include <atomic>
#include <new>
#include <optional>
#include <thread>

#include "model/reader.h"

namespace ui {

namespace {

constexpr int kPollMs = 40;

}  // namespace

base::Result<LoadedBoard> loadBoard(const LoadRequest& request, base::Progress& progress) {
    QElapsedTimer clock;
    clock.start();
    auto document = model::readBoard(request.path, {.step = request.step}, progress);
    if (!document) {
        return document.error();
    }
    auto boardModel = render::buildBoardModel(**document, {}, progress);
    if (!boardModel) {
        return boardModel.error();
    }
    auto index = model::indexBoard(*document, progress);
    if (!index) {
        return index.error();
    }
    auto nets = model::measureNets(**document, progress);
    if (!nets) {
        return nets.error();
    }
    return LoadedBoard{request,
                       *document,
                       std::make_shared<const render::BoardModel>(std::move(*boardModel)),
                       static_cast<double>(clock.elapsed()) / 1000.0,
                       *index,
                       std::make_shared<const model::NetStatistics>(std::move(*nets))};
}

struct Loader::Job {
    LoadRequest request;
    base::Progress progress;
    std::optional<base::Result<LoadedBoard>> result;  ///< written by the thread before isDone, read after
    std::atomic<bool> isDone = false;
    std::jthread thread;  ///< last, so that it is joined before what it uses goes

    void run(const Work& work) {
        try {
            result = work(request, progress);
        } catch (const std::bad_alloc&) {
            // A huge board must not take down the window that shows another one.
            result = base::Error{base::ErrorCode::BadInput, "There is not enough memory for this board"};
        }
        isDone = true;
    }
};

Loader::Loader(Work work, QObject* parent) : QObject(parent), m_work(std::move(work)) {
    m_timer.setInterval(kPollMs);
    connect(&m_timer, &QTimer::timeout, this, &Loader::poll);
}

Loader::~Loader() {
    retireCurrent();
}

void Loader::open(LoadRequest request) {
    cancel();
    m_current = std::make_unique<Job>();
    Job& job = *m_current;
    job.request = std::move(request);
    job.progress.beginPhase("Opening");
    job.thread = std::jthread([&job, work = m_work] { job.run(work); });
    m_timer.start();
    emit started(job.request);
}

void Loader::cancel() {
    if (m_current) {
        const LoadRequest request = m_current->request;
        retireCurrent();
        emit cancelled(request);
    }
}

void Loader::retireCurrent() {
    if (m_current) {
        m_current->progress.cancel();
        m_retiring.push_back(std::move(m_current));
    }
}

void Loader::poll() {
    std::erase_if(m_retiring, [](const auto& job) { return job->isDone.load(); });
    if (m_current && m_current->isDone) {
        deliver(std::move(m_current));
    } else if (m_current) {
        const base::Progress& progress = m_current->progress;
        emit progressed(QString::fromStdString(progress.phase()), static_cast<double>(progress.fraction()));
    }
    if (!m_current && m_retiring.empty()) {
        m_timer.stop();
    }
}

void Loader::deliver(std::unique_ptr<Job> job) {
    const base::Result<LoadedBoard>& result = *job->result;
    if (result) {
        emit loaded(*result);
    } else if (result.error().code == base::ErrorCode::Cancelled) {
        emit cancelled(job->request);
    } else {
        emit failed(job->request, QString::fromStdString(result.error().text));
    }
}

}  // namespace ui
