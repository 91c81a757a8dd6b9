// Jobs of several steps: panels, their copies, and what is refused.
#include "model/board/copies.h"
#include "tests/unit/model/formats/odb/odb_testing.h"

using namespace odb_testing;
using model::Document;
using model::ElementId;
using model::LayerId;
using model::Point;

namespace {

/// TOP and BOTTOM: one card is flipped.
void makeCopperNegative(const Folder& folder) {
    std::string matrix = readFile(folder.path() / "matrix/matrix");
    for (std::size_t at = matrix.find("POSITIVE"); at < matrix.find("DRILL"); at = matrix.find("POSITIVE", at)) {
        matrix.replace(at, 8, "NEGATIVE");
    }
    folder.write("matrix/matrix", matrix);
}

}  // namespace

class PanelReaderTest : public QObject {
    Q_OBJECT

private slots:
    void thePanelsCopiesLieWhereTheBlocksSay() {
        const auto d = read(dataJob("panel"));
        QCOMPARE(d->job.step, std::string("PANEL"));
        QCOMPARE(d->elements.size(), std::size_t{2});  // its own disc and laminate; copies stay where they are
        // The card's pad is at (3, 2), its datum at (1, 0): the pad is (2, 2) from the datum. Copies: as is at (10, 10)
        // and (30, 10), turned clockwise by 90° at (10, 40), turned and then mirrored at (50, 40), flipped at (70, 10).
        const std::vector<Point> expected = {{12'000'000, 12'000'000},
                                             {32'000'000, 12'000'000},
                                             {12'000'000, 38'000'000},
                                             {48'000'000, 38'000'000},
                                             {68'000'000, 12'000'000}};
        std::vector<Point> locations;
        for (const model::StepInstance& instance : d->instances) {
            QCOMPARE(d->steps[instance.step]->job.step, std::string("CARD"));
            locations.push_back(instance.placement.apply(Point{3'000'000, 2'000'000}));
        }
        QCOMPARE(locations, expected);
    }

    void aStepIsBuiltOnceHoweverOftenItIsPlaced() {
        const auto d = read(dataJob("panel"));
        QCOMPARE(d->steps.size(), std::size_t{1});
        const model::StepTree tree = model::unfoldCopies(*d);
        QCOMPARE(tree.steps.size(), std::size_t{3});  // panel, card, coupon
        QCOMPARE(tree.copies.size(), std::size_t{1 + 5 * 3});
        const auto card = read(dataJob("panel"), "card");
        QVERIFY(d->steps[0]->lines.size() == card->lines.size() && d->steps[0]->areas.size() == card->areas.size());
    }

    void copiesKeepTheirNetsAndComponents() {
        Folder folder;
        folder.copyJob("panel");
        folder.write("matrix/matrix", readFile(folder.path() / "matrix/matrix") +
                                          "LAYER {\nROW=4\nCONTEXT=BOARD\nTYPE=COMPONENT\nNAME=comp_+_top\n}\n");
        folder.write("steps/card/layers/comp_+_top/components", "UNITS=MM\nCMP 0 3 2 0 N R1 part\n");
        const auto d = read(folder.path());
        QVERIFY(d->nets.empty() && d->components.empty());
        const Document& card = *d->steps[0];
        QCOMPARE(card.nets.size(), std::size_t{1});
        QCOMPARE(card.elementsOf(card.findNet("A")).size(), std::size_t{1});
        QCOMPARE(card.components.size(), std::size_t{1});
        QCOMPARE(card.components[0].refdes, std::string("R1"));
        QCOMPARE(card.steps[0]->nets.size(), std::size_t{2});
        QVERIFY(findDiagnostic(d->diagnostics, "step MISSING has no folder") != nullptr);
    }

    void aFlippedCopyLandsOnTheOtherSide() {
        const auto d = read(dataJob("panel"));
        const model::StepInstance& flipped = d->instances.back();
        QVERIFY(flipped.isFlipped && flipped.placement.isMirrored);
        QCOMPARE(flipped.placement.apply(Point{1'000'000, 1'000'000}), (Point{70'000'000, 11'000'000}));
        const LayerId top = d->findLayer("top");
        const LayerId bottom = d->findLayer("bottom");
        QCOMPARE(d->layerOfCopy(top, true), bottom);
        QCOMPARE(d->layerOfCopy(bottom, true), top);
        QCOMPARE(d->layerOfCopy(d->findLayer("drill"), true), d->findLayer("drill"));
        // Five cards with a pad on top, a line on the bottom and two coupons; one of them is flipped.
        const auto& onTop = layerOf(*d, "top").countsWithCopies;
        const auto& onBottom = layerOf(*d, "bottom").countsWithCopies;
        QCOMPARE(onTop, (std::array<std::uint64_t, 5>{1, 0, 1 + 4 * 2, 0, 4}));
        QCOMPARE(onBottom, (std::array<std::uint64_t, 5>{4, 0, 2, 0, 1}));
        QCOMPARE(layerOf(*d, "drill").countsWithCopies[2], std::uint64_t{5});
    }

    void layersOfCopiesAreThoseOfThePanel() {
        const auto d = read(dataJob("panel"));
        for (const Document* step : model::distinctSteps(*d)) {
            QVERIFY(step->layers.size() <= d->layers.size());
            for (std::size_t row = 0; row < step->layers.size(); ++row) {
                QCOMPARE(step->layers[row].name, d->layers[row].name);
                if (step->layers[row].isSynthetic && step->layers[row].elements.count == 0) {
                    continue;  // a coupon without a laminate of its own
                }
                QCOMPARE(step->layers[row].z, d->layers[row].z);
                QCOMPARE(step->layers[row].thickness, d->layers[row].thickness);
            }
        }
        QCOMPARE(layerOf(*d->steps[0], "top").file, std::string("steps/card/layers/top/features"));
    }

    void thePanelsLaminateEndsWhereItsCardsBegin() {
        const auto d = read(dataJob("panel"));
        const ElementId rails{layerOf(*d, "board").elements.first};
        QCOMPARE(squareMillimetres(*d, rails), 80.0 * 50.0 - 5 * 36.0);
    }

    void aNegativeFeatureOverACopyIsReported() {
        Folder folder;
        folder.copyJob("panel");
        const auto write = [&](const char* location) {
            folder.write("steps/panel/layers/top/features",
                         std::string("UNITS=MM\n$0 r1000\nP 1 1 0 P 0 0\nP ") + location + " 0 N 0 0\n");
        };
        write("5 5");
        QVERIFY(findDiagnostic(read(folder.path())->diagnostics, "reaches over a copy") == nullptr);
        write("12 12");
        const auto d = read(folder.path());
        const model::Diagnostic* found = findDiagnostic(d->diagnostics, "reaches over a copy");
        QVERIFY(found != nullptr);
        QCOMPARE(found->line, 4U);
        QCOMPARE(found->file, std::string("steps/panel/layers/top/features"));
    }

    void negativeFeaturesOfACopyOverThePanelAreReported() {
        Folder folder;
        folder.copyJob("panel");
        folder.write("steps/card/layers/top/features", "UNITS=MM\n$0 r100\nP 3 2 0 P 0 0\nP 3 2 0 N 0 0\n");
        QVERIFY(findDiagnostic(read(folder.path())->diagnostics, "lies over this one") == nullptr);
        folder.write("steps/panel/layers/top/features", "UNITS=MM\n$0 r1000\nP 12 12 0 P 0 0\n");
        QVERIFY(findDiagnostic(read(folder.path())->diagnostics, "lies over this one") != nullptr);
    }

    void aPanelsNegativeLayerLeavesItsCardsToThem() {
        Folder folder;
        folder.copyJob("panel");
        std::string matrix = readFile(folder.path() / "matrix/matrix");
        matrix.replace(matrix.rfind("POSITIVE", matrix.find("DRILL")), 8, "NEGATIVE");  // BOTTOM
        folder.write("matrix/matrix", matrix);
        folder.write("steps/panel/layers/bottom/features", "UNITS=MM\n");
        const auto d = read(folder.path());
        const ElementId rails{layerOf(*d, "bottom").elements.first};
        QCOMPARE(layerOf(*d, "bottom").counts[4], 1U);
        QCOMPARE(squareMillimetres(*d, rails), 80.0 * 50.0 - 5 * 36.0);
        QVERIFY(layerOf(*d->steps[0], "bottom").counts[4] > 0);
    }

    void whatACardsNegativeLayerClearsAroundItIsClearedOnThePanel() {
        Folder folder;
        folder.copyJob("panel");
        makeCopperNegative(folder);
        folder.write("steps/panel/layers/top/features", "UNITS=MM\n");
        folder.write("steps/panel/layers/bottom/features", "UNITS=MM\n");
        // A square brush along the lower edge of the card, half of it outside, and over both ends by half its width.
        folder.write("steps/card/layers/top/features", "UNITS=MM\n$0 s1000\nL 0 0 6 0 0 P 0\n");
        folder.write("steps/card/layers/bottom/features", "UNITS=MM\n");
        const auto d = read(folder.path());
        const auto copper = [&](const char* layer) {
            return squareMillimetres(*d, ElementId{layerOf(*d, layer).elements.first});
        };
        const double around = 7.0 * 0.5 + 2 * 0.5 * 0.5;
        QCOMPARE(copper("top"), 80.0 * 50.0 - 5 * 36.0 - 4 * around);
        QCOMPARE(copper("bottom"), 80.0 * 50.0 - 5 * 36.0 - around);
        const Document& card = *d->steps[0];
        const ElementId plane{layerOf(card, "top").elements.first};
        QCOMPARE(squareMillimetres(card, plane), 36.0 - 6.0 * 0.5);
    }

    /// The card between has no features on the layer. What its coupons clear beside them goes beyond it by 8 mm.
    void whatInnerCopiesClearIsHandedOnByACardThatDrawsNothing() {
        Folder folder;
        folder.copyJob("panel");
        makeCopperNegative(folder);
        std::filesystem::remove_all(folder.path() / "steps/card/layers/top");
        folder.write("steps/panel/layers/top/features", "UNITS=MM\n");
        folder.write("steps/panel/layers/bottom/features", "UNITS=MM\n");
        folder.write("steps/card/layers/bottom/features", "UNITS=MM\n");
        folder.write("steps/coupon/profile", "UNITS=MM\nS P 0\nOB 0 0 I\nOS 1 0\nOS 1 1\nOS 0 1\nOS 0 0\nOE\nSE\n");
        folder.write("steps/coupon/layers/top/features", "UNITS=MM\n$0 s1000\nL 0.5 0.5 10.5 0.5 0 P 0\n");
        const auto d = read(folder.path());
        const auto copper = [&](const char* layer) {
            return squareMillimetres(*d, ElementId{layerOf(*d, layer).elements.first});
        };
        QCOMPARE(copper("top"), 80.0 * 50.0 - 5 * 36.0 - 4 * 2 * 8.0);
        QCOMPARE(copper("bottom"), 80.0 * 50.0 - 5 * 36.0 - 2 * 8.0);
        const Document& card = d->steps[0]->steps.empty() ? *d->steps[1] : *d->steps[0];
        QCOMPARE(layerOf(card, "top").elements.count, 0U);
    }

    /// A brush from one card to the next, which lies 20 mm to the right.
    void whatACopyClearsOverTheOneBesideItIsReported_data() {
        QTest::addColumn<QString>("brush");
        QTest::addColumn<bool>("isOver");
        QTest::newRow("over its copper") << "L 0 3 22 5 0 P 0" << true;
        QTest::newRow("over what that one clears itself") << "L 0 3 22 3 0 P 0" << false;
        QTest::newRow("as far as its edge") << "L 0 3 19.5 5 0 P 0" << false;
        QTest::newRow("beside it") << "L 0 0 6 0 0 P 0" << false;
    }
    void whatACopyClearsOverTheOneBesideItIsReported() {
        QFETCH(QString, brush);
        QFETCH(bool, isOver);
        Folder folder;
        folder.copyJob("panel");
        makeCopperNegative(folder);
        folder.write("steps/card/layers/top/features", "UNITS=MM\n$0 s1000\n" + brush.toStdString() + "\n");
        const auto d = read(folder.path());
        const model::Diagnostic* found = findDiagnostic(d->diagnostics, "over copper of the copy beside it");
        QCOMPARE(found != nullptr, isOver);
        if (isOver) {
            QVERIFY(found->text.starts_with("Layer TOP is negative"));
            QCOMPARE(found->file, std::string("steps/panel/stephdr"));
            QCOMPARE(found->line, 2U);
            QCOMPARE(found->severity, model::Severity::Warning);
        }
    }

    void oneStackHoldsForAllSteps() {
        Folder folder;
        folder.copyJob("panel");
        folder.write("steps/card/layers/top/attrlist", "UNITS=MM\n.copper_weight=70\n");
        const auto d = read(folder.path());
        QCOMPARE(layerOf(*d, "top").thickness, 70'000);
        QCOMPARE(layerOf(*d->steps[0], "top").thickness, 70'000);
    }

    void aPanelsProfileIsJudgedByItsCardsToo() {
        Folder folder;
        folder.copyJob("panel");
        // All copper of the panel itself is a mark beside it.
        folder.write("steps/panel/layers/top/features", "UNITS=MM\n$0 r1000\nP -20 1 0 P 0 0\n");
        const auto d = read(folder.path());
        QVERIFY(findDiagnostic(d->diagnostics, "does not enclose") == nullptr);
        QCOMPARE(d->board.width(), 80'000'000);
    }

    void anyStepCanBeChosen() {
        const auto card = read(dataJob("panel"), "card");
        QCOMPARE(card->job.step, std::string("CARD"));
        QCOMPARE(layerOf(*card, "top").countsWithCopies[2], std::uint64_t{2});
        const auto unknown = tryRead(dataJob("panel"), "nothing");
        QVERIFY(!unknown.ok());
        QCOMPARE(unknown.error().code, base::ErrorCode::BadUsage);
        QVERIFY(unknown.error().text.find("PANEL, CARD, COUPON") != std::string::npos);
    }

    void theFirstStepWithFeaturesIsTheDefault() {
        Folder folder;
        folder.copyJob("panel");
        fs::remove_all(folder.path() / "steps/panel/layers");
        QCOMPARE(read(folder.path())->job.step, std::string("CARD"));
    }

    void aStepInsideItselfIsReported() {
        Folder folder;
        folder.copyJob("panel");
        folder.write("steps/coupon/stephdr", "UNITS=MM\nSTEP-REPEAT {\nNAME=PANEL\nX=0\nY=0\nNX=1\nNY=1\n}\n");
        const auto d = read(folder.path());
        QVERIFY(findDiagnostic(d->diagnostics, "contains itself") != nullptr);
        QCOMPARE(layerOf(*d, "drill").countsWithCopies[2], std::uint64_t{5});
    }

    void copiesOutsideOfTheRangeAreLeftOut() {
        Folder folder;
        folder.copyJob("panel");
        folder.write("steps/panel/stephdr", "UNITS=MM\nSTEP-REPEAT {\nNAME=CARD\nX=1073\nY=0\nNX=1\nNY=1\n}\n");
        const auto d = read(folder.path());
        const model::Diagnostic* found = findDiagnostic(d->diagnostics, "outside of the coordinate range");
        QVERIFY(found != nullptr);
        QCOMPARE(found->line, 2U);
        QVERIFY(d->instances.empty());
    }

    void tooManyOrTooDeepCopiesAreReported() {
        const auto block = [](const char* name, int count) {
            return std::string("STEP-REPEAT {\nNAME=") + name + "\nDX=0.001\nNX=" + std::to_string(count) + "\n}\n";
        };
        Folder folder;
        folder.copyJob("panel");
        folder.write("steps/card/stephdr", "UNITS=MM\n" + block("COUPON", 999));
        folder.write("steps/panel/stephdr", "UNITS=MM\n" + block("CARD", 200));
        const auto d = read(folder.path());
        QCOMPARE(d->instances.size(), std::size_t{99});  // 1 + 99 * 1000 copies; one more would be too many
        QVERIFY(findDiagnostic(d->diagnostics, "more than 100000 copies, the limit") != nullptr);
        Folder deep;
        deep.copyJob("panel");
        for (int i = 0; i < 12; ++i) {
            deep.write("steps/n" + std::to_string(i) + "/stephdr",
                       "UNITS=MM\n" + block(("n" + std::to_string(i + 1)).c_str(), 1));
        }
        deep.write("steps/panel/stephdr", "UNITS=MM\n" + block("n0", 1));
        const auto nested = read(deep.path());
        QCOMPARE(model::unfoldCopies(*nested).copies.size(), std::size_t{9});
        QVERIFY(findDiagnostic(nested->diagnostics, "more than 8 levels of steps, the limit") != nullptr);
    }
};

QTEST_APPLESS_MAIN(PanelReaderTest)
#include "panel_reader_test.moc"
