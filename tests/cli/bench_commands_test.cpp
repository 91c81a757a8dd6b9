// bench and generate, and both pipelines and all triangulators by their options.
#include <QJsonDocument>
#include <QTemporaryDir>
#include <QtTest>

#include "tests/cli/program.h"

using namespace program;

constexpr bool kHasWorkbench = COPPERSCOPE_HAS_WORKBENCH;

class BenchCommandsTest : public QObject {
    Q_OBJECT

private slots:
    void benchMeasuresBothPipelines() {
        const Outcome run = copperscope({"bench", locations::kSample, "--frames", "1", "--stages", "--json"});
        QCOMPARE(run.exitCode, 0);
        const QJsonObject report = QJsonDocument::fromJson(run.out).object();
        QVERIFY(!report["device"].toString().isEmpty());
        QVERIFY(report.contains("commit"));
        const QJsonObject board = report["boards"].toArray().first().toObject();
        QCOMPARE(board["name"].toString(), QFileInfo(locations::kSample).fileName());
        QVERIFY(board["elements"].toObject()["total"].toInt() > 0);
        for (const char* pipeline : {"hybrid", "standard"}) {
            const QJsonObject result = board["pipelines"].toObject()[pipeline].toObject();
            for (const char* key : {"parse_ms", "create_ms", "discretise_ms", "triangulate_ms", "upload_ms"}) {
                QVERIFY2(result[key].toDouble(-1.0) >= 0.0, key);
            }
            QVERIFY(result["gpu_bytes"].toDouble() > 0 && result["cpu_bytes"].toDouble() > 0);
            QSet<QString> views;
            for (const QJsonValue& value : result["frames"].toArray()) {
                const QJsonObject frame = value.toObject();
                views.insert(frame["view"].toString());
                QVERIFY(frame["ms"].toDouble() > 0.0 && frame["triangles"].toInt() > 0);
                QVERIFY(frame["grey_mse"].toDouble() <= 0.001);
                QVERIFY(frame["stages_ms"].toObject().contains("end of the board"));
            }
            QCOMPARE(views, QSet<QString>({"whole", "5x", "30x"}));
        }
    }

    void benchMovesTheViewsOfTheWindow() {
        if (!kHasWorkbench) {
            QSKIP("this build has no workbench");
        }
        QProcessEnvironment environment = QProcessEnvironment::systemEnvironment();
        environment.remove("DISPLAY");
        environment.remove("QT_QPA_PLATFORM");
        const Outcome run =
            copperscope({"bench", "--interactive", locations::kSample, "--frames", "8", "--size", "800x500", "--json"},
                        {}, environment);
        QCOMPARE(run.exitCode, 0);
        const QJsonObject report = QJsonDocument::fromJson(run.out).object();
        QCOMPARE(report["width"].toInt(), 800);
        QCOMPARE(report["height"].toInt(), 500);
        QVERIFY(!report["device"].toString().isEmpty());
        const QJsonObject board = onlyOne(report["boards"]);
        QCOMPARE(board["name"].toString(), QFileInfo(locations::kSample).fileName());
        QVERIFY(board["first_frame_ms"].toDouble() > 0.0);
        QVERIFY(board["first_whole_ms"].toDouble() >= board["first_frame_ms"].toDouble());
        QStringList runs;
        for (const QJsonValue& value : board["runs"].toArray()) {
            const QJsonObject one = value.toObject();
            runs += one["view"].toString() + " " + one["name"].toString();
            const double median = one["median_ms"].toDouble();
            const double longest = one["longest_ms"].toDouble();
            QVERIFY(median > 0.0 && median <= one["p95_ms"].toDouble() && one["p95_ms"].toDouble() <= longest);
            QVERIFY(one["longest_stall_ms"].toDouble() > 0.0 && one["frames_per_second"].toDouble() > 0.0);
            const bool isChange = one["name"] == "highlight" || one["name"] == "layers";
            QCOMPARE(one["frames"].toInt(), isChange ? 2 : 8);
        }
        QCOMPARE(runs, QStringList({"2D pan", "2D zoom", "2D hover", "2D highlight", "2D layers", "3D orbit", "3D pan",
                                    "3D zoom", "3D hover", "3D highlight"}));
    }

    void benchOfTheWindowSaysWhatItCannotDo() {
        QCOMPARE(copperscope({"bench", "--interactive"}).exitCode, 1);
        QCOMPARE(copperscope({"bench", locations::kSample, "--size", "800x500"}).exitCode, 1);
        QCOMPARE(copperscope({"bench", "--interactive", locations::kSample, "--pipeline", "hybrid"}).exitCode, 1);
        const Outcome missing = copperscope({"bench", "--interactive", "/nonexistent.tgz"});
        if (!kHasWorkbench) {
            QCOMPARE(missing.exitCode, 3);
            return;
        }
        QCOMPARE(missing.exitCode, 2);
        QVERIFY2(missing.err.contains("/nonexistent.tgz"), missing.err.constData());
    }

    void benchSaysWhatCannotBeRead() {
        QCOMPARE(copperscope({"bench", "/nonexistent.tgz"}).exitCode, 2);
        QCOMPARE(copperscope({"bench"}).exitCode, 1);
    }

    void generatedBoardsHaveTheCountsAskedFor() {
        const QTemporaryDir folder;
        const QString job = folder.filePath("t1.tgz");
        QCOMPARE(copperscope({"generate", "--like", "t1", "-o", job}).exitCode, 0);
        const QJsonObject elements =
            QJsonDocument::fromJson(copperscope({"info", job, "--json"}).out).object()["elements"].toObject();
        QCOMPARE(elements["line"].toInt(), 539);
        QCOMPARE(elements["arc"].toInt(), 0);
        QCOMPARE(elements["circle"].toInt(), 1395);
        QCOMPARE(elements["trail"].toInt(), 529);
        QCOMPARE(elements["area"].toInt(), 823);
        QCOMPARE(copperscope({"generate", "--like", "t10", "-o", job}).exitCode, 1);
        QCOMPARE(copperscope({"generate", "--like", "t1", "-o", folder.filePath("t1.zip")}).exitCode, 1);
        QCOMPARE(copperscope({"generate", "--like", "t1", "-o", "/nonexistent/t1.tgz"}).exitCode, 3);
    }

    void generatedModelsHaveCurves() {
        const QTemporaryDir folder;
        const QString model = folder.filePath("t1.txt");
        QCOMPARE(copperscope({"generate", "--nurbs", "--like", "t1", "-o", model}).exitCode, 0);
        const QJsonObject elements =
            QJsonDocument::fromJson(copperscope({"info", model, "--json"}).out).object()["elements"].toObject();
        QCOMPARE(elements["circle"].toInt(), 1395);
        QCOMPARE(elements["area"].toInt(), 823);
        const auto job = copperscope({"generate", "--nurbs", "--like", "t1", "-o", folder.filePath("t1.tgz")});
        QCOMPARE(job.exitCode, 1);
        QVERIFY(job.err.contains("ODB++ has no NURBS"));
    }

    void theStandardPipelineDrawsToo() {
        const QTemporaryDir folder;
        const QString picture = folder.filePath("board.png");
        QCOMPARE(
            copperscope({"render", locations::kSample, "-o", picture, "--pipeline", "standard", "--size", "320x200"})
                .exitCode,
            0);
        QCOMPARE(pngSize(picture), QSize(320, 200));
    }

    void areasComeOutTheSameFromEveryTriangulator() {
        // Only how the triangles are found differs, so all that is said about the model has to be the same.
        const auto triangles = [](const QString& triangulator) {
            const Outcome run = copperscope({"info", locations::kSample, "--json", "--triangulator", triangulator});
            return run.exitCode == 0 ? QJsonDocument::fromJson(run.out).object()["triangles"].toObject()
                                     : QJsonObject();
        };
        const QJsonObject expected = triangles("cpu");
        QVERIFY(expected["stored"].toInt() > 10'000);
        for (const char* other : {"auto", "parallel", "cgal", "gpu"}) {
            QCOMPARE(triangles(other), expected);
        }
        QCOMPARE(copperscope({"info", locations::kSample, "--triangulator", "magic"}).exitCode, 1);
    }

    void benchRefusesOptionsOfTheOtherMeasurement() {
        QCOMPARE(copperscope({"bench", "--calibrate", locations::kSample}).exitCode, 1);
        QCOMPARE(copperscope({"bench", "--calibrate", "--frames", "3"}).exitCode, 1);
        QCOMPARE(copperscope({"bench", "--triangulation", "--sets", "none", "--frames", "3"}).exitCode, 1);
        QCOMPARE(copperscope({"bench", locations::kSample, "--repeats", "3"}).exitCode, 1);
    }

    void benchMeasuresAllTriangulators() {
        const Outcome run =
            copperscope({"bench", "--triangulation", locations::kSample, "--sets", "areas 1k", "--threads", "1",
                         "--repeats", "1", "--triangulators", "cgal,cpu,parallel,gpu", "--json"});
        QVERIFY2(run.exitCode == 0, run.err.constData());
        const QJsonObject report = QJsonDocument::fromJson(run.out).object();
        QVERIFY(!report["device"].toString().isEmpty());
        QVERIFY(report.contains("commit"));
        const QJsonArray sets = report["sets"].toArray();
        QCOMPARE(sets.size(), 2);
        for (const QJsonValue& set : sets) {
            const QJsonArray runs = set["runs"].toArray();
            QCOMPARE(runs.size(), 4);
            for (const QJsonValue& each : runs) {
                QVERIFY(each["verified"].toBool());
                QCOMPARE(each["hash"], runs.first()["hash"]);
                QVERIFY(each["ms"].toDouble() > 0.0);
            }
        }
        QCOMPARE(copperscope({"bench"}).exitCode, 1);
        QCOMPARE(copperscope({"bench", "--triangulation", "no-such-board"}).exitCode, 2);
        const Outcome limited =
            copperscope({"bench", "--triangulation", locations::kSample, "--sets", "none", "--max-unpacked", "10K"});
        QVERIFY2(limited.exitCode == 2 && limited.err.contains("unpacks to too much"), limited.err.constData());
    }
};

QTEST_GUILESS_MAIN(BenchCommandsTest)
#include "bench_commands_test.moc"
