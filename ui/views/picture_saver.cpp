#include "ui/views/picture_saver.h"

#include <QClipboard>
#include <QFileInfo>
#include <QGuiApplication>
#include <algorithm>
#include <chrono>
#include <string_view>
#include <utility>

#include "model/text/file_writer.h"
#include "render/frame/png.h"
#include "ui/common/paths.h"
#include "ui/views/board_views.h"
#include "ui/workspace/feature.h"

namespace ui {

namespace {

constexpr int kLookMs = 2;
constexpr std::chrono::milliseconds kWait{5};

base::Error cancelled() {
    return {base::ErrorCode::Cancelled, "The picture is no longer wanted."};
}

base::Status write(const QImage& picture, model::FileWriter& writer, base::Progress& progress) {
    progress.beginPhase(PictureSaver::tr("Writing the picture").toStdString());
    QImage line;
    const render::PngRows rows{
        static_cast<std::uint32_t>(picture.width()), static_cast<std::uint32_t>(picture.height()),
        picture.hasAlphaChannel(), [&](std::uint32_t row) {
            line = picture.copy(0, static_cast<int>(row), picture.width(), 1)
                       .convertToFormat(picture.hasAlphaChannel() ? QImage::Format_RGBA8888 : QImage::Format_RGB888);
            return line.constBits();
        }};
    const base::Status packed =
        render::packPng(rows, [&](std::string_view piece) { return !progress.isCancelled() && writer.write(piece); });
    RETURN_IF_ERROR(writer.status());
    RETURN_IF_ERROR(packed);
    return writer.commit();
}

}  // namespace

struct PictureSaver::Job {
    Job(ViewShot shot, render::gpu::Device& device) : picture(std::move(shot), device) {}

    /// On a thread of its own.
    base::Result<QImage> draw(const base::Progress& progress) {
        picture.prepare();
        prepared.set_value();
        const auto make = await(lacking, progress);
        if (!make) {
            return cancelled();
        }
        (*make)();
        made.set_value();
        const auto done = await(drawn, progress);
        if (!done) {
            return cancelled();
        }
        RETURN_IF_ERROR(*done);
        return picture.finish();
    }
    base::Result<QImage> save(const std::filesystem::path& path, base::Progress& progress) {
        model::FileWriter writer(path);
        RETURN_IF_ERROR(writer.status());
        ASSIGN_OR_RETURN(const QImage image, draw(progress));
        RETURN_IF_ERROR(write(image, writer, progress));
        return image;
    }

    ViewPicture picture;
    std::promise<void> prepared;  ///< it can be asked what it lacks
    std::future<void> isPrepared = prepared.get_future();
    std::promise<std::function<void()>> lacking;
    std::promise<void> made;  ///< it can be begun
    std::future<void> isMade = made.get_future();
    std::promise<base::Status> drawn;  ///< the device is done

private:
    /// None: cancelled.
    template <class Value>
    static std::optional<Value> await(std::promise<Value>& promise, const base::Progress& progress) {
        std::future<Value> future = promise.get_future();
        while (future.wait_for(kWait) != std::future_status::ready) {
            if (progress.isCancelled()) {
                return std::nullopt;
            }
        }
        return future.get();
    }
};

PictureSaver::PictureSaver(FeatureContext& context)
    : QObject(&context.window), m_context(context.device), m_views(context.views), m_workspace(context.workspace) {
    m_look.setTimerType(Qt::PreciseTimer);
    m_look.setInterval(kLookMs);
    connect(&m_look, &QTimer::timeout, this, &PictureSaver::look);
    connect(&m_context.turns(), &DeviceTurns::came, this, [this](QObject* user) {
        if (user == this) {
            takeTurn();
        }
    });
    connect(&m_work.background(), &Background::finished, this, &PictureSaver::report);
    connect(&m_work.background(), &Background::cancelled, this, [this] {
        m_workspace.report(m_path.isEmpty() ? tr("Stopped: the picture was not copied")
                                            : tr("Stopped: %1 was not saved").arg(m_path));
        goOn();
    });
    m_workspace.watchWriting(
        m_work.background(), [this] { return m_path.isEmpty() ? tr("Picture") : QFileInfo(m_path).fileName(); },
        [this] { return nextFile(); });
    connect(&m_workspace, &Workspace::boardLeaves, this, [this] {
        giveUp(!m_isBegun, tr("The board on the screen was replaced before the graphics device had drawn it"));
    });
    connect(&m_workspace, &Workspace::deviceGoes, this, &PictureSaver::releaseDevice);
}

PictureSaver::~PictureSaver() {
    m_context.turns().end(*this);
}

void PictureSaver::save(const BoardView& view, const QString& path, int width) {
    add(view, width > 0 ? width / (view.width() * view.devicePixelRatioF()) : 1.0, path);
}

void PictureSaver::copy(const BoardView& view) {
    add(view, 1.0, {});
}

void PictureSaver::add(const BoardView& view, double scale, const QString& path) {
    if (const base::Status can = ViewPicture::check(view.pixelsOf(scale), m_context.device()); !can) {
        m_workspace.reportError(QString::fromStdString(can.error().text));
        return;
    }
    m_waiting.push_back({view.shot(scale), path});
    goOn();
}

/// Once neither the thread nor the device is at work: with the next one.
void PictureSaver::goOn() {
    if (m_isDrawing || m_work.isRunning()) {
        return;
    }
    m_look.stop();
    m_context.turns().end(*this);
    if (m_job) {
        m_job->picture.release();  // its thread may not be at an end yet
        m_job.reset();
    }
    if (!m_waiting.empty()) {
        Wanted next = std::move(m_waiting.front());
        m_waiting.pop_front();
        start(std::move(next));
    }
}

void PictureSaver::start(Wanted wanted) {
    m_path = wanted.path;
    m_isBegun = m_isMaking = false;
    m_job = std::make_shared<Job>(std::move(wanted.shot), m_context.device());
    m_look.start();
    m_work.run(
        [job = m_job, path = m_path](base::Progress& progress) {
            return path.isEmpty() ? job->draw(progress) : job->save(toPath(path), progress);
        },
        tr("Drawing the picture"), tr("There is not enough memory for a picture of that size."));
}

void PictureSaver::look() {
    if (m_isDrawing) {
        const base::Result<bool> isDone = m_job->picture.isDone();
        if (!isDone || *isDone) {
            end(isDone ? base::Status(base::Done{}) : isDone.error());
        }
    } else if ((m_isMaking ? m_job->isMade : m_job->isPrepared).wait_for(std::chrono::seconds(0)) ==
               std::future_status::ready) {
        m_look.stop();
        if (m_context.turns().begin(*this)) {
            takeTurn();
        }
    }
}

void PictureSaver::takeTurn() {
    m_isMaking ? begin() : make();
}

/// The board may have been taken off the device for want of memory.
bool PictureSaver::isBoardThere() const {
    return m_job->picture.scene() == m_views.scene() || m_job->picture.scene() == nullptr;
}

/// Pipelines and images of this size take longer than a picture: others have the device meanwhile.
void PictureSaver::make() {
    m_isMaking = true;
    m_job->lacking.set_value(isBoardThere() ? m_job->picture.lacking() : [] {});
    m_context.turns().end(*this);
    m_look.start();
}

void PictureSaver::begin() {
    const base::Status begun =
        isBoardThere() ? m_job->picture.begin()
                       : base::Error{base::ErrorCode::DeviceFailed, "The board is no longer on the graphics device"};
    if (!begun) {
        end(begun);
        return;
    }
    m_isDrawing = m_isBegun = true;
    m_look.start();
}

/// The turn is over, and the thread goes on.
void PictureSaver::end(const base::Status& drawn) {
    m_isDrawing = false;
    m_look.stop();
    m_job->drawn.set_value(drawn);
    m_context.turns().end(*this);
    if (m_context.device().isLost()) {
        m_views.requestFrame();  // which has the device renewed
    }
    goOn();
}

void PictureSaver::report() {
    const base::Result<QImage> picture = m_work.take();
    if (picture && m_path.isEmpty()) {
        QGuiApplication::clipboard()->setImage(*picture);
        m_workspace.report(tr("The picture is on the clipboard"));
    } else {
        m_workspace.reportSaved(picture ? base::Status(base::Done{}) : picture.error(), m_path);
    }
    goOn();
}

QString PictureSaver::nextFile() const {
    const auto isFile = [](const Wanted& wanted) { return !wanted.path.isEmpty(); };
    const auto waiting = std::ranges::find_if(m_waiting, isFile);
    const QString path = m_path.isEmpty() && waiting != m_waiting.end() ? waiting->path : m_path;
    return QFileInfo(path).fileName();
}

void PictureSaver::giveUp(bool hasCurrent, const QString& why) {
    QStringList lost;
    const auto add = [&lost](const QString& path) { lost += path.isEmpty() ? tr("the picture to be copied") : path; };
    const std::deque<Wanted> waiting = std::exchange(m_waiting, {});  // cancelling goes on with the next one
    if (hasCurrent && m_work.isRunning()) {
        add(m_path);
        m_work.cancel();
    }
    std::ranges::for_each(waiting, add, &Wanted::path);
    if (!lost.isEmpty()) {
        // Once the next board is there: what is said before goes with this one.
        QMetaObject::invokeMethod(
            this,
            [this, text = tr("%1, so these were not saved: %2").arg(why, lost.join(QStringLiteral(", ")))] {
                m_workspace.reportError(text);
            },
            Qt::QueuedConnection);
    }
}

void PictureSaver::releaseDevice() {
    m_isDrawing = false;
    giveUp(true, tr("The graphics device failed"));
    goOn();
}

}  // namespace ui
