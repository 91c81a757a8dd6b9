#include "model/solids/milling.h"

#include <QtTest>
#include <numbers>
#include <random>

#include "model/base/parallel.h"
#include "model/figures/element_polygons.h"
#include "model/geometry/boolean.h"
#include "model/geometry/region.h"
#include "tests/unit/model/hand_made.h"

using namespace hand_made;
using model::ElementId;
using model::LayerType;
using model::MilledElement;
using model::Nm;
using model::Point;
using model::PolygonSet;

namespace {

constexpr std::array<StackLayer, 5> kStackup{{{"top", LayerType::Signal, 1'600 * kUm, 35 * kUm, 2},
                                              {"inner", LayerType::Signal, 800 * kUm, 35 * kUm, 1},
                                              {"bottom", LayerType::Signal, 0, 35 * kUm, 0},
                                              {"drill", LayerType::Drill, 0, 1'635 * kUm, 3},
                                              {"silk", LayerType::SilkScreen, 1'660 * kUm, 10 * kUm, 4}}};

/// A board of 20 mm by 10 mm.
class Board {
public:
    explicit Board(bool hasOutline = true) {
        addLayers(m_builder, kStackup);
        if (hasOutline) {
            m_builder.setProfile(m_builder.addShape(rectangle({0, 0}, {20 * kMm, 10 * kMm})));
        }
    }
    model::DocumentBuilder& on(std::size_t layer) {
        m_builder.beginLayer(model::LayerId{layer});
        return m_builder;
    }
    void disc(Point centre, Nm diameter) { m_builder.addCircle({centre, diameter, 0}, {}); }
    void hole(Point centre, Nm diameter, Nm inside) {
        m_builder.addCircle({centre, diameter, inside}, flagged(model::kHole));
    }

    /// A routed path with a round bit.
    void slot(std::span<const Point> points, Nm width) {
        std::vector<model::PathNode> nodes;
        for (const Point point : points) {
            nodes.emplace_back().point = point;
        }
        m_builder.addTrail(nodes, width, flagged(model::kHole));
    }

    void place(const std::shared_ptr<const model::Document>& step, const model::Placement& placement) {
        m_builder.addInstance({m_builder.addStep(step), placement, false});
    }
    [[nodiscard]] std::shared_ptr<const model::Document> finish() { return m_builder.finish(); }

    [[nodiscard]] model::MilledBoard found() const {
        return model::findMilled(m_builder.soFar(), model::kBooleanChords, {});
    }
    [[nodiscard]] std::vector<MilledElement> milled() const { return found().elements; }
    [[nodiscard]] const model::Document& document() const { return m_builder.soFar(); }

private:
    model::DocumentBuilder m_builder;
};

double areaMm2(const PolygonSet& set) {
    return static_cast<double>(model::twiceArea(set)) / 2.0 / kMm / kMm;
}

/// 20 mm × 10 mm with a cut-out of 4 mm × 2 mm in its middle.
model::ShapeSketch outlineWithCutout() {
    model::ShapeSketch outline = rectangle({0, 0}, {20 * kMm, 10 * kMm});
    const std::array<Point, 4> cutout{
        {{8 * kMm, 4 * kMm}, {8 * kMm, 6 * kMm}, {12 * kMm, 6 * kMm}, {12 * kMm, 4 * kMm}}};
    outline.addPolygon(cutout, true);
    return outline;
}

}  // namespace

class MillingTest : public QObject {
    Q_OBJECT

private slots:
    /// The tracks of a slot overlap where it turns; a box around all of it holds more than it passes.
    void aSlotOpensWhatItReachesAndNoMore() {
        Board board;
        board.on(0);
        board.disc({4 * kMm, 5 * kMm}, 200 * kUm);  // where the slot turns
        board.disc({4 * kMm, 7 * kMm}, 200 * kUm);  // in one of its tracks
        board.disc({2 * kMm, 8 * kMm}, 200 * kUm);  // in its box, beside it
        board.disc({5 * kMm, 8 * kMm}, kMm);        // at its edge
        board.on(3);
        board.slot(std::array<Point, 3>{Point{-2 * kMm, 5 * kMm}, {4 * kMm, 5 * kMm}, {4 * kMm, 9 * kMm}}, 2 * kMm);
        const std::vector<MilledElement> milled = board.milled();
        QCOMPARE(milled.size(), 4U);
        QCOMPARE(milled[0].element, ElementId{0});
        QVERIFY(milled[0].rest.polygons.empty());
        QCOMPARE(milled[1].element, ElementId{1});
        QVERIFY(milled[1].rest.polygons.empty());
        QCOMPARE(milled[2].element, ElementId{3});
        QVERIFY(std::abs(areaMm2(milled[2].rest) - std::numbers::pi / 8) < 0.01);
    }

    void whatLiesWithinIsNotListed() {
        Board board;
        board.on(0);
        board.disc({5 * kMm, 5 * kMm}, kMm);
        board.disc({kMm, 5 * kMm}, 2 * kMm);  // touches the outline
        QCOMPARE(board.milled().size(), 0U);
    }

    void whatLiesBeyondIsGone() {
        Board board;
        board.on(0);
        board.disc({5 * kMm, 5 * kMm}, kMm);
        board.disc({-5 * kMm, 5 * kMm}, kMm);
        const auto milled = board.milled();
        QCOMPARE(milled.size(), 1U);
        QCOMPARE(milled[0].element, ElementId{1});
        QVERIFY(milled[0].rest.polygons.empty());
    }

    void whatReachesAcrossIsCutAtTheOutline() {
        Board board;
        board.on(4).addLine({{5 * kMm, -3 * kMm}, {5 * kMm, 3 * kMm}, kMm, 0}, {});
        const auto milled = board.milled();
        QCOMPARE(milled.size(), 1U);
        QVERIFY(std::abs(areaMm2(milled[0].rest) - (3.0 + std::numbers::pi / 8.0)) < 0.01);
        for (const Point point : milled[0].rest.points) {
            QVERIFY(point.y >= 0);
        }
    }

    /// The outline as a closed line around the board: no edge of it need cross the profile's.
    void whatLiesAroundTheBoardIsGone() {
        Board board;
        board.on(0);
        board.disc({5 * kMm, 5 * kMm}, kMm);
        auto frame = rectangle({-5 * kMm, -5 * kMm}, {25 * kMm, 15 * kMm});
        const std::array<Point, 4> inside{
            {{-4 * kMm, -4 * kMm}, {-4 * kMm, 14 * kMm}, {24 * kMm, 14 * kMm}, {24 * kMm, -4 * kMm}}};
        frame.addPolygon(inside, true);
        auto& builder = board.on(4);
        builder.addArea({builder.addShape(frame), {}}, {});
        const auto milled = board.milled();
        QCOMPARE(milled.size(), 1U);
        QVERIFY(milled[0].rest.polygons.empty());
    }

    void aPlaneOverACutoutOfTheOutlineIsOpenThere() {
        Board board(false);
        auto& builder = board.on(0);
        builder.setProfile(builder.addShape(outlineWithCutout()));
        builder.addArea({builder.addShape(rectangle({kMm, kMm}, {19 * kMm, 9 * kMm})), {}}, {});
        const auto milled = board.milled();
        QCOMPARE(milled.size(), 1U);
        QCOMPARE(areaMm2(milled[0].rest), 18.0 * 8.0 - 4.0 * 2.0);
    }

    void ofAStepOfAPanelOnlyItsCutoutsAreOpen() {
        Board board(false);
        auto& builder = board.on(0);
        builder.setProfile(builder.addShape(outlineWithCutout()));
        builder.addArea({builder.addShape(rectangle({-kMm, kMm}, {19 * kMm, 9 * kMm})), {}}, {});
        board.disc({-5 * kMm, 5 * kMm}, kMm);
        board.disc({10 * kMm, 5 * kMm}, kMm);
        const auto milled = model::findInCutouts(board.document(), model::kBooleanChords, {}).elements;
        QCOMPARE(milled.size(), 2U);
        QCOMPARE(areaMm2(milled[0].rest), 20.0 * 8.0 - 4.0 * 2.0);
        QVERIFY(milled[1].rest.polygons.empty());
        QCOMPARE(areaMm2(model::cutoutsOf(board.document(), model::kBooleanChords)), 4.0 * 2.0);
        QCOMPARE(model::findInCutouts(Board().document(), model::kBooleanChords, {}).elements.size(), 0U);
    }

    void aCastellationKeepsHalfOfItsPlatingAndOpensWhatItPasses() {
        Board board;
        auto& builder = board.on(0);
        builder.addArea({builder.addShape(rectangle({4 * kMm, -kMm}, {6 * kMm, 2 * kMm})), {}}, {});
        board.on(1);
        board.disc({15 * kMm, 5 * kMm}, kMm);  // far from it
        board.on(3);
        board.hole({5 * kMm, 0}, kMm, 900 * kUm);
        const auto milled = board.milled();
        QCOMPARE(milled.size(), 2U);
        const double drilled = std::numbers::pi * 0.25 / 2.0;
        const double open = std::numbers::pi * 0.2025 / 2.0;
        QVERIFY(std::abs(areaMm2(milled[0].rest) - (4.0 - drilled)) < 0.005);
        QVERIFY(std::abs(areaMm2(milled[1].rest) - (drilled - open)) < 0.005);
    }

    void aHoleWithoutPlatingLeavesNothingAtTheOutline() {
        Board board;
        board.on(3);
        board.hole({0, 5 * kMm}, kMm, kMm);
        board.hole({5 * kMm, 5 * kMm}, kMm, kMm);
        const auto milled = board.milled();
        QCOMPARE(milled.size(), 1U);
        QVERIFY(milled[0].rest.polygons.empty());
    }

    void roundedCoordinatesAreNoReasonToMill() {
        Board board;
        auto& builder = board.on(0);
        builder.addArea({builder.addShape(rectangle({-2 * kUm, -2 * kUm}, {20 * kMm + 2 * kUm, 9 * kMm})), {}}, {});
        QCOMPARE(board.milled().size(), 0U);
    }

    void anOutlineThatIsNotTheBoardsMillsNothing() {
        Board board;
        board.on(0);
        board.disc({5 * kMm, 5 * kMm}, kMm);
        board.disc({-5 * kMm, 5 * kMm}, kMm);
        QVERIFY(!board.found().isOutlineDoubtful);
        board.disc({-6 * kMm, 5 * kMm}, kMm);
        QVERIFY(board.found().isOutlineDoubtful);
        QCOMPARE(board.milled().size(), 0U);
    }

    /// A panel without copper of its own but fiducials in its frame, which lies beyond its outline.
    void copiesOfStepsCountAsCopper() {
        Board step;
        step.on(0);
        for (Nm x = 1; x <= 3; ++x) {
            step.disc({x * kMm, 0}, kMm / 2);
        }
        const auto finished = step.finish();
        const auto isDoubtful = [&](const model::Placement& placement) {
            Board panel;
            panel.on(0);
            panel.disc({-5 * kMm, 5 * kMm}, kMm);
            panel.place(finished, placement);
            return panel.found().isOutlineDoubtful;
        };
        QVERIFY(!isDoubtful({{5 * kMm, 5 * kMm}}));
        QVERIFY(isDoubtful({{50 * kMm, 5 * kMm}}));
        QVERIFY(isDoubtful({{18'500 * kUm, 5 * kMm}}));  // two of its three lie beyond
        QVERIFY(!isDoubtful({{17'500 * kUm, 5 * kMm}}));
        QVERIFY(!isDoubtful({{18'500 * kUm, 5 * kMm}, 90.0}));  // upwards or downwards, all within
    }

    void withoutAnOutlineNothingIsMilled() {
        Board board(false);
        board.on(0);
        board.disc({-5 * kMm, 5 * kMm}, kMm);
        QCOMPARE(board.milled().size(), 0U);
    }

    /// What is left is what is on both; with one thread and with all.
    void randomTracksAreCutExactly() {
        Board board;
        auto& builder = board.on(0);
        std::mt19937 random(7);
        std::uniform_int_distribution<Nm> x(-4 * kMm, 24 * kMm);
        std::uniform_int_distribution<Nm> y(-4 * kMm, 14 * kMm);
        for (int i = 0; i < 300; ++i) {
            builder.addLine({{x(random), y(random)}, {x(random), y(random)}, 300 * kUm, 0}, {});
        }
        const auto milled = board.milled();
        QVERIFY(milled.size() > 100);
        const PolygonSet outline = model::discretise(board.document().shapes, board.document().profile, {});
        for (const MilledElement& element : milled) {
            const PolygonSet whole = model::discretise(board.document(), element.element, model::kBooleanChords);
            const PolygonSet beyond = model::subtract(whole, outline);
            QVERIFY(std::abs(areaMm2(element.rest) + areaMm2(beyond) - areaMm2(whole)) < 1e-4);
            QVERIFY(areaMm2(model::subtract(element.rest, outline)) < 1e-9);
        }
        const base::ThreadLimit one(1);
        const auto again = board.milled();
        QCOMPARE(again.size(), milled.size());
        for (std::size_t i = 0; i < milled.size(); ++i) {
            QCOMPARE(again[i].element, milled[i].element);
            QVERIFY(again[i].rest.points == milled[i].rest.points);
        }
    }
};

QTEST_APPLESS_MAIN(MillingTest)
#include "milling_test.moc"
