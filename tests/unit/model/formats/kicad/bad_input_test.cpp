// Boards of KiCad that are wrong in one place: a message with file and line, and the rest of the board is shown.

#include <QTemporaryDir>
#include <QtTest>
#include <algorithm>

#include "model/formats/registry.h"
#include "tests/unit/model/formats/kicad/kicad_testing.h"

using namespace kicad_testing;

namespace {

const std::string kLayers = "(layers (0 \"F.Cu\" signal) (2 \"B.Cu\" signal) (25 \"Edge.Cuts\" user))";
constexpr const char* kTrack = "(segment (start 1 1) (end 9 1) (width 0.2) (layer \"F.Cu\") (net 1))";

/// What is wrong stands on line 2.
std::string boardOf(const std::string& item, const std::string& head = "(version 20241229)",
                    const std::string& layers = kLayers) {
    return "(kicad_pcb " + head + layers + "(net 0 \"\") (net 1 \"A\")" + kTrack + "\n" + item + "\n" + kTrack + ")";
}

base::Result<std::shared_ptr<const Document>> open(const QTemporaryDir& folder, const std::string& text) {
    const std::filesystem::path path = folder.filePath("bad.kicad_pcb").toStdString();
    if (!writeWholeFile(path, text).ok()) {
        qFatal("the file cannot be written");
    }
    base::Progress progress;
    return readBoard(path, {}, progress);
}

/// The message with these words, or that begins with them but for the capital; null if there is none.
const Diagnostic* find(const Document& board, std::string_view words) {
    words.remove_prefix(1);
    const auto& entries = board.diagnostics.entries();
    const auto found = std::ranges::find_if(
        entries, [&](const Diagnostic& entry) { return entry.text.find(words) != std::string::npos; });
    return found == entries.end() ? nullptr : &*found;
}

std::uint32_t tracksOnTop(const Document& board) {
    const LayerId top = board.findLayer("F.Cu");
    return top.isValid() ? board.layer(top).elements.count : 0;
}

}  // namespace

class BadInputTest : public QObject {
    Q_OBJECT

private slots:
    void aMessageNamesThePlaceAndTheRestIsShown_data() {
        QTest::addColumn<QByteArray>("text");
        QTest::addColumn<QByteArray>("message");
        QTest::addColumn<std::uint32_t>("line");
        const auto row = [](const char* name, const std::string& text, const char* message, std::uint32_t line = 2) {
            QTest::newRow(name) << QByteArray::fromStdString(text) << QByteArray(message) << line;
        };
        const auto item = [&](const char* name, const std::string& text, const char* message) {
            row(name, boardOf(text), message);
        };
        item("net", "(segment (start 2 2) (end 3 2) (width 0.2) (layer \"F.Cu\") (net 77))", "not in the list of nets");
        item("layer", "(segment (start 2 2) (end 3 2) (width 0.2) (layer \"In7.Cu\") (net 1))", "on no layer");
        item("track without width", "(segment (start 2 2) (end 3 2) (layer \"F.Cu\") (net 1))", "lacks ends or width");
        item("words for numbers", "(segment (start a b) (end c d) (width 0.2) (layer \"F.Cu\") (net 1))",
             "lacks ends or width");
        item("far away", "(segment (start 2 2) (end 1e6 2) (width 0.2) (layer \"F.Cu\") (net 1))", "coordinate range");
        item("farther than any number", "(via (at 1e400 0) (size 1) (drill 0.5) (layers \"F.Cu\" \"B.Cu\") (net 1))",
             "a via has no place");
        item("huge pad",
             "(footprint \"x\" (layer \"F.Cu\") (at 0 0) (pad \"1\" smd rect (at 0 0) (size 1e5 1) (layers \"F.Cu\")))",
             "larger than the coordinate range");
        item("pad without place",
             "(footprint \"x\" (layer \"F.Cu\") (at 0 0) (pad \"1\" smd rect (size 1 1) (layers "
             "\"F.Cu\")))",
             "a pad has no place");
        item("via without drill", "(via (at 2 2) (size 1) (layers \"F.Cu\" \"B.Cu\") (net 1))", "names no drill");
        item("unfilled zone", "(zone (net 1) (layer \"B.Cu\") (polygon (pts (xy 0 0) (xy 1 0) (xy 1 1))))",
             "a zone is not filled");
        item("unknown kind", "(wormhole (at 0 0))", "items of the kind 'wormhole'");
        item("unknown kind in a footprint",
             "(footprint \"x\" (layer \"F.Cu\") (at 0 0) (fp_ellipse (center 0 0) (layer \"F.Cu\")))",
             "items of the kind 'fp_ellipse'");
        item("text without place",
             "(footprint \"x\" (layer \"F.Cu\") (at 0 0) (fp_text user \"a\" (layer \"F.Cu\") (effects (font (size 1 "
             "1)))))",
             "a text has no place");
        item("unknown shape",
             "(footprint \"x\" (layer \"F.Cu\") (at 0 0) (pad \"1\" smd blob (at 0 0) (size 1 1) (layers \"F.Cu\")))",
             "a pad has a shape that is not known");
        item("unknown kind in a pad",
             "(footprint \"x\" (layer \"F.Cu\") (at 0 0) (pad \"1\" smd custom (at 0 0) (size 1 1) (layers \"F.Cu\") "
             "(primitives (gr_ellipse (center 0 0)))))",
             "items of the kind 'gr_ellipse'");
        item("pad without drill",
             "(footprint \"x\" (layer \"F.Cu\") (at 0 0) (pad \"1\" thru_hole circle (at 0 0) (size 1 1) (layers "
             "\"F.Cu\")))",
             "a pad with a hole names no drill");
        item("hatched shape",
             "(gr_rect (start 0 0) (end 5 5) (stroke (width 0.2) (type solid)) (fill hatch) (layer \"F.Cu\"))",
             "of hatched shapes only the outline");
        item("a word", "stray", "a word between the items");
        item("a text that does not end", "(gr_text \"x (at 0 0))", "does not end on its line");
        row("newer version", boardOf("", "\n(version 20990101)"), "newer version of KiCad");
        row("next version", boardOf("", "\n(version 20260508)"), "newer version of KiCad");
    }
    void aMessageNamesThePlaceAndTheRestIsShown() {
        QFETCH(QByteArray, text);
        QFETCH(QByteArray, message);
        QFETCH(std::uint32_t, line);
        const QTemporaryDir folder;
        const auto board = open(folder, text.toStdString());
        QVERIFY2(board.ok(), board ? "" : board.error().text.c_str());
        const Diagnostic* const entry = find(**board, message.toStdString());
        QVERIFY2(entry != nullptr, message.constData());
        QCOMPARE(entry->file, std::string("bad.kicad_pcb"));
        QCOMPARE(entry->line, line);
        QVERIFY(tracksOnTop(**board) >= 1U);
    }

    void whatDrawsNothingInAFootprintIsNoNews() {
        const DrawnJob job = boardWith(
            "(footprint \"x\" (locked yes) (layer \"F.Cu\") (at 0 0) (descr \"\") (tags \"\") (uuid 1) (attr smd) "
            "(path \"\") (solder_paste_ratio 0) (duplicate_pad_numbers_are_jumpers no) (embedded_fonts no) (units) "
            "(net_tie_pad_groups \"1\") (property ki_fp_filters \"C_*\") (model \"x\"))",
            "", "20260206");
        QVERIFY(job.diagnostics.entries().empty());
    }

    void layersThatAreMissingAreAnError() {
        const QTemporaryDir folder;
        const auto board = open(folder, boardOf("", "(version 20241229)", ""));
        QVERIFY(!board);
        QCOMPARE(board.error().code, base::ErrorCode::BadInput);
        QVERIFY2(board.error().text.find("bad.kicad_pcb") != std::string::npos, board.error().text.c_str());
    }

    void listsInListsComeToAnEnd_data() {
        QTest::addColumn<QByteArray>("item");
        QTest::newRow("not closed") << QByteArray(1'000'000, '(');
        QTest::newRow("closed") << QByteArray(500'000, '(') + QByteArray(500'000, ')');
        QTest::newRow("closed too often") << QByteArray(1'000'000, ')');
        QTest::newRow("of one kind") << QByteArray("(group ").repeated(100'000) + QByteArray(100'000, ')');
        QTest::newRow("footprints in each other")
            << QByteArray("(footprint \"x\" (layer \"F.Cu\") (at 1 1) ").repeated(50'000) + QByteArray(50'000, ')');
    }
    void listsInListsComeToAnEnd() {
        QFETCH(QByteArray, item);
        const QTemporaryDir folder;
        const auto board = open(folder, boardOf(item.toStdString()));
        QVERIFY2(board.ok(), board ? "" : board.error().text.c_str());
        QVERIFY(tracksOnTop(**board) >= 1U);
        QVERIFY(!(*board)->diagnostics.entries().empty());
    }
};

QTEST_APPLESS_MAIN(BadInputTest)
#include "bad_input_test.moc"
