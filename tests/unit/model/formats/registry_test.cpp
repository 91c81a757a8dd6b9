#include "model/formats/registry.h"

#include <sys/stat.h>

#include <QtTest>
#include <algorithm>
#include <cctype>
#include <filesystem>
#include <fstream>

#include "tests/locations.h"

namespace {

std::string write(const QTemporaryDir& folder, const char* name, const QByteArray& content) {
    QFile file(folder.filePath(name));
    if (!file.open(QIODevice::WriteOnly) || file.write(content) != content.size()) {
        qFatal("cannot write %s", name);
    }
    return folder.filePath(name).toStdString();
}

}  // namespace

class ReaderTest : public QObject {
    Q_OBJECT

private slots:
    void aStepThatIsNotThereIsAnErrorWhateverTheFormat() {
        base::Progress progress;
        const std::filesystem::path data = locations::kTestData;
        for (const std::filesystem::path& board : {data / "odb" / "panel", data / "kicad" / "small.kicad_pcb"}) {
            model::ReadOptions options;
            options.step = "nope";
            const auto result = model::readBoard(board, options, progress);
            QVERIFY2(!result && result.error().code == base::ErrorCode::BadUsage, board.c_str());
            QVERIFY2(QByteArray(result.error().text.c_str()).contains("\"nope\"; it has: "),
                     result.error().text.c_str());
        }
        model::ReadOptions options;
        options.step = "PCB";
        QVERIFY(model::readBoard(data / "kicad" / "small.kicad_pcb", options, progress).ok());
    }

    void missingPathIsNamed() {
        base::Progress progress;
        const auto result = model::readBoard("/nowhere/board.tgz", {}, progress);
        QVERIFY(!result);
        QCOMPARE(result.error().code, base::ErrorCode::BadInput);
        QVERIFY(result.error().text.find("/nowhere/board.tgz") != std::string::npos);
    }

    void bothFormatsOpenThroughOneDoor() {
        base::Progress progress;
        const auto job = model::readBoard(locations::kSample, {}, progress);
        QVERIFY2(job.ok(), job ? "" : job.error().text.c_str());
        QVERIFY((*job)->elements.size() > 1000);

        QTemporaryFile file;
        QVERIFY(file.open());
        file.write("LAYERBEGIN\nLAYERTYPE,Top\nBASEPLANEHEIGHT,0\nTHICKNESS,1\nLAYEREND\n");
        file.flush();
        QVERIFY(model::readBoard(file.fileName().toStdString(), {}, progress).ok());
    }

    void theNameOfAFileDoesNotMatter() {
        QTemporaryDir folder;
        base::Progress progress;
        for (const char* name : {"board.pdf", "board.txt", "board"}) {
            const std::string path = folder.filePath(name).toStdString();
            std::filesystem::copy_file(locations::kSample, path);
            const auto result = model::readBoard(path, {}, progress);
            QVERIFY2(result.ok(), result ? "" : result.error().text.c_str());
        }
        const std::string path =
            write(folder, "model.tgz", "LAYERBEGIN\nLAYERTYPE,Top\nBASEPLANEHEIGHT,0\nTHICKNESS,1\nLAYEREND\n");
        QVERIFY(model::readBoard(path, {}, progress).ok());
    }

    void whatIsNoBoardIsNamed_data() {
        QTest::addColumn<QByteArray>("content");
        QTest::addColumn<QString>("kind");
        QTest::addRow("empty") << QByteArray() << "this is an empty file; what";
        QTest::addRow("picture") << QByteArray("\x89PNG\r\n\x1a\n\0\0", 10)
                                 << "a PNG picture, which begins with 89 50 4E 47 0D 0A 1A 0A;";
        QTest::addRow("KiCad") << QByteArray("(kicad_sch (version 20211014)") << "which begins with \"(kicad_sch";
        QTest::addRow("KiCad project") << QByteArray("{\n  \"board\": {\n    \"design_settings\": {}}}")
                                       << "its board is the .kicad_pcb beside it";
        QTest::addRow("JSON") << QByteArray("{\"board\": 1}") << "a JSON file";
        QTest::addRow("old KiCad") << QByteArray("PCBNEW-BOARD Version 1\n") << "a board from before KiCad 4";
        QTest::addRow("Gerber") << QByteArray("%FSLAX46Y46*%\n%MOMM*%\n")
                                << "a Gerber file, which begins with \"%FSLAX46Y46*%\"";
        QTest::addRow("Gerber with a comment") << QByteArray("G04 top*\n%FSLAX46Y46*%\n") << "a Gerber file";
        QTest::addRow("drills") << QByteArray("M48\nMETRIC\n") << "an Excellon drill file";
        QTest::addRow("XML") << QByteArray("\xef\xbb\xbf <?xml version=\"1.0\"?><a/>") << "an XML file";
        QTest::addRow("ZIP") << QByteArray("PK\x05\x06") + QByteArray(18, '\0')
                             << "a ZIP archive without an ODB++ matrix";
        QTest::addRow("text") << QByteArray("Dear diary\n") << "a text file, which begins with \"Dear diary\"";
        QTest::addRow("bytes") << QByteArray("\x01\x02\xab", 3) << "a file of unknown kind, which begins with 01 02 AB";
    }
    void whatIsNoBoardIsNamed() {
        QFETCH(QByteArray, content);
        QFETCH(QString, kind);
        QTemporaryDir folder;
        base::Progress progress;
        const auto result = model::readBoard(write(folder, "board.tgz", content), {}, progress);
        QVERIFY(!result);
        QCOMPARE(result.error().code, base::ErrorCode::BadInput);
        QVERIFY2(result.error().text.find(kind.toStdString()) != std::string::npos, result.error().text.c_str());
        QVERIFY(result.error().text.find(model::describeFormats()) != std::string::npos);
        QVERIFY(result.error().text.find("board.tgz") != std::string::npos);
    }

    void aFolderWithoutABoardIsNamed() {
        QTemporaryDir folder;
        base::Progress progress;
        const auto empty = model::readBoard(folder.path().toStdString(), {}, progress);
        QVERIFY(empty.error().text.ends_with(": the folder is empty"));
        write(folder, "diary.txt", "Dear diary\n");
        const auto result = model::readBoard(folder.path().toStdString(), {}, progress);
        QVERIFY(!result);
        QVERIFY(result.error().text.find("a folder without an ODB++ matrix") != std::string::npos);
    }

    void whatOfAFolderCannotBeReadMayHaveBeenTheBoard() {
        QTemporaryDir folder;
        const std::filesystem::path path = folder.path().toStdString();
        write(folder, "diary.txt", "Dear diary\n");
        std::filesystem::create_symlink("missing", path / "board.gtl");
        base::Progress progress;
        const auto none = model::readBoard(path, {}, progress);
        QVERIFY2(none.error().text.find(", of which not all could be read (board.gtl: The link leads to nothing); "
                                        "what can be read: ") != std::string::npos,
                 none.error().text.c_str());
    }

    /// The folder of a project holds much that is not the board.
    void aDesignLacksNothingWhereOtherFilesCannotBeRead() {
        QTemporaryDir folder;
        const std::filesystem::path path = folder.path().toStdString();
        std::filesystem::copy(std::filesystem::path(locations::kTestData) / "kicad" / "small.kicad_pcb", path);
        std::filesystem::create_symlink("missing", path / "library");
        base::Progress progress;
        const auto board = model::readBoard(path, {}, progress);
        QVERIFY2(board.ok(), board ? "" : board.error().text.c_str());
        const auto& entries = (*board)->diagnostics.entries();
        const auto link = std::ranges::find(entries, "library", &model::Diagnostic::file);
        QVERIFY(link != entries.end());
        QCOMPARE(link->severity, model::Severity::Warning);
    }

    void everyExtensionIsInTheFilterAndInTheHelp() {
        for (const model::BoardFormat& format : model::knownFormats()) {
            const std::string help = model::describeFormats();
            QVERIFY(help.find(format.name) != std::string::npos);
            for (const std::string_view extension : format.extensions) {
                const std::string pattern = " *" + std::string(extension) + " ";
                QVERIFY2((" " + model::namePatterns() + " ").find(pattern) != std::string::npos, pattern.c_str());
                QVERIFY(help.find(extension) != std::string::npos);
                QVERIFY(model::isNamedLikeBoard(
                    "/nowhere/BOARD" + QString::fromStdString(std::string(extension)).toUpper().toStdString()));
            }
        }
        QVERIFY(!model::isNamedLikeBoard("/nowhere/board.pdf"));
        QVERIFY(model::isNamedLikeBoard("/"));
    }

    void everyFormatHasAKeyOfItsOwn() {
        std::vector<std::string> keys = model::formatKeys();
        QCOMPARE(keys.size(), model::knownFormats().size());
        std::ranges::sort(keys);
        QVERIFY(std::ranges::adjacent_find(keys) == keys.end());
        for (const std::string& key : keys) {
            const bool isWord = std::ranges::all_of(key, [](char c) { return std::isalnum(static_cast<uchar>(c)); });
            QVERIFY2(!key.empty() && isWord, key.c_str());
        }
    }

    void ofSeveralFormsTheRichestIsRead() {
        QTemporaryDir folder;
        const std::filesystem::path both = folder.filePath("both").toStdString();
        std::filesystem::copy(std::filesystem::path(locations::kTestData) / "odb" / "drills", both,
                              std::filesystem::copy_options::recursive);
        std::ofstream(both / "board.xml") << "<?xml version=\"1.0\"?>\n<IPC-2581 revision=\"C\">\n</IPC-2581>\n";
        base::Progress progress;
        const auto chosen = model::readAnyBoard(both, {}, progress);
        QVERIFY2(chosen.ok(), chosen ? "" : chosen.error().text.c_str());
        QCOMPARE(chosen->format->key, std::string_view("odb"));
        const auto isChoice = [](const model::Diagnostic& entry) {
            return entry.severity == model::Severity::Info &&
                   entry.text == "Read as ODB++ job; what else is there: IPC-2581 (board.xml, --input-format ipc2581)";
        };
        QVERIFY(std::ranges::any_of(chosen->document->diagnostics.entries(), isChoice));
        model::ReadOptions options;
        options.format = "ipc2581";
        const auto other = model::readAnyBoard(both, options, progress);
        QVERIFY(!other || other->format->key == "ipc2581");  // and not what is easier to read
        options.format = "odb";
        QVERIFY(model::readAnyBoard(both, options, progress).ok());
    }

    void anEmptyBoardIsNotReadBeforeAJobThatDraws() {
        const QByteArray head =
            "(kicad_pcb (version 20241229) (generator \"pcbnew\") (setup (via_size 0.8)) "
            "(layers (0 \"F.Cu\" signal) (2 \"B.Cu\" signal))";
        QTemporaryDir folder;
        write(folder, "board-F_Cu.gbr",
              "%TF.FileFunction,Copper,L1,Top*%\n%FSLAX46Y46*%\n%MOMM*%\n%ADD10C,1*%\nD10*\nX0Y0D03*\nM02*\n");
        base::Progress progress;
        for (const char* items : {"", "(via (at 1 1) (size 1) (drill 0.4) (layers \"F.Cu\" \"B.Cu\"))",
                                  "(gr_line (start 0 0) (end 1 0) (layer \"Edge.Cuts\") (width 0.1))"}) {
            write(folder, "board.kicad_pcb", head + items + ")\n");
            const auto board = model::readAnyBoard(folder.path().toStdString(), {}, progress);
            QVERIFY2(board.ok(), board ? "" : board.error().text.c_str());
            QCOMPARE(board->format->key, std::string_view(*items == '\0' ? "gerber" : "kicad"));
            QCOMPARE(board->forms.size(), std::size_t{2});
        }
    }

    void aFormatThatIsNotThereIsSaid() {
        base::Progress progress;
        model::ReadOptions options;
        options.format = "ipc2581";
        const auto missing = model::readBoard(locations::kSample, options, progress);
        QVERIFY(!missing);
        QCOMPARE(missing.error().code, base::ErrorCode::BadInput);
        QVERIFY(missing.error().text.find("no board of format ipc2581, but ODB++ job (odb)") != std::string::npos);
        options.format = "pdf";
        QCOMPARE(model::readBoard(locations::kSample, options, progress).error().code, base::ErrorCode::BadUsage);
    }

    void aBoardFromAPipeIsRefusedWithTheReason() {
        const QTemporaryDir folder;
        const std::string pipe = folder.filePath("board.tgz").toStdString();
        QCOMPARE(mkfifo(pipe.c_str(), 0600), 0);
        base::Progress progress;
        const auto result = model::readBoard(pipe, {}, progress);
        QVERIFY(!result);
        QCOMPARE(result.error().text, pipe + ": a board must be a file or folder, and this is a pipe or device");
    }

    void aCancelledReadSaysSo() {
        base::Progress progress;
        progress.cancel();
        const auto result = model::readBoard(locations::kSample, {}, progress);
        QVERIFY(!result);
        QCOMPARE(result.error().code, base::ErrorCode::Cancelled);
    }
};

QTEST_APPLESS_MAIN(ReaderTest)
#include "registry_test.moc"
