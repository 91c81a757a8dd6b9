#include "model/generate/job_writer.h"

#include <QtTest>
#include <fstream>
#include <set>

#include "tests/unit/model/formats/odb/odb_testing.h"

using namespace model::generate;
using odb_testing::Folder;

/// Made-up boards hold exactly what was asked for and read without complaint.
class JobWriterTest : public QObject {
    Q_OBJECT

    static Wanted wantedLike(const char* name, double scale = 1.0) {
        const PaperModel* model = findPaperModel(name);
        Wanted wanted{model->counts, model->tracksPerTrail, 1};
        for (std::uint64_t& count : wanted.counts) {
            count = static_cast<std::uint64_t>(std::llround(static_cast<double>(count) * scale));
        }
        return wanted;
    }

    static std::filesystem::path write(const Folder& folder, const Wanted& wanted, const char* name = "job.tgz") {
        base::Progress progress;
        const base::Status status = writeJob(wanted, folder.path() / name, progress);
        if (!status) {
            qFatal("%s", status.error().text.c_str());
        }
        return folder.path() / name;
    }

private slots:
    void countsAreExact_data() {
        QTest::addColumn<QString>("like");
        QTest::addColumn<double>("scale");
        QTest::newRow("t1") << "t1" << 1.0;
        QTest::newRow("t2, with arcs") << "t2" << 1.0;
        QTest::newRow("t3") << "t3" << 1.0;
        QTest::newRow("2 x t1") << "t1" << 2.0;
        QTest::newRow("a thirtieth of t7") << "t7" << 1.0 / 30.0;
        QTest::newRow("a hundredth of t1") << "t1" << 0.01;
    }
    void countsAreExact() {
        QFETCH(QString, like);
        QFETCH(double, scale);
        const Wanted wanted = wantedLike(like.toUtf8().constData(), scale);
        const Folder folder;
        const auto document = odb_testing::read(write(folder, wanted));
        for (std::size_t kind = 0; kind < wanted.counts.size(); ++kind) {
            QCOMPARE(std::uint64_t{document->elementCounts()[kind]}, wanted.counts[kind]);
        }
        for (const model::Diagnostic& entry : document->diagnostics.entries()) {
            QVERIFY2(entry.severity == model::Severity::Info, entry.text.c_str());
        }
    }

    void netsHoldWhatTheyJoin() {
        const Folder folder;
        const auto document = odb_testing::read(write(folder, wantedLike("t3")));
        QCOMPARE(document->nets.size(), std::size_t{1334 + 2});  // one per trail, two planes
        const auto hasNet = [&](std::uint32_t row) { return document->elements.net[row].isValid(); };
        for (std::uint32_t row = 0; row < document->elements.size(); ++row) {
            const bool isTrail = document->elements.kind[row] == model::ElementKind::Trail;
            const bool isHole = (document->elements.flags[row] & model::kHole) != 0;
            QVERIFY(!(isTrail || isHole) || hasNet(row));
        }
        for (const char* plane : {"GND", "VCC"}) {
            const std::span<const model::ElementId> elements = document->elementsOf(document->findNet(plane));
            std::set<std::string> layers;
            for (const model::ElementId element : elements) {
                layers.insert(document->layer(document->elements.layer[element.row()]).name);
            }
            QVERIFY(layers.contains("top") && layers.contains("bottom") && layers.contains("drill"));
            QCOMPARE(layers.contains("ground"), std::string(plane) == "GND");
        }
    }

    /// A via lies in a hole of every plane but its own net's.
    void planesKeepClearOfOtherNets() {
        const Folder folder;
        const auto document = odb_testing::read(write(folder, wantedLike("t1")));
        for (const char* name : {"ground", "power"}) {
            const model::Layer& layer = document->layer(document->findLayer(name));
            QCOMPARE(layer.counts[static_cast<std::size_t>(model::ElementKind::Area)], 1U);
            const model::AreaGeometry& area = document->areas[document->elements.geometry[layer.elements.first]];
            const model::NetId own = document->elements.net[layer.elements.first];
            std::set<std::pair<model::Nm, model::Nm>> holes;
            for (const model::Contour& contour : document->shapes.contoursOf(area.shape)) {
                if (contour.isHole) {
                    const model::Point centre = document->shapes.nodesOf(contour)[0].centre;
                    holes.insert({centre.x, centre.y});
                }
            }
            const model::Layer& drill = document->layer(document->findLayer("drill"));
            for (std::uint32_t i = 0; i < drill.elements.count; ++i) {
                const std::uint32_t row = drill.elements.first + i;
                const model::Point at = document->circles[document->elements.geometry[row]].centre;
                QCOMPARE(holes.contains({at.x, at.y}), document->elements.net[row] != own);
            }
        }
    }

    void everythingLiesOnTheBoard() {
        const Folder folder;
        const auto document = odb_testing::read(write(folder, wantedLike("t2")));
        QVERIFY(document->extent.min.x >= document->board.min.x && document->extent.max.x <= document->board.max.x);
        QVERIFY(document->extent.min.y >= document->board.min.y && document->extent.max.y <= document->board.max.y);
    }

    void sameSeedGivesTheSameBytes() {
        const Folder folder;
        Wanted wanted = wantedLike("t1");
        const std::string first = odb_testing::readFile(write(folder, wanted, "a.tgz"));
        QVERIFY(first == odb_testing::readFile(write(folder, wanted, "b.tgz")));
        wanted.seed = 2;
        QVERIFY(first != odb_testing::readFile(write(folder, wanted, "c.tgz")));
    }

    void whatCannotBeWrittenIsAnError() {
        base::Progress progress;
        const base::Status noFolder = writeJob(wantedLike("t1"), "/nonexistent/job.tgz", progress);
        QVERIFY(!noFolder);
        QCOMPARE(noFolder.error().code, base::ErrorCode::OutputFailed);
        const base::Status tooLarge = writeJob(wantedLike("t9", 1000.0), "/nonexistent/job.tgz", progress);
        QVERIFY(!tooLarge);
        QCOMPARE(tooLarge.error().code, base::ErrorCode::BadUsage);
    }

    void cancellingLeavesNoFile() {
        const Folder folder;
        base::Progress progress;
        progress.cancel();
        const base::Status status = writeJob(wantedLike("t1"), folder.path() / "job.tgz", progress);
        QVERIFY(!status);
        QCOMPARE(status.error().code, base::ErrorCode::Cancelled);
        QVERIFY(!std::filesystem::exists(folder.path() / "job.tgz"));
    }

    void whatIsNotFinishedLeavesTheFileThatWasThere() {
        const Folder folder;
        std::ofstream(folder.path() / "job.tgz") << "kept";
        base::Progress cancelled;
        cancelled.cancel();
        QVERIFY(!writeJob(wantedLike("t1"), folder.path() / "job.tgz", cancelled));
        QVERIFY(odb_testing::readFile(folder.path() / "job.tgz") == "kept");
        const std::filesystem::directory_iterator files(folder.path());
        QCOMPARE(std::distance(begin(files), end(files)), std::ptrdiff_t{1});
    }
};

QTEST_APPLESS_MAIN(JobWriterTest)
#include "job_writer_test.moc"
