// Where lines pass elements of every kind, against the exact answer to "is this place covered?" at many places.
#include "model/section/line_cut.h"

#include <QtTest>
#include <random>

#include "model/board/document_builder.h"
#include "model/figures/distance.h"

using namespace model;

namespace {

constexpr Nm kMm = 1'000'000;

/// Random elements of every kind within 10 mm around the origin; coordinates fall on a coarse grid every other time, so
/// that lines through the grid run along edges and through vertices.
class Maker {
public:
    explicit Maker(unsigned seed) : m_random(seed) { m_builder.beginLayer(m_builder.addLayer({})); }

    Nm number(Nm low, Nm high) { return std::uniform_int_distribution<Nm>(low, high)(m_random); }
    Point point() {
        const Nm grid = number(0, 1) == 0 ? kMm : 1;
        return {number(-10 * kMm / grid, 10 * kMm / grid) * grid, number(-10 * kMm / grid, 10 * kMm / grid) * grid};
    }
    Nm width() { return number(1, 3) * kMm / 2 + number(0, 1) * number(0, 999); }
    EdgeKind turn() { return number(0, 1) == 0 ? EdgeKind::ArcClockwise : EdgeKind::ArcCounterClockwise; }
    Placement placement() {
        return {point(), number(0, 1) == 0 ? 90.0 * number(0, 3) : 0.001 * number(0, 359'999), number(0, 1) == 0};
    }

    ElementId line(std::uint8_t flags) {
        DocumentBuilder::Origin origin;
        origin.flags = flags;
        return m_builder.addLine({point(), number(0, 9) == 0 ? Point{} : point(), width(), 0}, origin);
    }
    ElementId tube() {
        DocumentBuilder::Origin origin;
        origin.flags = kHole | kPlated;
        const Nm outer = width();
        return m_builder.addLine({point(), point(), outer, outer - 100'000}, origin);
    }
    /// Ends on one circle up to rounding; now and then a full one.
    ElementId arc() {
        const Point centre = point();
        const double radius = number(1, 6) * 5e5;
        const auto end = [&] {
            const double angle = number(0, 3) == 0 ? 1.5707963267948966 * number(0, 3) : 1e-4 * number(0, 62831);
            return Point{centre.x + static_cast<Nm>(std::lround(radius * std::cos(angle))),
                         centre.y + static_cast<Nm>(std::lround(radius * std::sin(angle)))};
        };
        const Point a = end();
        return m_builder.addArc({PathNode{a, centre, turn()}, number(0, 4) == 0 ? a : end(), width()}, {});
    }
    ElementId circle() { return m_builder.addCircle({point(), width() * 2, 0}, {}); }
    ElementId ring() {
        const Nm outer = width() * 4;
        return m_builder.addCircle({point(), outer, outer / 2}, {});
    }
    ElementId trail() {
        std::vector<PathNode> nodes;
        for (Nm i = number(2, 5); i > 0; --i) {
            nodes.push_back({point(), {}, EdgeKind::Line});
        }
        return m_builder.addTrail(nodes, width(), {});
    }
    /// Two islands: a polygon with a round and a square hole, and a half disc.
    ElementId area() {
        ShapeSketch sketch;
        const Nm r = number(3, 7) * kMm;
        sketch.addPolygon(std::array<Point, 5>{{{-r, -r}, {r, -r}, {r, r}, {0, r + kMm}, {-r, r}}}, false);
        sketch.addCircle({-kMm, 0}, kMm, true);
        sketch.addPolygon(std::array<Point, 4>{{{kMm, 0}, {kMm, kMm}, {2 * kMm, kMm}, {2 * kMm, 0}}}, true);
        sketch.beginContour(false);
        sketch.addNode({{r + kMm, -2 * kMm}, {r + kMm, 0}, turn()});
        sketch.addNode(Point{r + kMm, 2 * kMm});
        return m_builder.addArea({m_builder.addShape(sketch), placement()}, {});
    }
    ElementId any(int kind) {
        switch (kind) {
            case 0: return line(0);
            case 1: return line(kSquarePen);
            case 2: return arc();
            case 3: return circle();
            case 4: return ring();
            case 5: return trail();
            case 6: return tube();
            default: return area();
        }
    }
    [[nodiscard]] const Document& document() const { return m_builder.soFar(); }

private:
    DocumentBuilder m_builder;
    std::mt19937 m_random;
};

constexpr int kKinds = 8;

bool contains(const Intervals& intervals, double at) {
    return std::ranges::any_of(intervals, [&](const Interval& i) { return i.from <= at && at <= i.to; });
}

bool isNearAnEnd(const Intervals& intervals, double at, double reach) {
    return std::ranges::any_of(
        intervals, [&](const Interval& i) { return std::abs(i.from - at) < reach || std::abs(i.to - at) < reach; });
}

/// How far the place is from the element; 0 inside.
double distanceTo(const FigureTable& figures, PointD location) {
    FigureTable probe;
    probe.addTrack(location, location, 0.0);
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t row = 0; row < figures.size(); ++row) {
        least = std::min(least, spacingBetween(figures, row, probe, 0)->distance);
    }
    return least;
}

/// A place that is covered but has a place beside the line within 2 nm that is not.
bool isOnOutline(const FigureTable& figures, PointD location, PointD unit) {
    return distanceTo(figures, {location.x + 2 * unit.y, location.y - 2 * unit.x}) > 0.0 ||
           distanceTo(figures, {location.x - 2 * unit.y, location.y + 2 * unit.x}) > 0.0;
}

}  // namespace

class LineCutTest : public QObject {
    Q_OBJECT

private slots:
    void setsOfIntervals() {
        QCOMPARE(united({{5, 6}, {1, 2}, {2, 3}, {4, 4}, {9, 8}, {5.5, 7}}), (Intervals{{1, 3}, {5, 7}}));
        QCOMPARE(subtracted({{0, 10}, {20, 30}}, {{-5, 1}, {3, 4}, {9, 22}, {30, 40}}),
                 (Intervals{{1, 3}, {4, 9}, {22, 30}}));
        QCOMPARE(subtracted({{0, 10}}, {{0, 10}}), Intervals{});
        QCOMPARE(clipped({{0, 10}, {20, 30}}, 5, 20), (Intervals{{5, 10}}));
    }

    void cutsAreExact() {
        DocumentBuilder builder;
        builder.beginLayer(builder.addLayer({}));
        const ElementId ring = builder.addCircle({{0, 0}, 10, 6}, {});
        const ElementCut through = cutElement(builder.soFar(), ring, CutLine::through({-20, 0}, {20, 0}));
        QCOMPARE(through.covered, (Intervals{{15, 25}}));
        QCOMPARE(through.opening, (Intervals{{17, 23}}));
        const ElementCut beside = cutElement(builder.soFar(), ring, CutLine::through({-20, 4}, {20, 4}));
        QCOMPARE(beside.covered, (Intervals{{17, 23}}));  // 3-4-5
        QVERIFY(beside.opening.empty());
        QVERIFY(cutElement(builder.soFar(), ring, CutLine::through({-20, 6}, {20, 6})).covered.empty());
    }

    void linesAlongEdgesLieOnOneSideOfThem() {
        DocumentBuilder builder;
        builder.beginLayer(builder.addLayer({}));
        ShapeSketch square;
        square.addPolygon(std::array<Point, 4>{{{0, 0}, {10, 0}, {10, 10}, {0, 10}}}, false);
        const ElementId area = builder.addArea({builder.addShape(square), {}}, {});
        const auto covered = [&](PointD from, PointD to) {
            return cutElement(builder.soFar(), area, CutLine::through(from, to)).covered;
        };
        QVERIFY(covered({-5, 0}, {15, 0}).empty());
        QCOMPARE(covered({15, 0}, {-5, 0}), (Intervals{{5, 15}}));
        QCOMPARE(covered({-5, 10}, {15, 10}), (Intervals{{5, 15}}));
        QCOMPARE(covered({-5, -5}, {15, 15}).size(), std::size_t{1});  // through two corners
    }

    void everyPlaceOnALineIsInsideOfACutIfTheElementCoversIt_data() {
        QTest::addColumn<int>("kind");
        const char* names[kKinds] = {"line", "square pen", "arc", "circle", "ring", "trail", "tube", "area"};
        for (int kind = 0; kind < kKinds; ++kind) {
            QTest::newRow(names[kind]) << kind;
        }
    }
    void everyPlaceOnALineIsInsideOfACutIfTheElementCoversIt() {
        QFETCH(int, kind);
        Maker maker(static_cast<unsigned>(kind) + 7);
        int inside = 0;
        for (int round = 0; round < 1000; ++round) {
            const ElementId element = maker.any(kind);
            FigureTable figures;
            figures.add(maker.document(), element);
            const Point a = maker.point();
            Point b = maker.point();
            b = round % 3 == 0 ? Point{a.x, a.y + 7 * kMm} : round % 3 == 1 ? Point{a.x - 7 * kMm, a.y} : b;
            if (a == b) {
                continue;
            }
            const CutLine line = CutLine::through(base::toDouble(a), base::toDouble(b));
            const ElementCut cut = cutElement(maker.document(), element, line);
            const bool isRing = kind == 4;
            const Intervals solid = isRing ? subtracted(cut.covered, cut.opening) : cut.covered;
            for (int i = 0; i < 100; ++i) {
                const double at = maker.number(-15 * kMm, 15 * kMm);
                const PointD location = {line.origin.x + line.unit.x * at, line.origin.y + line.unit.y * at};
                const double distance = distanceTo(figures, location);
                if (contains(solid, at)) {
                    ++inside;
                    QVERIFY2(distance < 2.0, qPrintable(QString("%1: %2 nm off").arg(at).arg(distance)));
                } else if (!isNearAnEnd(solid, at, 2.0)) {
                    QVERIFY2(distance > 0.0 || isOnOutline(figures, location, line.unit),
                             qPrintable(QString("not cut at %1, round %2").arg(at).arg(round)));
                }
            }
        }
        QVERIFY(inside > 300);
    }

    void placesAlongALineStayInCopiesOfIt() {
        Maker maker(5);
        for (int round = 0; round < 200; ++round) {
            const Placement placement = maker.placement();
            const CutLine line = CutLine::through(base::toDouble(maker.point()), {1e8, 3e7});
            const CutLine seen = line.seenFrom(placement);
            const PointD p = {1234.5, -9876.5};
            const PointD onBoard = placement.apply(p);
            QVERIFY(std::abs(seen.along(p) - line.along(onBoard)) < 1e-5);
            QVERIFY(std::abs(std::abs(seen.beside(p)) - std::abs(line.beside(onBoard))) < 1e-5);
        }
    }
};

QTEST_APPLESS_MAIN(LineCutTest)
#include "line_cut_test.moc"
