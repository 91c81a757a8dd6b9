// Areas with NURBS edges in everything that measures and draws, against dense samples of the curves themselves.
#include <QtTest>
#include <cmath>
#include <limits>
#include <random>

#include "model/board/single_element.h"
#include "model/figures/distance.h"
#include "model/figures/element_polygons.h"
#include "model/geometry/curve_edges.h"
#include "model/geometry/curve_queries.h"
#include "model/geometry/outlines.h"
#include "model/geometry/vectors.h"
#include "model/measure/edge_at.h"
#include "model/measure/snapping.h"
#include "model/section/line_cut.h"
#include "model/solids/cutouts.h"
#include "model/statistics/element_sizes.h"
#include "tests/unit/model/figures/element_spacing.h"
#include "tests/unit/model/geometry/some_curves.h"
#include "tests/unit/model/measure/measure_fixture.h"

using namespace model;
using namespace measuring;
using model::testing::circleCurve;

namespace {

constexpr double kPi = 3.14159265358979323846;

/// One area: a closed outline of a few curves of different degrees that winds once around 0, 0, with a straight side
/// and a round hole, laid down somewhere.
struct CurvedArea {
    std::vector<Nurbs> curves;  ///< in their own coordinates; the last one is the hole
    ShapeSketch sketch;
    Placement placement;

    CurvedArea(std::mt19937_64& random, double radius, const Placement& at) : placement(at) {
        constexpr int kCurves = 3;
        const auto number = [&](double low, double high) { return std::uniform_real_distribution(low, high)(random); };
        const auto around = [&](double turn) {
            const double reach = radius * number(0.6, 1.0);
            return rounded({reach * std::cos(2 * kPi * turn), reach * std::sin(2 * kPi * turn)});
        };
        std::vector<Point> ends;
        for (int i = 0; i <= kCurves; ++i) {
            ends.push_back(around(static_cast<double>(i) / (kCurves + 1)));
        }
        sketch.beginContour(false);
        for (int i = 0; i < kCurves; ++i) {
            const int degree = 2 + i;
            const int controls = degree + 5;
            Nurbs curve = model::testing::randomCurve(random, degree, controls, 1.0);
            for (int k = 1; k + 1 < controls; ++k) {
                curve.controls[static_cast<std::size_t>(k)].at =
                    base::toDouble(around((i + static_cast<double>(k) / (controls - 1)) / (kCurves + 1)));
            }
            curve.controls.front().at = base::toDouble(ends[static_cast<std::size_t>(i)]);
            curve.controls.back().at = base::toDouble(ends[static_cast<std::size_t>(i) + 1]);
            sketch.addCurve(ends[static_cast<std::size_t>(i)], curve.view(), ends[static_cast<std::size_t>(i) + 1]);
            curves.push_back(curve);
        }
        sketch.addNode(ends.back());
        curves.push_back(circleCurve({0, 0}, std::floor(radius / 5)));
        const Point start{static_cast<Nm>(radius / 5), 0};
        sketch.beginContour(true);
        sketch.addCurve(start, curves.back().view(), start);
    }

    /// A curve where it lies on the board.
    [[nodiscard]] Nurbs laid(std::size_t row) const {
        Nurbs curve = curves[row];
        for (ControlPoint& control : curve.controls) {
            control.at = placement.apply(control.at);
        }
        return curve;
    }
    /// All of its edges on the board as Bézier pieces, the straight one too.
    [[nodiscard]] std::vector<std::vector<Bezier>> pieces() const {
        std::vector<std::vector<Bezier>> all;
        for (std::size_t i = 0; i < curves.size(); ++i) {
            all.push_back(bezierPieces(laid(i).view()));
        }
        const Nurbs side{1, {0, 0, 1, 1}, {{all[2].back().end(), 1}, {all[0].front().start(), 1}}};
        all.push_back(bezierPieces(side.view()));
        return all;
    }
    [[nodiscard]] std::vector<PointD> samples(int perCurve) const {
        std::vector<PointD> points;
        for (const auto& curve : pieces()) {
            for (int i = 0; i < perCurve; ++i) {
                points.push_back(
                    pointAt(curve, curve.front().from() + (curve.back().to() - curve.front().from()) * i / perCurve));
            }
        }
        return points;
    }
    [[nodiscard]] bool covers(PointD p) const {
        const auto all = pieces();
        int island = 0;
        for (const std::size_t i : {0U, 1U, 2U, 4U}) {
            island += windingAround(all[i], p);
        }
        return island != 0 && windingAround(all[3], p) == 0;
    }
};

OnCurve nearestTo(const std::vector<std::vector<Bezier>>& curves, PointD p) {
    OnCurve nearest;
    nearest.distance = std::numeric_limits<double>::infinity();
    for (const auto& curve : curves) {
        const OnCurve own = nearestOn(curve, p);
        nearest = own.distance < nearest.distance ? own : nearest;
    }
    return nearest;
}

ElementId addTo(DocumentBuilder& builder, const CurvedArea& area) {
    return builder.addArea({builder.addShape(area.sketch), area.placement}, {});
}

std::vector<PickLayer> layersOf(const Document& board) {
    std::vector<PickLayer> layers;
    for (const Layer& layer : board.layers) {
        layers.push_back({true, double(layer.z), double(layer.z) + layer.thickness});
    }
    return layers;
}

const Placement kPlacements[] = {{{0, 0}, 0, false},
                                 {{3 * kMm, -2 * kMm}, 90, false},
                                 {{-5 * kMm, 7 * kMm}, 33.3, false},
                                 {{123'456'789, 1'234}, 200.1, true}};

}  // namespace

class CurvesTest : public QObject {
    Q_OBJECT

private slots:
    void distancesBetweenAreasAreThoseOfSamples() {
        std::mt19937_64 random(1);
        for (Placement at : kPlacements) {
            const CurvedArea a(random, 1e6, at);
            at.origin.x += 2'100'000;
            at.clockwiseDeg += 71;
            const CurvedArea b(random, 1e6, at);
            DocumentBuilder builder;
            addLayers(builder);
            builder.beginLayer(LayerId{Top});
            const ElementId first = addTo(builder, a);
            const ElementId second = addTo(builder, b);
            const auto board = builder.finish();
            const auto found = figure_testing::spacingBetween(*board, first, second);
            QVERIFY(found && found->distance > 0);
            const auto others = b.pieces();
            const auto own = a.pieces();
            PointD p = own[0].front().start();
            for (const PointD each : a.samples(400)) {
                p = nearestTo(others, each).distance < nearestTo(others, p).distance ? each : p;
            }
            // From one curve to the other and back, to where they are nearest.
            for (int step = 0; step < 200; ++step) {
                p = nearestTo(own, nearestTo(others, p).point).point;
            }
            const double expected = nearestTo(others, p).distance;
            QVERIFY2(std::abs(found->distance - expected) < 0.55,
                     qPrintable(QString::number(found->distance - expected)));
            QVERIFY(nearestTo(a.pieces(), found->from).distance <= kMeasured + 1e-3);
            QVERIFY(nearestTo(others, found->to).distance <= kMeasured + 1e-3);
        }
    }

    void distancesToTracksAreThoseOfTheCurve() {
        std::mt19937_64 random(2);
        for (const Placement& at : kPlacements) {
            const CurvedArea area(random, 1e6, at);
            const Point centre = at.origin;
            DocumentBuilder builder;
            addLayers(builder);
            builder.beginLayer(LayerId{Top});
            const ElementId own = addTo(builder, area);
            std::vector<ElementId> discs;
            std::vector<Point> middles;
            for (int i = 0; i < 24; ++i) {
                middles.push_back({centre.x + static_cast<Nm>(1.3e6 * std::cos(i * kPi / 12)),
                                   centre.y + static_cast<Nm>(1.3e6 * std::sin(i * kPi / 12))});
                discs.push_back(builder.addCircle({middles.back(), 100'000, 0}, {}));
            }
            const auto board = builder.finish();
            const auto pieces = area.pieces();
            for (std::size_t i = 0; i < discs.size(); ++i) {
                const double found = figure_testing::spacingBetween(*board, own, discs[i])->distance;
                const double expected = nearestTo(pieces, base::toDouble(middles[i])).distance - 50'000;
                QVERIFY2(std::abs(found - expected) < 0.26, qPrintable(QString::number(found - expected)));
            }
        }
    }

    void insideIsWhatTheCurvesWindAround() {
        std::mt19937_64 random(3);
        int inside = 0;
        for (const Placement& at : kPlacements) {
            const CurvedArea area(random, 1e6, at);
            DocumentBuilder builder;
            builder.beginLayer(builder.addLayer({}));
            const ElementId own = addTo(builder, area);
            const auto board = builder.finish();
            FigureTable figures;
            figures.add(*board, own);
            const auto pieces = area.pieces();
            std::uniform_real_distribution<double> place(-1.1e6, 1.1e6);
            for (int i = 0; i < 300; ++i) {
                const PointD p = {at.origin.x + place(random), at.origin.y + place(random)};
                if (nearestTo(pieces, p).distance > 1.0) {
                    QCOMPARE(isInside(figures, 0, p), area.covers(p));
                    inside += area.covers(p) ? 1 : 0;
                }
            }
        }
        QVERIFY(inside > 200);
    }

    void sectionsPassWhereTheCurvesDo() {
        std::mt19937_64 random(4);
        std::size_t ends = 0;
        for (const Placement& at : kPlacements) {
            const CurvedArea area(random, 1e6, at);
            DocumentBuilder builder;
            builder.beginLayer(builder.addLayer({}));
            const ElementId own = addTo(builder, area);
            const auto board = builder.finish();
            std::uniform_real_distribution<double> place(-1.5e6, 1.5e6);
            for (int i = 0; i < 60; ++i) {
                const PointD a = {at.origin.x + place(random), at.origin.y + place(random)};
                const PointD b = {at.origin.x + place(random), at.origin.y + place(random)};
                const CutLine line = CutLine::through(a, b);
                const ElementCut cut = cutElement(*board, own, line);
                const auto pointOnLine = [&](double t) {
                    return PointD{line.origin.x + line.unit.x * t, line.origin.y + line.unit.y * t};
                };
                Edge whole;
                whole.a = pointOnLine(-6e6);
                whole.b = pointOnLine(6e6);
                std::vector<double> expected;
                bool isGrazing = false;
                for (const auto& curve : area.pieces()) {
                    for (const OnCurve& crossing : crossingsOf(curve, whole)) {
                        expected.push_back(line.along(crossing.point));
                        const auto piece = std::ranges::find_if(
                            curve, [&](const Bezier& each) { return crossing.parameter <= each.to(); });
                        const PointD along = piece->at(crossing.parameter).first;
                        isGrazing = isGrazing || std::abs(cross(line.unit, along)) < 0.5 * length(along);
                    }
                }
                std::ranges::sort(expected);
                if (isGrazing) {
                    continue;  // there a quarter of a nanometre across is more along the line
                }
                std::vector<double> found;
                for (const Interval& interval : cut.covered) {
                    found.insert(found.end(), {interval.from, interval.to});
                }
                QCOMPARE(found.size(), expected.size());
                for (std::size_t k = 0; k < found.size(); ++k) {
                    QVERIFY(std::abs(found[k] - expected[k]) <= 2 * kMeasured + 1e-3);
                }
                ends += found.size();
            }
        }
        QVERIFY(ends > 40);
    }

    void polygonsStayWithinTheirTolerance_data() {
        QTest::addColumn<double>("tolerance");
        for (const double tolerance : {500.0, 5000.0, 50000.0}) {
            QTest::addRow("%g nm", tolerance) << tolerance;
        }
    }
    void polygonsStayWithinTheirTolerance() {
        QFETCH(double, tolerance);
        std::mt19937_64 random(5);
        for (const Placement& at : kPlacements) {
            const CurvedArea area(random, 1e6, at);
            DocumentBuilder builder;
            builder.beginLayer(builder.addLayer({}));
            const ElementId own = addTo(builder, area);
            const PolygonSet polygons = discretise(*builder.finish(), own, {tolerance, false});
            QCOMPARE(polygons.polygons.size(), 1U);
            QCOMPARE(polygons.loopCount(), 2U);
            std::vector<Edge> sides;
            for (std::size_t loop = 0; loop < 2; ++loop) {
                const auto points = polygons.loop(loop);
                for (std::size_t i = 0; i < points.size(); ++i) {
                    sides.push_back(edgeOf({points[i], {}, EdgeKind::Line}, points[(i + 1) % points.size()]));
                }
            }
            for (const PointD p : area.samples(800)) {
                double least = 1e9;
                for (const Edge& side : sides) {
                    least = std::min(least, distance(nearestOn(side, p), p));
                }
                QVERIFY2(least <= tolerance, qPrintable(QString::number(least)));
            }
        }
    }

    void boxesAndAreasAreThoseOfSamples() {
        std::mt19937_64 random(6);
        for (const Placement& at : kPlacements) {
            const CurvedArea area(random, 1e6, at);
            DocumentBuilder builder;
            builder.beginLayer(builder.addLayer({}));
            const ElementId own = addTo(builder, area);
            const auto board = builder.finish();
            PointD low = {1e18, 1e18};
            PointD high = {-1e18, -1e18};
            const std::vector<PointD> samples = area.samples(20'000);
            for (const PointD p : samples) {
                low = {std::min(low.x, p.x), std::min(low.y, p.y)};
                high = {std::max(high.x, p.x), std::max(high.y, p.y)};
            }
            const Box box = board->boxOf(own);
            // Placed ends are rounded.
            QVERIFY(std::abs(box.min.x - low.x) < 2.0 && std::abs(box.min.y - low.y) < 2.0);
            QVERIFY(std::abs(box.max.x - high.x) < 2.0 && std::abs(box.max.y - high.y) < 2.0);
            const auto twice = [&](std::size_t first, std::size_t end) {
                double sum = 0;
                for (std::size_t i = first; i + 1 < end; ++i) {
                    sum += cross(minus(samples[i], samples[first]), minus(samples[i + 1], samples[first]));
                }
                return sum;
            };
            const PointD end = area.pieces()[2].back().end();  // samples leave it out
            const double corner = cross(minus(samples[59'999], samples[0]), minus(end, samples[0]));
            const double outline = std::abs(twice(0, 60'000) + corner) / 2;
            const double hole = std::abs(twice(60'000, 80'000)) / 2;
            const double found = areaOf(*board, own);
            QVERIFY2(std::abs(found - (outline - hole)) < 1e-5 * outline,
                     qPrintable(QString("%1, not %2 - %3").arg(found).arg(outline).arg(hole)));
        }
    }

    void cursorsSnapToCurvesAndTheirEndsOnly() {
        std::mt19937_64 random(7);
        const CurvedArea area(random, 1e6, {});
        DocumentBuilder builder;
        addLayers(builder);
        builder.beginLayer(LayerId{Top});
        const ElementId own = addTo(builder, area);
        const auto index = indexed(builder.finish());
        Snapper snapper(index);
        const auto pieces = area.pieces();
        for (std::size_t curve = 0; curve < 3; ++curve) {
            const PointD start = pieces[curve].front().start();
            const SnapPoint atStart = snapper.at({start.x + 300, start.y - 200}, 1e3, layersOf(*index->board));
            QCOMPARE(atStart.kind, SnapKind::End);
            QVERIFY(distance(atStart.at, start) < 1e-3);
            for (const double share : {0.2, 0.37, 0.55, 0.8}) {
                const PointD on = pointAt(pieces[curve], pieces[curve].back().to() * share);
                const SnapPoint found = snapper.at({on.x + 150, on.y + 90}, 1e3, layersOf(*index->board));
                QCOMPARE(found.kind, SnapKind::Edge);
                QVERIFY(nearestTo(pieces, found.at).distance <= kMeasured + 1e-3);
                QVERIFY(!roundAt(*index, {0, own}, on, 1e3));
                QVERIFY(!straightAt(*index, {0, own}, on, 1e3));
            }
        }
    }

    void copiesKeepTheirCurves() {
        std::mt19937_64 random(8);
        const CurvedArea area(random, 1e6, {{5, 7}, 30, true});
        DocumentBuilder builder;
        builder.beginLayer(builder.addLayer({}));
        const ElementId own = addTo(builder, area);
        const auto board = builder.finish();
        const auto curvesOf = [](const PathNodes& path) {
            return std::ranges::count(path, EdgeKind::Curve, &PathNode::edge);
        };
        for (const Nm detail : {0, 1'000}) {
            const auto alone = elementAlone(*board, own, detail);
            const auto contours = alone->shapes.contoursOf(alone->areas[0].shape);
            QCOMPARE(curvesOf(alone->shapes.nodesOf(contours[0])), 3);
            QCOMPARE(curvesOf(alone->shapes.nodesOf(contours[1])), 1);
            QVERIFY(std::abs(areaOf(*alone, ElementId{0}) - areaOf(*board, own)) < 1.0);
        }
        Cutouts cutouts;
        cutouts.add(*board, own, {{1 * kMm, 0}, 45, false});
        ShapeSketch inverted;
        cutouts.addInverted(0, inverted);
        QCOMPARE(inverted.contourCount(), 2U);
        QVERIFY(inverted.isHole(0) && !inverted.isHole(1));
        QCOMPARE(curvesOf(inverted.contour(0)), 3);
        const Placement both = Placement{{1 * kMm, 0}, 45, false}.after(area.placement);
        const NurbsView moved = inverted.contour(0).curveAt(1);
        for (std::size_t i = 0; i < moved.controls.size(); ++i) {
            QVERIFY(distance(moved.controls[i].at, both.apply(area.curves[1].controls[i].at)) < 1.0);
        }
    }
};

QTEST_APPLESS_MAIN(CurvesTest)
#include "curves_test.moc"
