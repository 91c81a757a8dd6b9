#include "model/geometry/slits.h"

#include <QtTest>
#include <algorithm>
#include <random>

#include "model/board/document_builder.h"
#include "model/formats/common/archive.h"
#include "model/formats/odb/features/features.h"
#include "model/geometry/nesting.h"
#include "model/geometry/region.h"
#include "tests/locations.h"

using model::EdgeKind;
using model::PathNode;
using model::Point;
using model::PolygonSet;
using model::ShapeSketch;

namespace {

/// Contours as "island 4, hole 4": kind and nodes.
QString text(const ShapeSketch& sketch) {
    QStringList parts;
    for (std::size_t i = 0; i < sketch.contourCount(); ++i) {
        parts += QString("%1 %2").arg(sketch.isHole(i) ? "hole" : "island").arg(sketch.contour(i).size());
    }
    return parts.join(", ");
}

ShapeSketch contour(std::initializer_list<Point> points, bool isHole = false) {
    ShapeSketch sketch;
    sketch.addPolygon(std::vector<Point>(points), isHole);
    return sketch;
}

/// The polygons that the program makes of it with slits and all.
PolygonSet unhealed(const ShapeSketch& sketch) {
    return model::polygonsOf(sketch, {});
}

PolygonSet healed(const ShapeSketch& sketch) {
    return model::polygonsOf(model::healSlits(sketch).value_or(sketch), {});
}

int winding(std::span<const Point> loop, double x, double y) {
    int turns = 0;
    for (std::size_t i = 0; i < loop.size(); ++i) {
        const Point a = loop[i];
        const Point b = loop[(i + 1) % loop.size()];
        const double side = (double(b.x) - a.x) * (y - a.y) - (double(b.y) - a.y) * (x - a.x);
        turns += a.y <= y && b.y > y && side > 0 ? 1 : 0;
        turns -= b.y <= y && a.y > y && side < 0 ? 1 : 0;
    }
    return turns;
}

int winding(const PolygonSet& set, double x, double y) {
    int turns = 0;
    for (std::size_t i = 0; i < set.loopCount(); ++i) {
        turns += winding(set.loop(i), x, y);
    }
    return turns;
}

/// Points over the whole shape, none of which lies on a corner.
bool coversSame(const PolygonSet& a, const PolygonSet& b, int points) {
    model::Box box;
    std::ranges::for_each(a.points, [&](const Point& p) { box.include(p); });
    std::mt19937 random(7);
    std::uniform_real_distribution<double> x(box.min.x, box.max.x);
    std::uniform_real_distribution<double> y(box.min.y, box.max.y);
    for (int i = 0; i < points; ++i) {
        const double px = x(random);
        const double py = y(random);
        if (winding(a, px, py) != winding(b, px, py)) {
            return false;
        }
    }
    return true;
}

/// Every S record of every feature file of a job, as the file says it.
std::vector<ShapeSketch> surfacesOf(const std::filesystem::path& job) {
    base::Progress progress;
    model::Diagnostics diagnostics;
    const auto archive = model::formats::Archive::open(job, {}, progress, diagnostics);
    std::vector<ShapeSketch> sketches;
    for (int row = 0; archive && row < static_cast<int>(archive->size()); ++row) {
        if (!archive->path(row).ends_with("/features")) {
            continue;
        }
        const auto bytes = archive->bytes(row);
        const auto file = model::odb::parseFeatures(bytes->view(), "", model::odb::Unit::Millimetre, diagnostics);
        for (std::size_t shape = 0; shape < file.surfaces.size(); ++shape) {
            if (file.surfaces.shapes[shape].contourCount > 0) {
                sketches.push_back(sketchOf(file.surfaces, model::ShapeId{shape}));
            }
        }
    }
    return sketches;
}

/// A name, the nodes of a contour, and what it is healed to.
struct Case {
    const char* name;
    const char* nodes;
    const char* expected;
};
constexpr Case kContours[] = {
    {"a square", "0,0 90,0 90,90 0,90", ""},
    {"a keyhole", "0,0 90,0 90,90 0,90 0,50 20,50 40,70 60,50 40,30 20,50 0,50", "island 5, hole 4"},
    {"the same, clockwise", "0,50 20,50 40,30 60,50 40,70 20,50 0,50 0,90 90,90 90,0 0,0", "island 5, hole 4"},
    {"one that begins in the middle of the slit", "20,50 40,70 60,50 40,30 20,50 0,50 0,0 90,0 90,90 0,90 0,50",
     "island 5, hole 4"},
    {"a slit from hole to hole",
     "0,0 90,0 90,90 0,90 0,50 20,50 30,60 40,50 60,50 70,60 80,50 70,40 60,50 40,50 30,40 20,50 0,50",
     "island 5, hole 4, hole 4"},
    {"two slits from one point", "0,0 90,0 90,90 0,90 0,50 20,60 20,80 40,70 20,60 0,50 20,40 40,30 20,20 20,40 0,50",
     "island 5, hole 3, hole 3"},
    {"an island in a hole", "0,0 90,0 90,90 0,90 0,0 10,10 10,80 80,80 80,10 10,10 20,20 60,20 60,60 20,60 20,20 10,10",
     "island 4, island 4, hole 4"},
    {"a slit that ends in the copper", "0,0 90,0 90,90 50,50 90,90 0,90", "island 4"},
    {"a corner that touches a corner", "0,0 50,50 90,0 90,90 50,50 0,90", ""},
    {"an edge that runs along part of another", "0,0 90,0 90,90 0,90 0,50 20,50 40,70 60,50 0,50", ""},
    {"an edge run twice the same way", "0,0 90,0 90,90 0,0 90,0 90,90", ""},
    {"a slit and nothing else", "0,0 90,0", ""},
    {"a figure of eight beside the slit, halves alike",
     "0,0 90,0 90,90 0,90 0,0 10,10 20,20 30,20 20,30 30,30 20,20 10,10", ""},
};

ShapeSketch contour(const QString& nodes) {
    std::vector<Point> points;
    for (const QString& node : nodes.split(' ')) {
        points.push_back({node.section(',', 0, 0).toInt(), node.section(',', 1, 1).toInt()});
    }
    ShapeSketch sketch;
    sketch.addPolygon(points, false);
    return sketch;
}

}  // namespace

class SlitsTest : public QObject {
    Q_OBJECT

private slots:
    void contours_data() {
        QTest::addColumn<QString>("nodes");
        QTest::addColumn<QString>("expected");  // empty: nothing to heal
        for (const auto& [name, nodes, expected] : kContours) {
            QTest::newRow(name) << QString(nodes) << QString(expected);
        }
    }
    void contours() {
        QFETCH(QString, nodes);
        QFETCH(QString, expected);
        const ShapeSketch sketch = contour(nodes);
        const std::optional<ShapeSketch> result = model::healSlits(sketch);
        QCOMPARE(result ? text(*result) : QString(), expected);
        QVERIFY(coversSame(unhealed(sketch), healed(sketch), 400));
        QVERIFY(model::twiceArea(unhealed(sketch)) == model::twiceArea(healed(sketch)));
    }

    void whatRunsBackInPiecesGetsNodes_data() {
        QTest::addColumn<QString>("nodes");
        QTest::addColumn<int>("added");
        QTest::addColumn<QString>("expected");
        QTest::newRow("one edge in along a hole's side, and back behind it")
            << "0,0 90,0 90,90 50,90 50,20 20,20 20,60 50,60 50,90 0,90" << 1 << "island 5, hole 4";
        QTest::newRow("in behind it, back along its side")
            << "50,90 50,60 80,60 80,20 50,20 50,90 0,90 0,0 90,0 90,90" << 1 << "island 5, hole 4";
        QTest::newRow("past two holes")
            << "0,0 90,0 90,90 50,90 50,10 20,10 20,30 50,30 50,50 20,50 20,70 50,70 50,90 0,90" << 3
            << "island 5, hole 4, hole 4";
        QTest::newRow("aslant") << "0,0 120,0 120,90 60,90 20,10 5,50 40,50 60,90 0,90" << 1 << "island 5, hole 3";
        QTest::newRow("to and fro, neither within the other")
            << "0,0 90,0 90,90 60,90 60,40 20,40 20,60 60,60 60,90 0,90" << 1 << "island 5, hole 4";
        QTest::newRow("an edge that runs along part of another")
            << "0,0 90,0 90,90 0,90 0,50 20,50 40,70 60,50 0,50" << 1 << "island 5, hole 3";
        QTest::newRow("the same ends") << "0,0 90,0 90,90 0,90 0,50 20,50 40,70 60,50 40,30 20,50 0,50" << 0
                                       << "island 5, hole 4";
        QTest::newRow("the same way") << "0,0 90,0 90,90 0,0 60,0 60,60" << 0 << "";
        QTest::newRow("beside each other") << "0,0 90,0 90,50 10,50 10,51 90,51 90,90 0,90" << 0 << "";
    }
    void whatRunsBackInPiecesGetsNodes() {
        QFETCH(QString, nodes);
        const ShapeSketch sketch = contour(nodes);
        const auto before = sketch.contour(0);
        const std::vector<PathNode> after = model::withNodesWhereRunBack({before.begin(), before.end()});
        QTEST(static_cast<int>(after.size() - before.size()), "added");
        ShapeSketch cut;
        cut.beginContour(false);
        cut.addNodes(after);
        const std::optional<ShapeSketch> result = model::healSlits(cut);
        QTEST(result ? text(*result) : QString(), "expected");
        QVERIFY(coversSame(unhealed(sketch), healed(cut), 400));
        QVERIFY(model::twiceArea(unhealed(sketch)) == model::twiceArea(healed(cut)));
    }

    /// Around the opening of an O in the direction of its outside.
    void openingsRunAroundAsTheOutsideAreOpen() {
        const std::vector<Point> letter = {{0, 0},   {90, 0},  {90, 90}, {45, 90}, {45, 60}, {30, 60},
                                           {30, 30}, {60, 30}, {60, 60}, {45, 60}, {45, 90}, {0, 90}};
        for (std::size_t begin = 0; begin < letter.size(); ++begin) {
            std::vector<PathNode> nodes;
            for (std::size_t i = 0; i < letter.size(); ++i) {
                nodes.push_back({letter[(begin + i) % letter.size()], {}});
            }
            ShapeSketch sketch;
            sketch.beginContour(false);
            for (const PathNode& node : model::withOpeningsAgainst(nodes)) {
                sketch.addNode(node);
            }
            QCOMPARE(text(model::healSlits(sketch).value_or(sketch)), QString("island 5, hole 5"));
        }
    }
    void otherLoopsAtSlitsStay_data() {
        QTest::addColumn<QVector<QPoint>>("points");
        QTest::newRow("an opening run around against the outside")
            << QVector<QPoint>{{0, 0},   {90, 0},  {90, 90}, {45, 90}, {45, 60}, {60, 60},
                               {60, 30}, {30, 30}, {30, 60}, {45, 60}, {45, 90}, {0, 90}};
        QTest::newRow("two islands joined by a line")
            << QVector<QPoint>{{0, 0},   {40, 0},  {40, 20}, {60, 20}, {60, 0},  {80, 0},
                               {80, 40}, {60, 40}, {60, 20}, {40, 20}, {40, 40}, {0, 40}};
        QTest::newRow("no slit") << QVector<QPoint>{{0, 0}, {40, 0}, {40, 20}};
    }
    void otherLoopsAtSlitsStay() {
        QFETCH(QVector<QPoint>, points);
        std::vector<PathNode> nodes;
        for (const QPoint& point : points) {
            nodes.push_back({{point.x(), point.y()}, {}});
        }
        QVERIFY(model::withOpeningsAgainst(nodes) == nodes);
    }

    void edgesThatLieUponEachOtherTakeLittleTime() {
        std::vector<PathNode> contour;
        for (int i = 0; i < 100'000; ++i) {
            contour.push_back({{i % 2 == 0 ? i : 1'000'000 - i, 0}, {}, EdgeKind::Line});
        }
        QCOMPARE(model::withNodesWhereRunBack(contour), contour);
    }

    void arcsStayArcs() {
        const Point centre{50, 50};
        ShapeSketch sketch = contour({{0, 0}, {90, 0}, {90, 90}, {0, 90}, {0, 50}});
        sketch.addNode(Point{40, 50});
        sketch.addNode({{40, 50}, centre, EdgeKind::ArcClockwise});  // a full circle
        const auto result = model::healSlits(sketch);
        QVERIFY(!result);  // the way back is missing: not a slit but a crack
        sketch = contour({{0, 0}, {90, 0}, {90, 90}, {0, 90}, {0, 50}});
        sketch.addNode({{40, 50}, centre, EdgeKind::ArcClockwise});
        sketch.addNode(Point{40, 50});
        sketch.addNode(Point{0, 50});
        const auto circle = model::healSlits(sketch);
        QVERIFY(circle.has_value());
        QCOMPARE(text(*circle), QString("island 5, hole 1"));
        QVERIFY((circle->contour(1)[0] == PathNode{{40, 50}, centre, EdgeKind::ArcClockwise}));
    }

    /// Holes of a job stay where they are, and a hole with a slit becomes a hole with an island in it.
    void holesAreHealedToo() {
        ShapeSketch sketch = contour({{0, 0}, {90, 0}, {90, 90}, {0, 90}});
        sketch.addPolygon(
            std::vector<Point>{
                {10, 10}, {80, 10}, {80, 80}, {10, 80}, {10, 10}, {20, 20}, {20, 60}, {60, 60}, {60, 20}, {20, 20}},
            true);
        const auto result = model::healSlits(sketch);
        QVERIFY(result.has_value());
        QCOMPARE(text(*result), QString("island 4, hole 4, island 4"));
    }

    void areasOfADocumentHaveNoSlits() {
        model::DocumentBuilder builder;
        const model::ShapeId shape = builder.addShape(contour(
            {{0, 0}, {90, 0}, {90, 90}, {0, 90}, {0, 50}, {20, 50}, {40, 70}, {60, 50}, {40, 30}, {20, 50}, {0, 50}}));
        const auto contours = builder.shapes().contoursOf(shape);
        QCOMPARE(contours.size(), std::size_t{2});
        QVERIFY(!contours[0].isHole && contours[1].isHole);
    }

    void surfacesOfJobsKeepTheirAreas_data() {
        QTest::addColumn<QString>("job");
        QTest::addColumn<std::size_t>("holes");  // that no record H says
        const auto row = [](const char* job, std::size_t holes) {
            if (!locations::boardsNamed({job}).empty()) {
                QTest::newRow(job) << QString::fromStdString((locations::boards() / job).string()) << holes;
            }
        };
        row("kicad/StickHub.tgz", 7);
        row("kicad/jetson-agx-thor-baseboard.tgz", 8477);
        row("kicad/dram-tester.tgz", 1398);
        row("severson_amdc_revC.tgz", 0);
        row("opencellular_sync.tgz", 0);
    }
    void surfacesOfJobsKeepTheirAreas() {
        QFETCH(QString, job);
        QFETCH(std::size_t, holes);
        std::size_t made = 0;
        for (const ShapeSketch& sketch : surfacesOf(job.toStdString())) {
            const auto result = model::healSlits(sketch);
            if (!result) {
                continue;
            }
            const PolygonSet before = unhealed(sketch);
            const PolygonSet after = healed(sketch);
            QVERIFY(model::twiceArea(before) == model::twiceArea(after));
            QVERIFY(!model::healSlits(*result));
            QVERIFY(coversSame(before, after, locations::isThorough() ? 1000 : 50));
            made += after.loopCount() - before.loopCount();
        }
        QCOMPARE(made, holes);
    }
};

QTEST_APPLESS_MAIN(SlitsTest)
#include "slits_test.moc"
