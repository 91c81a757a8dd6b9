#include "model/board/board_colours.h"

#include <QtTest>

#include "model/board/document_builder.h"
#include "tests/unit/model/formats/odb/odb_testing.h"

using namespace model;

namespace {

std::shared_ptr<const Document> boardWith(const char* name, LayerType type) {
    DocumentBuilder builder;
    Layer layer;
    layer.name = name;
    layer.type = type;
    builder.addLayer(layer);
    return builder.finish();
}

BoardColours coloursWith(const char* name, LayerType type) {
    return boardColours(*boardWith(name, type));
}

}  // namespace

/// What a job's names say of a board's colours, and what the user chose over that.
class BoardColoursTest : public QObject {
    Q_OBJECT

private slots:
    void aJobThatSaysNothingIsGreenWhiteAndGold() {
        const auto board = boardWith("SMT", LayerType::SolderMask);
        QVERIFY(coloursInJob(*board) == BoardColourChoice{});
        QVERIFY((boardColours(*board) == BoardColours{BoardColour::Green, BoardColour::White, SurfaceFinish::Gold}));
    }

    void namesOfLayersSayTheirColour() {
        QCOMPARE(coloursWith("Top Solder Mask-Blue", LayerType::SolderMask).solderMask, BoardColour::Blue);
        QCOMPARE(coloursWith("SMT_MATTE_BLACK", LayerType::SolderMask).solderMask, BoardColour::Black);
        QCOMPARE(coloursWith("SILK_YELLOW", LayerType::SilkScreen).silkscreen, BoardColour::Yellow);
        QCOMPARE(coloursWith("REDUCED_MASK", LayerType::SolderMask).solderMask, BoardColour::Green);  // no word
        QCOMPARE(coloursWith("RED", LayerType::Signal).solderMask, BoardColour::Green);               // no mask
    }

    void wordsForAFinish() {
        QCOMPARE(coloursWith("top_finish_hasl", LayerType::Mask).finish, SurfaceFinish::Tin);
        QCOMPARE(coloursWith("Immersion Silver", LayerType::ConductivePaste).finish, SurfaceFinish::Tin);
        QCOMPARE(coloursWith("OSP", LayerType::Mask).finish, SurfaceFinish::Copper);
        QCOMPARE(coloursWith("TIN", LayerType::Mask).finish, SurfaceFinish::Gold);  // what for is not said
    }

    void materialsCountToo() {
        Document board = *boardWith("SMT", LayerType::SolderMask);
        board.stackup.facts.layers.resize(1);
        board.stackup.facts.layers[0].material.name = "LPI red";
        QCOMPARE(boardColours(board).solderMask, BoardColour::Red);
    }

    void theUsersChoiceCountsFirst() {
        const auto board = boardWith("MASK blue", LayerType::SolderMask);
        const BoardColourChoice chosen{BoardColour::Purple, std::nullopt, SurfaceFinish::Copper};
        const BoardColours colours = boardColours(*board, chosen);
        QVERIFY((colours == BoardColours{BoardColour::Purple, BoardColour::White, SurfaceFinish::Copper}));
    }

    void printOnAWhiteMaskIsBlack() {
        const auto board = boardWith("SMT", LayerType::SolderMask);
        QCOMPARE(boardColours(*board, {.solderMask = BoardColour::White}).silkscreen, BoardColour::Black);
    }

    void everyNameIsRead() {
        for (std::size_t i = 0; i < boardColourNames().size(); ++i) {
            QCOMPARE(boardColourNamed(boardColourNames()[i]), std::optional(static_cast<BoardColour>(i)));
        }
        for (std::size_t i = 0; i < surfaceFinishNames().size(); ++i) {
            QCOMPARE(surfaceFinishNamed(surfaceFinishNames()[i]), std::optional(static_cast<SurfaceFinish>(i)));
        }
        QVERIFY(!boardColourNamed("pink") && !surfaceFinishNamed(""));
    }

    void onlyFlexiblePartsAreFilm() {
        const auto board = odb_testing::read(odb_testing::dataJob("rigid_flex"));
        std::vector<bool> bodies;
        for (const Layer& layer : board->layers) {
            if (layer.type == LayerType::Body) {
                bodies.push_back(isFlexibleFilm(*board, layer));
            }
            if (layer.name == "COVER solder mask") {
                QVERIFY(isFlexibleFilm(*board, layer));
            } else if (layer.name == "SMT solder mask" || layer.isCopper()) {
                QVERIFY(!isFlexibleFilm(*board, layer));
            }
        }
        QCOMPARE(bodies, (std::vector<bool>{false, true, false}));
    }
};

QTEST_APPLESS_MAIN(BoardColoursTest)
#include "board_colours_test.moc"
