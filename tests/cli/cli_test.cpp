// What every command has in common, info, render and thicknesses.
#include <QJsonDocument>
#include <QTemporaryDir>
#include <QtTest>
#include <set>

#include "tests/cli/program.h"

using namespace program;

namespace {

/// The limit is not set where a sanitizer maps far more than there is.
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
constexpr bool kHasLimitOfMemory = false;
#else
constexpr bool kHasLimitOfMemory = true;
#endif

void endsOrSaysThatMemoryRanOut(const QStringList& arguments, int mib) {
    const Outcome run = copperscope(arguments + QStringList{"--max-memory", QString::number(mib) + "M"});
    const bool isSaid = run.exitCode == 3 && run.err.startsWith("copperscope: out of memory: ") &&
                        run.err.contains(QByteArray::number(mib) + " MiB") && run.err.contains("--max-memory");
    QVERIFY2(run.exitCode == 0 || isSaid, qPrintable(QString("%1 with %2 MiB: exit code %3: %4")
                                                         .arg(arguments.join(' '))
                                                         .arg(mib)
                                                         .arg(run.exitCode)
                                                         .arg(QString(run.err))));
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

    void memoryBeyondTheLimitIsSaid() {
        if (!kHasLimitOfMemory) {
            QSKIP("a sanitizer is at work");
        }
        const Outcome run = copperscope({"info", locations::kSample, "--max-memory", "12M"});
        QCOMPARE(run.exitCode, 3);
        QVERIFY2(run.err.contains("out of memory: this takes more than 12 MiB, the limit that --max-memory sets"),
                 run.err.constData());
        QCOMPARE(copperscope({"info", locations::kSample, "--max-memory", "8G"}).exitCode, 0);
        QCOMPARE(copperscope({"info", locations::kSample, "--max-memory", "much"}).exitCode, 1);
        QCOMPARE(copperscope({"info", locations::kSample, "--max-unpacked", "10K"}).exitCode, 2);
    }

    void noLimitOfMemoryIsACrash() {
        // At first libarchive has no room, in the middle of this range a thread finds no room for its stack, beyond it
        // the work is done.
        for (const int mib : {2, 3, 4, 6, 9, 12, 13, 14, 15, 16, 17, 18, 19, 20, 24, 64}) {
            endsOrSaysThatMemoryRanOut({"info", locations::kSample}, mib);
        }
        const QTemporaryDir folder;
        for (const int mib : {16, 48}) {
            endsOrSaysThatMemoryRanOut({"measure", locations::kSample, "--from", "part:U2", "--to", "edge"}, mib);
            endsOrSaysThatMemoryRanOut({"export", locations::kSample, "-o", folder.filePath("a.glb")}, mib);
            endsOrSaysThatMemoryRanOut({"render", locations::kSample, "-o", folder.filePath("a.png")}, mib);
        }
    }

    void outputThatIsLostIsAFailure() {
        for (const QStringList& arguments :
             {QStringList{"--help"}, QStringList{"--version"}, QStringList{"info", locations::kSample},
              QStringList{"info", locations::kSample, "--json"},
              QStringList{"measure", locations::kSample, "--from", "part:U2", "--to", "edge"}}) {
            const Outcome run = copperscopeInShell("exec %1 >/dev/full", arguments);
            QVERIFY2(run.exitCode == 3, qPrintable(arguments.join(' ')));
            QVERIFY2(run.err.contains("cannot be written to stdout"), run.err.constData());
        }
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

    void assumedPlatingIsMarked() {
        const QString board = QString(locations::kTestData) + "/odb/everything";
        const QJsonObject info = QJsonDocument::fromJson(copperscope({"info", board, "--json"}).out).object();
        int assumed = 0;
        for (const QJsonValue& row : info["drills"].toArray()) {
            const bool isAsDrilled = row["inside_nm"] == row["diameter_nm"];
            const bool isSaid = row["inside_nm"] == row["finished_nm"] && row["diameter_nm"] == row["drill_nm"];
            const bool isArea = row["shape"].toString() == "area";
            QCOMPARE(row["inside_source"].toString(), isArea ? "" : isAsDrilled || isSaid ? "job" : "assumed");
            assumed += row["inside_source"].toString() == "assumed" ? 1 : 0;
        }
        const QByteArray text = copperscope({"info", board}).out;
        const QByteArray holes = text.mid(text.indexOf("holes on"));
        QVERIFY(assumed > 0);
        QCOMPARE(holes.left(holes.indexOf("\n\n")).count(" assumed "), assumed);
    }

    void holesOfCopiesAreCountedToo() {
        const QString panel = QString(locations::kTestData) + "/odb/panel";
        const QJsonObject info = QJsonDocument::fromJson(copperscope({"info", panel, "--json"}).out).object();
        const auto countOf = [](const QJsonObject& board, const char* drills = "drills") {
            int count = 0;
            for (const QJsonValue& row : board[drills].toArray()) {
                count += row["count"].toInt();
            }
            return count;
        };
        int expected = countOf(info);
        for (const QJsonValue& placed : info["placed_steps"].toArray()) {
            const Outcome step = copperscope({"info", panel, "--json", "--step", placed["name"].toString()});
            expected += placed["copies"].toInt() * countOf(QJsonDocument::fromJson(step.out).object());
        }
        QVERIFY(expected > countOf(info));
        QCOMPARE(countOf(info, "drills_with_copies"), expected);
        const QByteArray text = copperscope({"info", panel}).out;
        QVERIFY2(text.contains(" " + QByteArray::number(expected) + "\n"), text.constData());
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

    /// Nobody may take half a board for a whole one, least of all a script that looks at exit codes.
    void whatCouldNotBeReadIsSaidByAllCommands() {
        const QTemporaryDir folder;
        QFile whole(locations::kTestData + QStringLiteral("/kicad/small.kicad_pcb"));
        QFile cut(folder.filePath("cut.kicad_pcb"));
        QVERIFY(whole.open(QIODevice::ReadOnly) && cut.open(QIODevice::WriteOnly));
        cut.write(whole.read(whole.size() * 2 / 3));
        cut.close();
        const QByteArray loss = "error: The file ends before the board does; it was cut off";
        const auto run = [&](QStringList words) { return copperscope(words, folder.path()); };
        for (const QStringList& words : {QStringList{"export", "cut.kicad_pcb", "-o", "cut.svg"},
                                         QStringList{"render", "cut.kicad_pcb", "-o", "cut.png", "--size", "64x64"},
                                         QStringList{"info", "cut.kicad_pcb"}}) {
            const Outcome said = run(words);
            QVERIFY2(said.exitCode == 0 && said.err.contains(loss), said.err.constData());
        }
        for (const QStringList& words :
             {QStringList{"clearance", "cut.kicad_pcb", "--below", "1um"},
              QStringList{"clearance", "cut.kicad_pcb", "--through", "--below", "1um"},
              QStringList{"measure", "cut.kicad_pcb", "--from", "net:GND", "--to", "at:0mm,0mm", "--below", "1um"},
              QStringList{"agree", "cut.kicad_pcb", "cut.kicad_pcb"}}) {
            const Outcome verdict = run(words);
            QVERIFY2(verdict.exitCode == 4 && verdict.err.contains(loss), verdict.err.constData());
            QVERIFY(verdict.err.contains("not everything could be checked"));
            QVERIFY(!verdict.out.contains("The jobs agree."));
            const Outcome allowed = run(words + QStringList{"--allow-incomplete"});
            QVERIFY2(allowed.exitCode == 0 && allowed.err.contains("not everything"), allowed.err.constData());
        }
        QCOMPARE(run({"agree", whole.fileName(), whole.fileName()}).exitCode, 0);
        const QStringList rules{"clearance", "cut.kicad_pcb", "--rules", "default"};
        QVERIFY(run(rules).out.contains("1 error: not all of the job could be read"));
        QCOMPARE(run(rules).exitCode, 4);
        QVERIFY(!run({"clearance", whole.fileName(), "--rules", "default"}).out.contains("could be read"));
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

    void boardsAreDrawnInTheColoursAskedFor() {
        QTemporaryDir folder;
        std::set<QByteArray> pictures;
        for (const QStringList& options :
             {QStringList{}, QStringList{"--mask-colour", "blue"}, QStringList{"--silkscreen-colour", "yellow"},
              QStringList{"--finish", "tin"}, QStringList{"--finish", "copper"}}) {
            const Outcome run =
                copperscope(QStringList{"render", "-o", "out.png", "--view", "top"} + options, folder.path());
            QVERIFY2(run.exitCode == 0, run.err.constData());
            QFile picture(folder.filePath("out.png"));
            QVERIFY(picture.open(QIODevice::ReadOnly));
            pictures.insert(picture.readAll());
        }
        QCOMPARE(pictures.size(), std::size_t{5});
    }

    void unwritableOutputAnswersThree() {
        const Outcome run = copperscope({"render", "-o", "/nowhere/out.png", "--size", "64x64"});
        QCOMPARE(run.exitCode, 3);
        QVERIFY(run.err.contains("/nowhere/out.png"));
    }

    void aPictureThatDoesNotFitLeavesTheOneBefore() {
        const QTemporaryDir folder;
        const QString path = folder.filePath("out.png");
        QFile before(path);
        QVERIFY(before.open(QIODevice::WriteOnly));
        before.write("the picture before");
        before.close();
        const Outcome run = copperscopeInShell("ulimit -f 4; exec %1", {"render", "-o", path, "--mode", "2d"});
        QCOMPARE(run.exitCode, 3);
        QVERIFY2(run.err.contains(path.toUtf8() + " cannot be written: File too large"), run.err.constData());
        QVERIFY(before.open(QIODevice::ReadOnly));
        QCOMPARE(before.readAll(), QByteArray("the picture before"));
        QCOMPARE(QDir(folder.path()).entryList(QDir::Files).size(), 1);
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

    void totalsZonesAndFindingsOfTheStackupAreReported() {
        const Outcome text = copperscope({"info", locations::kTestData + QStringLiteral("/odb/rigid_flex")});
        QVERIFY2(text.out.contains("zone Flex: copper to copper 556.67 um, overall 606.67 um: COVER, L2, CORE, L3"),
                 text.out.constData());
        const Outcome run =
            copperscope({"info", locations::kSample, "--json", "--no-session", "--set-thickness", "TOP_SOLDER=254um"});
        QCOMPARE(stackupRow(run.out, "DIELECTRIC_1")["kind"].toString(), "prepreg");
        const QJsonObject stackup = QJsonDocument::fromJson(run.out).object()["stackup"].toObject();
        const QJsonObject whole = stackup["substacks"].toArray()[0].toObject();
        QVERIFY(whole["zone"].isNull());
        QCOMPARE(whole["copper_to_copper_nm"].toInt(), 1'570'740);
        QCOMPARE(whole["overall_nm"].toInt(), 1'570'740 + 254'000 + 17'780);
        QCOMPARE(whole["rows"].toArray()[2].toObject()["cumulative_nm"].toInt(), 254'000);
        const QJsonObject finding = stackup["findings"].toArray()[0].toObject();
        QCOMPARE(finding["check"].toString(), "mask_thickness");
        QCOMPARE(finding["severity"].toString(), "warning");
        QCOMPARE(finding["rows"].toArray(), QJsonArray{"TOP_SOLDER"});
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
        QVERIFY2(run.exitCode == 4, run.err.constData());  // a build has to know
        QCOMPARE(copperscope({"info", job, "--json"}).exitCode, 0);
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

    /// "0 shorts" of a board without nets would be a pass that nobody looked for.
    void nothingToCompareIsNoPass() {
        const QString job = locations::kTestData + QStringLiteral("/odb/drills");
        const Outcome run = copperscope({"info", job, "--check-nets", "--json"});
        QCOMPARE(run.exitCode, 4);
        QVERIFY2(run.err.contains("nothing was compared: the board has copper but no nets (--allow-incomplete"),
                 run.err.constData());
        const QJsonObject found = QJsonDocument::fromJson(run.out).object()["connectivity"].toObject();
        QCOMPARE(found["steps_without_nets"].toArray(), QJsonArray{"BOARD"});
        const Outcome text = copperscope({"info", job, "--check-nets", "--allow-incomplete"});
        QCOMPARE(text.exitCode, 0);
        QVERIFY2(text.out.contains("BOARD: not compared: it has copper but no nets"), text.out.constData());
        // Frames of panels have no nets beside boards that do.
        const Outcome panel = copperscope({"info", locations::kTestData + QStringLiteral("/odb/panel"), "--check-nets",
                                           "--allow-incomplete", "--json"});
        QVERIFY2(panel.exitCode == 0 && !panel.err.contains("nothing was compared"), panel.err.constData());
        const QJsonObject steps = QJsonDocument::fromJson(panel.out).object()["connectivity"].toObject();
        QCOMPARE(steps["steps_without_nets"].toArray(), QJsonArray{"PANEL"});
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
        const Outcome text = copperscope({"info", job, "--infer-nets", "--check-nets"});
        QVERIFY2(text.out.contains("its nets follow from its copper"), text.out.constData());
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
        const bool isFaulty = !found["opens"].toArray().isEmpty() || !found["shorts"].toArray().isEmpty();
        QCOMPARE(run.exitCode, isFaulty ? 4 : 0);  // floating copper is no fault
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
