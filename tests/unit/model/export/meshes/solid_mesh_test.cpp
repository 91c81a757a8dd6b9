#include "model/export/meshes/solid_mesh.h"

#include <QtTest>
#include <algorithm>
#include <array>

#include "tests/unit/model/export/meshes/mesh_board.h"

using mesh_board::isClosed;
using mesh_board::isNear;
using mesh_board::kMm;
using model::EdgeLoops;
using model::Point;
using model::SolidMesh;

namespace {

constexpr double kMm3 = 1e18;
constexpr model::ZRange kHeights{kMm, 3 * kMm};

model::PolygonSet polygons(const std::vector<std::vector<Point>>& loops) {
    model::PolygonSet set;
    set.beginPolygon();
    for (const auto& loop : loops) {
        set.addLoop(loop);
    }
    return set;
}

std::vector<Point> square(model::Nm from, model::Nm to) {
    return {{from, from}, {to, from}, {to, to}, {from, to}};
}

}  // namespace

class SolidMeshTest : public QObject {
    Q_OBJECT

private slots:
    void aBoxHasTwelveTriangles() {
        SolidMesh mesh;
        QVERIFY(model::appendPrisms(polygons({square(0, kMm)}), kHeights, mesh));
        QCOMPARE(mesh.points.size(), std::size_t{8});
        QCOMPARE(mesh.triangleCount(), std::size_t{12});
        QVERIFY(isClosed(mesh.triangles));
        QCOMPARE(model::volumeOf(mesh), 2 * kMm3);
    }

    void holesHaveWallsToo() {
        SolidMesh mesh;
        QVERIFY(model::appendPrisms(polygons({square(0, 4 * kMm), square(kMm, 2 * kMm)}), kHeights, mesh));
        QVERIFY(isClosed(mesh.triangles));
        QCOMPARE(mesh.triangleCount(), std::size_t{2 * 8 + 2 * 8});
        QVERIFY(isNear(model::volumeOf(mesh), 30 * kMm3, 1e-12));
    }

    /// Many cores find triangles in another order every time.
    void cornersAndTrianglesKeepTheOrderOfTheLoops() {
        std::vector<std::vector<Point>> loops{square(0, 30 * kMm)};
        for (model::Nm at = 1; at < 14; ++at) {
            loops.push_back(square(2 * at * kMm, (2 * at + 1) * kMm));
        }
        SolidMesh mesh;
        QVERIFY(model::appendPrisms(polygons(loops), kHeights, mesh));
        const std::size_t half = mesh.points.size() / 2;
        QCOMPARE(half, 4 * loops.size());
        for (std::size_t row = 0; row < half; ++row) {
            const Point corner{mesh.points[row].x, mesh.points[row].y};
            QVERIFY(std::ranges::find(loops[row / 4], corner) != loops[row / 4].end());
        }
        std::vector<std::array<std::uint32_t, 3>> upper;
        for (std::size_t i = 0; i < mesh.triangles.size(); i += 3) {
            const std::array triangle{mesh.triangles[i], mesh.triangles[i + 1], mesh.triangles[i + 2]};
            if (std::ranges::all_of(triangle, [&](std::uint32_t corner) { return corner >= half; })) {
                upper.push_back(triangle);
            }
        }
        QVERIFY(upper.size() > 50);
        QVERIFY(std::ranges::is_sorted(upper));
    }

    /// Chords lie within a disc: what is missing is known from their number.
    void arcsAreChordsWithinTheTolerance() {
        EdgeLoops disc;
        disc.addCircle({0.5, 0.25}, 1e6);
        disc.addCircle({0.5, 0.25}, 0.9e6);
        for (const double tolerance : {500.0, 5'000.0, 50'000.0}) {
            SolidMesh mesh;
            QVERIFY(model::appendPrisms(model::polygonsOf(disc, {tolerance}), kHeights, mesh));
            QVERIFY(isClosed(mesh.triangles));
            const double exact = model::volumeOf(model::Shell{disc, kHeights});
            QVERIFY(std::abs(model::volumeOf(mesh) - exact) <= 2 * std::numbers::pi * 1.0e6 * tolerance * 2e6);
            for (const model::MeshPoint& p : mesh.points) {
                const double radius = std::hypot(p.x, p.y);
                QVERIFY(std::abs(radius - 1e6) < 2.0 || std::abs(radius - 0.9e6) < 2.0);
            }
        }
    }

    void clockwiseArcsBulgeInwards() {
        EdgeLoops notch;
        notch.addLine({0, 0}, {4e6, 0});
        notch.addLine({4e6, 0}, {4e6, 4e6});
        notch.addLine({4e6, 4e6}, {3e6, 4e6});
        notch.addArc({3e6, 4e6}, {1e6, 4e6}, {2e6, 4e6}, true);
        notch.addLine({1e6, 4e6}, {0, 4e6});
        notch.addLine({0, 4e6}, {0, 0});
        QVERIFY(notch.endLoop());
        SolidMesh mesh;
        QVERIFY(model::appendPrisms(model::polygonsOf(notch, {500.0}), kHeights, mesh));
        QVERIFY(isNear(model::volumeOf(mesh), 2 * (16 - std::numbers::pi / 2) * kMm3, 1e-4));
    }

    /// A corner of a hole that lies on an edge of the outline: walls stand where triangles end, so nothing gapes.
    void loopsMayTouch() {
        SolidMesh mesh;
        const std::vector<Point> touching{{2 * kMm, 0}, {3 * kMm, kMm}, {kMm, kMm}};
        QVERIFY(model::appendPrisms(polygons({square(0, 4 * kMm), touching}), kHeights, mesh));
        QVERIFY(isClosed(mesh.triangles));
        QVERIFY(isNear(model::volumeOf(mesh), 30 * kMm3, 1e-12));
    }

    void contoursThatCrossAreRepaired() {
        SolidMesh mesh;
        const std::vector<Point> bow{{0, 0}, {2 * kMm, 2 * kMm}, {2 * kMm, 0}, {0, 4 * kMm}};
        QVERIFY(model::appendPrisms(polygons({bow}), kHeights, mesh));
        QVERIFY(isClosed(mesh.triangles));
        QVERIFY(model::volumeOf(mesh) > 0.0);
    }

    void whatHasNoAreaIsSaid() {
        SolidMesh mesh;
        QVERIFY(!model::appendPrisms({}, kHeights, mesh));
        QVERIFY(!model::appendPrisms(polygons({{{0, 0}, {kMm, 0}, {2 * kMm, 0}}}), kHeights, mesh));
        QVERIFY(mesh.points.empty() && mesh.triangles.empty());
        EdgeLoops dust;
        dust.addCircle({0.2, 0.2}, 0.1);
        QVERIFY(model::polygonsOf(dust, {}).polygons.empty());
    }

    void appendedMeshesAreTurnedAndMoved() {
        SolidMesh box;
        QVERIFY(model::appendPrisms(polygons({{{0, 0}, {2 * kMm, 0}, {2 * kMm, kMm}, {0, kMm}}}), kHeights, box));
        SolidMesh both = box;
        both.append(box, {{10 * kMm, 0}, 90.0, false});
        QCOMPARE(both.points.size(), std::size_t{16});
        QVERIFY(isClosed(both.triangles));
        QVERIFY(isNear(model::volumeOf(both), 8 * kMm3, 1e-12));
        model::Box extent;
        for (std::size_t i = 8; i < 16; ++i) {
            extent.include(Point{both.points[i].x, both.points[i].y});
        }
        QCOMPARE(extent, (model::Box{{10 * kMm, -2 * kMm}, {11 * kMm, 0}}));  // clockwise
    }
};

QTEST_GUILESS_MAIN(SolidMeshTest)
#include "solid_mesh_test.moc"
