// Boards of KiCad whose (setup …) holds no stackup: they are what KiCad makes of them, in its exports too.
#include <QtTest>
#include <algorithm>
#include <string_view>

#include "model/formats/drawing/assembly.h"
#include "tests/unit/model/formats/kicad/kicad_testing.h"

using namespace kicad_testing;

namespace {

constexpr const char* kMessage = "he board has no stackup";
constexpr const char* kTwoLayers = "(0 \"F.Cu\" signal) (2 \"B.Cu\" signal)";
constexpr const char* kFourLayers =
    "(0 \"F.Cu\" signal) (4 \"In1.Cu\" signal) (6 \"In2.Cu\" signal) (2 \"B.Cu\" signal)";
constexpr const char* kMasks = "(1 \"F.Mask\" user) (3 \"B.Mask\" user)";

DrawnJob boardOf(std::string_view layers, std::string_view masks, std::string_view setup = {}) {
    std::string text = "(kicad_pcb (version 20241229)\n(general\n(thickness 1.6))\n(layers ";
    for (const std::string_view part : {layers, masks, std::string_view(")\n(setup "), setup, std::string_view("))")}) {
        text += part;
    }
    return drawn(text);
}

std::shared_ptr<const Document> documentOf(DrawnJob job) {
    base::Progress progress;
    const auto document = formats::assemble(std::move(job), 0.0, progress);
    return document ? *document : nullptr;
}

std::vector<Nm> thicknessesOf(const Document& board, LayerType type) {
    std::vector<Nm> thicknesses;
    for (const StackupRow& row : board.stackup.rows) {
        if (row.type == type) {
            thicknesses.push_back(row.thickness);
        }
    }
    return thicknesses;
}

Source sourceOf(const Document& board, LayerType type) {
    const auto row = std::ranges::find(board.stackup.rows, type, &StackupRow::type);
    return row == board.stackup.rows.end() ? Source::Session : row->source;
}

}  // namespace

class DefaultStackupTest : public QObject {
    Q_OBJECT

private slots:
    /// KiCad's own IPC-2581 and .gbrjob of such boards say 0.01, 0.035, 1.51, 0.035 and 0.01 mm.
    void layersAreAsThickAsInKicadsExports() {
        const auto board = documentOf(boardOf(kTwoLayers, kMasks));
        QVERIFY(board);
        QCOMPARE(thicknessesOf(*board, LayerType::Signal), (std::vector<Nm>{35'000, 35'000}));
        QCOMPARE(thicknessesOf(*board, LayerType::SolderMask), (std::vector<Nm>{10'000, 10'000}));
        QCOMPARE(thicknessesOf(*board, LayerType::Dielectric), std::vector<Nm>{1'510'000});
        QCOMPARE(board->boardThickness, 1'580'000);
        QCOMPARE(sourceOf(*board, LayerType::Signal), Source::Assumed);
        QCOMPARE(sourceOf(*board, LayerType::SolderMask), Source::Assumed);
        QCOMPARE(sourceOf(*board, LayerType::Dielectric), Source::Derived);
    }

    void dielectricsShareTheRestEvenly() {
        const auto board = documentOf(boardOf(kFourLayers, kMasks));
        QVERIFY(board);
        QCOMPARE(thicknessesOf(*board, LayerType::Dielectric), (std::vector<Nm>{480'000, 480'000, 480'000}));
        QCOMPARE(board->boardThickness, 1'580'000);
    }

    void onlyMasksThatTheBoardHasAreTakenOff() {
        QCOMPARE(boardOf(kTwoLayers, "(1 \"F.Mask\" user)").boardNm, std::optional(1.59e6));
        QCOMPARE(boardOf(kTwoLayers, "").boardNm, std::optional(1.6e6));
    }

    /// The thickness of a document is that of the substrate there.
    void theCopperOfASingleLayerIsTakenOffToo() {
        const auto board = documentOf(boardOf("(0 \"F.Cu\" signal)", kMasks));
        QVERIFY(board);
        QCOMPARE(thicknessesOf(*board, LayerType::Dielectric), std::vector<Nm>{1'545'000});
    }

    void aMessageSaysIt() {
        const DrawnJob job = boardOf(kTwoLayers, kMasks);
        QCOMPARE(messages(job.diagnostics, kMessage), 1U);
        const auto& entries = job.diagnostics.entries();
        const auto found = std::ranges::find_if(entries, [](const Diagnostic& entry) {
            return entry.text.find("as KiCad does, copper is taken as 35 µm and each solder mask as 10 µm") !=
                   std::string::npos;
        });
        QVERIFY(found != entries.end());
        QCOMPARE(found->severity, Severity::Info);
        QCOMPARE(found->file, std::string("board.kicad_pcb"));
        QCOMPARE(found->line, 3U);
    }

    void boardsWithAStackupAreAsTheySay() {
        const DrawnJob job = boardOf(kTwoLayers, kMasks,
                                     "(stackup (layer \"F.Mask\" (type \"Top Solder Mask\")) (layer \"F.Cu\" (type "
                                     "\"copper\") (thickness 0.07)) (layer \"dielectric 1\" (type \"core\") "
                                     "(thickness 1.4)) (layer \"B.Cu\" (type \"copper\") (thickness 0.07)))");
        QCOMPARE(messages(job.diagnostics, kMessage), 0U);
        QVERIFY(!job.layers[rowOf(job, "F.Mask")].facts.thicknessNm);
        QCOMPARE(job.boardNm, std::optional(1.6e6 - 2.0 * kDefaultMask));
        const auto board = documentOf(job);
        QVERIFY(board);
        QCOMPARE(thicknessesOf(*board, LayerType::Signal), (std::vector<Nm>{70'000, 70'000}));
        QCOMPARE(board->boardThickness, 1'540'000);
    }
};

QTEST_APPLESS_MAIN(DefaultStackupTest)
#include "default_stackup_test.moc"
