#include <QtTest>
#include <filesystem>
#include <fstream>

#include "model/formats/registry.h"
#include "tests/unit/model/formats/kicad/kicad_testing.h"

using namespace kicad_testing;

namespace {

namespace fs = std::filesystem;

void write(const fs::path& path, const std::string& text) {
    std::ofstream(path, std::ios::binary) << text;
}

std::shared_ptr<const Document> read(const fs::path& path) {
    base::Progress progress;
    const auto board = readBoard(path, {}, progress);
    return board ? *board : nullptr;
}

}  // namespace

class KicadReaderTest : public QObject {
    Q_OBJECT

private slots:
    void aFileIsReadWithTheProjectBesideIt() {
        QTemporaryDir folder;
        const fs::path path = folder.path().toStdString();
        write(path / "small.kicad_pcb", fileText("small.kicad_pcb"));
        write(path / "small.kicad_pro",
              R"({"net_settings": {"netclass_patterns": [{"netclass": "Power", "pattern": "GND"}]}})");
        const auto board = read(path / "small.kicad_pcb");
        QVERIFY(board);
        QCOMPARE(board->job.name, std::string("small"));
        QCOMPARE(board->job.version, std::string("KiCad 9 (20241229)"));
        const Net& gnd = board->nets[board->findNet("GND").row()];
        QCOMPARE(board->text(board->propertiesOf(gnd.properties)[0].value), std::string("Power"));
        QCOMPARE(board->boardThickness, 1'580'000);
        QCOMPARE(board->board.width(), std::int64_t{30 * kMm});
        QCOMPARE(board->components.size(), std::size_t{2});
        QCOMPARE(messages(board->diagnostics, "pin that is not there"), 0U);
    }

    void ofSeveralBoardsTheOneWithAProjectIsRead() {
        QTemporaryDir folder;
        const fs::path path = folder.path().toStdString();
        write(path / "a.kicad_pcb", fileText("old.kicad_pcb"));
        write(path / "b.kicad_pcb", fileText("small.kicad_pcb"));
        write(path / "b.kicad_pro", "{}");
        write(path / "_autosave-b.kicad_pcb", "nothing");
        const auto board = read(path);
        QVERIFY(board);
        QCOMPARE(board->job.name, std::string("b"));
        QCOMPARE(messages(board->diagnostics, "what else is there: KiCad board (a.kicad_pcb)"), 1U);
    }

    void everyPrefixIsReadWithoutHarm() {
        for (const char* name : {"small.kicad_pcb", "old.kicad_pcb", "annotations.kicad_pcb"}) {
            const std::string text = fileText(name);
            for (std::size_t length = 0; length < text.size(); length += 7) {
                base::Progress progress;
                const std::string prefix = text.substr(0, length);
                static_cast<void>(kicad::drawBoard(prefix, name, {}, progress));
            }
        }
    }
};

QTEST_APPLESS_MAIN(KicadReaderTest)
#include "reader_test.moc"
