// What is refused before anything is read: options that are wrong, that do not fit together or would do nothing.
#include <QDir>
#include <QTemporaryDir>
#include <QtTest>
#include <filesystem>

#include "tests/cli/program.h"

using namespace program;

class OptionsTest : public QObject {
    Q_OBJECT

private slots:
    void whatIsReadIsNotWrittenOver() {
        const QTemporaryDir folder;
        const QString board = folder.filePath("board.tgz");
        const QString link = folder.filePath("link.tgz");
        QVERIFY(QFile::copy(locations::kSample, board) && QFile::link(board, link));
        const auto bytes = [&board] {
            QFile file(board);
            return file.open(QFile::ReadOnly) ? file.readAll() : QByteArray();
        };
        const QByteArray before = bytes();
        for (const QString& out : {board, link}) {
            const Outcome run = copperscope({"clearance", board, "--worst", "1", "-o", out});
            QCOMPARE(run.exitCode, 1);
            QVERIFY2(run.err.contains("is read, so it is not written over"), run.err.constData());
        }
        QCOMPARE(copperscope({"clearance", board, "--rules", "default", "--write-waivers", board, "--reason", "x",
                              "--author", "y"})
                     .exitCode,
                 1);
        const Outcome map = copperscope({"clearance", board, "--layer", "L01-TOP_LAYER", "--map", board});
        QCOMPARE(map.exitCode, 1);
        QVERIFY2(map.err.contains("name another file for --map"), map.err.constData());
        QCOMPARE(bytes(), before);
    }

    /// What lies in the folder and is no part of the job is replaced.
    void jobsThatAreFoldersAreNotWrittenTo() {
        const QTemporaryDir folder;
        const std::filesystem::path job = folder.filePath("job").toStdString();
        std::filesystem::copy(std::filesystem::path(locations::kTestData) / "odb" / "drills", job,
                              std::filesystem::copy_options::recursive);
        const QString path = folder.filePath("job");
        const QString matrix = path + "/matrix/matrix";
        const qint64 size = QFileInfo(matrix).size();
        const Outcome refused = copperscope({"clearance", path, "--format", "csv", "-o", matrix});
        QCOMPARE(refused.exitCode, 1);
        QVERIFY2(refused.err.contains("is read, so it is not written over"), refused.err.constData());
        QCOMPARE(QFileInfo(matrix).size(), size);
        for (int time = 0; time < 2; ++time) {
            const Outcome run = copperscope({"export", path, "-o", path + "/board.svg"});
            QVERIFY2(run.exitCode == 0, run.err.constData());
        }
    }

    void whatIsReadBesideABoardIsNotWrittenOver() {
        const QTemporaryDir folder;
        const QString board = folder.filePath("small.kicad_pcb");
        const QString project = folder.filePath("small.kicad_pro");
        QVERIFY(QFile::copy(QString(locations::kTestData) + "/kicad/small.kicad_pcb", board));
        QFile file(project);
        QVERIFY(file.open(QFile::WriteOnly) && file.write("{}") == 2);
        file.close();
        const Outcome refused = copperscope({"clearance", board, "--worst", "1", "--format", "csv", "-o", project});
        QCOMPARE(refused.exitCode, 1);
        QVERIFY2(refused.err.contains("small.kicad_pro is read, so it is not written over"), refused.err.constData());
        QCOMPARE(QFileInfo(project).size(), qint64{2});
        const Outcome run = copperscope({"export", board, "-o", folder.filePath("small.svg")});
        QVERIFY2(run.exitCode == 0, run.err.constData());
    }

    /// The board has the name of the materials.
    void whatIsReadIsNoMaterials() {
        const QTemporaryDir folder;
        const QString board = folder.filePath("board.mtl");
        QVERIFY(QFile::copy(locations::kSample, board));
        const Outcome run = copperscope({"export", board, "-o", folder.filePath("board.obj")});
        QCOMPARE(run.exitCode, 1);
        QVERIFY2(run.err.contains("board.mtl, which belongs to ") && run.err.contains("it is not written over"),
                 run.err.constData());
        QCOMPARE(QDir(folder.path()).entryList(QDir::Files), QStringList{"board.mtl"});
        QCOMPARE(QFileInfo(board).size(), QFileInfo(locations::kSample).size());
    }

    void numbersAreFinite() {
        const QStringList commands[] = {{"agree", locations::kSample, locations::kSample, "--allow", "nan"},
                                        {"info", locations::kSample, "--chord", "nan"},
                                        {"export", locations::kSample, "-o", "x.svg", "--window", "nan,0,1,1"},
                                        {"section", locations::kSample, "--line", "0,0,1,1", "--scale", "-nan"}};
        for (const QStringList& arguments : commands) {
            const Outcome run = copperscope(arguments, QDir::tempPath());
            QCOMPARE(run.exitCode, 1);
            QVERIFY2(run.err.contains("nan is no number") || run.err.contains("not in range"), run.err.constData());
        }
    }

    void coordinatesAreFinite() {
        for (const char* item : {"at:nanmm,0mm", "at:0mm,nanmm", "at:infmm,0mm"}) {
            const Outcome run = copperscope({"measure", locations::kSample, "--from", item, "--to", "edge"});
            QCOMPARE(run.exitCode, 1);
            QVERIFY2(run.err.contains("is no coordinate"), run.err.constData());
        }
    }

    void aFileThatCannotBeUsedIsNamed() {
        const QTemporaryDir folder;
        const QString path = folder.filePath("setting.json");
        QFile file(path);
        QVERIFY(file.open(QFile::WriteOnly) && file.write("{}") == 2);
        file.close();
        for (const QStringList& options : {QStringList{"--rules", path}, {"--rules", "default", "--waivers", path}}) {
            const Outcome run = copperscope(QStringList{"clearance", locations::kSample} + options);
            QCOMPARE(run.exitCode, 2);
            QVERIFY2(run.err.contains((path + ": the ").toUtf8()), run.err.constData());
        }
    }

    void aMisspeltCommandIsNamed() {
        const auto errorOf = [](const QStringList& arguments) {
            const Outcome run = copperscope(arguments, QDir::tempPath());
            return run.exitCode == 1 && run.out.isEmpty() ? run.err : QByteArray();
        };
        const QByteArray near = errorOf({"clearnce", locations::kSample});
        QVERIFY2(near.contains("clearnce is neither") && near.contains("did you mean clearance?"), near.constData());
        QCOMPARE(errorOf({"clearnce", locations::kSample, "--rules", "default"}), near);
        QCOMPARE(errorOf({"clearnce"}), near);
        const QByteArray far = errorOf({"frobnicate"});
        QVERIFY2(far.contains("frobnicate is neither") && !far.contains("did you mean"), far.constData());
        const QByteArray option = errorOf({"info", "--frobnicate"});
        QVERIFY2(option.contains("--frobnicate") && !option.contains("neither"), option.constData());
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
        QTest::addRow("no colour of masks") << QStringList{"render", "-o", "x.png", "--mask-colour", "pink"};
        QTest::addRow("no finish") << QStringList{"render", "-o", "x.png", "--finish", "paint"};
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

    /// Nobody may take something for done that was not.
    void optionsThatWouldDoNothingAreRefused_data() {
        QTest::addColumn<QStringList>("arguments");
        QTest::addColumn<QString>("why");
        const auto row = [](const char* arguments, const char* why) {
            QStringList words = QString(arguments).split(' ');
            words.insert(1, locations::kSample);
            QTest::newRow(arguments) << words << QString(why);
        };
        const auto ofRender = [&row](const char* options, const char* why) {
            row(qPrintable("render -o x.png " + QString(options)), why);
        };
        row("clearance --tolerance 0.3um", "--tolerance requires --rules");
        row("clearance --allow-incomplete", "--allow-incomplete needs --rules or --below");
        row("measure --from edge --to net:GND --allow-incomplete", "--allow-incomplete requires --below");
        row("clearance --rules default --write-waivers w.json --reason x --author y -o r.txt", "excludes");
        row("clearance --rules default --print --below 1mm", "excludes");
        row("clearance --through --layer L01-TOP_LAYER", "excludes");
        row("clearance --through --map x.png --layer L01-TOP_LAYER", "excludes");
        row("clearance --map x.png --layer L01-TOP_LAYER --format csv", "excludes");
        row("info --print-layer-map --json", "excludes");
        row("info --chord 3 --paper-segments", "excludes");
        row("info --save-session", "nothing is set");
        row("measure --from edge --to net:GND --chord 3", "--chord");
        row("measure --from edge --to net:GND --triangulator cgal", "--triangulator");
        row("section --line 0,0,9,9 --chord 3", "--chord");
        row("section --line 0,0,9,9 --format csv --scale 2", "need --format svg");
        row("section --line 0,0,9,9 --format json --height-times 2", "need --format svg");
        row("export -o x.step --triangulator cgal", "--triangulator");
        row("export -o x.step --chord 3", "has the exact curves");
        row("export -o x.svg --paper-segments", "has the exact curves");
        row("export -o x.svg --as-designed", "whole layers");
        row("export -o x.obj --one-part", "OBJ does not know --one-part");
        row("export -o x.stl --one-part", "STL does not know --one-part");
        row("export -o x.svg --set-thickness DIELECTRIC_1=1mm", "is flat");
        ofRender("--mode 3d --window 1,1,5,5", "--window is for pictures in 2D");
        ofRender("--outlines", "--outlines is for pictures in 2D");
        ofRender("--mode 2d --clip 0,0,9,9", "--clip is for pictures in 3D");
        ofRender("--mode 2d --explode 1", "--explode is for pictures in 3D");
        ofRender("--window 1,1,5,5 --z-scale 10,5", "--z-scale is for pictures in 3D");
        ofRender("--mode 2d --mask-colour blue", "--mask-colour is for pictures in 3D");
        ofRender("--mode 2d --silkscreen-colour blue", "--silkscreen-colour is for pictures in 3D");
        ofRender("--mode 2d --finish tin", "--finish is for pictures in 3D");
        ofRender("--mode 2d --set-thickness DIELECTRIC_1=1mm", "--set-thickness is for pictures in 3D");
        ofRender("--window 900,900,901,901", "--window lies beside the board");
        ofRender("--mode 2d --as-designed", "--as-designed is for pictures in 3D");
        ofRender("--components --layers L01-TOP_LAYER", "excludes");
        ofRender("--mono --net GND", "excludes");
        ofRender("--mono --components", "excludes");
        ofRender("--layers TOP_SOLDER --mask-colour red",
                 "--mask-colour: the layers that are drawn have no solder mask");
        ofRender("--layers TOP_SOLDER --silkscreen-colour red", "have no silkscreen");
        ofRender("--layers TOP_OVERLAY --finish tin", "have no copper");
        ofRender("--mono --finish tin", "excludes");
        ofRender("--pipeline standard --backend pull", "--backend is of the hybrid pipeline");
        ofRender("--pipeline standard --lod paper", "--lod is of the hybrid pipeline");
        ofRender("--pipeline standard --triangulator cgal", "--triangulator is of the hybrid pipeline");
        ofRender("--pipeline standard --as-designed", "--as-designed is of the hybrid pipeline");
        row("clearance --rules default --print", "excludes");
        QTest::newRow("agree without layers")
            << QStringList{"agree", "a.tgz", "b.tgz", "--aspects", "nets", "--tolerance", "20um"}
            << QStringLiteral("--tolerance is for layers, outline and holes");
        QTest::newRow("agree without areas")
            << QStringList{"agree", "a.tgz", "b.tgz", "--aspects", "net-names", "--allow", "50"}
            << QStringLiteral("--allow is for layers and outline");
        QTest::newRow("agree without nets")
            << QStringList{"agree", "a.tgz", "b.tgz", "--aspects", "copper", "--infer-nets"}
            << QStringLiteral("--infer-nets is for nets and their names");
        row("bench --pipeline standard --lod paper", "--lod is of the hybrid pipeline");
        row("bench --triangulation --sets nope", "there is no set nope; there are none, areas 1k");
        row("bench --triangulation --chord 3", "excludes");
        row("bench --interactive --paper-segments", "excludes");
        QTest::newRow("before the command")
            << QStringList{"--infer-nets", "info"} << QStringLiteral("--infer-nets stands before info");
        QTest::newRow("board before the command")
            << QStringList{locations::kSample, "info"} << QStringLiteral("stands before info");
    }

    void optionsThatWouldDoNothingAreRefused() {
        QFETCH(QStringList, arguments);
        QFETCH(QString, why);
        QTemporaryDir folder;
        const Outcome run = copperscope(arguments, folder.path());
        QVERIFY2(run.exitCode == 1 && run.out.isEmpty(), run.err.constData());
        QVERIFY2(run.err.contains(why.toUtf8()), run.err.constData());
        QVERIFY(QDir(folder.path()).isEmpty());
    }
};

QTEST_GUILESS_MAIN(OptionsTest)
#include "options_test.moc"
