#include "ui/workspace/workspace.h"

#include <QSignalSpy>
#include <QUndoCommand>
#include <QtTest>
#include <atomic>
#include <chrono>
#include <future>
#include <thread>

#include "model/board/document_builder.h"
#include "tests/patience.h"

using base::ErrorCode;
using model::OpenRequest;
using ui::LoadedBoard;
using ui::Workspace;

namespace {

/// A step of so many elements.
std::shared_ptr<const model::Document> stepOf(const char* name, int elements) {
    model::DocumentBuilder builder;
    builder.job().step = name;
    builder.beginLayer(builder.addLayer({}));
    for (int i = 0; i < elements; ++i) {
        builder.addCircle({{i * 1'000'000, 0}, 500'000, 0}, {});
    }
    return builder.finish();
}

/// Boards of these names never end, fail, or have notes; others are done at once.
base::Result<LoadedBoard> work(const OpenRequest& request, base::Progress& progress) {
    while (request.path == "slow" && !progress.isCancelled()) {
        std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }
    if (request.path == "slow" || request.path == "broken") {
        return base::Error{request.path == "slow" ? ErrorCode::Cancelled : ErrorCode::BadInput, "It is broken"};
    }
    model::DocumentBuilder builder;
    builder.job().step = "pcb";
    for (const bool isSynthetic : {false, true}) {
        model::Layer layer;
        layer.isSynthetic = isSynthetic;
        builder.beginLayer(builder.addLayer(layer));
        builder.addCircle({{0, 0}, 1'000'000, 0}, {});
    }
    const std::string path = request.path.string();
    constexpr int kTimes[] = {3, 1, 2};
    for (std::size_t i = 0; path.starts_with("panel") && i < std::size_t(path.back() - '0'); ++i) {
        const std::uint32_t step = builder.addStep(stepOf(i == 0   ? "PCB1"
                                                          : i == 1 ? "COUPON"
                                                                   : "MARK",
                                                          1'200 / (1 + static_cast<int>(i))));
        for (int copy = 0; copy < kTimes[i]; ++copy) {
            builder.addInstance({step, {{copy * 1'000'000, 0}, 0.0, false}, false});
        }
    }
    LoadedBoard board{{request, builder.finish()}, std::make_shared<const render::BoardModel>(), {}};
    board.thicknesses = {{{"TOP", 35'000}}, {{"CORE", 1'000'000}}};
    if (request.path == "noted") {
        board.notes = {"The session names no layer", "Nor a net"};
    }
    return board;
}

}  // namespace

class WorkspaceTest : public QObject {
    Q_OBJECT

private slots:
    void boardsAreDeliveredStepByStep() {
        Workspace workspace(work);
        QStringList steps;
        const auto log = [&](const char* name) { return [&steps, name] { steps += name; }; };
        // Connected against the order of the steps: who connects first does not hear first.
        connect(&workspace, &Workspace::sessionRestored, this, log("restored"));
        connect(&workspace, &Workspace::boardOpened, this, log("opened"));
        connect(&workspace.selection(), &ui::SelectionModel::selectionChanged, this, log("selection"));
        connect(&workspace, &Workspace::boardShown, this, log("shown"));
        connect(&workspace, &Workspace::boardRead, this, log("read"));
        connect(&workspace, &Workspace::boardRead, this, [&] { QVERIFY(workspace.board() != nullptr); });
        open(workspace, "board");
        QCOMPARE(steps, QStringList({"read", "shown", "selection", "opened", "restored"}));
    }

    void layersAndElementsAreThoseOfTheJob() {
        Workspace workspace(work);
        const QSignalSpy reports(&workspace, &Workspace::reported);
        open(workspace, "board");
        const QString said = reports.last()[0].toString();
        QVERIFY2(said.startsWith("Opened board: 1 layer, 1 element, "), qPrintable(said));
    }

    void whatCopiesOnAPanelHoldIsSaidToo() {
        Workspace workspace(work);
        const QSignalSpy reports(&workspace, &Workspace::reported);
        const std::pair<const char*, const char*> expected[] = {
            {"panel1", "1 element, 3 copies of PCB1 with 1,200 each, "},
            {"panel2", "1 element, 3 copies of PCB1 with 1,200 each, 1 copy of COUPON with 600, "},
            {"panel3", "1 element, copies of 3 steps with 5,000 in all, "}};
        for (const auto& [path, text] : expected) {
            open(workspace, path);
            const QString said = reports.last()[0].toString();
            QVERIFY2(said.contains(text), qPrintable(said));
        }
    }

    void filesAreProposedBesideTheBoard() {
        Workspace workspace(work);
        QCOMPARE(workspace.boardFolder(), QDir::homePath());
        const QTemporaryDir folder;
        open(workspace, folder.filePath("job/").toUtf8());
        QCOMPARE(workspace.boardFolder(), folder.path());
        open(workspace, "/nowhere/board.tgz");  // nothing can be written there
        QCOMPARE(workspace.boardFolder(), QDir::homePath());
    }

    void whatWasOfTheBoardBeforeGoes() {
        Workspace workspace(work);
        open(workspace, "board");
        workspace.history().push(new QUndoCommand);
        workspace.setCurrentLayer(model::LayerId{3});
        connect(&workspace, &Workspace::boardRead, this, [&] {
            QVERIFY(!workspace.history().canUndo());
            QVERIFY(!workspace.currentLayer().isValid());
        });
        open(workspace, "another");
        QCOMPARE(workspace.board()->request.path.string(), std::string("another"));
    }

    /// Nobody expects to undo on one board what was done on another, but on the same one that is read again.
    void readingABoardAgainSaysThatUndoBeginsAnew() {
        Workspace workspace(work);
        const QSignalSpy reports(&workspace, &Workspace::reported);
        const auto says = [&](const char* path) {
            open(workspace, path);
            return reports.last()[0].toString().startsWith("Undo begins anew. Opened ");
        };
        QVERIFY(!says("board"));
        QVERIFY(!says("board"));  // nothing was done
        workspace.history().push(new QUndoCommand);
        QVERIFY(says("board"));
        workspace.history().push(new QUndoCommand);
        QVERIFY(!says("another"));
    }

    /// What belongs to a large board takes longer to free than a frame.
    void theBoardBeforeIsFreedOnAnotherThread() {
        std::promise<std::thread::id> freed;
        std::future<std::thread::id> by = freed.get_future();
        Workspace workspace([&freed](const OpenRequest& request, base::Progress& progress) {
            base::Result<LoadedBoard> board = work(request, progress);
            if (request.path == "board") {
                board->model = {new render::BoardModel, [&freed](const render::BoardModel* model) {
                                    delete model;
                                    freed.set_value(std::this_thread::get_id());
                                }};
            }
            return board;
        });
        open(workspace, "board");
        open(workspace, "another");
        QTRY_VERIFY(by.wait_for(std::chrono::seconds(0)) == std::future_status::ready);
        QVERIFY(by.get() != std::this_thread::get_id());
    }

    void failedBoardsLeaveTheOneThatIsOpen() {
        Workspace workspace(work);
        open(workspace, "board");
        const QSignalSpy read(&workspace, &Workspace::boardRead);
        QSignalSpy errors(&workspace, &Workspace::errorReported);
        open(workspace, "broken");
        QCOMPARE(read.count(), 0);
        QCOMPARE(errors.last()[0].toString(), QString("broken was not opened. It is broken"));
        QVERIFY(workspace.isOpen("pcb"));
        open(workspace, "noted");
        QCOMPARE(errors.last()[0].toString(), QString("The session names no layer\nNor a net"));
    }

    void thicknessesStayOverAReload() {
        Workspace workspace(work);
        open(workspace, "board");
        const model::SetThicknesses ofFile = workspace.board()->thicknesses;
        workspace.reload([](OpenRequest& request) { request.inferNets = true; });
        QTRY_VERIFY(!workspace.isWorking());
        QCOMPARE(workspace.board()->request.thicknesses, std::vector<std::string>{"CORE=1 mm"});
        QVERIFY(workspace.board()->request.inferNets);
        QCOMPARE(workspace.board()->thicknesses, ofFile);

        const model::SetThicknesses inNoFile{{{"TOP", 70'000}}, {}};
        workspace.restack(workspace.board()->document, inNoFile, false);
        workspace.reload();
        QTRY_VERIFY(!workspace.isWorking());
        QCOMPARE(workspace.board()->thicknesses, inNoFile);
        QVERIFY(!workspace.board()->areThicknessesSaved);
        QVERIFY2(!workspace.board()->request.noSession, "all else that the session holds counts");

        open(workspace, "another");
        QCOMPARE(workspace.board()->thicknesses, ofFile);
        QVERIFY(workspace.board()->areThicknessesSaved);
    }

    void workOnABoardEndsWithItAndFilesAreWrittenOn() {
        Workspace workspace(work);
        open(workspace, "board");
        ui::Background search;
        ui::Background writing;
        workspace.watch(search, [] { return QString("Search"); });
        workspace.watchWriting(writing, [] { return QString("File"); });
        workspace.open({"another"});
        search.start(untilStopped, "Searching");  // of the board that is still there
        writing.start(untilStopped, "Writing");
        QTRY_COMPARE(workspace.board()->request.path.string(), std::string("another"));
        QVERIFY(!search.isRunning() && writing.isRunning());
        QCOMPARE(workspace.fileAtWork(), QString("File"));
        QVERIFY(workspace.cancelWork());
        QVERIFY(workspace.fileAtWork().isEmpty() && !workspace.isWorking());
    }

    void aBoardIsReadWhenWhatWasEditedIsWritten() {
        std::atomic<bool> isWritten = false;
        std::atomic<bool> isReadAfter = false;
        Workspace workspace([&](const OpenRequest& request, base::Progress& progress) {
            isReadAfter = isWritten.load();
            return work(request, progress);
        });
        bool isTold = false;
        connect(&workspace, &Workspace::boardLeaves, this, [&] { QVERIFY(isTold); });
        open(workspace, "board");
        workspace.files().add(
            nullptr,
            [&]() -> base::Status {
                std::this_thread::sleep_for(std::chrono::milliseconds(50));
                isWritten = true;
                return base::Done{};
            },
            [&](const base::Status&) { isTold = true; });
        open(workspace, "another");
        QVERIFY(isReadAfter && isTold);
    }

    void workThatWritesNoFileNowIsNoFileAtWork() {
        Workspace workspace(work);
        ui::Background writing;
        QString file;
        workspace.watchWriting(
            writing, [] { return QString("Picture"); }, [&file] { return file; });
        writing.start(untilStopped, "Drawing");
        QVERIFY(workspace.isWorking() && workspace.fileAtWork().isEmpty());
        file = "picture.png";
        QCOMPARE(workspace.fileAtWork(), file);
    }

    void progressIsThatOfTheFirstWork() {
        Workspace workspace(work);
        ui::Background first;
        ui::Background second;
        workspace.watch(first, [] { return QString("First"); });
        workspace.watch(second, [] { return QString("Second"); });
        QSignalSpy began(&workspace, &Workspace::workBegan);
        const QSignalSpy idle(&workspace, &Workspace::idle);
        second.start(untilStopped, "Counting");
        first.start(untilStopped, "Counting");
        QCOMPARE(began.last()[0].toString(), QString("First"));
        first.cancel();
        QCOMPARE(began.last()[0].toString(), QString("Second"));
        QCOMPARE(idle.count(), 0);
        second.cancel();
        QCOMPARE(idle.count(), 1);
    }

    void workIsShownAndStopped() {
        Workspace workspace(work);
        ui::Background other;
        workspace.watch(other, [] { return QString("Other work"); });
        QSignalSpy began(&workspace, &Workspace::workBegan);
        QSignalSpy reported(&workspace, &Workspace::reported);
        const QSignalSpy idle(&workspace, &Workspace::idle);
        other.start(untilStopped, "Counting");
        QCOMPARE(began.last()[0].toString(), QString("Other work"));
        QVERIFY(workspace.cancelWork());
        QCOMPARE(reported.last()[0].toString(), QString("Stopped"));
        QCOMPARE(idle.count(), 1);
        workspace.open({"slow"});
        QVERIFY(workspace.isWorking());
        QVERIFY(workspace.cancelWork());
        QCOMPARE(reported.last()[0].toString(), QString("Stopped opening slow"));
        QVERIFY(!workspace.cancelWork());
    }

private:
    static void untilStopped(base::Progress& progress) {
        while (!progress.isCancelled()) {
            std::this_thread::sleep_for(std::chrono::milliseconds(1));
        }
    }

    static void open(Workspace& workspace, const char* path) {
        workspace.open({path});
        QTRY_VERIFY(!workspace.isWorking());
    }
};

QTEST_GUILESS_MAIN(WorkspaceTest)
#include "workspace_test.moc"
