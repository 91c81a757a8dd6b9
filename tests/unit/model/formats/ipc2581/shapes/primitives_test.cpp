#include "model/formats/ipc2581/shapes/primitives.h"

#include <QtTest>
#include <cmath>
#include <numbers>

#include "model/formats/ipc2581/shapes/hatches.h"
#include "model/formats/ipc2581/shapes/turn.h"
#include "model/geometry/outlines.h"
#include "model/geometry/region.h"

using model::Box;
using model::formats::PadShape;
using model::ipc2581::XmlCursor;

namespace {

/// In millimetres.
PadShape shapeOf(const QByteArray& text) {
    const std::string copy = text.toStdString();
    XmlCursor at(copy);
    at.next();
    return model::ipc2581::primitiveShape(at, 1e6);
}

/// In mm², of polygons no further than 1 µm from arcs.
double areaOf(const model::ShapeSketch& sketch) {
    return static_cast<double>(model::twiceArea(model::polygonsOf(sketch))) / 2e12;
}

}  // namespace

class PrimitivesTest : public QObject {
    Q_OBJECT

private slots:
    void everyKindHasItsSizeAndArea_data() {
        QTest::addColumn<QByteArray>("text");
        QTest::addColumn<double>("width");
        QTest::addColumn<double>("height");
        QTest::addColumn<double>("area");
        constexpr double kPi = std::numbers::pi;
        const auto row = [](const char* text, double width, double height, double area) {
            QTest::newRow(text) << QByteArray(text) << width << height << area;
        };
        row("<Circle diameter='2'/>", 2, 2, kPi);
        row("<RectCenter width='3' height='2'/>", 3, 2, 6);
        row("<RectCorner lowerLeftX='-1' lowerLeftY='0' upperRightX='2' upperRightY='2'/>", 3, 2, 6);
        row("<RectRound width='3' height='2' radius='0.5' upperRight='true'/>", 3, 2, 6 - 0.25 + kPi / 16);
        row("<RectRound width='3' height='2' radius='0.5'/>", 3, 2, 6 - 1 + kPi / 4);
        row("<RectCham width='3' height='2' chamfer='0.5' lowerLeft='true' upperRight='true'/>", 3, 2, 5.75);
        row("<Oval width='3' height='1'/>", 3, 1, 2 + kPi / 4);
        row("<Donut shape='ROUND' outerDiameter='2' innerDiameter='1'/>", 2, 2, kPi * 0.75);
        row("<Donut shape='SQUARE' outerDiameter='2' innerDiameter='1'/>", 2, 2, 3);
        row("<Thermal shape='ROUND' outerDiameter='2' innerDiameter='1' spokeCount='0' spokeWidth='0.2'/>", 2, 2,
            kPi * 0.75);
        row("<Thermal shape='SQUARE' outerDiameter='2' innerDiameter='1' spokeCount='4' spokeWidth='0.2' "
            "spokeStartAngle='0'/>",
            2, 2, 3 - 4 * 0.5 * 0.2);
        row("<Butterfly shape='ROUND' diameter='2'/>", 2, 2, kPi / 2);
        row("<Butterfly shape='SQUARE' side='2'/>", 2, 2, 2);
        row("<Diamond width='3' height='2'/>", 3, 2, 3);
        row("<Hexagon length='2'/>", 2, std::sqrt(3.0), 1.5 * std::sqrt(3.0));
        row("<Octagon length='2'/>", 2, 2, 8 * (std::numbers::sqrt2 - 1));
        row("<Ellipse width='3' height='2'/>", 3, 2, kPi * 1.5);
        row("<Triangle base='3' height='2'/>", 3, 2, 3);
        row("<Moire diameter='4' ringWidth='0.5' ringGap='0.5' ringNumber='2' lineWidth='0' lineLength='0'/>", 4, 4,
            kPi * (4 - 2.25 + 1 - 0.25));
    }
    void everyKindHasItsSizeAndArea() {
        QFETCH(QByteArray, text);
        QFETCH(double, width);
        QFETCH(double, height);
        QFETCH(double, area);
        const PadShape shape = shapeOf(text);
        QVERIFY2(shape.problem.empty(), shape.problem.c_str());
        const model::ShapeSketch outline = model::formats::outlineOf(shape);
        const Box box = model::boxOf(outline);
        QVERIFY2(std::abs(static_cast<double>(box.width()) - width * 1e6) <= 2,
                 qPrintable(QString::number(box.width())));
        QVERIFY2(std::abs(static_cast<double>(box.height()) - height * 1e6) <= 2,
                 qPrintable(QString::number(box.height())));
        QVERIFY2(std::abs(areaOf(outline) - area) < 0.01, qPrintable(QString::number(areaOf(outline))));
    }

    void roundThermalsLoseTheirSpokes() {
        const PadShape shape = shapeOf(
            "<Thermal shape='ROUND' outerDiameter='2' innerDiameter='1' spokeCount='4' spokeWidth='0.2' "
            "spokeStartAngle='45'/>");
        QCOMPARE(shape.region.contourCount(), std::size_t{4});
        QVERIFY(std::abs(areaOf(shape.region) - (std::numbers::pi * 0.75 - 4 * 0.5 * 0.2)) < 0.01);
        const model::PathNodes piece = shape.region.contour(0);
        QCOMPARE(piece.size(), std::size_t{4});
        QCOMPARE(piece[0].edge, model::EdgeKind::ArcCounterClockwise);
        QVERIFY(piece[0].point.x < piece[0].point.y);  // left of the cut at 45 degrees
    }

    void whatCannotBeDrawnSaysWhy_data() {
        QTest::addColumn<QByteArray>("text");
        for (const char* text : {"<Circle/>", "<Circle diameter='-1'/>", "<RectCenter width='900' height='1'/>",
                                 "<Circle diameter='0'/>", "<Thermal outerDiameter='2' innerDiameter='3'/>",
                                 "<Moire diameter='4' ringWidth='1' ringGap='1' ringNumber='1000000'/>"}) {
            QTest::newRow(text) << QByteArray(text);
        }
    }
    void whatCannotBeDrawnSaysWhy() {
        QFETCH(QByteArray, text);
        const PadShape shape = shapeOf(text);
        QCOMPARE(shape.kind, PadShape::Kind::Nothing);
        QVERIFY(!shape.problem.empty());
    }

    void namesTellShapesApart() {
        const auto name = [](const char* text, double nm) {
            XmlCursor at(text);
            at.next();
            return model::ipc2581::primitiveName(at, nm);
        };
        QCOMPARE(name("<Oval width='3' height='1'/>", 1e6), std::string("Oval 3 1"));
        QCOMPARE(name("<Circle diameter='0.01'/>", 25.4e6), std::string("Circle 0.254"));
        QVERIFY(name("<RectCham width='3' height='1' chamfer='0.1' upperLeft='true'/>", 1e6) !=
                name("<RectCham width='3' height='1' chamfer='0.1' upperLeft='false'/>", 1e6));
    }

    void turnsRotateBeforeTheyMirror() {
        const model::ipc2581::Turn turn{{10, 20}, 90.0, true, 2.0};
        QCOMPARE(turn.apply({1, 0}), (model::PointD{10, 22}));
        QCOMPARE(turn.apply({0, 1}), (model::PointD{12, 20}));
        const model::ipc2581::Turn inner{{3, 4}, 30.0, true, 1.0};
        const model::PointD once = turn.after(inner).apply({5, 6});
        const model::PointD twice = turn.apply(inner.apply({5, 6}));
        QVERIFY(std::hypot(once.x - twice.x, once.y - twice.y) < 1e-9);
    }

    void hatchesCoverStripsOfTheArea() {
        model::ShapeSketch square;
        model::addBox(square, 10e6, 10e6, false);
        const auto hatch = [&](double pitch, double width) {
            return model::ipc2581::hatchOf(square, {{{{0.0, pitch}, {90.0, 0.0}}}, width});
        };
        QVERIFY(std::abs(areaOf(hatch(2e6, 1e6).shape) - 50.0) < 0.01);  // five lines, the outer two cut in half
        QVERIFY(hatch(2e6, 1e6).problem.empty());
        QVERIFY(!hatch(0.0, 1e6).problem.empty());
        QVERIFY(!hatch(1.0, 1e6).problem.empty());
        QCOMPARE(areaOf(hatch(1.0, 1e6).shape), 100.0);
    }
};

QTEST_APPLESS_MAIN(PrimitivesTest)
#include "primitives_test.moc"
