#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QProcess>
#include <QTemporaryDir>
#include <QXmlStreamReader>
#include <QtTest>

#include "tests/locations.h"

namespace {

struct Outcome {
    int exitCode = -1;
    QByteArray out;
    QByteArray err;
};

Outcome copperscope(const QStringList& arguments, const QString& folder = {},
                    const QProcessEnvironment& environment = {}) {
    QProcess process;
    process.setProcessEnvironment(environment.isEmpty() ? QProcessEnvironment::systemEnvironment() : environment);
    if (!folder.isEmpty()) {
        process.setWorkingDirectory(folder);
    }
    process.start(locations::kProgram, arguments);
    process.waitForFinished(300'000);
    const bool isNormal = process.exitStatus() == QProcess::NormalExit;
    return {isNormal ? process.exitCode() : -1, process.readAllStandardOutput(), process.readAllStandardError()};
}

/// Width and height from a PNG's header, which is all that must be known here.
QSize pngSize(const QString& path) {
    QFile file(path);
    if (!file.open(QIODevice::ReadOnly)) {
        return {};
    }
    const QByteArray head = file.read(24);
    const auto number = [&](int at) {
        return static_cast<int>(qFromBigEndian<quint32>(reinterpret_cast<const uchar*>(head.constData()) + at));
    };
    return head.startsWith("\x89PNG") ? QSize(number(16), number(20)) : QSize();
}

/// The element of a list that must have one.
QJsonObject onlyOne(const QJsonValue& list) {
    const QJsonArray array = list.toArray();
    return array.size() == 1 ? array.first().toObject() : QJsonObject();
}

}  // namespace

class CliTest : public QObject {
    Q_OBJECT

private slots:
    void infoNamesZonesAndThePlacesOfMessages() {
        const auto info = [](const char* job) {
            const Outcome run = copperscope({"info", QString(locations::kTestData) + "/odb/" + job, "--json"});
            return QJsonDocument::fromJson(run.out).object();
        };
        const QJsonArray zones = info("rigid_flex")["zones"].toArray();
        QCOMPARE(zones.size(), 3);
        QCOMPARE(zones[1].toObject()["name"].toString(), QString("Flex"));
        QCOMPARE(zones[1].toObject()["layers"].toArray(), (QJsonArray{"COVER", "L2", "CORE", "L3"}));
        const QJsonArray messages = info("drills")["diagnostics"].toArray();
        const auto found = std::find_if(messages.begin(), messages.end(), [](const QJsonValue& message) {
            return message.toObject()["text"].toString().contains("takes the plating");
        });
        QVERIFY(found != messages.end());
        const QJsonObject location = (*found).toObject()["location"].toObject();
        QCOMPARE(location["layer"].toString(), QString("BACK"));
        QCOMPARE(location["x_nm"].toInt(), 4'000'000);
        QCOMPARE(location["y_nm"].toInt(), 4'000'000);
    }

    void infoHasTheKeysThatOthersRelyOn() {
        const Outcome run = copperscope({"info", locations::kSample, "--json"});
        QCOMPARE(run.exitCode, 0);
        const QJsonObject info = QJsonDocument::fromJson(run.out).object();
        const auto hasKeys = [](const QJsonObject& object, const QStringList& keys) {
            for (const QString& key : keys) {
                if (!object.contains(key)) {
                    qWarning() << "missing:" << key;
                    return false;
                }
            }
            return true;
        };
        QVERIFY(hasKeys(info, {"job", "layers", "stackup", "elements", "nets", "components", "drills", "board",
                               "diagnostics", "timing_ms"}));
        QVERIFY(hasKeys(info["job"].toObject(), {"name", "generator", "version", "units", "steps"}));
        QVERIFY(hasKeys(info["elements"].toObject(), {"line", "arc", "circle", "trail", "area", "total"}));
        QVERIFY(hasKeys(info["board"].toObject(), {"width_nm", "height_nm", "thickness_nm"}));
        QVERIFY(hasKeys(info["timing_ms"].toObject(), {"parse", "create", "discretise", "triangulate"}));
        const QJsonObject layer = info["layers"].toArray().first().toObject();
        QVERIFY(
            hasKeys(layer, {"name", "type", "side", "polarity", "z_nm", "thickness_nm", "thickness_source", "counts"}));
        const QJsonObject stackup = info["stackup"].toObject();
        QCOMPARE(stackup["board_nm"].toInt(), 1'570'741);
        const QJsonObject prepreg = stackup["rows"].toArray()[4].toObject();
        QCOMPARE(prepreg["name"].toString(), "DIELECTRIC_1");
        QCOMPARE(prepreg["material"].toString(), "2x106");
        QCOMPARE(prepreg["material_type"].toString(), "PREPREG");
        QCOMPARE(prepreg["dielectric_constant"].toDouble(), 4.1);
        QVERIFY(prepreg["loss_tangent"].isNull());
        QCOMPARE(stackup["rows"].toArray()[3].toObject()["copper_oz_source"].toString(), "derived");
        QVERIFY(hasKeys(layer["counts"].toObject(), {"line", "arc", "circle", "trail", "area", "features"}));
        QVERIFY(hasKeys(info["diagnostics"].toArray().first().toObject(),
                        {"severity", "file", "line", "text", "count", "location", "place"}));
    }

    void benchMeasuresBothPipelines() {
        const Outcome run = copperscope({"bench", locations::kSample, "--frames", "1", "--json"});
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
            }
            QCOMPARE(views, QSet<QString>({"whole", "5x", "30x"}));
        }
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

    void clearanceTellsABuildWhatIsTooClose() {
        const Outcome all = copperscope({"clearance", locations::kSample, "--worst", "3", "--format", "json"});
        QVERIFY2(all.exitCode == 0, all.err.constData());
        const QJsonArray listed = QJsonDocument::fromJson(all.out)["steps"][0]["clearances"].toArray();
        QCOMPARE(listed.size(), 3);
        QCOMPARE(listed[0]["gap_um"], listed[0]["clearance_um"]);  // the old name
        const double narrowest = listed[0]["clearance_um"].toDouble();
        QVERIFY(narrowest > 0.0 && narrowest <= listed[1]["clearance_um"].toDouble());
        const auto below = [&](double um) {
            return copperscope({"clearance", locations::kSample, "--below", QString::number(um, 'f', 3) + "um"})
                .exitCode;
        };
        QCOMPARE(below(narrowest + 1.0), 4);
        QCOMPARE(below(narrowest - 1.0), 0);
        QCOMPARE(copperscope({"clearance", locations::kSample, "--below", "3 apples"}).exitCode, 1);
        QCOMPARE(copperscope({"clearance", locations::kSample, "--layer", "nowhere"}).exitCode, 1);
    }

    void rulesTellABuildWhatIsBroken() {
        QTemporaryDir folder;
        const auto check = [&](const char* um) {
            QFile file(folder.filePath("rules.json"));
            file.open(QIODevice::WriteOnly);
            file.write(R"({"copperscope_rules": 1, "rules": [{"kind": "copper-copper", "least_um": )");
            file.write(um + QByteArray("}]}"));
            file.close();
            return copperscope({"clearance", locations::kSample, "--rules", file.fileName(), "--format", "json"});
        };
        QCOMPARE(check("1").exitCode, 0);
        const Outcome broken = check("5000");
        QCOMPARE(broken.exitCode, 4);
        const QJsonValue rule = QJsonDocument::fromJson(broken.out)["steps"][0]["rules"][0];
        QCOMPARE(rule["passed"].toBool(true), false);
        QCOMPARE(rule["findings"].toArray().size(), std::min(100, rule["count"].toInt()));
        QVERIFY(rule["findings"][0]["clearance_um"].toDouble() < 5000.0);
        QCOMPARE(check("-1").exitCode, 2);
        QVERIFY(check("-1").err.contains("least_um"));
        QCOMPARE(copperscope({"clearance", locations::kSample, "--rules", "/nowhere.json"}).exitCode, 2);
    }

    void measureTellsHowFarThingsAreApart() {
        const auto measure = [](const QStringList& rest) {
            return copperscope(QStringList{"measure", locations::kSample} + rest);
        };
        // The narrowest clearance of the board is the distance of its two nets, and of its two elements.
        const Outcome all = copperscope({"clearance", locations::kSample, "--worst", "1", "--format", "json"});
        const QJsonObject narrowest = onlyOne(QJsonDocument::fromJson(all.out)["steps"][0]["clearances"]);
        const double gap = narrowest["clearance_um"].toDouble() * 1000.0;
        const auto item = [&](const char* prefix, const char* list, int row) {
            return prefix + narrowest[list][row].toVariant().toString();
        };
        for (const auto& [prefix, list] : {std::pair("net:", "nets"), std::pair("element:", "elements")}) {
            const Outcome run =
                measure({"--from", item(prefix, list, 0), "--to", item(prefix, list, 1), "--format", "json"});
            QVERIFY2(run.exitCode == 0, run.err.constData());
            const QJsonObject way = QJsonDocument::fromJson(run.out)["on_layer"].toObject();
            QVERIFY2(std::abs(way["distance_nm"].toDouble() - gap) < 0.01, run.out.constData());
            QCOMPARE(way["ends"][0]["layer"], narrowest["layer"]);
            QCOMPARE(way["gap_nm"], way["spacing_nm"]);  // old names stay beside the new ones
            QVERIFY(QJsonDocument::fromJson(run.out).object().contains("remarks"));
            QCOMPARE(way["relation"].toString(), QString("apart"));
        }
        const QStringList nets = {"--from", item("net:", "nets", 0), "--to", item("net:", "nets", 1)};
        QCOMPARE(measure(nets + QStringList{"--below", QString::number(gap / 1000 + 1) + "um"}).exitCode, 4);
        QCOMPARE(measure(nets + QStringList{"--below", QString::number(gap / 1000 - 1) + "um"}).exitCode, 0);
        const Outcome csv = measure(nets + QStringList{"--format", "csv"});
        QVERIFY(csv.out.startsWith("kind,distance um") && csv.out.count('\n') == 4);
        QVERIFY(measure({"--from", "part:U1", "--to", "edge"}).out.contains("on one layer"));
        QVERIFY(measure({"--from", "at:1mm,-2mm", "--to", "at:4mm,2mm"}).out.contains("5.000000 mm"));
    }

    void measureSaysWhatItDoesNotKnow() {
        const auto measure = [](const QString& from) {
            return copperscope({"measure", locations::kSample, "--from", from, "--to", "edge"});
        };
        for (const auto& [from, why] :
             {std::pair("net:GNDD", "did you mean GND"), std::pair("pin:U1.999", "no pin of U1"),
              std::pair("element:99999999", "numbered from 0"), std::pair("at:1,2", "a number with um"),
              std::pair("at:1mm", "X,Y"), std::pair("apple", "names no item"), std::pair("7/net:GND", "no copy 7"),
              std::pair("at:1mm,1mm,nowhere", "no layer nowhere")}) {
            const Outcome run = measure(from);
            QVERIFY2(run.exitCode == 1 && run.err.contains(why), run.err.constData());
        }
        QVERIFY(measure("edge").out.contains("both are the same"));
    }

    void measureFollowsNets() {
        const auto path = [](const QStringList& rest) {
            return copperscope(QStringList{"measure", locations::kSample, "--path", "GND"} + rest);
        };
        const Outcome run = path({"--from", "net:GND", "--to", "net:GND", "--format", "json"});
        QVERIFY2(run.exitCode == 0, run.err.constData());
        QCOMPARE(QJsonDocument::fromJson(run.out)["length_nm"].toDouble(), 0.0);
        const Outcome off = path({"--from", "edge", "--to", "net:GND"});
        QVERIFY2(off.exitCode == 1 && off.err.contains("has no copper of net GND"), off.err.constData());
        QCOMPARE(path({"--from", "edge", "--to", "net:GND", "--below", "1mm"}).exitCode, 1);
    }

    void oldNamesOfSolderMasksStillWork() {
        const Outcome run = copperscope({"section", locations::kTestData + QStringLiteral("/odb/everything"), "--line",
                                         "0,1,9,1", "--layers", "SMT coat"});
        QVERIFY2(run.exitCode == 0, run.err.constData());
        QVERIFY2(run.err.contains("\"SMT coat\" is now named \"SMT solder mask\""), run.err.constData());
    }

    void sectionShowsWhatALineCuts() {
        const Outcome run =
            copperscope({"section", locations::kSample, "--line", "-1000,20,1000,20.5", "--format", "json"});
        QVERIFY2(run.exitCode == 0, run.err.constData());
        const QJsonObject section = QJsonDocument::fromJson(run.out).object();
        QSet<QString> layers;
        for (const QJsonValue& piece : section["pieces"].toArray()) {
            layers.insert(piece["layer"].toString());
            QVERIFY(piece["from_nm"].toDouble() < piece["to_nm"].toDouble());
            QVERIFY(piece["bottom_nm"].toInt() <= piece["top_nm"].toInt());
        }
        QVERIFY2(layers.size() > 3, run.out.constData());
        QXmlStreamReader svg(copperscope({"section", locations::kSample, "--line", "-1000,20,1000,20.5"}).out);
        while (!svg.atEnd()) {
            svg.readNext();
        }
        QVERIFY2(!svg.hasError(), qPrintable(svg.errorString()));
        const Outcome beside =
            copperscope({"section", locations::kSample, "--line", "900,900,901,900", "--format", "csv"});
        QCOMPARE(beside.exitCode, 0);
        QCOMPARE(beside.out.count('\n'), 1);
        for (const char* line : {"1,2,3", "1,2,1,2", "1,2", "0,0,5000,0"}) {
            QCOMPARE(copperscope({"section", locations::kSample, "--line", line}).exitCode, 1);
        }
        QCOMPARE(copperscope({"section", locations::kSample, "--line", "0,0,1,1", "--layers", "nowhere"}).exitCode, 1);
    }

    void benchRefusesOptionsOfTheOtherMeasurement() {
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
    }

    void elementsAreTheSumOfTheLayers() {
        const QJsonObject info =
            QJsonDocument::fromJson(copperscope({"info", locations::kSample, "--json"}).out).object();
        int lines = 0;
        for (const QJsonValue& layer : info["layers"].toArray()) {
            lines += layer.toObject()["counts"].toObject()["line"].toInt();
        }
        const QJsonObject elements = info["elements"].toObject();
        QCOMPARE(elements["line"].toInt(), lines);
        QCOMPARE(elements["total"].toInt(), elements["line"].toInt() + elements["arc"].toInt() +
                                                elements["circle"].toInt() + elements["trail"].toInt() +
                                                elements["area"].toInt());
        QVERIFY(elements["total"].toInt() > 1000);
    }

    void theSampleIsTheDefaultBoard() {
        const Outcome run = copperscope({"info"});
        QCOMPARE(run.exitCode, 0);
        QVERIFY(run.out.contains("layer") && run.out.contains("times"));
        QVERIFY(run.err.isEmpty());
    }

    void wrongUsageAnswersOne_data() {
        QTest::addColumn<QStringList>("arguments");
        QTest::addRow("unknown option") << QStringList{"info", "--frobnicate"};
        QTest::addRow("no output") << QStringList{"render"};
        QTest::addRow("unknown layer") << QStringList{"render", "-o", "x.png", "--layers", "no-such-layer"};
        QTest::addRow("unknown net") << QStringList{"render", "-o", "x.png", "--net", "no-such-net"};
        QTest::addRow("unknown step") << QStringList{"info", "--step", "no-such-step"};
        QTest::addRow("bad size") << QStringList{"render", "-o", "x.png", "--size", "12"};
        QTest::addRow("bad chord") << QStringList{"info", "--chord", "0.1"};
        QTest::addRow("picture of unknown kind") << QStringList{"render", "-o", "x.bmp"};
        QTest::addRow("empty window") << QStringList{"render", "-o", "x.png", "--window", "1,1,1,5"};
        QTest::addRow("2D from the side") << QStringList{"render", "-o", "x.png", "--mode", "2d", "--view", "iso"};
    }
    void wrongUsageAnswersOne() {
        QFETCH(QStringList, arguments);
        QTemporaryDir folder;
        const Outcome run = copperscope(arguments, folder.path());
        QCOMPARE(run.exitCode, 1);
        QVERIFY(run.out.isEmpty() || run.err.size() > 0);
        QVERIFY(QDir(folder.path()).isEmpty());
    }

    void unreadableInputAnswersTwo_data() {
        QTest::addColumn<QByteArray>("content");
        QTest::addColumn<QString>("name");
        QFile sample(locations::kSample);
        QVERIFY(sample.open(QIODevice::ReadOnly));
        const QByteArray whole = sample.readAll();
        QTest::addRow("empty file") << QByteArray() << "board.tgz";
        QTest::addRow("no archive") << QByteArray("hello") << "board.tgz";
        QTest::addRow("truncated archive") << whole.left(whole.size() / 2) << "board.tgz";
        QTest::addRow("no board") << QByteArray("PK\x05\x06") + QByteArray(18, '\0') << "board.zip";
    }
    void unreadableInputAnswersTwo() {
        QFETCH(QByteArray, content);
        QFETCH(QString, name);
        QTemporaryDir folder;
        QFile file(folder.filePath(name));
        QVERIFY(file.open(QIODevice::WriteOnly));
        file.write(content);
        file.close();
        const Outcome run = copperscope({"info", name}, folder.path());
        QCOMPARE(run.exitCode, 2);
        QVERIFY2(run.err.contains(name.toUtf8()), run.err.constData());
        QVERIFY(run.out.isEmpty());
        QCOMPARE(QDir(folder.path()).entryList(QDir::Files).size(), 1);
    }

    void missingInputAnswersTwo() {
        const Outcome run = copperscope({"info", "/nowhere/board.tgz"});
        QCOMPARE(run.exitCode, 2);
        QVERIFY(run.err.contains("/nowhere/board.tgz"));
    }

    void renderWritesOnlyThePicture_data() {
        QTest::addColumn<QStringList>("options");
        QTest::addRow("3D, pull") << QStringList{"--backend", "pull"};
        QTest::addRow("3D, impostor") << QStringList{"--backend", "impostor"};
        QTest::addRow("3D, raster") << QStringList{"--backend", "raster"};
        QTest::addRow("3D, automatic") << QStringList{};
        QTest::addRow("bottom") << QStringList{"--view", "bottom"};
        QTest::addRow("2D") << QStringList{"--mode", "2d"};
        QTest::addRow("exploded") << QStringList{"--explode", "1"};
        QTest::addRow("window, mono") << QStringList{"--window", "10,10,20,20", "--mono"};
    }
    void renderWritesOnlyThePicture() {
        QFETCH(QStringList, options);
        QTemporaryDir folder;
        const Outcome run =
            copperscope(QStringList{"render", "-o", "out.png", "--size", "120x80"} + options, folder.path());
        QVERIFY2(run.exitCode == 0, run.err.constData());
        QCOMPARE(QDir(folder.path()).entryList(QDir::Files), QStringList{"out.png"});
        QCOMPARE(pngSize(folder.filePath("out.png")), QSize(120, 80));
        QVERIFY(run.out.isEmpty());
    }

    void unwritableOutputAnswersThree() {
        const Outcome run = copperscope({"render", "-o", "/nowhere/out.png", "--size", "64x64"});
        QCOMPARE(run.exitCode, 3);
        QVERIFY(run.err.contains("/nowhere/out.png"));
    }

    void missingDriverAnswersThreeInWords() {
        QProcessEnvironment environment = QProcessEnvironment::systemEnvironment();
        environment.insert("VK_DRIVER_FILES", "/nowhere/driver.json");
        environment.insert("VK_ICD_FILENAMES", "/nowhere/driver.json");
        const Outcome run = copperscope({"render", "-o", "/nowhere/out.png", "--size", "64x64"}, {}, environment);
        QCOMPARE(run.exitCode, 3);
        QVERIFY2(run.err.contains("Vulkan"), run.err.constData());
    }

    // ---- thicknesses ----

    static QJsonObject stackupRow(const QByteArray& json, const QString& name) {
        for (const QJsonValue& row : QJsonDocument::fromJson(json).object()["stackup"].toObject()["rows"].toArray()) {
            if (row.toObject()["name"].toString() == name) {
                return row.toObject();
            }
        }
        return {};
    }

    void setThicknessesCountAndLeaveNoFile() {
        QTemporaryDir folder;
        QVERIFY(QFile::copy(locations::kSample, folder.filePath("amp.tgz")));
        const Outcome run = copperscope({"info", "amp.tgz", "--json", "--set-thickness", "dielectric_2=1.5mm",
                                         "--set-thickness", "L02-INNER_LAYER=2oz"},
                                        folder.path());
        QVERIFY2(run.exitCode == 0, run.err.constData());
        QCOMPARE(stackupRow(run.out, "DIELECTRIC_2")["thickness_nm"].toInt(), 1'500'000);
        QCOMPARE(stackupRow(run.out, "DIELECTRIC_2")["thickness_source"].toString(), "session");
        QCOMPARE(stackupRow(run.out, "L02-INNER_LAYER")["thickness_nm"].toInt(), 69'600);
        QCOMPARE(stackupRow(run.out, "DIELECTRIC_1")["thickness_source"].toString(), "job");
        QCOMPARE(QDir(folder.path()).entryList(QDir::Files), QStringList{"amp.tgz"});
    }

    void savedThicknessesStayUntilIgnored() {
        QTemporaryDir folder;
        QVERIFY(QFile::copy(locations::kSample, folder.filePath("amp.tgz")));
        const QStringList info{"info", "amp.tgz", "--json"};
        const QStringList set{"--set-thickness", "DIELECTRIC_2=1500um", "--save-session"};
        QCOMPARE(copperscope(info + set, folder.path()).exitCode, 0);
        QVERIFY(QFile::exists(folder.filePath("amp.tgz.copperscope.json")));
        QCOMPARE(stackupRow(copperscope(info, folder.path()).out, "DIELECTRIC_2")["thickness_nm"].toInt(), 1'500'000);
        const Outcome without = copperscope(info + QStringList{"--no-session"}, folder.path());
        QCOMPARE(stackupRow(without.out, "DIELECTRIC_2")["thickness_nm"].toInt(), 1'122'680);
        const Outcome picture = copperscope(
            {"render", "amp.tgz", "-o", "out.png", "--size", "64x64", "--set-thickness", "DIELECTRIC_1=0.3mm"},
            folder.path());
        QVERIFY2(picture.exitCode == 0, picture.err.constData());
    }

    void thicknessesThatMakeNoSenseAnswerOne() {
        for (const char* text : {"NOWHERE=35um", "DIELECTRIC_2", "DIELECTRIC_2=thick", "DIELECTRIC_2=1oz",
                                 "DIELECTRIC_2=-1mm", "DIELECTRIC_2=50mm"}) {
            const Outcome run = copperscope({"info", locations::kSample, "--set-thickness", text});
            QVERIFY2(run.exitCode == 1, text);
            QVERIFY(run.out.isEmpty());
            QVERIFY2(run.err.contains("--set-thickness"), run.err.constData());
        }
    }

    void aStrangeSessionIsToldAndSkipped() {
        QTemporaryDir folder;
        QVERIFY(QFile::copy(locations::kSample, folder.filePath("amp.tgz")));
        QFile file(folder.filePath("amp.tgz.copperscope.json"));
        QVERIFY(file.open(QIODevice::WriteOnly));
        file.write(R"({"copperscope_session": 7})");
        file.close();
        const Outcome run = copperscope({"info", "amp.tgz", "--json"}, folder.path());
        QCOMPARE(run.exitCode, 0);
        QVERIFY2(run.err.contains("version 7"), run.err.constData());
        const Outcome save =
            copperscope({"info", "amp.tgz", "--set-thickness", "DIELECTRIC_2=1mm", "--save-session"}, folder.path());
        QCOMPARE(save.exitCode, 3);
    }

    void checkedNetsListOpensShortsAndLooseCopper() {
        const QString job = locations::kTestData + QStringLiteral("/odb/open_short");
        const Outcome run = copperscope({"info", job, "--check-nets", "--json"});
        QVERIFY2(run.exitCode == 0, run.err.constData());
        const QJsonObject found = QJsonDocument::fromJson(run.out).object()["connectivity"].toObject();
        QCOMPARE(found["islands"].toInt(), 5);
        const QJsonObject open = onlyOne(found["opens"]);
        QCOMPARE(open["net"].toString(), "SPLIT");
        QCOMPARE(open["islands"].toArray().size(), 2);
        const QJsonObject shorted = onlyOne(found["shorts"]);
        QCOMPARE(shorted["nets"].toArray(), (QJsonArray{"A", "B"}));
        QCOMPARE(shorted["layer"].toString(), "TOP");
        QCOMPARE(shorted["x_nm"].toInt(), 4'000'000);
        QCOMPARE(shorted["y_nm"].toInt(), 5'000'000);
        QCOMPARE(onlyOne(found["floating"])["net"].toString(), "LOOSE");
        const Outcome text = copperscope({"info", job, "--check-nets"});
        QVERIFY2(text.out.contains("A and B touch on TOP at 4.0000, 5.0000 mm"), text.out.constData());
        QVERIFY(!copperscope({"info", job}).out.contains("nets against copper"));
    }

    void inferredNetsAreTheIslandsOfTheCopper() {
        const QString job = locations::kTestData + QStringLiteral("/odb/open_short");
        const Outcome run = copperscope({"info", job, "--infer-nets", "--check-nets", "--json"});
        QVERIFY2(run.exitCode == 0, run.err.constData());
        const QJsonObject info = QJsonDocument::fromJson(run.out).object();
        const QJsonObject nets = info["nets"].toObject();
        QCOMPARE(nets["count"].toInt(), 5);
        QCOMPARE(nets["list"].toArray()[0].toObject()["name"].toString(), "$1");
        QStringList elements;
        for (const QJsonValue& net : nets["list"].toArray()) {
            elements += QString::number(net.toObject()["elements"].toInt());
        }
        QCOMPARE(elements.join(' '), "1 1 2 2 1");  // both pads, the crossing lines, the pad with its line, the rest
        for (const char* list : {"opens", "shorts", "floating", "loose"}) {
            QVERIFY2(info["connectivity"].toObject()[list].toArray().isEmpty(), list);
        }
    }

    void netsOfWholeBoardsAreAsTheyWere_data() {
        QTest::addColumn<int>("islands");
        QTest::addColumn<int>("opens");
        QTest::addColumn<int>("loose");
        QTest::addColumn<int>("shorts");
        const auto row = [](const char* name, int islands, int opens, int loose, int shorts) {
            for (const auto& board : locations::boardsNamed({name})) {
                QTest::newRow(board.c_str()) << islands << opens << loose << shorts;
            }
        };
        row("opencellular_breakout.tgz", 665, 0, 0, 0);
        row("kicad/StickHub.tgz", 47, 0, 0, 0);  // as many as nets
        row("severson_amdc_revC.tgz", 655, 0, 5, 0);
        row("kicad/dram-tester.tgz", 2225, 137, 0, 8);  // unfinished: a field of pads without tracks
    }
    void netsOfWholeBoardsAreAsTheyWere() {
        const Outcome run = copperscope({"info", QTest::currentDataTag(), "--check-nets", "--no-session", "--json"});
        const QJsonObject found = QJsonDocument::fromJson(run.out).object()["connectivity"].toObject();
        QFETCH(int, islands);
        QCOMPARE(found["islands"].toInt(), islands);
        for (const char* list : {"opens", "loose", "shorts"}) {
            const int expected = *static_cast<const int*>(QTest::qData(list, qMetaTypeId<int>()));
            QCOMPARE(found[list].toArray().size(), expected);
        }
    }

    void helpAnswersZero() {
        QCOMPARE(copperscope({"--help"}).exitCode, 0);
        QCOMPARE(copperscope({"render", "--help"}).exitCode, 0);
    }

    void versionNamesProgramNumberAndCommit() {
        const Outcome run = copperscope({"--version"});
        QCOMPARE(run.exitCode, 0);
        const QRegularExpression form("^Copperscope (\\S+?)(, commit [0-9a-f]{7,}\\+?)?\n$");
        const QRegularExpressionMatch match = form.match(QString::fromUtf8(run.out));
        QVERIFY2(match.hasMatch(), run.out.constData());
        QCOMPARE(match.captured(1), QString(COPPERSCOPE_VERSION));
    }
};

QTEST_GUILESS_MAIN(CliTest)
#include "cli_test.moc"
