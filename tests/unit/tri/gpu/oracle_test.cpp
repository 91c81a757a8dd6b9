#include "tests/unit/tri/gpu/oracle.h"

#include <QtTest>
#include <vector>

#include "tests/unit/tri/cases.h"
#include "tests/unit/tri/generator.h"

using cases::Case;
using cases::Generator;
using tri::gpu::CallOrder;
using tri::gpu::Eraser;
using tri::gpu::ForestData;
using tri::gpu::Oracle;

namespace {

using Triangles = std::vector<std::uint32_t>;

constexpr int kMaxSteps = 100'000;

/// Steps until all is done.
int grow(Oracle& oracle) {
    int steps = 0;
    while (oracle.step() && steps < kMaxSteps) {
        ++steps;
    }
    return steps;
}

std::vector<tri::Polygon> polygonsOf(const std::vector<Case>& inputs) {
    std::vector<tri::Polygon> polygons;
    for (const Case& input : inputs) {
        polygons.push_back(input.polygon());
    }
    return polygons;
}

/// Counts what the oracle did with some polygons, all in one forest.
struct Tally {
    int same = 0;     ///< triangles as those of the sequential triangulator
    int flagged = 0;  ///< has to go to the CPU, which can do it
    int refused = 0;  ///< flagged, and the CPU refuses it as well
    QStringList wrong;
};

Tally compare(const std::vector<Case>& inputs, Eraser eraser = Eraser::Sector) {
    const ForestData data = tri::gpu::plant(polygonsOf(inputs), eraser);
    Oracle oracle(data, CallOrder::Forward);
    Tally tally;
    if (grow(oracle) >= kMaxSteps) {
        tally.wrong << "did not end";
    }
    oracle.erase();
    for (std::size_t tree = 0; tree < data.trees.size(); ++tree) {
        const Case& input = inputs[data.polygonOf[tree]];
        Triangles expected;
        const tri::Status status = tri::triangulate(input.polygon(), tri::Triangulator::Cpu, expected);
        if (oracle.forest().trees.at[tree].flags != 0) {
            (status.outcome == tri::Outcome::Ok ? tally.flagged : tally.refused) += 1;
        } else if (tri::triangleSetHash(oracle.trianglesOf(tree)) == tri::triangleSetHash(expected)) {
            ++tally.same;
        } else {
            tally.wrong << QString::fromStdString(input.name);
        }
    }
    return tally;
}

/// The mesh, as numbers that differ if the mesh does.
std::vector<std::uint32_t> meshOf(const Oracle& oracle) {
    std::vector<std::uint32_t> mesh;
    for (std::size_t t = 0; t < 2 * std::size_t{oracle.forest().vertexCount}; ++t) {
        const std::vector<std::uint32_t> triangle = Oracle::meshAt(oracle.forest().triangles.at[t]);
        mesh.push_back(static_cast<std::uint32_t>(triangle.size()));
        mesh.insert(mesh.end(), triangle.begin(), triangle.end());
    }
    return mesh;
}

}  // namespace

class OracleTest : public QObject {
    Q_OBJECT

private slots:
    void namedCasesComeOutAsFromTheCpu() {
        const Tally tally = compare(cases::nasty());
        QVERIFY2(tally.wrong.isEmpty(), qPrintable(tally.wrong.join(", ")));
        QVERIFY(tally.same >= 19);
        QVERIFY(tally.flagged <= 11);  // contours through vertices, and triangles between slits
    }

    void randomPolygonsComeOutAsFromTheCpu() {
        std::vector<Case> inputs;
        for (unsigned seed = 0; seed < 400; ++seed) {
            Generator generator(seed);
            inputs.push_back(generator.cells(2 + generator.below(7)));
            inputs.push_back(generator.scribble(2 + generator.below(4), 8));
            inputs.push_back(generator.scribble(3 + generator.below(60), 5));
            inputs.push_back(generator.star(10 << generator.below(20), 3 + generator.below(60)));
        }
        const Tally tally = compare(inputs);
        QVERIFY2(tally.wrong.isEmpty(), qPrintable(tally.wrong.join(", ")));
        QVERIFY(tally.same > 400);
    }

    void planesAndChannelsNeedNoHelp() {
        const Tally tally = compare({cases::plane(6), cases::channels(30), cases::plane(20)});
        QVERIFY2(tally.wrong.isEmpty(), qPrintable(tally.wrong.join(", ")));
        QCOMPARE(tally.same, 3);
    }

    void everyStepIsTheSameInEveryOrderOfCalls() {
        std::vector<Case> inputs = cases::nasty();
        inputs.push_back(cases::plane(5));
        inputs.push_back(cases::channels(20));
        const ForestData data = tri::gpu::plant(polygonsOf(inputs), Eraser::Sector);
        Oracle forward(data, CallOrder::Forward);
        Oracle backward(data, CallOrder::Backward);
        Oracle scattered(data, CallOrder::Scattered);
        for (int step = 0; forward.step(); ++step) {
            QVERIFY(step < kMaxSteps);
            QVERIFY(backward.step());
            QVERIFY(scattered.step());
            QVERIFY2(meshOf(forward) == meshOf(backward), qPrintable(QString::number(step)));
            QVERIFY2(meshOf(forward) == meshOf(scattered), qPrintable(QString::number(step)));
        }
        QCOMPARE(forward.control().flips, backward.control().flips);
    }

    void thePapersRuleNeedsHelpWhereLoopsTouch() {
        // A triangle with corners on two loops may lie outside if these touch; the proof finds it.
        const std::vector<Case> touching = {Case{"holes"}
                                                .loop(cases::square(0, 0, 100))
                                                .loop(cases::squareHole(20, 20, 20))
                                                .loop(cases::squareHole(40, 40, 20)),
                                            Case{"island"}
                                                .loop(cases::square(0, 0, 100))
                                                .loop(cases::squareHole(20, 20, 60))
                                                .loop(cases::square(40, 40, 20))};
        const Tally tally = compare(touching, Eraser::Loop);
        QVERIFY(tally.wrong.isEmpty());
        QCOMPARE(tally.flagged, 2);
        QCOMPARE(compare({cases::plane(6), cases::channels(30)}, Eraser::Loop).same, 2);
    }
};

QTEST_APPLESS_MAIN(OracleTest)
#include "oracle_test.moc"
