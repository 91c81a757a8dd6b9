#include "model/generate/model_writer.h"

#include <QtTest>
#include <cmath>
#include <fstream>
#include <sstream>

#include "model/figures/distance.h"
#include "model/formats/registry.h"
#include "model/generate/job_writer.h"
#include "model/statistics/element_sizes.h"
#include "tests/unit/model/figures/element_spacing.h"
#include "tests/unit/model/formats/odb/odb_testing.h"

using namespace model::generate;
using odb_testing::Folder;

/// The same made-up boards as jobs, with NURBS for the edges of their areas.
class ModelWriterTest : public QObject {
    Q_OBJECT

    static Wanted wantedLike(const char* name) {
        const PaperModel* model = findPaperModel(name);
        return {model->counts, model->tracksPerTrail, 1};
    }

    static std::filesystem::path write(const Folder& folder, const Wanted& wanted, const char* name = "model.txt") {
        base::Progress progress;
        const base::Status status = writeModel(wanted, folder.path() / name, progress);
        if (!status) {
            qFatal("%s", status.error().text.c_str());
        }
        return folder.path() / name;
    }

    static std::shared_ptr<const model::Document> read(const std::filesystem::path& path) {
        base::Progress progress;
        const auto board = model::readBoard(path, {}, progress);
        return board ? *board : nullptr;
    }

    static std::size_t curvesOf(const model::Document& board, const model::AreaGeometry& area) {
        std::size_t count = 0;
        for (const model::Contour& contour : board.shapes.contoursOf(area.shape)) {
            const auto nodes = board.shapes.nodesOf(contour);
            count +=
                static_cast<std::size_t>(std::ranges::count(nodes, model::EdgeKind::Curve, &model::PathNode::edge));
        }
        return count;
    }

private slots:
    void countsAreExactAndAllAreasHaveCurves_data() {
        QTest::addColumn<QString>("like");
        QTest::newRow("t1") << "t1";
        QTest::newRow("t2, with arcs") << "t2";
    }
    void countsAreExactAndAllAreasHaveCurves() {
        QFETCH(QString, like);
        const Wanted wanted = wantedLike(like.toUtf8().constData());
        const Folder folder;
        const auto board = read(write(folder, wanted));
        QVERIFY(board);
        for (std::size_t kind = 0; kind < wanted.counts.size(); ++kind) {
            QCOMPARE(std::uint64_t{board->elementCounts()[kind]}, wanted.counts[kind]);
        }
        for (const model::Diagnostic& entry : board->diagnostics.entries()) {
            QVERIFY2(entry.severity == model::Severity::Info, entry.text.c_str());
        }
        for (const model::AreaGeometry& area : board->areas) {
            QVERIFY(curvesOf(*board, area) > 0);
        }
        QCOMPARE(board->boardThickness, 1'620'000);  // with the print
    }

    void itIsTheBoardOfTheJob() {
        const Folder folder;
        Wanted wanted = wantedLike("t1");
        const auto board = read(write(folder, wanted));
        base::Progress progress;
        QVERIFY(writeJob(wanted, folder.path() / "job.tgz", progress));
        const auto job = odb_testing::read(folder.path() / "job.tgz");
        // Elements of a layer come in the same order.
        const auto elementsOn = [](const model::Document& document, std::string_view layer, model::ElementKind kind) {
            std::vector<model::ElementId> elements;
            for (std::uint32_t row = 0; row < document.elements.size(); ++row) {
                if (document.layer(document.elements.layer[row]).name == layer && document.elements.kind[row] == kind) {
                    elements.push_back(model::ElementId{row});
                }
            }
            return elements;
        };
        const auto pads = elementsOn(*board, "Top", model::ElementKind::Area);
        const auto jobPads = elementsOn(*job, "top", model::ElementKind::Area);
        QCOMPARE(pads.size(), jobPads.size());
        double most = 0;
        for (std::size_t i = 0; i < pads.size(); ++i) {
            QVERIFY(board->boxOf(pads[i]) == job->boxOf(jobPads[i]));
            const double own = model::areaOf(*board, pads[i]);
            const double expected = model::areaOf(*job, jobPads[i]);
            // Small pads are the very same region; of the others at most corners are cut.
            const bool isSmall = board->boxOf(pads[i]).width() == 200'000;
            const double least = isSmall ? 1 - 1e-9 : 0.7;
            QVERIFY2(own <= expected * (isSmall ? 1 + 1e-9 : 1.02) && own > expected * least,
                     qPrintable(QString("%1 of %2, %3").arg(own).arg(expected).arg(own / expected - 1)));
            most = std::max(most, expected);
        }
        QVERIFY(most > 0);
        const auto planes = elementsOn(*board, "Ground", model::ElementKind::Area);
        const auto jobPlanes = elementsOn(*job, "ground", model::ElementKind::Area);
        QCOMPARE(planes.size(), jobPlanes.size());
        QVERIFY(!planes.empty());
        for (std::size_t i = 0; i < planes.size(); ++i) {
            QVERIFY(model::areaOf(*board, planes[i]) < model::areaOf(*job, jobPlanes[i]));
            QVERIFY(model::areaOf(*board, planes[i]) > 0.99 * model::areaOf(*job, jobPlanes[i]));
        }
    }

    void distancesAreThoseOfTheJob() {
        const Folder folder;
        const Wanted wanted = wantedLike("t1");
        const auto board = read(write(folder, wanted));
        // Barrels stand in the middle of circles of 250 µm in a plane: 175 µm from it, on all sides.
        int holes = 0;
        model::FigureTable planes;
        for (std::uint32_t row = 0; row < board->elements.size(); ++row) {
            const bool isPlane = board->elements.kind[row] == model::ElementKind::Area &&
                                 board->layer(board->elements.layer[row]).name == "Ground";
            if (isPlane) {
                planes.add(*board, model::ElementId{row});
            }
        }
        for (std::uint32_t row = 0; row < board->elements.size(); ++row) {
            if (board->layer(board->elements.layer[row]).name != "MultiLayer") {
                continue;
            }
            model::FigureTable barrel;
            barrel.add(*board, model::ElementId{row});
            const auto spacing = model::spacingBetween(planes, barrel, 1e6);
            if (spacing && spacing->distance > 0) {
                QVERIFY2(std::abs(spacing->distance - 175'000) < 0.3, qPrintable(QString::number(spacing->distance)));
                ++holes;
            }
        }
        QVERIFY(holes > 100);
    }

    void theSameArgumentsGiveTheSameText() {
        const Folder folder;
        const auto textOf = [](const std::filesystem::path& path) {
            std::stringstream text;
            text << std::ifstream(path, std::ios::binary).rdbuf();
            return text.str();
        };
        const std::string first = textOf(write(folder, wantedLike("t1"), "a.txt"));
        QVERIFY(first == textOf(write(folder, wantedLike("t1"), "b.txt")));
        QVERIFY(first.find("NURBS,1,0,5,24") != std::string::npos);
    }

    void failuresAreToldAndLeaveNoFile() {
        base::Progress progress;
        const base::Status status = writeModel(wantedLike("t1"), "/nonexistent/model.txt", progress);
        QVERIFY(!status);
        QVERIFY(status.error().code == base::ErrorCode::OutputFailed);
        const Folder folder;
        base::Progress cancelled;
        cancelled.cancel();
        const base::Status stopped = writeModel(wantedLike("t1"), folder.path() / "model.txt", cancelled);
        QVERIFY(!stopped && stopped.error().code == base::ErrorCode::Cancelled);
        QVERIFY(!std::filesystem::exists(folder.path() / "model.txt"));
    }

    void whatIsNotFinishedLeavesTheFileThatWasThere() {
        const Folder folder;
        std::ofstream(folder.path() / "model.txt") << "kept";
        base::Progress cancelled;
        cancelled.cancel();
        QVERIFY(!writeModel(wantedLike("t1"), folder.path() / "model.txt", cancelled));
        QVERIFY(odb_testing::readFile(folder.path() / "model.txt") == "kept");
        const std::filesystem::directory_iterator files(folder.path());
        QCOMPARE(std::distance(begin(files), end(files)), std::ptrdiff_t{1});
    }
};

QTEST_APPLESS_MAIN(ModelWriterTest)
#include "model_writer_test.moc"
