#include "model/geometry/loops/fit_arcs.h"

#include <QtTest>
#include <numbers>

#include "tests/unit/model/geometry/edge_loop_checks.h"

using model::EdgeLoops;
using model::PointD;

namespace {

PointD onCircle(PointD centre, double radius, double angle) {
    return {std::round(centre.x + radius * std::cos(angle)), std::round(centre.y + radius * std::sin(angle))};
}

/// A rectangle of 4 x 2 mm whose corners are rounded by chords.
EdgeLoops roundedByChords(int chords) {
    EdgeLoops loops;
    std::vector<PointD> corners;
    constexpr PointD kCentres[] = {{3.5e6, 1.5e6}, {0.5e6, 1.5e6}, {0.5e6, 0.5e6}, {3.5e6, 0.5e6}};
    for (int corner = 0; corner < 4; ++corner) {
        for (int i = 0; i <= chords; ++i) {
            corners.push_back(onCircle(kCentres[corner], 0.5e6, (corner + double(i) / chords) * std::numbers::pi / 2));
        }
    }
    for (std::size_t i = 0; i < corners.size(); ++i) {
        loops.addLine(corners[i], corners[(i + 1) % corners.size()]);
    }
    loops.endLoop();
    return loops;
}

}  // namespace

class FitArcsTest : public QObject {
    Q_OBJECT

private slots:
    void roundedCornersBecomeArcs() {
        const EdgeLoops chords = roundedByChords(12);
        const EdgeLoops fitted = model::withFittedArcs(chords, 5'000.0);
        QCOMPARE(fitted.edges.size(), std::size_t{8});
        QVERIFY(edge_loop_checks::areSound(fitted));
        for (const model::Edge& edge : chords.edges) {  // its corners lie on the new outline
            double nearest = 1e9;
            for (const model::Edge& other : fitted.edges) {
                const PointD on = model::nearestOn(other, edge.a);
                nearest = std::min(nearest, std::hypot(on.x - edge.a.x, on.y - edge.a.y));
            }
            QVERIFY(nearest < 2.0);
        }
        const double exact = 8e12 - (4 - std::numbers::pi) * 0.25e12;
        QVERIFY(std::abs(model::areaOf(fitted) / exact - 1.0) < 1e-6);
    }

    void chordsThatAreFurtherAwayStay() {
        const EdgeLoops coarse = roundedByChords(3);  // 17 um between chord and arc
        QCOMPARE(model::withFittedArcs(coarse, 5'000.0).edges.size(), coarse.edges.size());
        QVERIFY(model::withFittedArcs(coarse, 50'000.0).edges.size() < coarse.edges.size());
    }

    void holesOfChordsBecomeCircles() {
        EdgeLoops region;
        region.addLine({-2e6, -2e6}, {2e6, -2e6});
        region.addLine({2e6, -2e6}, {2e6, 2e6});
        region.addLine({2e6, 2e6}, {-2e6, 2e6});
        region.addLine({-2e6, 2e6}, {-2e6, -2e6});
        region.endLoop();
        for (int i = 0; i < 32; ++i) {
            region.addLine(onCircle({}, 0.6e6, 2 * std::numbers::pi * i / 32),
                           onCircle({}, 0.6e6, 2 * std::numbers::pi * ((i + 1) % 32) / 32));
        }
        region.endLoop();
        const EdgeLoops fitted = model::withFittedArcs(region, 5'000.0);
        QCOMPARE(fitted.edges.size(), std::size_t{5});
        QVERIFY(fitted.edges.back().isFullCircle());
        QVERIFY(std::abs(fitted.edges.back().radius - 0.6e6) < 2.0);
    }

    void straightOutlinesStay() {
        EdgeLoops zigzag;
        for (int i = 0; i < 40; ++i) {
            const auto at = [](int k) { return PointD{k * 1e5, k % 2 == 0 ? 0.0 : 3e4}; };
            zigzag.addLine(at(i), at(i + 1));
        }
        zigzag.addLine({40e5, 0.0}, {20e5, -1e6});
        zigzag.addLine({20e5, -1e6}, {0.0, 0.0});
        zigzag.endLoop();
        QCOMPARE(model::withFittedArcs(zigzag, 5'000.0).edges.size(), zigzag.edges.size());
    }
};

QTEST_APPLESS_MAIN(FitArcsTest)
#include "fit_arcs_test.moc"
