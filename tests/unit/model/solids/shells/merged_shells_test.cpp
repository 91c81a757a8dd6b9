#include "model/solids/shells/merged_shells.h"

#include <QtTest>

#include "model/geometry/loops/edge_faults.h"
#include "tests/unit/model/geometry/edge_loop_checks.h"
#include "tests/unit/model/hand_made.h"

using namespace edge_loop_checks;
using namespace hand_made;
using model::ElementId;
using model::LayerType;
using model::MergedShells;
using model::Shell;

namespace {

constexpr std::array<StackLayer, 1> kStackup{{{"top", LayerType::Signal, 1'600 * kUm, 35 * kUm, 0}}};

class Board {
public:
    Board() {
        addLayers(m_builder, kStackup);
        m_builder.beginLayer(model::LayerId{0});
    }
    void line(model::Point a, model::Point b, model::Nm width) {
        m_elements.push_back(m_builder.addLine({a, b, width, 0}, {}));
    }
    void disc(model::Point at, model::Nm diameter) { m_elements.push_back(m_builder.addCircle({at, diameter, 0}, {})); }
    void pour(model::Point min, model::Point max) {
        m_elements.push_back(m_builder.addArea({m_builder.addShape(rectangle(min, max)), {}}, {}));
    }
    [[nodiscard]] MergedShells merged() const { return model::mergedShells(m_builder.soFar(), m_elements); }

private:
    model::DocumentBuilder m_builder;
    std::vector<ElementId> m_elements;
};

bool areAllSound(const MergedShells& merged) {
    for (const Shell& shell : merged.shells) {
        if (!areSound(shell.outline) || model::findFault(shell.outline) || shell.z.bottom != 1'600 * kUm ||
            shell.z.top != 1'635 * kUm) {
            return false;
        }
    }
    return merged.apart == 0;
}

}  // namespace

class MergedShellsTest : public QObject {
    Q_OBJECT

private slots:
    void nothing() { QVERIFY(Board().merged().shells.empty()); }

    void aTrackBetweenTwoPads() {
        Board board;
        board.disc({0, 0}, kMm);
        board.line({0, 0}, {5 * kMm, 0}, 200 * kUm);
        board.pour({5 * kMm - 500 * kUm, -500 * kUm}, {5 * kMm + 500 * kUm, 500 * kUm});
        const MergedShells merged = board.merged();
        QVERIFY(areAllSound(merged));
        QCOMPARE(merged.problems, 0U);
        QCOMPARE(merged.shells.size(), 1U);
        QCOMPARE(merged.shells.front().outline.edges.size(), 8U);  // 2 sides, 1 arc, 5 of the square
        const double half = std::sqrt(25e10 - 1e10);
        const double segment = 25e10 * std::asin(1e5 / 5e5) - half * 1e5;  // of the disc, beyond the chord
        QVERIFY(relative(areaOf(merged.shells.front().outline),
                         kPi * 25e10 + 1e12 + (5e6 - half - 5e5) * 2e5 - segment) < 1e-9);
    }

    void piecesThatDoNotTouch() {
        Board board;
        for (int i = 0; i < 100; ++i) {
            board.disc({i % 10 * kMm, i / 10 * kMm}, 500 * kUm);
            board.line({i % 10 * kMm, i / 10 * kMm}, {i % 10 * kMm + 600 * kUm, i / 10 * kMm}, 100 * kUm);
        }
        QVERIFY(areAllSound(board.merged()));
        QCOMPARE(board.merged().shells.size(), 100U);
    }

    void aGridOfTracksHasHoles() {
        Board board;
        for (int i = 0; i <= 20; ++i) {
            board.line({0, i * kMm}, {20 * kMm, i * kMm}, 200 * kUm);
            board.line({i * kMm, 0}, {i * kMm, 20 * kMm}, 200 * kUm);
        }
        const MergedShells merged = board.merged();
        QVERIFY(areAllSound(merged));
        QCOMPARE(merged.shells.size(), 1U);
        QCOMPARE(merged.shells.front().outline.loopCount(), 401U);
        const double corners = (4 - kPi) * 1e10;  // the ends of the outer tracks are round
        QVERIFY(relative(areaOf(merged.shells.front().outline), 20.2e6 * 20.2e6 - 400 * 64e10 - corners) < 1e-9);
    }

    void elementsWithoutASolidAreCounted() {
        Board board;
        board.line({0, 0}, {kMm, 0}, 0);
        board.disc({0, 0}, kMm);
        QCOMPARE(board.merged().problems, 1U);
        QCOMPARE(board.merged().shells.size(), 1U);
    }
};

QTEST_APPLESS_MAIN(MergedShellsTest)
#include "merged_shells_test.moc"
