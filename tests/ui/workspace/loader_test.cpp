#include "ui/workspace/loader.h"

#include <QSignalSpy>
#include <QTemporaryDir>
#include <QtTest>
#include <thread>

#include "model/board/document_builder.h"
#include "tests/locations.h"
#include "tests/patience.h"

using base::Error;
using base::ErrorCode;
using base::Progress;
using model::OpenRequest;
using ui::LoadedBoard;
using ui::Loader;

namespace {

LoadedBoard emptyBoard(const OpenRequest& request) {
    model::DocumentBuilder builder;
    return {{request, builder.finish()}, std::make_shared<const render::BoardModel>(), {}};
}

/// Works until it is told to stop.
base::Result<LoadedBoard> endless(const OpenRequest&, Progress& progress) {
    progress.beginPhase("Reading layers");
    progress.setFraction(0.5F);
    while (!progress.isCancelled()) {
        std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }
    return Error{ErrorCode::Cancelled, "Cancelled"};
}

/// Endless for boards of that name, else done at once.
base::Result<LoadedBoard> endlessIfSlow(const OpenRequest& request, Progress& progress) {
    return request.path == "slow" ? endless(request, progress) : base::Result<LoadedBoard>(emptyBoard(request));
}

/// What a loader said, in order.
struct Log {
    explicit Log(Loader& loader) {
        QObject::connect(&loader, &Loader::started, [this](const OpenRequest& r) { add("started", r); });
        QObject::connect(&loader, &Loader::loaded, [this](const LoadedBoard& b) { add("loaded", b.request); });
        QObject::connect(&loader, &Loader::cancelled, [this](const OpenRequest& r) { add("cancelled", r); });
        QObject::connect(&loader, &Loader::failed, [this](const OpenRequest& r, const QString& reason) {
            add("failed", r);
            reasons += reason;
        });
    }
    void add(const char* what, const OpenRequest& request) {
        entries += QStringLiteral("%1 %2").arg(what, QString::fromStdString(request.path.string()));
    }
    QStringList entries;
    QStringList reasons;
};

}  // namespace

class LoaderTest : public QObject {
    Q_OBJECT

private slots:
    void boardArrivesOnTheThreadOfTheLoader() {
        std::thread::id worker;
        Loader loader([&](const OpenRequest& request, Progress&) {
            worker = std::this_thread::get_id();
            return base::Result<LoadedBoard>(emptyBoard(request));
        });
        const Log log(loader);
        std::thread::id receiver;
        connect(&loader, &Loader::loaded, [&] { receiver = std::this_thread::get_id(); });
        loader.open({"a", {}});
        QVERIFY(loader.isLoading());
        QTRY_VERIFY(!loader.isLoading());
        QCOMPARE(log.entries, QStringList({"started a", "loaded a"}));
        QVERIFY(receiver == std::this_thread::get_id());
        QVERIFY(worker != receiver);
    }

    void progressTellsPhaseAndFraction() {
        Loader loader(endless);
        QSignalSpy progressed(&loader.background(), &ui::Background::progressed);
        loader.open({"a", {}});
        QTRY_VERIFY(!progressed.isEmpty() && progressed.last()[0].toString() == "Reading layers" &&
                    progressed.last()[1].toDouble() == 0.5);
        loader.cancel();
    }

    void cancelIsAnsweredAtOnce() {
        Loader loader(endless);
        const Log log(loader);
        loader.open({"a", {}});
        loader.cancel();
        QCOMPARE(log.entries, QStringList({"started a", "cancelled a"}));
        QVERIFY(!loader.isLoading());
        loader.cancel();
        QCOMPARE(log.entries.size(), 2);
    }

    void secondBoardCancelsTheFirst() {
        Loader loader(endlessIfSlow);
        const Log log(loader);
        loader.open({"slow", {}});
        loader.open({"quick", {}});
        QTRY_VERIFY(!loader.isLoading());
        QCOMPARE(log.entries, QStringList({"started slow", "cancelled slow", "started quick", "loaded quick"}));
    }

    void failureTellsTheReason() {
        Loader loader([](const OpenRequest&, Progress&) -> base::Result<LoadedBoard> {
            return Error{ErrorCode::BadInput, "No such file"};
        });
        const Log log(loader);
        loader.open({"a", {}});
        QTRY_COMPARE(log.entries, QStringList({"started a", "failed a"}));
        QCOMPARE(log.reasons, QStringList("No such file"));
    }

    void wantOfMemoryIsAFailureNotACrash() {
        Loader loader([](const OpenRequest&, Progress&) -> base::Result<LoadedBoard> { throw std::bad_alloc(); });
        const Log log(loader);
        loader.open({"a", {}});
        QTRY_COMPARE(log.entries, QStringList({"started a", "failed a"}));
        QVERIFY(log.reasons[0].contains("memory"));
    }

    void destroyingTheLoaderStopsItsWork() {
        auto loader = std::make_unique<Loader>(endless);
        loader->open({"a", {}});
        loader.reset();  // hangs if the work is not told
    }

    void realWorkSaysWhatIsMissing() {
        Loader loader;
        const Log log(loader);
        loader.open({"/no/such/board.tgz", {}});
        QTRY_COMPARE(log.entries, QStringList({"started /no/such/board.tgz", "failed /no/such/board.tgz"}));
        QVERIFY(!log.reasons[0].isEmpty());
    }

    void realWorkReadsAndModelsTheSample() {
        Loader loader;
        std::shared_ptr<const render::BoardModel> boardModel;
        std::shared_ptr<const model::Document> document;
        connect(&loader, &Loader::loaded, [&](const LoadedBoard& board) {
            document = board.document;
            boardModel = board.model;
        });
        loader.open({locations::kSample, {}});
        QTRY_VERIFY(!loader.isLoading());
        QVERIFY(document && boardModel);
        QVERIFY(document->elements.size() > 100);
        QVERIFY(!boardModel->lets.empty());
    }
};

QTEST_GUILESS_MAIN(LoaderTest)
#include "loader_test.moc"
