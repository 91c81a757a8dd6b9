// How deep figures lie in each other: exactly where both are convex, never too deep elsewhere, and right about
// touching.
#include "model/figures/overlap.h"

#include <QtTest>
#include <array>
#include <cmath>
#include <random>

#include "model/board/document_builder.h"
#include "model/figures/distance.h"

using namespace model;

namespace {

constexpr Nm kMm = 1'000'000;

class LayerGeometry {
public:
    LayerGeometry() { m_builder.beginLayer(m_builder.addLayer({})); }
    ElementId circle(Point centre, Nm diameter, Nm inner = 0) {
        return m_builder.addCircle({centre, diameter, inner}, {});
    }
    ElementId line(Point a, Point b, Nm width) { return m_builder.addLine({a, b, width, 0}, {}); }
    ElementId area(const ShapeSketch& sketch, const Placement& placement = {}) {
        return m_builder.addArea({m_builder.addShape(sketch), placement}, {});
    }
    ElementId rectangle(Point min, Point max) {
        ShapeSketch sketch;
        sketch.addPolygon(std::array<Point, 4>{{min, {max.x, min.y}, max, {min.x, max.y}}}, false);
        return area(sketch);
    }
    /// A rectangle whose corners are quarter circles.
    ElementId rounded(Point min, Point max, Nm radius) {
        ShapeSketch s;
        s.beginContour(false);
        const auto corner = [&](Point from, Point centre) { s.addNode({from, centre, EdgeKind::ArcCounterClockwise}); };
        s.addNode(Point{min.x + radius, min.y});
        corner({max.x - radius, min.y}, {max.x - radius, min.y + radius});
        s.addNode(Point{max.x, min.y + radius});
        corner({max.x, max.y - radius}, {max.x - radius, max.y - radius});
        s.addNode(Point{max.x - radius, max.y});
        corner({min.x + radius, max.y}, {min.x + radius, max.y - radius});
        s.addNode(Point{min.x, max.y - radius});
        corner({min.x, min.y + radius}, {min.x + radius, min.y + radius});
        return area(s);
    }
    /// Concave: a square without its right upper quarter.
    ElementId corner(Point at, Nm size) {
        ShapeSketch s;
        const Nm h = size / 2;
        s.addPolygon(std::array<Point, 6>{{at,
                                           {at.x + size, at.y},
                                           {at.x + size, at.y + h},
                                           {at.x + h, at.y + h},
                                           {at.x + h, at.y + size},
                                           {at.x, at.y + size}}},
                     false);
        return area(s);
    }
    [[nodiscard]] Overlap overlap(ElementId a, ElementId b) const {
        FigureTable first;
        FigureTable second;
        first.add(m_builder.soFar(), a);
        second.add(m_builder.soFar(), b);
        const auto gap = spacingBetween(first, 0, second, 0, kTouchNm);
        return gap ? overlapBetween(first, 0, second, 0, gap->from) : Overlap{-1.0, true};
    }
    [[nodiscard]] const DocumentBuilder& builder() const { return m_builder; }

private:
    DocumentBuilder m_builder;
};

bool isNear(double a, double b, double within = 1e-3) {
    return std::abs(a - b) <= within;
}

}  // namespace

class OverlapTest : public QObject {
    Q_OBJECT

private slots:
    void dotsOverlapByRadiiLessDistance() {
        LayerGeometry s;
        const Overlap o = s.overlap(s.circle({0, 0}, 2 * kMm), s.circle({3 * kMm / 2, 0}, 2 * kMm));
        QVERIFY(o.isExact && isNear(o.depth, 0.5 * kMm));
        QVERIFY(isNear(s.overlap(s.circle({0, 0}, 2 * kMm), s.circle({0, 0}, kMm)).depth, 1.5 * kMm));
    }

    void latticeCasesAreExact() {
        // On the left of x = 0, and a wall that begins at `shift`: negative ones overlap by that much.
        LayerGeometry s;
        const std::vector<ElementId> convex = {s.circle({-kMm, 0}, 2 * kMm), s.line({-5 * kMm, 0}, {-kMm, 0}, 2 * kMm),
                                               s.rectangle({-4 * kMm, -kMm}, {0, kMm}),
                                               s.rounded({-4 * kMm, -kMm}, {0, kMm}, 500'000)};
        const std::vector<ElementId> others = {s.circle({-3 * kMm, 0}, 6 * kMm, 4 * kMm),
                                               s.corner({-2 * kMm, -kMm}, 2 * kMm)};
        for (const Nm shift : {0, 1, 1000, 200'000}) {
            for (const ElementId wall : {s.rectangle({-shift, -20 * kMm}, {9 * kMm, 20 * kMm}),
                                         s.line({500'000 - shift, -20 * kMm}, {500'000 - shift, 20 * kMm}, kMm)}) {
                for (const ElementId left : convex) {
                    const Overlap o = s.overlap(left, wall);
                    QVERIFY2(o.isExact && isNear(o.depth, shift),
                             qPrintable(QString("%1 by %2: %3").arg(left.value).arg(shift).arg(o.depth)));
                    QVERIFY(isNear(s.overlap(wall, left).depth, o.depth, 1e-6));
                }
                for (const ElementId left : others) {
                    const Overlap o = s.overlap(left, wall);
                    QVERIFY(!o.isExact);
                    QVERIFY2(o.depth <= shift + 1e-3 && (o.depth > kTouchNm) == (shift > 0),
                             qPrintable(QString("%1 by %2: %3").arg(left.value).arg(shift).arg(o.depth)));
                }
            }
        }
    }

    void crossingStrokesHaveToLeaveOverTheNearestEnd() {
        LayerGeometry s;
        // A cross of two strokes 0.2 mm wide; one reaches 1 mm beyond the other.
        const ElementId lying = s.line({-5 * kMm, 0}, {5 * kMm, 0}, 200'000);
        QVERIFY(isNear(s.overlap(lying, s.line({0, -kMm}, {0, 4 * kMm}, 200'000)).depth, kMm + 200'000));
        // A dot deep in a rectangle leaves over the nearest side.
        const ElementId plate = s.rectangle({0, 0}, {10 * kMm, 4 * kMm});
        QVERIFY(isNear(s.overlap(plate, s.circle({5 * kMm, kMm}, kMm)).depth, 1.5 * kMm));
    }

    void concaveFiguresThatFitTogetherTouch() {
        LayerGeometry s;
        const ElementId corner = s.corner({0, 0}, 4 * kMm);
        // Right in the notch, then a nanometre into it.
        const Overlap fits = s.overlap(corner, s.corner({2 * kMm, 2 * kMm}, 3 * kMm));
        QVERIFY2(fits.depth <= kTouchNm, qPrintable(QString::number(fits.depth)));
        const Overlap pinches = s.overlap(corner, s.corner({2 * kMm - 1, 2 * kMm}, 3 * kMm));
        QVERIFY2(pinches.depth > kTouchNm && pinches.depth < 1.01, qPrintable(QString::number(pinches.depth)));
        QVERIFY(s.overlap(corner, s.circle({kMm, kMm}, 10)).depth > 1e6);  // wholly inside
    }

    void movingByTheDepthIsJustEnough() {
        // Convex pairs at random: moved by its depth in no direction less, in one enough.
        std::mt19937 random(3);
        std::uniform_int_distribution<Nm> place(-kMm, kMm);
        int overlapping = 0;
        for (int round = 0; round < 200; ++round) {
            LayerGeometry s;
            const auto made = [&]() {
                const Point a{place(random), place(random)};
                switch (random() % 3) {
                    case 0: return s.circle(a, kMm);
                    case 1: return s.line(a, {place(random), place(random)}, kMm / 2);
                    default: return s.rectangle(a, {a.x + kMm, a.y + kMm / 2});
                }
            };
            const ElementId a = made();
            const ElementId b = made();
            const Overlap o = s.overlap(a, b);
            if (o.depth <= kTouchNm) {
                continue;
            }
            ++overlapping;
            QVERIFY(o.isExact);
            bool isFreed = false;
            FigureTable still;
            still.add(s.builder().soFar(), a);
            for (int i = 0; i < 720; ++i) {
                const double angle = i * 3.14159265358979 / 360;
                const auto gapAfter = [&](double way) {
                    FigureTable moved;
                    moved.add(
                        s.builder().soFar(), b,
                        {{static_cast<Nm>(way * std::cos(angle)), static_cast<Nm>(way * std::sin(angle))}, 0, false});
                    return spacingBetween(still, 0, moved, 0)->distance;
                };
                QVERIFY(gapAfter(o.depth - 2) <= 0.5);
                isFreed = isFreed || gapAfter(o.depth * 1.0001 + 50) > 0;
            }
            QVERIFY2(isFreed, qPrintable(QString("round %1").arg(round)));
        }
        QVERIFY(overlapping > 50);
    }
};

QTEST_APPLESS_MAIN(OverlapTest)
#include "overlap_test.moc"
