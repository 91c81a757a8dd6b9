// Which of several forms of a board is read, what the files of a job draw, and whether two jobs agree.
#include <QDir>
#include <QFile>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QTemporaryDir>
#include <QtTest>

#include "tests/cli/program.h"
#include "tests/zip.h"

using namespace program;

class FormsCommandsTest : public QObject {
    Q_OBJECT

private slots:
    void jobsOfOneBoardAgree() {
        const Outcome same = copperscope({"agree", locations::kSample, locations::kSample});
        QVERIFY2(same.exitCode == 0, same.err.constData());
        QVERIFY(same.out.contains("The jobs agree.") && same.out.contains("Never compared: materials"));
        const QString breakout = QString::fromStdString((locations::boards() / "opencellular_breakout.tgz").string());
        const Outcome other = copperscope({"agree", locations::kSample, breakout, "--json", "--worst", "1"});
        QCOMPARE(other.exitCode, 4);
        const QJsonObject report = QJsonDocument::fromJson(other.out).object();
        QCOMPARE(report["agree"].toBool(true), false);
        QCOMPARE(report["never_compared"].toArray().size(), 3);
        const Outcome nameless = copperscope({"info", ""});
        QVERIFY2(nameless.exitCode == 1 && nameless.err.contains("the value is empty"), nameless.err.constData());
        const QJsonObject copper = report["comparisons"][0].toObject();
        QCOMPARE(copper["aspect"].toString(), QString("copper"));
        QCOMPARE(copper["verdict"].toString(), QString("differ"));
        QVERIFY(copper["only_nm2"][0].toDouble() > 0.0);
        QCOMPARE(copper["differences"].toArray().size(), 1);
    }

    void theFormatToReadIsSaid() {
        for (const char* option : {"--input-format", "--format"}) {
            const Outcome info = copperscope({"info", locations::kSample, option, "odb", "--json"});
            QVERIFY2(info.exitCode == 0, info.err.constData());
            QCOMPARE(QJsonDocument::fromJson(info.out)["job"]["format"].toString(), QString("odb"));
        }
        const QStringList measure{"measure", locations::kSample, "--from", "at:0mm,0mm", "--to", "at:1mm,1mm"};
        QCOMPARE(copperscope(measure + QStringList{"--format", "json", "--input-format", "odb"}).exitCode, 0);
        QCOMPARE(copperscope({"info", locations::kSample, "--format", "paper"}).exitCode, 2);
        QCOMPARE(copperscope({"info", locations::kSample, "--format", "pdf"}).exitCode, 1);
        QCOMPARE(copperscope({"agree", locations::kSample, locations::kSample, "--format-b", "paper"}).exitCode, 2);
    }

    /// One of two boards in a folder is no silent choice.
    void whichOfSeveralBoardsWasReadIsSaid() {
        const QTemporaryDir folder;
        const QByteArray board =
            "(kicad_pcb (version 20241229) (layers (0 \"F.Cu\" signal) (2 \"B.Cu\" signal)) (net 1 \"GND\")\n"
            "(segment (start 0 0) (end 9 0) (width 1) (layer \"F.Cu\") (net 1)))\n";
        for (const char* name : {"one.kicad_pcb", "two.kicad_pcb"}) {
            QFile file(folder.filePath(name));
            QVERIFY(file.open(QFile::WriteOnly) && file.write(board) == board.size());
        }
        const QString one = folder.filePath("one.kicad_pcb");
        const QByteArray said =
            folder.path().toUtf8() +
            ": read as KiCad board, one.kicad_pcb; what else is there: KiCad board (two.kicad_pcb)\n";
        const QList<QStringList> all{
            {"info", folder.path()},
            {"clearance", folder.path()},
            {"clearance", folder.path(), "--format", "html", "--rules", "default", "--allow-incomplete"},
            {"measure", folder.path(), "--from", "at:0mm,0mm", "--to", "at:1mm,1mm"},
            {"export", folder.path(), "-o", folder.filePath("a.svg")},
            {"agree", one, folder.path()},
            {"clearance", folder.path(), "--input-format", "kicad"}};
        for (const QStringList& arguments : all) {
            const Outcome run = copperscope(arguments);
            QVERIFY2(run.exitCode == 0 || run.exitCode == 4, run.err.constData());
            QVERIFY2(run.err.count(said) == 1, run.err.constData());
            QCOMPARE(run.out.contains("Job " + one.toUtf8()), arguments.contains("html"));
        }
        QVERIFY(!copperscope({"clearance", one}).err.contains("what else is there"));
    }

    void filesWithNamesBeyondAsciiAreRead() {
        const QTemporaryDir folder;
        const std::string pads = "%FSLAX46Y46*%\n%MOMM*%\n%ADD10C,1.5*%D10*X2000000Y2000000D03*X8000000D03*M02*\n";
        const QByteArray bytes = QByteArray::fromStdString(
            zip::packed({{"board.gtl", pads}, {"Leiterplatte_Rückseite.gbl", pads, zip::kUtf8Name}}));
        QFile file(folder.filePath("board.zip"));
        QVERIFY(file.open(QFile::WriteOnly) && file.write(bytes) == bytes.size());
        file.close();
        const Outcome info = copperscope({"info", file.fileName()});
        QVERIFY2(info.exitCode == 0, info.err.constData());
        QVERIFY2(info.out.contains("top copper") && info.out.contains("bottom copper"), info.out.constData());
    }

    void whatFilesDrawIsSaid() {
        const QTemporaryDir folder;
        const auto write = [&](const QString& name, const QByteArray& text) {
            QFile file(folder.filePath(name));
            return file.open(QIODevice::WriteOnly) && file.write(text) == text.size();
        };
        QVERIFY(QDir(folder.path()).mkdir("job"));
        const QByteArray pads = "%FSLAX46Y46*%\n%MOMM*%\n%ADD10C,1.5*%D10*X2000000Y2000000D03*X8000000D03*M02*\n";
        QVERIFY(write("job/one.gbr", pads) && write("job/two.gbr", pads));
        const QString job = folder.filePath("job");
        const QString map = folder.filePath("map.txt");
        const Outcome proposed = copperscope({"info", job, "--print-layer-map"});
        QVERIFY2(proposed.exitCode == 0, proposed.err.constData());
        QVERIFY(proposed.out.contains("# not sure: nothing tells\none.gbr = document\n"));
        QVERIFY(write("map.txt", "one.gbr = copper top\ntwo.gbr = copper bottom\nthree.gbr = outline\n"));
        const Outcome told = copperscope({"info", job, "--layer-map", map});
        QVERIFY2(told.exitCode == 0, told.err.constData());
        QVERIFY(told.out.contains("top copper") && told.out.contains("bottom copper"));
        QVERIFY(told.out.contains("map.txt:3: The layer map names \"three.gbr\""));
        QVERIFY(copperscope({"info", job, "--layer-map", map, "--print-layer-map"}).out.contains("# the layer map\n"));
        QCOMPARE(copperscope({"info", job, "--layer-map", folder.filePath("none.txt")}).exitCode, 2);
        const Outcome other = copperscope({"info", locations::kSample, "--print-layer-map"});
        QVERIFY2(other.exitCode == 1 && other.out.isEmpty() &&
                     other.err.contains("this is no Gerber job; it is read as ODB++"),
                 other.err.constData());
        const Outcome unused = copperscope({"info", locations::kSample, "--layer-map", map});
        QVERIFY2(unused.exitCode == 1 && unused.err.contains("this was read as odb"), unused.err.constData());
        QCOMPARE(copperscope({"agree", locations::kSample, locations::kSample, "--layer-map", map}).exitCode, 1);
        QCOMPARE(copperscope({"agree", locations::kSample, job, "--layer-map", map}).exitCode, 4);
    }

    void aChangedJobDiffersInTheLayerThatChanged() {
        const QTemporaryDir folder;
        const std::filesystem::path job = folder.filePath("job").toStdString();
        const std::filesystem::path original = std::filesystem::path(locations::kTestData) / "odb" / "drills";
        std::filesystem::copy(original, job, std::filesystem::copy_options::recursive);
        QFile file(QString::fromStdString((job / "steps/board/layers/l1/features").string()));
        QVERIFY(file.open(QIODevice::Append));
        QVERIFY(file.write("L 1 1 4 1 0 P 0\n") > 0);
        file.close();
        const QStringList both{QString::fromStdString(original.string()), QString::fromStdString(job.string())};
        const Outcome all = copperscope(QStringList{"agree"} + both);
        QCOMPARE(all.exitCode, 4);
        QCOMPARE(all.out.count("DIFFER"), 1);
        QVERIFY(all.out.contains("DIFFER        copper         L1"));
        QCOMPARE(copperscope(QStringList{"agree", "--aspects", "holes,nets"} + both).exitCode, 0);
        QCOMPARE(copperscope(QStringList{"agree", "--allow", "100"} + both).exitCode, 0);
        QCOMPARE(copperscope(QStringList{"agree", "--aspects", "colour"} + both).exitCode, 1);
        QCOMPARE(copperscope(QStringList{"agree", "--tolerance", "3 apples"} + both).exitCode, 1);
        QCOMPARE(copperscope({"agree", both[0], "nowhere.tgz"}).exitCode, 2);
    }

    void aThickerLayerDiffersInTheStackup() {
        const QTemporaryDir folder;
        QStringList both;
        for (const QByteArray um : {"35", "70"}) {
            const std::filesystem::path job = folder.filePath(um).toStdString();
            std::filesystem::copy(std::filesystem::path(locations::kTestData) / "odb" / "drills", job,
                                  std::filesystem::copy_options::recursive);
            both += QString::fromStdString(job.string());
            QFile file(both.back() + "/steps/board/layers/l1/attrlist");
            QVERIFY(file.open(QIODevice::WriteOnly) && file.write("UNITS=MM\n.copper_weight=" + um + "\n") > 0);
        }
        const Outcome run = copperscope(QStringList{"agree", "--json", "--aspects", "stackup"} + both);
        QCOMPARE(run.exitCode, 4);
        const QJsonObject stackup = QJsonDocument::fromJson(run.out)["comparisons"][0].toObject();
        QCOMPARE(stackup["aspect"].toString(), QString("stackup"));
        QCOMPARE(stackup["differences"][0]["text"].toString(),
                 QString::fromUtf8("copper L1 is 35.0 µm thick in A, 70.0 µm in B"));
        QCOMPARE(copperscope(QStringList{"agree", "--aspects", "copper,holes"} + both).exitCode, 0);
    }
};

QTEST_GUILESS_MAIN(FormsCommandsTest)
#include "forms_commands_test.moc"
