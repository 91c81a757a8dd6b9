#include "ui/shell/interaction_bench.h"

#include <QAction>
#include <QApplication>
#include <QElapsedTimer>
#include <QLoggingCategory>
#include <QMouseEvent>
#include <QTemporaryDir>
#include <QThread>
#include <QWheelEvent>
#include <algorithm>
#include <clocale>
#include <cmath>
#include <ctime>
#include <functional>
#include <numbers>
#include <numeric>

#include "ui/canvas/gpu_context.h"
#include "ui/shell/main_window.h"

namespace ui {

namespace {

constexpr double kPatienceMs = 60e3;
constexpr int kQuietMs = 500;      // longer than a view waits before it refines its picture
constexpr int kNotchesAway = 12;   // of the wheel, before it turns back
constexpr double kPanShare = 0.3;  // of the canvas to either side
constexpr double kOrbitShare = 0.15;
constexpr std::size_t kNets = 10;  // largest ones, highlighted in turn

double milliseconds(const QElapsedTimer& clock) {
    return static_cast<double>(clock.nsecsElapsed()) / 1e6;
}

/// A window with a board, and an event loop that knows how long its turns take.
class Bench {
public:
    Bench(GpuContext& context, const InteractionRequest& request)
        : m_request(request),
          m_settings(m_folder.filePath("settings.ini")),
          m_window(context, m_settings,
                   [this](const model::OpenRequest& board, base::Progress& progress) { return load(board, progress); }),
          m_views(*m_window.findChild<BoardViews*>()),
          m_loader(*m_window.findChild<Loader*>()),
          m_turns(context.turns()) {
        for (BoardView* view : m_views.both()) {
            QObject::connect(view, &BoardView::timed, [this, view](const render::FrameStats& stats) {
                const bool isEnough =
                    m_isOverlayEnough || !(stats.isOverlayAlone || (m_isWholeWanted && stats.isPartial));
                m_isShown = m_isShown || (view == m_view && isEnough);
                m_isPartial = view == m_view ? stats.isPartial : m_isPartial;
            });
        }
    }

    base::Status open() {
        m_window.show();
        use(m_views.flat());
        RETURN_IF_ERROR(fit(*m_window.centralWidget()));  // its views have no room yet
        std::optional<base::Error> error;
        bool isLoaded = false;
        QObject::connect(&m_loader, &Loader::loaded, [&] { isLoaded = true; });
        QObject::connect(&m_loader, &Loader::failed, [&](const model::OpenRequest&, const QString& reason) {
            error = base::Error{base::ErrorCode::BadInput, reason.toStdString()};
        });
        m_isShown = false;
        m_isOverlayEnough = false;
        m_window.open(m_request.board);
        while (m_loader.isLoading()) {
            turn();
        }
        if (error || !isLoaded) {
            return error.value_or(base::Error{base::ErrorCode::BadInput, "the board was not opened"});
        }
        RETURN_IF_ERROR(awaitFrame());
        firstFrameMs = firstWholeMs = milliseconds(m_sinceModel);
        if (m_isPartial) {
            m_isShown = false;
            m_isWholeWanted = true;
            RETURN_IF_ERROR(awaitFrame());
            firstWholeMs = milliseconds(m_sinceModel);
            m_isWholeWanted = false;
        }
        return settle();
    }

    /// Brings one view alone onto the screen, in the size that is wanted.
    base::Status show(BoardView& view) {
        use(view);
        RETURN_IF_ERROR(fit(view));
        view.controller().fit();
        return settle();
    }

    /// `act(i)` does what makes the i-th of `count` frames; an overlay alone counts where the board stays as it is.
    base::Status measure(const char* name, int count, bool isOverlayEnough, const std::function<void(int)>& act) {
        InteractionRun run;
        run.view = m_view->kind() == BoardView::Kind::Flat ? "2D" : "3D";
        run.name = name;
        m_isOverlayEnough = isOverlayEnough;
        m_longestTurnMs = 0.0;
        for (int i = 0; i < count; ++i) {
            const std::clock_t processor = std::clock();
            QElapsedTimer clock;
            clock.start();
            m_isShown = false;
            act(i);
            m_longestTurnMs = std::max(m_longestTurnMs, milliseconds(clock));
            RETURN_IF_ERROR(awaitFrame());
            run.frameMs.push_back(milliseconds(clock));
            run.seconds += run.frameMs.back() / 1e3;
            run.processorSeconds += static_cast<double>(std::clock() - processor) / CLOCKS_PER_SEC;
            RETURN_IF_ERROR(saveFrame(run, QStringLiteral("%1").arg(i, 3, 10, QLatin1Char('0'))));
        }
        run.longestStallMs = m_longestTurnMs;
        runs.push_back(std::move(run));
        RETURN_IF_ERROR(settle());
        return saveFrame(runs.back(), QStringLiteral("rest"));
    }

    void mouse(QEvent::Type type, QPointF at, Qt::MouseButton button) {
        const bool isMove = type == QEvent::MouseMove;
        const bool isUp = type == QEvent::MouseButtonRelease;
        QMouseEvent event(type, at, m_view->mapToGlobal(at), isMove ? Qt::NoButton : button,
                          isUp ? Qt::NoButton : Qt::MouseButtons(button), {});
        QCoreApplication::sendEvent(&m_view->canvas(), &event);
    }
    void wheel(QPointF at, int notches) {
        QWheelEvent event(at, m_view->mapToGlobal(at), {}, QPoint(0, 120 * notches), {}, {}, Qt::NoScrollPhase, false);
        QCoreApplication::sendEvent(&m_view->canvas(), &event);
    }

    /// The i-th of `count` locations on a loop around the middle that comes back to where it began.
    [[nodiscard]] QPointF onLoop(int i, int count, double share) const {
        const double angle = 2.0 * std::numbers::pi * (i + 1) / count;
        return {m_request.width * (0.5 + share * std::sin(angle)),
                m_request.height * (0.5 + share * std::sin(2.0 * angle))};
    }

    /// A drag along the loop.
    base::Status drag(const char* name, Qt::MouseButton button, double share) {
        const int count = m_request.frames;
        const QPointF middle = onLoop(count - 1, count, share);
        mouse(QEvent::MouseButtonPress, middle, button);
        mouse(QEvent::MouseMove, middle + QPointF(20.0, 0.0), button);  // no click any more
        const base::Status status =
            measure(name, count, false, [&](int i) { mouse(QEvent::MouseMove, onLoop(i, count, share), button); });
        mouse(QEvent::MouseButtonRelease, middle, button);
        return status ? settle() : status;
    }

    base::Status zoom() {
        const QPointF at(m_request.width * 0.4, m_request.height * 0.45);
        return measure("zoom", m_request.frames, false, [&](int i) { wheel(at, i / kNotchesAway % 2 == 0 ? 1 : -1); });
    }

    base::Status hover() {
        return measure("hover", m_request.frames, true, [&](int i) {
            mouse(QEvent::MouseMove, onLoop(i, m_request.frames, kPanShare), Qt::NoButton);
            m_view->requestOverlay();  // also where nothing new is under the pointer
        });
    }

    base::Status highlight() {
        const std::vector<model::NetId> nets = largestNets();
        SelectionModel& selection = m_window.findChild<Workspace*>()->selection();
        const base::Status status = nets.empty() ? base::Done{} : measure("highlight", changes(), false, [&](int i) {
            selection.setNets({{0, nets[static_cast<std::size_t>(i) % nets.size()]}});
        });
        selection.setNets({});
        return status ? settle() : status;
    }

    base::Status toggleLayers() {
        auto& layers = *m_window.findChild<LayerModel*>();
        const std::vector<bool> before = layers.visibility();
        std::vector<model::LayerId> copper;
        for (std::size_t row = 0; row < before.size(); ++row) {
            if (before[row]) {
                copper.emplace_back(row);
            }
        }
        if (copper.empty()) {
            return base::Done{};
        }
        return measure("layers", changes() / 2 * 2, false, [&](int i) {
            const model::LayerId layer = copper[static_cast<std::size_t>(i) / 2 % copper.size()];
            layers.setVisible(std::span(&layer, 1), i % 2 != 0);
        });
    }

    [[nodiscard]] BoardViews& views() { return m_views; }

    double firstFrameMs = 0.0;
    double firstWholeMs = 0.0;
    std::vector<InteractionRun> runs;

private:
    base::Result<LoadedBoard> load(const model::OpenRequest& board, base::Progress& progress) {
        base::Result<LoadedBoard> loaded = loadBoard(board, progress);
        m_sinceModel.start();
        return loaded;
    }

    [[nodiscard]] int changes() const { return std::max(2, m_request.frames / 4); }

    std::vector<model::NetId> largestNets() {
        const model::Document& board = *m_window.findChild<Workspace*>()->board()->document;
        std::vector<model::NetId> nets;
        for (std::size_t row = 0; row < board.nets.size(); ++row) {
            nets.emplace_back(row);
        }
        std::ranges::stable_sort(nets, std::greater(), [&](model::NetId net) { return board.elementsOf(net).size(); });
        nets.resize(std::min(nets.size(), kNets));
        std::erase_if(nets, [&](model::NetId net) { return board.elementsOf(net).empty(); });
        return nets;
    }

    /// At rest also what the device draws.
    base::Status saveFrame(const InteractionRun& run, const QString& which) {
        if (m_request.pictures.empty()) {
            return base::Done{};
        }
        const QString path =
            QStringLiteral("%1/%2-%3-%4").arg(m_request.pictures.c_str(), run.view.c_str(), run.name.c_str(), which);
        const auto save = [](const QImage& picture, const QString& to) -> base::Status {
            return picture.save(to, "PNG")
                       ? base::Status(base::Done{})
                       : base::Error{base::ErrorCode::OutputFailed, to.toStdString() + " cannot be written."};
        };
        RETURN_IF_ERROR(save(m_view->grab().toImage(), path + ".png"));
        if (which == QStringLiteral("rest")) {
            ASSIGN_OR_RETURN(const QImage device, m_view->grabPicture());
            return save(device, path + "-device.png");
        }
        return base::Done{};
    }

    void use(BoardView& view) {
        m_view = &view;
        m_views.setArrangement(view.kind() == BoardView::Kind::Flat ? Arrangement::Flat : Arrangement::Solid);
    }

    /// Panels and bars take their room beside it.
    base::Status fit(const QWidget& widget) {
        const QSize wanted(m_request.width, m_request.height);
        for (int i = 0; i < 10 && widget.size() != wanted; ++i) {
            m_window.resize(m_window.size() + wanted - widget.size());
            turn();
        }
        if (widget.size() != wanted) {
            return base::Error{base::ErrorCode::BadUsage, "The window cannot show a view of " +
                                                              std::to_string(m_request.width) + "x" +
                                                              std::to_string(m_request.height) + " pixels."};
        }
        return base::Done{};
    }

    /// One turn of the event loop. `isUntilShown`: what waits behind the frame that is awaited is left to the next one.
    void turn(bool isUntilShown = false) {
        QElapsedTimer clock;
        clock.start();
        QCoreApplication::sendPostedEvents();
        if (!isUntilShown || !m_isShown) {
            QCoreApplication::processEvents(QEventLoop::AllEvents);
        }
        m_longestTurnMs = std::max(m_longestTurnMs, milliseconds(clock));
        QThread::usleep(200);
    }

    base::Status awaitFrame() {
        QElapsedTimer clock;
        clock.start();
        while (!m_isShown && milliseconds(clock) < kPatienceMs) {
            turn(true);
        }
        if (!m_isShown) {
            return base::Error{base::ErrorCode::DeviceFailed, "A view got no frame for a minute."};
        }
        return base::Done{};
    }

    /// Until nothing has been drawn for a while: pictures are refined when a view rests.
    base::Status settle() {
        QElapsedTimer clock;
        clock.start();
        do {
            turn();
        } while (milliseconds(clock) < kQuietMs || !m_turns.isFree());
        return base::Done{};
    }

    InteractionRequest m_request;
    QTemporaryDir m_folder;
    Settings m_settings;
    QElapsedTimer m_sinceModel;
    MainWindow m_window;
    BoardViews& m_views;
    Loader& m_loader;
    DeviceTurns& m_turns;
    BoardView* m_view = nullptr;
    bool m_isShown = false;
    bool m_isOverlayEnough = false;
    bool m_isWholeWanted = false;
    bool m_isPartial = false;  ///< the last frame
    double m_longestTurnMs = 0.0;
};

base::Status measureBoth(Bench& bench) {
    RETURN_IF_ERROR(bench.open());
    RETURN_IF_ERROR(bench.show(bench.views().flat()));
    RETURN_IF_ERROR(bench.drag("pan", Qt::RightButton, kPanShare));
    RETURN_IF_ERROR(bench.zoom());
    RETURN_IF_ERROR(bench.show(bench.views().flat()));
    RETURN_IF_ERROR(bench.hover());
    RETURN_IF_ERROR(bench.highlight());
    RETURN_IF_ERROR(bench.toggleLayers());
    RETURN_IF_ERROR(bench.show(bench.views().solid()));
    RETURN_IF_ERROR(bench.drag("orbit", Qt::LeftButton, kOrbitShare));
    RETURN_IF_ERROR(bench.drag("pan", Qt::RightButton, kPanShare));
    RETURN_IF_ERROR(bench.zoom());
    RETURN_IF_ERROR(bench.show(bench.views().solid()));
    RETURN_IF_ERROR(bench.hover());
    return bench.highlight();
}

}  // namespace

base::Result<InteractionReport> measureInteraction(const InteractionRequest& request) {
    if (qEnvironmentVariableIsEmpty("QT_QPA_PLATFORM")) {
        qputenv("QT_QPA_PLATFORM", "offscreen");
    }
    QLoggingCategory::setFilterRules("default.warning=false");  // what the platform cannot do, of windows nobody sees
    static int argc = 1;
    static char name[] = "copperscope";
    static char* argv[] = {name, nullptr};
    const QApplication application(argc, argv);
    std::setlocale(LC_NUMERIC, "C");
    ASSIGN_OR_RETURN(const std::unique_ptr<GpuContext> context, GpuContext::create());
    Bench bench(*context, request);
    RETURN_IF_ERROR(measureBoth(bench));
    const render::gpu::Caps& caps = context->device().caps();
    return InteractionReport{caps.name + ", " + caps.driver, bench.firstFrameMs, bench.firstWholeMs,
                             std::move(bench.runs)};
}

}  // namespace ui
