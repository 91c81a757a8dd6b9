#include "model/formats/board_forms.h"

#include <QtTest>

#include "tests/unit/model/formats/odb/odb_testing.h"

using namespace odb_testing;
using model::BoardForm;

namespace {

constexpr const char* kIpc =
    "<?xml version=\"1.0\"?>\n<IPC-2581 revision=\"%1\" xmlns=\"http://webstds.ipc.org/2581\">\n"
    "<HistoryRecord number=\"1\"><FileRevision fileRevisionId=\"1\"><SoftwarePackage name=\"Maker\" vendor=\"V\"/>"
    "</FileRevision></HistoryRecord>\n</IPC-2581>\n";

std::string ipc(const char* revision) {
    return QString(kIpc).arg(revision).toStdString();
}

std::string kicadBoard() {
    return readFile(fs::path(locations::kTestData) / "kicad" / "small.kicad_pcb");
}

const std::string kImage =
    "%TF.FileFunction,Copper,L1,Top*%\n%FSLAX46Y46*%\n%MOMM*%\n%ADD10C,1*%\nD10*\nX0Y0D03*\nX5000000Y0D03*\nM02*\n";

/// A board in all forms, as CAD systems leave them: open, packed, and packed once more.
void fill(const fs::path& folder) {
    writeFile(folder / "board.kicad_pcb", kicadBoard());
    writeFile(folder / "board-b.xml", ipc("B"));
    writeFile(folder / "board-c.xml", ipc("C"));
    fs::create_directories(folder / "out");
    fs::create_directories(folder / "board-backups");
    writeArchive(folder / "out" / "odb.tgz", Container::Ustar, Packing::Gzip, membersOf(dataJob("drills"), "job/"));
    writeArchive(folder / "gerber.zip", Container::Zip, Packing::Plain, {{"board-F_Cu.gtl", kImage, 0644, {}}});
    writeArchive(folder / "board-backups" / "board-2026.zip", Container::Zip, Packing::Plain,
                 {{"board.kicad_pcb", kicadBoard(), 0644, {}}});
}

base::Result<model::ReadBoard> open(const fs::path& path, const model::ReadOptions& options = {}) {
    base::Progress progress;
    return model::readAnyBoard(path, options, progress);
}

std::vector<BoardForm> formsOf(const fs::path& path) {
    model::ReadOptions options;
    options.onlyAsks = true;
    const base::Result<model::ReadBoard> asked = open(path, options);
    if (!asked || asked->document) {
        qFatal("%s does not hold several forms", path.c_str());
    }
    return asked->forms;
}

QStringList textsOf(const std::vector<BoardForm>& forms, const fs::path& path) {
    QStringList texts;
    for (const BoardForm& form : forms) {
        texts += QString::fromStdString(std::string(form.format->key) + ": " + model::fileOf(form, path) + ": " +
                                        form.contents);
    }
    return texts;
}

bool saysOthers(const model::ReadBoard& board, const char* text) {
    return findDiagnostic(board.document->diagnostics, text) != nullptr;
}

}  // namespace

class BoardFormsTest : public QObject {
    Q_OBJECT

private slots:
    void theFormsInAFolderAreListedTheDesignFirstThenTheRichest() {
        Folder folder;
        fill(folder.path());
        const QStringList expected{"kicad: board.kicad_pcb: by KiCad 9.0, format 20241229",
                                   "odb: out/odb.tgz: 15 layers, 4 of copper",
                                   "ipc2581: board-c.xml: revision C, by Maker",
                                   "ipc2581: board-b.xml: revision B, by Maker", "gerber: gerber.zip: 1 image"};
        QCOMPARE(textsOf(formsOf(folder.path()), folder.path()), expected);
    }

    void everyFormOfAFolderOpensByItself() {
        Folder folder;
        fill(folder.path());
        for (const BoardForm& form : formsOf(folder.path())) {
            QVERIFY(form.path != folder.path() && fs::is_regular_file(form.path));
            if (form.format->key == "ipc2581") {
                continue;  // these say nothing of a board
            }
            model::ReadOptions options;
            options.format = form.format->key;
            options.member = form.member;
            const base::Result<model::ReadBoard> alone = open(form.path, options);
            QVERIFY2(alone.ok(), alone ? "" : alone.error().text.c_str());
            QCOMPARE(alone->format, form.format);
            QVERIFY(alone->forms.empty());
        }
    }

    void theFirstIsReadAndTheOthersAreNamed() {
        Folder folder;
        fill(folder.path());
        const base::Result<model::ReadBoard> board = open(folder.path());
        QVERIFY2(board.ok(), board ? "" : board.error().text.c_str());
        QCOMPARE(board->format->key, std::string_view("kicad"));
        QVERIFY(saysOthers(*board,
                           "Read as KiCad board, board.kicad_pcb; what else is there: ODB++ job (out/odb.tgz, "
                           "--input-format odb), IPC-2581 (board-c.xml, --input-format ipc2581), IPC-2581 "
                           "(board-b.xml), Gerber job (gerber.zip, --input-format gerber)"));
        model::ReadOptions options;
        options.format = "odb";
        QCOMPARE(open(folder.path(), options)->document->elements.size(), read(dataJob("drills"))->elements.size());
        options.format = "gerber";
        const base::Result<model::ReadBoard> other = open(folder.path(), options);
        QVERIFY2(other.ok(), other ? "" : other.error().text.c_str());
        QCOMPARE(other->format->key, std::string_view("gerber"));
        QCOMPARE(other->forms.front().path, folder.path() / "gerber.zip");
    }

    void archivesInAnArchiveAreFormsOfIt() {
        Folder folder;
        fill(folder.path() / "in");
        const fs::path all = folder.path() / "all.zip";
        writeArchive(all, Container::Zip, Packing::Plain, membersOf(folder.path() / "in", "StickHub/"));
        const std::vector<BoardForm> forms = formsOf(all);
        QCOMPARE(textsOf(forms, all).first(), "kicad: StickHub/board.kicad_pcb: by KiCad 9.0, format 20241229");
        QCOMPARE(textsOf(forms, all).last(), "gerber: StickHub/gerber.zip: 1 image");
        QCOMPARE(forms.size(), std::size_t(5));
        for (const BoardForm& form : forms) {
            QCOMPARE(form.path, all);
            model::ReadOptions options;
            options.format = form.format->key;
            options.member = form.member;
            const base::Result<model::ReadBoard> board = open(all, options);
            QVERIFY(form.format->key == "ipc2581" || (board.ok() && board->format == form.format));
        }
        QCOMPARE(open(all)->format->key, std::string_view("kicad"));
    }

    void ofSeveralFilesOfOneFormatTheNamedOneIsRead() {
        Folder folder;
        const fs::path all = folder.path() / "two.zip";
        std::string second = kicadBoard();
        second.replace(second.find("Small board"), 11, "Other board");
        second.replace(second.find("\"GND\""), 5, "\"VSS\"");
        writeArchive(all, Container::Zip, Packing::Plain,
                     {{"a.kicad_pcb", kicadBoard(), 0644, {}}, {"b.kicad_pcb", second, 0644, {}}});
        QCOMPARE(formsOf(all).size(), std::size_t(2));
        model::ReadOptions options;
        options.member = "b.kicad_pcb";
        const base::Result<model::ReadBoard> board = open(all, options);
        QVERIFY2(board.ok(), board ? "" : board.error().text.c_str());
        const auto& nets = board->document->nets;
        QVERIFY(std::ranges::any_of(nets, [](const model::Net& net) { return net.name == "VSS"; }));
        options.member = "c.kicad_pcb";
        QCOMPARE(open(all, options).error().code, base::ErrorCode::BadInput);
    }

    void aBoardWithNothingOnItIsMarkedAndComesLast() {
        Folder folder;
        writeFile(folder.path() / "a.kicad_pcb", "(kicad_pcb (version 20241229) (net 0 \"\"))\n");
        writeFile(folder.path() / "b.kicad_pcb", kicadBoard());
        const std::vector<BoardForm> forms = formsOf(folder.path());
        QCOMPARE(forms.size(), std::size_t{2});
        QVERIFY(forms[0].path.filename() == "b.kicad_pcb" && !forms[0].isEmpty);
        QVERIFY(forms[1].path.filename() == "a.kicad_pcb" && forms[1].isEmpty);
        QCOMPARE(forms[1].contents, std::string("empty, format 20241229"));
    }

    void oneFormIsNoChoice() {
        Folder folder;
        fs::create_directories(folder.path() / "board-backups");
        writeFile(folder.path() / "board.kicad_pcb", kicadBoard());
        writeFile(folder.path() / "board.d356", "P  CODE 00\nP  UNITS CUST 0\n999\n");
        writeArchive(folder.path() / "board-backups" / "board-2026.zip", Container::Zip, Packing::Plain,
                     {{"board.kicad_pcb", kicadBoard(), 0644, {}}});
        writeFile(folder.path() / "pictures.zip", "PK\x03\x04 and then nothing");
        model::ReadOptions options;
        options.onlyAsks = true;
        const base::Result<model::ReadBoard> board = open(folder.path(), options);
        QVERIFY2(board.ok(), board ? "" : board.error().text.c_str());
        QVERIFY(board->document != nullptr);
        QVERIFY(board->forms.empty());
        QVERIFY(!saysOthers(*board, "what else is there"));
    }

    void whatIsReadInAFolderIsTold() {
        Folder folder;
        fill(folder.path());
        fs::copy(dataJob("drills"), folder.path() / "job", fs::copy_options::recursive);
        folder.write("gerber/top.gbr", kImage);
        folder.write("gerber/board.ipc", "P  CODE 00\nP  UNITS CUST 0\n999\n");
        folder.write("board.kicad_pro", "{}");
        folder.write("report.csv", "spacing,limit\n1,2\n");
        folder.write("report.txt", "Spacings of the board\n");
        folder.write("report.xml", "<?xml version=\"1.0\"?>\n<testsuites/>\n");
        folder.write("job/report.json", "{}");
        folder.write("picture.svg", "<svg/>");
        fs::create_symlink("job/matrix/matrix", folder.path() / "link");
        for (const char* file : {"job/matrix/matrix", "link", "gerber/top.gbr", "gerber/board.ipc", "gerber.zip",
                                 "board-c.xml", "board.kicad_pcb", "board.kicad_pro"}) {
            QVERIFY2(model::isReadFor(folder.path(), folder.path() / file), file);
        }
        for (const char* file :
             {"report.csv", "report.txt", "report.xml", "job/report.json", "picture.svg", "none", "job"}) {
            QVERIFY2(!model::isReadFor(folder.path(), folder.path() / file), file);
        }
        QVERIFY(!model::isReadFor(folder.path() / "gerber", folder.path() / "board.kicad_pcb"));
    }

    void whatIsReadWithAFileIsTold() {
        Folder folder;
        fill(folder.path());
        const fs::path jobFile = folder.write("job/board.gbrjob", "{\"GeneralSpecs\": {}, \"FilesAttributes\": []}");
        for (const char* name : {"job/top.gbr", "job/out/bottom.gbr"}) {
            folder.write(name, kImage);
        }
        for (const char* name : {"board.kicad_pro", "board.kicad_dru", "other.kicad_pro", "job/report.csv"}) {
            folder.write(name, "{}");
        }
        fs::copy(folder.path() / "gerber.zip", folder.path() / "job");
        const auto isRead = [&folder](const char* board, const char* file) {
            return model::isReadFor(folder.path() / board, folder.path() / file);
        };
        QCOMPARE(model::sourceOf(jobFile), folder.path() / "job");
        for (const char* file : {"job/board.gbrjob", "job/top.gbr", "job/out/bottom.gbr"}) {
            QVERIFY2(isRead("job/board.gbrjob", file), file);
        }
        for (const char* file : {"job/report.csv", "job/gerber.zip", "job/none.gbr", "board.kicad_pcb"}) {
            QVERIFY2(!isRead("job/board.gbrjob", file), file);
        }
        for (const char* file : {"board.kicad_pcb", "board.kicad_pro", "board.kicad_dru"}) {
            QVERIFY2(isRead("board.kicad_pcb", file), file);
        }
        for (const char* file : {"other.kicad_pro", "board-b.xml"}) {
            QVERIFY2(!isRead("board.kicad_pcb", file), file);
        }
        QVERIFY(isRead("job/top.gbr", "job/top.gbr") && !isRead("job/top.gbr", "job/out/bottom.gbr"));
    }

    void imagesThatAreNamedTogetherAreAJob() {
        Folder folder;
        const fs::path top = folder.path() / "a.gtl";
        const fs::path bottom = folder.path() / "a.gbl";
        const fs::path note = folder.path() / "note.txt";
        writeFile(top, kImage);
        writeFile(bottom, kImage);
        writeFile(note, "Dear fabricator\n");
        QCOMPARE(model::jobOfFiles(std::vector{top, bottom, note}), folder.path());
        QCOMPARE(model::jobOfFiles(std::vector{top, note}), fs::path());
        QCOMPARE(model::jobOfFiles(std::vector{top, folder.path() / "other" / "a.gbl"}), fs::path());
    }
};

QTEST_APPLESS_MAIN(BoardFormsTest)
#include "board_forms_test.moc"
