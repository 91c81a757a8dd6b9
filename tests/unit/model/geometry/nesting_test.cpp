#include "model/geometry/nesting.h"

#include <QtTest>

using model::Point;
using model::ShapeSketch;

namespace {

void addSquare(ShapeSketch& sketch, int x, int y, int size, bool isHole) {
    const Point corners[] = {{x, y}, {x + size, y}, {x + size, y + size}, {x, y + size}};
    sketch.addPolygon(corners, isHole);
}

/// Lower left corners of the contours, holes in brackets.
QString text(const ShapeSketch& sketch) {
    QStringList parts;
    for (std::size_t i = 0; i < sketch.contourCount(); ++i) {
        const QString x = QString::number(sketch.contour(i)[0].point.x);
        parts += sketch.isHole(i) ? "(" + x + ")" : x;
    }
    return parts.join(' ');
}

}  // namespace

class NestingTest : public QObject {
    Q_OBJECT

private slots:
    void holesMoveBehindTheirIsland() {
        ShapeSketch sketch;
        addSquare(sketch, 0, 0, 100, false);
        addSquare(sketch, 200, 0, 100, false);
        addSquare(sketch, 230, 30, 10, true);
        addSquare(sketch, 10, 10, 10, true);
        addSquare(sketch, 50, 50, 10, true);
        QCOMPARE(text(model::nestHoles(sketch)), "0 (10) (50) 200 (230)");
    }

    void holesInAnIslandInsideAHoleBelongToTheInnerOne() {
        ShapeSketch sketch;
        addSquare(sketch, 0, 0, 1000, false);
        addSquare(sketch, 300, 300, 400, false);
        addSquare(sketch, 200, 200, 600, true);
        addSquare(sketch, 400, 400, 100, true);
        QCOMPARE(text(model::nestHoles(sketch)), "0 (200) 300 (400)");
    }

    void boxesThatOverlapAreDecidedByTheOutline() {
        // Two triangles whose boxes are equal; the hole lies in the second.
        ShapeSketch sketch;
        const Point lower[] = {{0, 0}, {1000, 0}, {0, 1000}};
        const Point upper[] = {{1000, 1000}, {0, 1000}, {1000, 0}};
        sketch.addPolygon(lower, false);
        sketch.addPolygon(upper, false);
        addSquare(sketch, 800, 800, 50, true);
        addSquare(sketch, 100, 100, 50, true);
        QCOMPARE(text(model::nestHoles(sketch)), "0 (100) 1000 (800)");
    }

    void aHoleInNoIslandKeepsItsPlace() {
        ShapeSketch sketch;
        addSquare(sketch, 0, 0, 100, false);
        addSquare(sketch, 200, 0, 100, false);
        addSquare(sketch, 500, 500, 10, true);
        QCOMPARE(text(model::nestHoles(sketch)), "0 200 (500)");
    }
};

QTEST_APPLESS_MAIN(NestingTest)
#include "nesting_test.moc"
