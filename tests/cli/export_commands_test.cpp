// export and verify: what leaves a board, and the proof of it.
#include <QDir>
#include <QDirIterator>
#include <QJsonDocument>
#include <QTemporaryDir>
#include <QtTest>
#include <csignal>

#include "tests/cli/program.h"

using namespace program;

namespace {

/// Sends the signal once the folder, or one in it, has a file of that name, and waits for the program's end. How it
/// ended: the signal it died of, or 0.
int signalOnceThereIs(const QString& name, const QDir& folder, const QStringList& arguments, int signal) {
    QProcess process;
    QProcessEnvironment environment = QProcessEnvironment::systemEnvironment();
    environment.insert("TMPDIR", folder.path());
    process.setProcessEnvironment(environment);
    process.setChildProcessModifier([signal] { std::signal(signal, SIG_DFL); });  // whoever runs the test may ignore it
    process.start(locations::kProgram, arguments);
    const auto isThere = [&] {
        return QDirIterator(folder.path(), {name}, QDir::Files, QDirIterator::Subdirectories).hasNext();
    };
    while (!isThere() && process.state() != QProcess::NotRunning) {
        process.waitForFinished(1);
    }
    if (process.state() == QProcess::NotRunning) {
        return 0;
    }
    ::kill(static_cast<pid_t>(process.processId()), signal);
    process.waitForFinished(300'000);
    return process.exitStatus() == QProcess::CrashExit ? process.exitCode() : 0;
}

}  // namespace

class ExportCommandsTest : public QObject {
    Q_OBJECT

private slots:
    void everyFormatIsWritten_data() {
        QTest::addColumn<QString>("ending");
        QTest::addColumn<QByteArray>("begins");
        QTest::newRow("STEP") << "step" << QByteArray("ISO-10303-21;");
        QTest::newRow("GLB") << "glb" << QByteArray("glTF");
        QTest::newRow("STL") << "STL" << QByteArray();
        QTest::newRow("OBJ") << "obj" << QByteArray("#");
        QTest::newRow("DXF") << "dxf" << QByteArray();
        QTest::newRow("SVG") << "svg" << QByteArray("<?xml");
        QTest::newRow("PDF") << "pdf" << QByteArray("%PDF");
    }
    void everyFormatIsWritten() {
        QFETCH(QString, ending);
        QFETCH(QByteArray, begins);
        const QTemporaryDir folder;
        const QString path = folder.filePath("board." + ending);
        const Outcome done = copperscope({"export", locations::kSample, "--layers", "L01-TOP_LAYER", "-o", path});
        QVERIFY2(done.exitCode == 0, done.err.constData());
        QVERIFY(done.out.isEmpty());
        QFile file(path);
        QVERIFY(file.open(QFile::ReadOnly));
        QVERIFY(file.size() > 1000);
        QVERIFY(file.read(100).startsWith(begins));
        QCOMPARE(done.err.contains(path.toUtf8() + " and " + folder.filePath("board.mtl").toUtf8() + ": "),
                 ending == "obj");
    }

    void filtersMakeItSmaller() {
        const QTemporaryDir folder;
        const auto size = [&](const QStringList& more) {
            const QString path = folder.filePath("board.step");
            const int code = copperscope(QStringList{"export", locations::kSample, "-o", path} + more).exitCode;
            return code == 0 ? QFileInfo(path).size() : -code;
        };
        const qint64 top = size({"--layers", "L01-TOP_LAYER"});
        QVERIFY(top > 0);
        QVERIFY(size({"--layers", "L01-TOP_LAYER", "--nets", "GND"}) < top);
        QVERIFY(size({"--layers", "L01-TOP_LAYER", "--window", "0,0,5,5"}) < top);
        QVERIFY(size({"--outer-only", "--min-hole", "0.5mm"}) > 0);
        QCOMPARE(size({"--layers", "nowhere"}), -1);
        QCOMPARE(size({"--nets", "nowhere"}), -1);
        QCOMPARE(size({"--window", "3,3,3,9"}), -1);
        QCOMPARE(size({"--min-hole", "3 apples"}), -1);
    }

    /// One rule for all formats, whatever the choice is that leaves nothing.
    void nothingLeftIsWrongUsage_data() {
        QTest::addColumn<QString>("ending");
        QTest::addColumn<QStringList>("choice");
        for (const char* ending : {"step", "stpz", "glb", "stl", "obj"}) {
            QTest::addRow("%s, layer", ending) << QString(ending) << QStringList{"--layers", "DIELECTRIC_1"};
            QTest::addRow("%s, window", ending) << QString(ending) << QStringList{"--window", "900,900,901,901"};
            QTest::addRow("%s, net", ending)
                << QString(ending) << QStringList{"--nets", "GND", "--window", "900,900,901,901"};
        }
        for (const char* ending : {"dxf", "svg", "pdf"}) {
            QTest::addRow("%s, layer", ending) << QString(ending) << QStringList{"--layers", "DIELECTRIC_1"};
        }
    }
    void nothingLeftIsWrongUsage() {
        QFETCH(QString, ending);
        QFETCH(QStringList, choice);
        const QTemporaryDir folder;
        const Outcome run =
            copperscope(QStringList{"export", locations::kSample, "-o", folder.filePath("board." + ending)} + choice);
        QCOMPARE(run.exitCode, 1);
        QVERIFY2(run.err.contains("nothing on the board is left to export"), run.err.constData());
        QVERIFY(QDir(folder.path()).isEmpty());
    }

    /// Not in those of the 3D view, where all outer copper has the colour of its finish.
    void drawingsHaveTheColoursOfTheFlatView() {
        const QTemporaryDir folder;
        const QString path = folder.filePath("board.svg");
        QCOMPARE(copperscope({"export", locations::kSample, "-o", path, "--layers", "L01-TOP_LAYER,L04-BOTTOM_LAYER"})
                     .exitCode,
                 0);
        QFile file(path);
        QVERIFY(file.open(QIODevice::ReadOnly));
        const QByteArray svg = file.readAll();
        const auto colourOf = [&](const QByteArray& layer) {
            const qsizetype title = svg.indexOf("<title>" + layer + "</title>");
            const qsizetype fill = svg.lastIndexOf("fill=\"#", title);
            const int rgb = svg.mid(fill + 7, 6).toInt(nullptr, 16);
            return std::pair(rgb >> 16, rgb & 0xFF);
        };
        const auto [topRed, topBlue] = colourOf("L01-TOP_LAYER");
        const auto [bottomRed, bottomBlue] = colourOf("L04-BOTTOM_LAYER");
        QVERIFY2(topRed > 2 * topBlue, qPrintable(QString::number(topBlue)));
        QVERIFY2(bottomBlue > 2 * bottomRed, qPrintable(QString::number(bottomRed)));
    }

    void refusesInPlainWords() {
        const QTemporaryDir folder;
        const Outcome unknown = copperscope({"export", locations::kSample, "-o", folder.filePath("board.xyz")});
        QCOMPARE(unknown.exitCode, 1);
        QVERIFY(unknown.err.contains(".step"));
        const Outcome nowhere = copperscope({"export", locations::kSample, "-o", folder.filePath("no/board.dxf")});
        QCOMPARE(nowhere.exitCode, 3);
        QVERIFY(nowhere.err.contains("cannot be written"));
        QCOMPARE(copperscope({"export", locations::kSample, "-o", "/dev/full", "--layers", "top"}).exitCode, 1);
        QCOMPARE(copperscope({"export", locations::kSample, "-o", folder.filePath("a.dxf"), "--nets", "GND"}).exitCode,
                 1);
        QVERIFY(QDir(folder.path()).isEmpty());
    }

    void anOptionOfAnotherFormatIsRefused_data() {
        QTest::addColumn<QString>("ending");
        QTest::addColumn<QString>("option");
        QTest::newRow("pages of a drawing") << "svg"
                                            << "--one-page";
        QTest::newRow("mirrored outlines") << "dxf"
                                           << "--mirror-bottom";
        QTest::newRow("milling of a drawing") << "pdf"
                                              << "--as-designed";
        QTest::newRow("joined copper in a drawing") << "svg"
                                                    << "--merge";
        QTest::newRow("polylines of triangles") << "glb"
                                                << "--polylines";
        QTest::newRow("triangles written out") << "stl"
                                               << "--written-out";
        QTest::newRow("exact solids compressed as triangles are") << "step"
                                                                  << "--compress";
        QTest::newRow("instances of exact solids") << "stpz"
                                                   << "--instancing";
    }
    void anOptionOfAnotherFormatIsRefused() {
        QFETCH(QString, ending);
        QFETCH(QString, option);
        const QTemporaryDir folder;
        const Outcome refused =
            copperscope({"export", locations::kSample, "-o", folder.filePath("board." + ending), option});
        QCOMPARE(refused.exitCode, 1);
        QVERIFY2(refused.err.contains("does not know " + option.toUtf8()), refused.err.constData());
        QVERIFY(QDir(folder.path()).isEmpty());
    }

    /// What cannot be written to its end is not left there.
    void aLimitOfFileSizeLeavesNoHalfFile_data() {
        QTest::addColumn<QString>("ending");
        for (const char* ending : {"step", "stpz", "glb", "stl", "obj", "dxf", "svg", "pdf"}) {
            QTest::newRow(ending) << QString(ending);
        }
    }
    void aLimitOfFileSizeLeavesNoHalfFile() {
        QFETCH(QString, ending);
        const QTemporaryDir folder;
        const QString path = folder.filePath("board." + ending);
        const Outcome run = copperscopeInShell("ulimit -f 16; exec %1", {"export", locations::kSample, "-o", path});
        QVERIFY2(run.exitCode == 3, run.err.constData());
        QVERIFY2(run.err.contains(path.toUtf8() + " cannot be written: File too large"), run.err.constData());
        QVERIFY(QDir(folder.path()).isEmpty());
    }

    void signalsLeaveTheFileThatWasThere_data() {
        QTest::addColumn<QStringList>("arguments");
        QTest::addColumn<QString>("ending");
        QTest::addColumn<int>("signal");
        for (const auto& [name, signal] : {std::pair{"INT", SIGINT}, {"TERM", SIGTERM}, {"HUP", SIGHUP}}) {
            QTest::addRow("export, %s", name) << QStringList{"export", locations::kSample} << "step" << signal;
            QTest::addRow("generate, %s", name) << QStringList{"generate", "--like", "t9"} << "tgz" << signal;
        }
    }
    void signalsLeaveTheFileThatWasThere() {
        QFETCH(QStringList, arguments);
        QFETCH(QString, ending);
        QFETCH(int, signal);
        const QTemporaryDir folder;
        QFile kept(folder.filePath("kept." + ending));
        QVERIFY(kept.open(QFile::ReadWrite) && kept.write("kept") == 4 && kept.flush());
        arguments += QStringList{"-o", kept.fileName()};
        QCOMPARE(signalOnceThereIs("*.part*", folder.path(), arguments, signal), signal);
        QCOMPARE(QDir(folder.path()).entryList(QDir::Files), QStringList{"kept." + ending});
        kept.close();
        QVERIFY(kept.open(QFile::ReadOnly));
        QCOMPARE(kept.readAll(), QByteArray("kept"));
    }

    void signalsLeaveNothingOfWhatIsVerified_data() {
        QTest::addColumn<QString>("file");
        QTest::addColumn<QStringList>("more");
        // The reader ends only once it has the whole text of a file: of all layers that takes 20 s.
        const QStringList few{"--layers", "top_paste"};
        QTest::newRow("while it is written") << "*.step.part*" << QStringList{};
        QTest::newRow("while it is read") << "*.step" << few;
        QTest::newRow("while it is read strictly") << "STEP" << few;
    }
    void signalsLeaveNothingOfWhatIsVerified() {
        if (copperscope({"verify", "/nowhere"}).err.contains("OpenCASCADE")) {
            QSKIP("this build has no OpenCASCADE");
        }
        QFETCH(QString, file);
        QFETCH(QStringList, more);
        const QTemporaryDir folder;
        const QStringList words{"verify", locations::kSample, "--strict"};
        QCOMPARE(signalOnceThereIs(file, folder.path(), words + more, SIGINT), SIGINT);
        QVERIFY(QDir(folder.path()).isEmpty());
    }

    void theTimeInAFileCanBeSet_data() {
        QTest::addColumn<QString>("ending");
        QTest::newRow("STEP") << "step";
        QTest::newRow("packed") << "stpz";
        QTest::newRow("PDF") << "pdf";
    }
    void theTimeInAFileCanBeSet() {
        QFETCH(QString, ending);
        const QTemporaryDir folder;
        const auto bytes = [&](const QString& name, const QString& seconds) {
            QProcessEnvironment environment = QProcessEnvironment::systemEnvironment();
            environment.insert("SOURCE_DATE_EPOCH", seconds);
            QFile file(folder.filePath(name + "." + ending));
            const QStringList arguments{"export", locations::kSample, "--layers", "L01-TOP_LAYER",
                                        "-o",     file.fileName()};
            const int code = copperscope(arguments, {}, environment).exitCode;
            return code == 0 && file.open(QFile::ReadOnly) ? file.readAll() : QByteArray::number(code);
        };
        const QByteArray first = bytes("a", "1000000000");
        QVERIFY(first.size() > 1000 && first == bytes("b", "1000000000"));
        QVERIFY(ending != "step" || first.contains("'2001-09-09T01:46:40Z'"));
        QVERIFY(ending == "pdf" || first != bytes("c", "1000000001"));
        QCOMPARE(bytes("d", "yesterday"), ending == "pdf" ? first : QByteArray("1"));
        QVERIFY(bytes("e", "").size() > 1000);
    }

    void solidsAreProvedByAnIndependentReader() {
        const Outcome done = copperscope({"verify", locations::kSample, "--layers", "L01-TOP_LAYER", "--sample", "20",
                                          "--points", "400", "--no-pictures", "--strict", "--json"});
        if (done.err.contains("OpenCASCADE")) {
            QCOMPARE(done.exitCode, 3);
            QSKIP("this build has no OpenCASCADE");
        }
        QVERIFY2(done.exitCode == 0, done.err.constData());
        const QJsonDocument report = QJsonDocument::fromJson(done.out);
        QVERIFY(report["passed"].toBool());
        QVERIFY(report["solids"].toInt() >= 20);
        QCOMPARE(report["solids"], report["expected"]);
        QVERIFY(report["points"]["share"].toDouble() >= 0.9999);
    }

    /// A program that was copied without its modules says so before it reads a board or writes a file.
    void withoutTheReaderNothingIsWritten() {
        const QTemporaryDir folder;
        const QString alone = folder.filePath("copperscope");
        QVERIFY(QFile::copy(locations::kProgram, alone));
        QVERIFY(QDir(folder.path()).mkdir("written"));
        QProcess process;
        QProcessEnvironment environment = QProcessEnvironment::systemEnvironment();
        environment.insert("TMPDIR", folder.filePath("written"));
        process.setProcessEnvironment(environment);
        process.start(alone, {"verify", locations::kSample, "--layers", "top_paste", "--no-pictures"});
        const Outcome done = program::outcomeOf(process);
        QCOMPARE(done.exitCode, 3);
        QVERIFY2(done.err.contains("OpenCASCADE") && !done.err.contains("MB written"), done.err.constData());
        QVERIFY(done.out.isEmpty() && QDir(folder.filePath("written")).isEmpty());
    }

    void withoutAFolderForTemporaryFilesVerifyFails_data() {
        QTest::addColumn<QString>("folder");
        QTest::addColumn<QStringList>("more");
        QTest::newRow("a file") << QString(locations::kSample) << QStringList{};
        QTest::newRow("nowhere") << "/nowhere" << QStringList{};
        QTest::newRow("for settings of the reader")
            << "/nowhere" << QStringList{"--strict", "--step", locations::kTestData + QStringLiteral("/no.step")};
        QTest::newRow("nothing can be made there") << "/proc" << QStringList{};
    }
    void withoutAFolderForTemporaryFilesVerifyFails() {
        QFETCH(QString, folder);
        QFETCH(QStringList, more);
        QProcessEnvironment environment = QProcessEnvironment::systemEnvironment();
        environment.insert("TMPDIR", folder);
        const QStringList words{"verify", locations::kSample, "--layers", "top_paste", "--no-pictures"};
        const Outcome done = copperscope(words + more, {}, environment);
        QCOMPARE(done.exitCode, 3);
        QVERIFY2(done.err.contains("OpenCASCADE") || done.err.contains("(TMPDIR)") ||
                     done.err.contains("no folder can be made in /proc"),
                 done.err.constData());
    }

    void wallsWithBendsAreProvedToo() {
        const Outcome done = copperscope({"verify", locations::kSample, "--layers", "L02-INNER_LAYER", "--sample", "15",
                                          "--points", "200", "--no-pictures", "--polylines", "--json"});
        if (done.err.contains("OpenCASCADE")) {
            QSKIP("this build has no OpenCASCADE");
        }
        QVERIFY2(done.exitCode == 0, done.out.constData());
        QVERIFY(QJsonDocument::fromJson(done.out)["passed"].toBool());
    }

    void wrongSolidsAreFound() {
        const QTemporaryDir folder;
        const QString path = folder.filePath("other.step");
        QCOMPARE(
            copperscope({"export", locations::kSample, "-o", path, "--layers", "top_paste", "--as-designed"}).exitCode,
            0);
        const Outcome done = copperscope({"verify", locations::kSample, "--layers", "bottom_paste", "--step", path,
                                          "--points", "100", "--no-pictures"});
        QVERIFY(done.exitCode == 4 || (done.exitCode == 3 && done.err.contains("OpenCASCADE")));
        QVERIFY2(done.exitCode == 3 || done.out.contains("its volume is "), done.out.constData());
    }
};

QTEST_APPLESS_MAIN(ExportCommandsTest)
#include "export_commands_test.moc"
