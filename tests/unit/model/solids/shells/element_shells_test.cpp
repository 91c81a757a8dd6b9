#include "model/solids/shells/element_shells.h"

#include <QtTest>

#include "model/geometry/loops/edge_faults.h"
#include "tests/unit/model/geometry/edge_loop_checks.h"
#include "tests/unit/model/hand_made.h"

using namespace edge_loop_checks;
using namespace hand_made;
using model::EdgeKind;
using model::ElementId;
using model::ElementShells;
using model::LayerType;
using model::Point;
using model::ShapeSketch;
using model::Shell;

namespace {

constexpr std::array<StackLayer, 4> kStackup{{{"top", LayerType::Signal, 1'600 * kUm, 35 * kUm, 2},
                                              {"inner", LayerType::Signal, 800 * kUm, 35 * kUm, 1},
                                              {"bottom", LayerType::Signal, 0, 35 * kUm, 0},
                                              {"drill", LayerType::Drill, 0, 1'635 * kUm, 3}}};

class Board {
public:
    Board() { addLayers(m_builder, kStackup); }
    model::DocumentBuilder& on(std::size_t layer) {
        m_builder.beginLayer(model::LayerId{layer});
        return m_builder;
    }
    [[nodiscard]] ElementShells shellsOf(ElementId element) const {
        return model::shellsOf(m_builder.soFar(), element);
    }

private:
    model::DocumentBuilder m_builder;
};

bool areAllSound(const ElementShells& shells) {
    for (const Shell& shell : shells.shells) {
        if (!areSound(shell.outline) || model::findFault(shell.outline) || shell.z.top <= shell.z.bottom) {
            return false;
        }
    }
    return true;
}

}  // namespace

class ElementShellsTest : public QObject {
    Q_OBJECT

private slots:
    void oneSolidOfEachKind() {
        Board board;
        auto& top = board.on(0);
        const ElementId line = top.addLine({{0, 0}, {kMm, 0}, 200 * kUm, 0}, {});
        const ElementId arc =
            top.addArc({{{kMm, 0}, {0, 0}, EdgeKind::ArcCounterClockwise}, {998'630, -52'336}, 200 * kUm, 0}, {});
        const ElementId disc = top.addCircle({{0, 0}, kMm, 0}, {});
        const std::array<model::PathNode, 3> nodes{{{{0, 0}, {}, {}}, {{kMm, 0}, {}, {}}, {{kMm, kMm}, {}, {}}}};
        const ElementId trail = top.addTrail(nodes, 200 * kUm, {});
        const ElementId area = top.addArea({top.addShape(rectangle({0, 0}, {kMm, kMm})), {{5, 5}, 30.0, true}}, {});
        for (const ElementId element : {line, arc, disc, trail, area}) {
            const ElementShells shells = board.shellsOf(element);
            QCOMPARE(shells.problem, std::string_view{});
            QCOMPARE(shells.shells.size(), 1U);
            QVERIFY(areAllSound(shells));
            QCOMPARE(shells.shells.front().z.bottom, 1'600 * kUm);
            QCOMPARE(shells.shells.front().z.top, 1'635 * kUm);
        }
        QVERIFY(relative(volumeOf(board.shellsOf(area).shells.front()), 1e12 * 35'000) < 1e-12);
    }

    void barrelsGoFromCopperToCopper() {
        Board board;
        const ElementId hole =
            board.on(3).addCircle({{0, 0}, 400 * kUm, 350 * kUm}, flagged(model::kHole | model::kPlated));
        const ElementId bare = board.on(2).addCircle({{0, 0}, 400 * kUm, 400 * kUm}, flagged(model::kHole));
        const ElementShells barrel = board.shellsOf(hole);
        QVERIFY(areAllSound(barrel) && barrel.problem.empty());
        QCOMPARE(barrel.shells.front().z.bottom, 0);
        QCOMPARE(barrel.shells.front().z.top, 1'635 * kUm);
        QVERIFY(relative(volumeOf(barrel.shells.front()), kPi / 4 * (16e10 - 35e4 * 35e4) * 1'635'000) < 1e-9);
        QVERIFY(board.shellsOf(bare).shells.empty() && board.shellsOf(bare).problem.empty());
    }

    void faultyAreasAreCleaned() {
        Board board;
        auto& top = board.on(0);
        ShapeSketch pinched;
        pinched.addPolygon(
            std::vector<Point>{{0, 0}, {kMm, 0}, {kMm / 2, kMm / 2}, {kMm, kMm}, {0, kMm}, {kMm / 2, kMm / 2}}, false);
        const ElementShells shells = board.shellsOf(top.addArea({top.addShape(pinched), {{7, 9}, 90.0, false}}, {}));
        QVERIFY(areAllSound(shells) && shells.problem.empty());
        QCOMPARE(shells.shells.size(), 2U);
        QVERIFY(relative(areaOf(shells.shells[0].outline) + areaOf(shells.shells[1].outline), 5e11) < 1e-5);
    }

    void reasonsWhyThereIsNoSolid() {
        Board board;
        auto& top = board.on(0);
        const ElementId line = top.addLine({{0, 0}, {kMm, 0}, 0, 0}, {});
        const std::array<model::PathNode, 2> nodes{{{{0, 0}, {}, {}}, {{kMm, 0}, {}, {}}}};
        const ElementId trail = top.addTrail(nodes, 0, {});
        const ElementId arc = top.addArc({{{kMm, 0}, {0, 0}, EdgeKind::ArcClockwise}, {0, kMm}, 0, 0}, {});
        ShapeSketch flat;
        flat.addPolygon(std::vector<Point>{{0, 0}, {kMm, 0}}, false);
        const ElementId area = top.addArea({top.addShape(flat), {}}, {});
        for (const ElementId element : {line, trail, arc}) {
            QCOMPARE(board.shellsOf(element).problem, std::string_view("it has no width"));
            QVERIFY(board.shellsOf(element).shells.empty());
        }
        QCOMPARE(board.shellsOf(area).problem, std::string_view("its outline has no area"));
    }
};

QTEST_APPLESS_MAIN(ElementShellsTest)
#include "element_shells_test.moc"
