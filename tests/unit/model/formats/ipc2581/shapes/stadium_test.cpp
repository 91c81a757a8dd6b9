#include "model/formats/ipc2581/shapes/stadium.h"

#include <QtTest>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "model/geometry/outlines.h"

using model::Point;
using model::ShapeSketch;

namespace {

/// A stadium of 4 × 1.5 mm at (100, -50) mm, rotated, with `chords` for each of its ends, corners on the circle: half a
/// chord beside its beginning, and there too if it is asked for.
ShapeSketch polygon(double degrees, int chords, bool hasTangents = false) {
    std::vector<Point> points;
    const double turn = degrees * std::numbers::pi / 180;
    for (const double sign : {1.0, -1.0}) {
        for (int i = hasTangents ? -1 : 0; i < chords + (hasTangents ? 1 : 0); ++i) {
            const double part = std::clamp((i + 0.5) / chords, 0.0, 1.0);
            const double angle = (-0.5 + part + (sign < 0 ? 1.0 : 0.0)) * std::numbers::pi;
            const double x = sign * 1.25e6 + 0.75e6 * std::cos(angle);
            const double y = 0.75e6 * std::sin(angle);
            points.push_back(model::rounded(
                {100e6 + x * std::cos(turn) - y * std::sin(turn), -50e6 + x * std::sin(turn) + y * std::cos(turn)}));
        }
    }
    ShapeSketch sketch;
    sketch.addPolygon(points, false);
    return sketch;
}

}  // namespace

class StadiumTest : public QObject {
    Q_OBJECT

private slots:
    void polygonsOfManyChordsAreStadiums_data() {
        QTest::addColumn<double>("degrees");
        QTest::addColumn<bool>("hasTangents");
        for (const double degrees : {0.0, 30.0, 45.0, 90.0, 200.0}) {
            QTest::newRow(QByteArray::number(degrees)) << degrees << false;
            QTest::newRow(QByteArray::number(degrees) + " with tangents") << degrees << true;
        }
    }
    void polygonsOfManyChordsAreStadiums() {
        QFETCH(double, degrees);
        QFETCH(bool, hasTangents);
        const auto stadium = model::ipc2581::stadiumOf(polygon(degrees, 16, hasTangents));
        QVERIFY(stadium.has_value());
        QVERIFY(std::abs(stadium->width - 1'500'000) <= 10);
        const double length = std::hypot(static_cast<double>(stadium->a.x) - stadium->b.x,
                                         static_cast<double>(stadium->a.y) - stadium->b.y);
        QVERIFY(std::abs(length - 2.5e6) <= 10);
        QVERIFY(std::abs(stadium->a.x / 2 + stadium->b.x / 2 - 100'000'000) <= 10);
        QVERIFY(std::abs(stadium->a.y / 2 + stadium->b.y / 2 + 50'000'000) <= 10);
    }

    void arcsAreExact() {
        ShapeSketch oval;
        model::addOval(oval, 3e6, 1e6, false);
        const auto stadium = model::ipc2581::stadiumOf(oval);
        QVERIFY(stadium.has_value());
        QCOMPARE(stadium->width, 1'000'000);
        QCOMPARE(std::max(stadium->a.x, stadium->b.x), 1'000'000);
        QCOMPARE(stadium->a.y, 0);
    }

    void otherShapesStayThemselves() {
        ShapeSketch box;
        model::addBox(box, 3e6, 1e6, false);
        ShapeSketch disc;
        model::addDisc(disc, 3e6, false);
        ShapeSketch rounded;
        model::addCornerBox(rounded, 3e6, 1e6, 0.3e6, model::kAllCorners, model::CornerStyle::Rounded, false);
        ShapeSketch ring;
        model::addOval(ring, 3e6, 1e6, false);
        model::addOval(ring, 2e6, 0.5e6, true);
        for (const ShapeSketch& shape : {box, disc, rounded, ring, polygon(0.0, 4)}) {
            QVERIFY(!model::ipc2581::stadiumOf(shape));
        }
        QVERIFY(!model::ipc2581::stadiumOf({}));
    }
};

QTEST_APPLESS_MAIN(StadiumTest)
#include "stadium_test.moc"
