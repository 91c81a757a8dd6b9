#include "model/solids/drilled_print.h"

#include <QtTest>
#include <algorithm>
#include <numbers>

#include "model/geometry/region.h"
#include "tests/unit/model/hand_made.h"

using namespace hand_made;
using model::ElementId;
using model::LayerType;
using model::MilledElement;
using model::Nm;
using model::Point;

namespace {

enum Row : std::size_t { Top, Inner, Bottom, Drill, Mask, Silk, Below };

constexpr std::array<StackLayer, 7> kStackup{{{"top", LayerType::Signal, 1'600 * kUm, 35 * kUm, 2},
                                              {"inner", LayerType::Signal, 800 * kUm, 35 * kUm, 1},
                                              {"bottom", LayerType::Signal, 0, 35 * kUm, 0},
                                              {"drill", LayerType::Drill, 0, 1'635 * kUm, 3},
                                              {"mask", LayerType::SolderMask, 1'635 * kUm, 20 * kUm, 4},
                                              {"silk", LayerType::SilkScreen, 1'655 * kUm, 10 * kUm, 6},
                                              {"below", LayerType::SilkScreen, -30 * kUm, 10 * kUm, 5}}};

/// A line of 8 mm by 0.2 mm over a hole in its middle, at every y that is asked for.
class Board {
public:
    Board() {
        for (StackLayer row : kStackup) {
            addLayers(m_builder, {&row, 1});
        }
        m_builder.setProfile(m_builder.addShape(rectangle({-10 * kMm, -10 * kMm}, {10 * kMm, 10 * kMm})));
    }
    model::DocumentBuilder& on(Row layer) {
        m_builder.beginLayer(model::LayerId{std::size_t{layer}});
        return m_builder;
    }
    void hole(Point at, Nm diameter, bool isPlated) {
        const int flags = model::kHole | (isPlated ? model::kPlated : 0);
        m_builder.addCircle({at, diameter, isPlated ? diameter - 50 * kUm : diameter}, flagged(flags));
    }
    void print(Nm y, Nm from = -4 * kMm) { m_builder.addLine({{from, y}, {4 * kMm, y}, 200 * kUm, 0}, {}); }
    [[nodiscard]] std::vector<MilledElement> found() const {
        return model::findDrilledPrint(m_builder.soFar(), model::kBooleanChords, {});
    }

private:
    model::DocumentBuilder m_builder;
};

double areaMm2(const model::PolygonSet& set) {
    return static_cast<double>(model::twiceArea(set)) / 2.0 / kMm / kMm;
}

}  // namespace

class DrilledPrintTest : public QObject {
    Q_OBJECT

private slots:
    void inkEndsAtTheEdgeOfAnOpenHole() {
        Board board;
        board.on(Drill);
        board.hole({0, 0}, 2 * kMm, false);
        board.on(Silk);
        board.print(0);
        board.print(3 * kMm);  // beside it
        board.on(Below).addCircle({{0, 0}, kMm, 0}, {});
        const std::vector<MilledElement> found = board.found();
        QCOMPARE(found.size(), 2U);
        QCOMPARE(found[0].element, ElementId{1});
        QCOMPARE(found[0].rest.polygons.size(), 2U);
        const double whole = 8 * 0.2 + std::numbers::pi / 100;
        QVERIFY(std::abs(areaMm2(found[0].rest) - (whole - 2 * 0.2)) < 0.002);
        QCOMPARE(found[1].element, ElementId{3});  // all of it in the hole, at the other face
        QVERIFY(found[1].rest.polygons.empty());
    }

    /// The box of a slanting line holds more than the line covers.
    void whatPassesAHoleIsNotListed() {
        Board board;
        board.on(Drill);
        board.hole({0, 2 * kMm}, kMm, false);
        board.on(Silk).addLine({{-4 * kMm, -4 * kMm}, {4 * kMm, 4 * kMm}, 200 * kUm, 0}, {});
        QCOMPARE(board.found().size(), 0U);
    }

    /// The edge of what stays is drawn on a layer of routed paths, and is no hole; a path without a width opens
    /// nothing.
    void whatIsNoHoleOpensNothing() {
        Board board;
        auto& drills = board.on(Drill);
        drills.addLine({{-5 * kMm, 0}, {5 * kMm, 0}, kMm, 0}, {});
        drills.addLine({{-5 * kMm, 0}, {5 * kMm, 0}, 0, 0}, flagged(model::kHole));
        board.on(Silk);
        board.print(0);
        QCOMPARE(board.found().size(), 0U);
    }

    /// A frame has holes of the board within, and a logo may cover one altogether.
    void areasAreCutByWhatTheyMeetOnly() {
        Board board;
        board.on(Drill);
        board.hole({0, 0}, kMm, false);
        board.hole({7 * kMm, 0}, kMm, false);
        auto& builder = board.on(Silk);
        model::ShapeSketch frame = rectangle({-5 * kMm, -5 * kMm}, {5 * kMm, 5 * kMm});
        frame.addCircle({0, 0}, 2 * kMm, true);
        builder.addArea({builder.addShape(frame), {}}, {});
        builder.addArea({builder.addShape(rectangle({6 * kMm, -kMm}, {8 * kMm, kMm})), {}}, {});
        builder.addLine({{-kMm, 0}, {kMm, 0}, 0, 0}, {});  // without a width
        const std::vector<MilledElement> found = board.found();
        QCOMPARE(found.size(), 1U);
        QCOMPARE(found[0].element, ElementId{3});
        QVERIFY2(std::abs(areaMm2(found[0].rest) - (4 - std::numbers::pi / 4)) < 0.005,
                 qPrintable(QString::number(areaMm2(found[0].rest))));
    }

    /// Mask closes narrow vias, and is printed on, but where it is open.
    void maskCarriesPrintOverNarrowVias() {
        Board board;
        board.on(Drill);
        board.hole({0, 0}, 300 * kUm, true);
        board.hole({0, kMm}, 300 * kUm, true);
        board.hole({0, 2 * kMm}, 900 * kUm, true);
        board.on(Mask).addCircle({{0, kMm}, 500 * kUm, 0}, {});
        board.on(Silk);
        board.print(0);
        board.print(kMm);
        board.print(2 * kMm);
        const std::vector<MilledElement> found = board.found();
        QCOMPARE(found.size(), 2U);
        QCOMPARE(found[0].element, ElementId{5});
        QCOMPARE(found[1].element, ElementId{6});
    }

    /// Whatever draws the opening: straight and curved tracks, the corner of a square pen; not beside, nor in a ring.
    void maskIsOpenWhereItsElementsReach() {
        using enum model::EdgeKind;
        Board board;
        board.on(Drill);
        for (Nm y = 0; y < 5 * kMm; y += kMm) {
            board.hole({0, y}, 300 * kUm, true);
        }
        auto& mask = board.on(Mask);
        const model::PathNode zigzag[] = {{{-kMm, -300 * kUm}, {}, Line},
                                          {{kMm, -300 * kUm}, {}, Line},
                                          {{kMm, 50 * kUm}, {}, Line},
                                          {{-kMm, 50 * kUm}, {}, Line}};
        mask.addTrail(zigzag, 200 * kUm, {});
        const model::PathNode bow[] = {{{-500 * kUm, 500 * kUm}, {0, 500 * kUm}, ArcClockwise},
                                       {{500 * kUm, 500 * kUm}, {}, Line},
                                       {{kMm, 500 * kUm}, {}, Line}};
        mask.addTrail(bow, 200 * kUm, {});
        mask.addLine({{-kMm, 2'300 * kUm}, {kMm, 2'300 * kUm}, 400 * kUm, 0}, {});
        mask.addLine({{-2 * kMm, 3'180 * kUm}, {-180 * kUm, 3'180 * kUm}, 400 * kUm, 0}, flagged(model::kSquarePen));
        mask.addCircle({{0, 4 * kMm}, kMm, 600 * kUm}, {});
        mask.addLine({{-kMm, 4 * kMm}, {kMm, 4 * kMm}, 0, 0}, {});  // draws nothing
        board.on(Silk);
        for (Nm y = 0; y < 5 * kMm; y += kMm) {
            board.print(y);
        }
        std::vector<ElementId> found;
        std::ranges::transform(board.found(), std::back_inserter(found), &MilledElement::element);
        QCOMPARE(found, (std::vector{ElementId{11}, ElementId{12}, ElementId{14}}));
    }

    void whatIsMilledTooIsCutByBoth() {
        Board board;
        board.on(Drill);
        board.hole({0, 0}, 2 * kMm, false);
        board.on(Silk);
        board.print(0);
        model::PolygonSet left;  // to the left of x = 2 mm
        left.beginPolygon();
        left.addLoop(std::array<Point, 4>{{{-9 * kMm, -kMm}, {2 * kMm, -kMm}, {2 * kMm, kMm}, {-9 * kMm, kMm}}});
        std::vector<MilledElement> milled{{ElementId{0}, {}}, {ElementId{1}, left}};
        model::addDrilledPrint(board.found(), milled);
        QCOMPARE(milled.size(), 2U);
        QVERIFY(std::abs(areaMm2(milled[1].rest) - (4 * 0.2 + std::numbers::pi / 200)) < 0.002);
    }
};

QTEST_APPLESS_MAIN(DrilledPrintTest)
#include "drilled_print_test.moc"
