#include "model/geometry/loops/edge_union.h"

#include <QtMath>
#include <QtTest>
#include <algorithm>
#include <cmath>
#include <random>

#include "model/geometry/boolean.h"
#include "model/geometry/loops/edge_faults.h"
#include "tests/locations.h"
#include "tests/unit/model/geometry/edge_loop_checks.h"

using namespace edge_loop_checks;
using model::EdgeLoops;
using model::PointD;
using Regions = std::vector<EdgeLoops>;

namespace {

EdgeLoops polygon(std::initializer_list<PointD> points) {
    EdgeLoops loops;
    for (auto p = points.begin(); p != points.end(); ++p) {
        loops.addLine(*p, p + 1 == points.end() ? *points.begin() : p[1]);
    }
    loops.endLoop();
    return loops;
}

EdgeLoops box(double x, double y, double width, double height) {
    return polygon({{x, y}, {x + width, y}, {x + width, y + height}, {x, y + height}});
}

EdgeLoops disc(PointD centre, double radius) {
    EdgeLoops loops;
    loops.addCircle(centre, radius);
    return loops;
}

EdgeLoops ring(PointD centre, double outer, double inner) {
    EdgeLoops loops = disc(centre, outer);
    loops.addCircle(centre, inner);
    return loops;
}

EdgeLoops capsule(PointD a, PointD b, double radius) {
    EdgeLoops loops;
    loops.addCapsule(a, b, radius);
    return loops;
}

/// A quarter of a ring with half circles at its ends.
EdgeLoops bend(PointD centre, double radius, double pen) {
    EdgeLoops loops;
    const PointD outerA{centre.x + radius + pen, centre.y};
    const PointD outerB{centre.x, centre.y + radius + pen};
    const PointD innerB{centre.x, centre.y + radius - pen};
    const PointD innerA{centre.x + radius - pen, centre.y};
    loops.addArc(outerA, outerB, centre, false);
    loops.addArc(outerB, innerB, {centre.x, centre.y + radius}, false);
    loops.addArc(innerB, innerA, centre, true);
    loops.addArc(innerA, outerA, {centre.x + radius, centre.y}, false);
    loops.endLoop();
    return loops;
}

/// A disc without a sector, which ends at the angle 0: `sweep` in degrees.
EdgeLoops sector(double radius, double sweep) {
    const double angle = qDegreesToRadians(sweep);
    const PointD end = sweep == 270.0 ? PointD{0, -radius} : PointD{radius * std::cos(angle), radius * std::sin(angle)};
    EdgeLoops loops;
    loops.addArc({radius, 0}, end, {0, 0}, false);
    loops.addLine(end, {0, 0});
    loops.addLine({0, 0}, {radius, 0});
    loops.endLoop();
    return loops;
}

double areaOf(const Regions& regions) {
    double sum = 0.0;
    for (const EdgeLoops& region : regions) {
        sum += model::areaOf(region);
    }
    return sum;
}

std::size_t edgesOf(const Regions& regions) {
    std::size_t sum = 0;
    for (const EdgeLoops& region : regions) {
        sum += region.edges.size();
    }
    return sum;
}

bool areSoundRegions(const Regions& regions) {
    return std::ranges::all_of(regions,
                               [](const EdgeLoops& region) { return areSound(region) && !model::findFault(region); });
}

double discretisedArea(const Regions& regions, double chordNm) {
    model::PolygonSet all;
    for (const EdgeLoops& region : regions) {
        all.append(edge_loop_checks::polygonsOf(region, chordNm));
    }
    return edge_loop_checks::areaOf(model::unite(all));
}

EdgeLoops rotated(const EdgeLoops& loops) {
    return placed(loops, {{0, 0}, 90.0, false});
}

/// Copper as boards have it: tracks of few widths that start where others end, in eight directions, bends, pads.
Regions randomCopper(std::mt19937& random, int count) {
    const auto pick = [&](int from, int to) { return std::uniform_int_distribution<int>(from, to)(random); };
    Regions regions;
    PointD at{0, 0};
    constexpr PointD kDirections[8] = {{1, 0}, {1, 1}, {0, 1}, {-1, 1}, {-1, 0}, {-1, -1}, {0, -1}, {1, -1}};
    for (int i = 0; i < count; ++i) {
        const double pen = 50'000.0 * pick(1, 4);
        switch (pick(0, 5)) {
            case 0: regions.push_back(disc(at, pen * 1.5)); break;
            case 1: regions.push_back(box(at.x - pen, at.y - 2 * pen, 2 * pen, 4 * pen)); break;
            case 2: regions.push_back(bend(at, pen + 100'000.0 * pick(1, 8), pen)); break;
            case 3: regions.push_back(ring(at, 3 * pen, pen)); break;
            default: {
                const PointD direction = kDirections[pick(0, 7)];
                const double full = 25'000.0 * pick(0, 60);
                PointD to{at.x + direction.x * full, at.y + direction.y * full};
                if (pick(0, 3) == 0) {
                    to = {to.x + pick(-3, 3), to.y + pick(-90'000, 90'000)};
                }
                regions.push_back(capsule(at, to, pen));
                at = to;
            }
        }
        if (pick(0, 3) == 0) {
            at = {at.x + pick(-3, 3), at.y + pick(-3, 3)};  // as jobs round
        }
        if (pick(0, 9) == 0) {
            at = {50'000.0 * pick(-40, 40), 50'000.0 * pick(-40, 40)};
        }
    }
    return regions;
}

}  // namespace

class EdgeUnionTest : public QObject {
    Q_OBJECT

private slots:
    void nothing() {
        QVERIFY(model::unite(Regions{})->empty());
        QVERIFY(model::unite(Regions(3))->empty());
    }

    void apartStayApart() {
        const auto united = model::unite(Regions{disc({0, 0}, 1e5), box(2e5, 0, 1e5, 1e5)});
        QVERIFY(united && areSoundRegions(*united));
        QCOMPARE(united->size(), 2U);
        QCOMPARE(edgesOf(*united), 5U);
        QVERIFY(relative(areaOf(*united), kPi * 1e10 + 1e10) < 1e-12);
    }

    void twoDiscs() {
        const auto united = model::unite(Regions{disc({0, 0}, 1e5), disc({1e5, 0}, 1e5)});
        QVERIFY(united && areSoundRegions(*united));
        QCOMPARE(united->size(), 1U);
        QCOMPARE(edgesOf(*united), 2U);
        const double lens = 2 * kPi / 3 - std::sqrt(3.0) / 2;
        QVERIFY(relative(areaOf(*united), (2 * kPi - lens) * 1e10) < 1e-9);
    }

    void theSameTwice() {
        for (const EdgeLoops& region :
             {disc({1, 2}, 1e5), capsule({0, 0}, {4e5, 3e5}, 5e4), ring({0, 0}, 1e5, 3e4), box(0, 0, 9, 9)}) {
            const auto united = model::unite(Regions{region, region, region});
            QVERIFY(united && areSoundRegions(*united));
            QCOMPARE(united->size(), 1U);
            QCOMPARE(edgesOf(*united), region.edges.size());
            QVERIFY(relative(areaOf(*united), model::areaOf(region)) < 1e-12);
        }
    }

    /// Side lines are tangent to the circle that both tracks share.
    void tracksThatJoin() {
        const auto straight = model::unite(Regions{capsule({0, 0}, {1e6, 0}, 1e5), capsule({1e6, 0}, {3e6, 0}, 1e5)});
        QVERIFY(straight && areSoundRegions(*straight));
        QCOMPARE(edgesOf(*straight), 4U);
        QVERIFY(relative(areaOf(*straight), 3e6 * 2e5 + kPi * 1e10) < 1e-9);
        const auto corner = model::unite(Regions{capsule({0, 0}, {1e6, 0}, 1e5), capsule({1e6, 0}, {1e6, 1e6}, 1e5)});
        QVERIFY(corner && areSoundRegions(*corner));
        QCOMPARE(edgesOf(*corner), 7U);  // 4 sides, 2 ends, 1 round outside
        QVERIFY(relative(areaOf(*corner), 2 * (1e6 * 2e5 + kPi * 1e10) - kPi * 1e10 * 3 / 4 - 1e10) < 1e-9);
    }

    void bendBetweenTracks() {
        const auto united = model::unite(Regions{capsule({0, -1e6}, {0, 0}, 1e5), bend({-5e5, 0}, 5e5, 1e5),
                                                 capsule({-5e5, 5e5}, {-2e6, 5e5}, 1e5)});
        QVERIFY(united && areSoundRegions(*united));
        QCOMPARE(united->size(), 1U);
        QCOMPARE(edgesOf(*united), 8U);
        const double exact = 1e6 * 2e5 + 1.5e6 * 2e5 + kPi / 2 * 5e5 * 2e5 + kPi * 1e10;
        QVERIFY(relative(areaOf(*united), exact) < 1e-9);
    }

    void framesHaveHoles() {
        const auto united = model::unite(
            Regions{box(0, 0, 9e5, 1e5), box(0, 8e5, 9e5, 1e5), box(0, 0, 1e5, 9e5), box(8e5, 0, 1e5, 9e5)});
        QVERIFY(united && areSoundRegions(*united));
        QCOMPARE(united->size(), 1U);
        QCOMPARE(united->front().loopCount(), 2U);
        QCOMPARE(edgesOf(*united), 8U);
        QCOMPARE(areaOf(*united), 81e10 - 49e10);
    }

    void islandsInHoles() {
        const auto united = model::unite(Regions{ring({0, 0}, 9e5, 8e5), ring({0, 0}, 5e5, 4e5), disc({0, 0}, 1e5),
                                                 disc({3e6, 0}, 1e5), ring({3e6, 0}, 3e5, 2e5)});
        QVERIFY(united && areSoundRegions(*united));
        QCOMPARE(united->size(), 5U);
        QVERIFY(relative(areaOf(*united), kPi * 1e10 * (17 + 9 + 1 + 1 + 5)) < 1e-12);
    }

    void holesThatAreFilledVanish() {
        const auto united = model::unite(Regions{ring({0, 0}, 9e5, 8e5), disc({0, 0}, 8e5)});
        QVERIFY(united && areSoundRegions(*united));
        QCOMPARE(united->size(), 1U);
        QCOMPARE(edgesOf(*united), 1U);
    }

    void boxesSideBySide() {
        const auto united =
            model::unite(Regions{box(0, 0, 1e5, 1e5), box(1e5, 0, 1e5, 1e5), box(2e5 + 1, 0, 1e5, 1e5)});
        QVERIFY(united && areSoundRegions(*united));  // a spacing of 1 nm closes
        QCOMPARE(united->size(), 1U);
        QCOMPARE(edgesOf(*united), 4U);
        QVERIFY(relative(areaOf(*united), 3e10) < 2e-5);
    }

    void discsThatTouchAtAPoint() {
        const auto united = model::unite(Regions{disc({0, 0}, 1e5), disc({2e5, 0}, 1e5)});
        QVERIFY(united && areSoundRegions(*united));
        QCOMPARE(united->size(), 2U);
        QVERIFY(relative(areaOf(*united), 2 * kPi * 1e10) < 1e-4);
    }

    void cleaned_data() {
        QTest::addColumn<Regions>("region");
        QTest::addColumn<int>("regions");
        QTest::addColumn<int>("loops");
        QTest::addColumn<double>("area");
        const auto row = [](const char* name, const EdgeLoops& region, int regions, int loops, double area) {
            QTest::newRow(name) << Regions{region} << regions << loops << area;
        };
        row("a square", box(0, 0, 90, 90), 1, 1, 8100);
        row("a keyhole",
            polygon({{0, 0},
                     {900, 0},
                     {900, 900},
                     {0, 900},
                     {0, 500},
                     {200, 500},
                     {400, 700},
                     {600, 500},
                     {400, 300},
                     {200, 500},
                     {0, 500}}),
            1, 2, 810'000 - 80'000);
        row("a spike without width",
            polygon({{0, 0}, {900, 0}, {900, 900}, {500, 900}, {500, 2000}, {500, 900}, {0, 900}}), 1, 1, 810'000);
        row("a bow tie", polygon({{0, 0}, {900, 900}, {900, 0}, {0, 600}}), 1, 1, 243'000);
        row("a pinch", polygon({{0, 0}, {900, 0}, {450, 450}, {900, 900}, {0, 900}, {450, 450}}), 2, 2, 405'000);
        EdgeLoops holes = box(0, 0, 900, 900);
        for (const double x : {100.0, 400.0}) {
            holes.addLine({x, 100}, {x + 300, 100});
            holes.addLine({x + 300, 100}, {x + 300, 800});
            holes.addLine({x + 300, 800}, {x, 800});
            holes.addLine({x, 800}, {x, 100});
            holes.endLoop();
        }
        row("holes side by side", holes, 1, 2, 810'000 - 420'000);
        EdgeLoops touching = disc({0, 0}, 1e5);
        touching.addCircle({4e4, 0}, 5e4);
        row("a hole inside", touching, 1, 2, kPi * (1e10 - 25e8));
        EdgeLoops biting = disc({0, 0}, 1e5);
        biting.addCircle({1e5, 0}, 1e5);
        const double lens = (2 * kPi / 3 - std::sqrt(3.0) / 2) * 1e10;
        row("a hole over the edge", biting, 1, 1, kPi * 1e10 - lens);
    }
    void cleaned() {
        QFETCH(Regions, region);
        QFETCH(int, regions);
        QFETCH(int, loops);
        QFETCH(double, area);
        const auto clean = model::cleaned(region.front());
        QVERIFY(clean.has_value());
        for (const EdgeLoops& part : *clean) {
            const auto fault = model::findFault(part);
            QVERIFY2(!fault, fault ? fault->what.c_str() : "");
        }
        QVERIFY(areSoundRegions(*clean));
        QCOMPARE(static_cast<int>(clean->size()), regions);
        int found = 0;
        for (const EdgeLoops& part : *clean) {
            found += static_cast<int>(part.loopCount());
        }
        QCOMPARE(found, loops);
        QVERIFY2(std::abs(areaOf(*clean) - area) <= 6 * lengthOf(region.front()) * 0.1,
                 qPrintable(QString::number(areaOf(*clean), 'g', 15)));
    }

    void differences() {
        const auto slot =
            model::subtract(Regions{capsule({0, 0}, {1e6, 0}, 2e5)}, Regions{capsule({0, 0}, {1e6, 0}, 1e5)});
        QVERIFY(slot && areSoundRegions(*slot));
        QCOMPARE(slot->size(), 1U);
        QCOMPARE(slot->front().loopCount(), 2U);
        QVERIFY(relative(areaOf(*slot), 1e6 * 2e5 + kPi * 3e10) < 1e-12);
        const auto cut = model::subtract(Regions{box(0, 0, 9e5, 1e5)}, Regions{box(4e5, -1e5, 1e5, 9e5)});
        QVERIFY(cut && areSoundRegions(*cut));
        QCOMPARE(cut->size(), 2U);
        QCOMPARE(areaOf(*cut), 8e10);
    }

    void arcsThatStartAtAnExtremeEndWhereTheyEnd_data() {
        QTest::addColumn<double>("sweep");
        for (const double sweep : {90.0, 180.0, 269.0, 270.0, 271.0, 300.0, 359.0}) {
            QTest::addRow("%g degrees", sweep) << sweep;
        }
    }
    void arcsThatStartAtAnExtremeEndWhereTheyEnd() {
        QFETCH(double, sweep);
        const EdgeLoops large = sector(1e6, sweep);
        const EdgeLoops small = box(100'000, 1'000, 100'000, 100'000);
        const auto left = model::subtract({&large, 1}, {&small, 1});
        QVERIFY(left && areSoundRegions(*left));
        QVERIFY(relative(areaOf(*left), model::areaOf(large) - 1e10) < 1e-6);
        const Regions both{large, box(100'000, 1'000, 100'000, 2e6)};
        const auto united = model::unite(both);
        const auto rest = united ? model::subtract(*united, {both.data() + 1, 1}) : std::nullopt;
        QVERIFY(rest && areSoundRegions(*rest));
        const auto same = model::subtract({&large, 1}, {both.data() + 1, 1});
        QVERIFY(same && relative(areaOf(*rest), areaOf(*same)) < 1e-6);
    }

    void whatIsOnNoBoardHasNoUnion() {
        EdgeLoops loops = box(0, 0, 1e5, 1e5);
        loops.edges[1].b.x = loops.edges[2].a.x = std::nan("");
        QVERIFY(!model::cleaned(loops));
        QVERIFY(!model::unite(Regions{loops, box(0, 0, 9, 9)}));
        QVERIFY(!model::unite(Regions{box(0, 0, 1e5, 1e5), box(1, 1, 1e10, 1)}));
        QVERIFY(!model::subtract(Regions{disc({0, 0}, 1e5)}, Regions{disc({1e9, 0}, 1e9)}));
    }

    void randomUnions() {
        std::mt19937 random(11);
        int left = 0;
        const int kCases = locations::isThorough() ? 5000 : 200;
        constexpr double kChordNm = 20.0;
        for (int i = 0; i < kCases; ++i) {
            Regions regions = randomCopper(random, 2 + i % 40);
            const auto united = model::unite(regions);
            if (!united) {
                ++left;
                continue;
            }
            QVERIFY2(areSoundRegions(*united), qPrintable(QString::number(i)));
            double length = 0.0;
            for (const EdgeLoops& region : regions) {
                length += lengthOf(region);
            }
            const double polygons = discretisedArea(regions, kChordNm);
            const double difference = areaOf(*united) - polygons;
            QVERIFY2(
                difference > -4 * length && difference < kChordNm * length,
                qPrintable(
                    QString("case %1: %2 of %3, %4 nm").arg(i).arg(difference).arg(polygons).arg(difference / length)));
            QVERIFY(edgesOf(*united) <= 6 * regions.size() * regions.size());

            std::ranges::shuffle(regions, random);
            const auto shuffled = model::unite(regions);
            QVERIFY(shuffled && relative(areaOf(*shuffled), areaOf(*united)) < 1e-9);
            std::ranges::transform(regions, regions.begin(), rotated);
            const auto turned = model::unite(regions);
            QVERIFY(turned && areSoundRegions(*turned));
            QVERIFY2(relative(areaOf(*turned), areaOf(*united)) < 1e-5,
                     qPrintable(QString("%1: %2").arg(i).arg(relative(areaOf(*turned), areaOf(*united)))));
        }
        QCOMPARE(left, 0);
    }

    void linesInAnyOrderEncloseTheSame() {
        // A box, a smaller one that is drawn up to its side only, a line across all, one that covers part of a side,
        // a circle over a corner, and one of its own within.
        EdgeLoops drawing = box(0, 0, 1000, 600);
        const std::array<std::array<PointD, 2>, 5> lines = {{{{{1000, 100}, {1300, 100}}},
                                                             {{{1300, 100}, {1300, 500}}},
                                                             {{{1300, 500}, {1000, 500}}},
                                                             {{{-200, 300}, {1500, 300}}},
                                                             {{{800, 0}, {200, 0}}}}};
        for (const auto& [a, b] : lines) {
            drawing.addLine(a, b);
        }
        drawing.addCircle({0, 600}, 100);
        drawing.addCircle({300, 150}, 50);
        const double area = 600e3 + 300.0 * 400.0 + 0.75 * M_PI * 1e4;
        std::mt19937 random(3);
        for (int i = 0; i < 50; ++i) {
            std::ranges::shuffle(drawing.edges, random);
            for (model::Edge& edge : drawing.edges) {
                edge = random() % 2 == 0 ? edge : model::reversed(edge);
            }
            const auto enclosed = model::enclosedBy(drawing.edges);
            QVERIFY(enclosed);
            QCOMPARE(enclosed->size(), std::size_t{2});
            const double outer = std::max(areaOf(enclosed->front()), areaOf(enclosed->back()));
            QVERIFY(std::abs(outer - area) < 1.0);
        }
    }

    void openLinesEncloseNothing() {
        EdgeLoops drawing = polygon({{0, 0}, {1000, 0}, {1000, 1000}});
        drawing.edges.pop_back();
        const auto enclosed = model::enclosedBy(drawing.edges);
        QVERIFY(enclosed && enclosed->empty());
        QVERIFY(model::enclosedBy({})->empty());
    }
};

QTEST_APPLESS_MAIN(EdgeUnionTest)
#include "edge_union_test.moc"
