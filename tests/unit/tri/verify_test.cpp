#include "tri/verify.h"

#include <QtTest>

#include "tests/unit/tri/cases.h"

using cases::Case;
using tri::Fault;

namespace {

using Triangles = std::vector<std::uint32_t>;

/// Corners 0..3 of a square of 100; the perturbed choice of its diagonal is 1-3.
Case square() {
    return Case{}.loop(cases::square(0, 0, 100));
}

}  // namespace

class VerifyTest : public QObject {
    Q_OBJECT

private slots:
    void acceptsTheTriangulationInAnyOrder() {
        QCOMPARE(tri::verify(square().polygon(), Triangles{0, 1, 3, 1, 2, 3}), Fault::None);
        QCOMPARE(tri::verify(square().polygon(), Triangles{3, 1, 2, 1, 3, 0}), Fault::None);
        QCOMPARE(tri::verify(Case{}.polygon(), {}), Fault::None);
    }

    void findsIndicesThatAreNone() {
        QCOMPARE(tri::verify(square().polygon(), Triangles{0, 1, 3, 1, 2, 4}), Fault::BadIndex);
        QCOMPARE(tri::verify(square().polygon(), Triangles{0, 1, 3, 1, 2}), Fault::BadIndex);
        const Case repeated = Case{}.loop({{0, 0}, {9, 0}, {9, 0}, {0, 9}});
        QCOMPARE(tri::verify(repeated.polygon(), Triangles{0, 2, 3}), Fault::BadIndex);
        QCOMPARE(tri::verify(repeated.polygon(), Triangles{0, 1, 3}), Fault::None);
    }

    void findsClockwiseAndFlatTriangles() {
        QCOMPARE(tri::verify(square().polygon(), Triangles{0, 1, 3, 1, 3, 2}), Fault::NotCounterClockwise);
        QCOMPARE(tri::verify(square().polygon(), Triangles{0, 1, 3, 1, 2, 3, 0, 1, 1}), Fault::NotCounterClockwise);
    }

    void findsHolesAndSurplus() {
        QCOMPARE(tri::verify(square().polygon(), Triangles{0, 1, 3}), Fault::WrongArea);
        QCOMPARE(tri::verify(square().polygon(), Triangles{0, 1, 3, 1, 2, 3, 0, 1, 3}), Fault::WrongArea);
        QCOMPARE(tri::verify(square().polygon(), {}), Fault::WrongArea);
        // Right area, wrong place: the same triangle twice.
        QCOMPARE(tri::verify(square().polygon(), Triangles{0, 1, 3, 0, 1, 3}), Fault::Overlap);
    }

    void findsBordersThatAreNoContours() {
        // A quadrangle with a dent at corner 2 or at lone point 4: equal areas, and the triangles fit the other one.
        const Case input = Case{}.loop({{0, 0}, {100, 0}, {60, 60}, {0, 100}}).loop({{100, 40}});
        const Case other = Case{}.loop({{0, 0}, {100, 0}, {100, 40}, {0, 100}}).loop({{60, 60}});
        QCOMPARE(tri::verify(input.polygon(), Triangles{0, 1, 2, 0, 2, 3}), Fault::None);
        QCOMPARE(tri::verify(input.polygon(), Triangles{0, 1, 4, 0, 4, 3}), Fault::WrongArea);
        const Case sheared = Case{}.loop({{0, 0}, {100, 0}, {60, 60}, {0, 100}}).loop({{80, 40}});
        QCOMPARE(tri::verify(sheared.polygon(), Triangles{0, 1, 4, 0, 4, 3}), Fault::WrongBorder);
    }

    void findsRegionsCoveredTwice() {
        // A square in a square, both counter-clockwise: every border is a contour, the areas add up.
        const Case input = square().loop(cases::square(200, 0, 100));
        QCOMPARE(tri::verify(input.polygon(), Triangles{0, 1, 3, 1, 2, 3, 4, 5, 7, 5, 6, 7}), Fault::None);
        const Case nested = square().loop(cases::square(20, 30, 40));
        QCOMPARE(tri::verify(nested.polygon(), Triangles{0, 1, 3, 1, 2, 3, 4, 5, 7, 5, 6, 7}), Fault::Overlap);
        const Case crossing = square().loop(cases::square(70, 70, 100));
        QCOMPARE(tri::verify(crossing.polygon(), Triangles{0, 1, 3, 1, 2, 3, 4, 5, 7, 5, 6, 7}), Fault::Overlap);
    }

    void findsPointsThatAreNoCorners() {
        const Case inside = square().loop({{30, 20}});
        QCOMPARE(tri::verify(inside.polygon(), Triangles{0, 1, 3, 1, 2, 3}), Fault::MissingVertex);
        const Case onEdge = square().loop({{0, 50}});
        QCOMPARE(tri::verify(onEdge.polygon(), Triangles{0, 1, 3, 1, 2, 3}), Fault::MissingVertex);
        const Case outside = square().loop({{-1, 50}}).loop({{50, 101}});
        QCOMPARE(tri::verify(outside.polygon(), Triangles{0, 1, 3, 1, 2, 3}), Fault::None);
    }

    void findsEdgesThatAreNotDelaunay() {
        QCOMPARE(tri::verify(square().polygon(), Triangles{0, 1, 2, 0, 2, 3}), Fault::NotDelaunay);
        const Case kite = Case{}.loop({{0, 0}, {50, -10}, {100, 0}, {50, 10}});
        QCOMPARE(tri::verify(kite.polygon(), Triangles{0, 1, 2, 0, 2, 3}), Fault::NotDelaunay);
        QCOMPARE(tri::verify(kite.polygon(), Triangles{0, 1, 3, 1, 2, 3}), Fault::None);
    }
};

QTEST_APPLESS_MAIN(VerifyTest)
#include "verify_test.moc"
