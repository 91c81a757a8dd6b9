// The language of Gerber images: numbers, apertures, macros, transformations, blocks, repeated steps, regions, arcs,
// attributes, outdated forms.

#include <QtTest>
#include <algorithm>

#include "model/formats/gerber/image/expression.h"
#include "model/formats/gerber/image/image.h"
#include "model/geometry/discretise.h"
#include "model/geometry/outlines.h"
#include "model/geometry/region.h"

using model::formats::DrawnFeature;
using model::formats::DrawnKind;
using model::formats::PadShape;
using model::gerber::Image;

namespace {

Image parse(const std::string& body, const std::string& head = "%FSLAX46Y46*%%MOMM*%") {
    return model::gerber::parseImage(head + body + "M02*", "test.gbr");
}

const PadShape& shapeOf(const Image& image, std::size_t feature) {
    return image.symbols[static_cast<std::size_t>(image.features[feature].symbol)].shape;
}

/// In mm².
double areaOf(const PadShape& shape) {
    return static_cast<double>(twiceArea(polygonsOf(outlineOf(shape)))) / 2e12;
}

bool isReported(const Image& image, const std::string& words) {
    return std::ranges::any_of(image.diagnostics.entries(),
                               [&](const auto& entry) { return entry.text.find(words) != std::string::npos; });
}

}  // namespace

class GerberImageTest : public QObject {
    Q_OBJECT

private slots:
    void anImageMayEndTwice() {
        const std::string body = "%ADD10C,1*%D10*X0Y0D03*M00*\n";
        QVERIFY(parse(body + "M02*\n").diagnostics.entries().empty());
        QVERIFY(isReported(parse(body + "M02*\nX1000000D03*\n"), "behind the end of the image"));
    }

    /// Boards larger than the format: what is written in front can only be integers.
    void furtherDigitsInFrontAreNoDoubt() {
        const auto severityOf = [](const std::string& format) {
            const Image image = parse("%ADD10C,1*%D10*X1280840000Y0D03*", format + "%MOMM*%");
            return image.diagnostics.entries().at(0).severity;
        };
        QCOMPARE(severityOf("%FSLAX26Y26*%"), model::Severity::Info);
        QCOMPARE(severityOf("%FSTAX26Y26*%"), model::Severity::Warning);
    }

    /// DipTrace runs around the openings of letters in the direction of their outside.
    void openingsOfLettersAreOpen() {
        const Image image = parse(
            "G36*X0Y0D02*G01*X90000000D01*Y90000000D01*X45000000D01*Y60000000D01*X30000000D01*Y30000000D01*"
            "X60000000D01*"
            "Y60000000D01*X45000000D01*Y90000000D01*X0D01*Y0D01*G37*");
        QCOMPARE(image.regions.size(), std::size_t{1});
        const auto polygons = model::polygonsOf(image.regions[0], {});
        QCOMPARE(static_cast<double>(twiceArea(polygons)) / 2e12, 7200.0);
    }

    /// DipTrace writes its macros before the format, and outlines of text make them long.
    void theFormatIsFoundBehindLongMacros() {
        std::string head = "%MOIN*%\n";
        for (int i = 0; i < 20'000; ++i) {
            head += "%AMM" + std::to_string(i) + "*1,1,0.1,0,0*%\n";
        }
        const Image image = parse("%ADD10C,0.01*%D10*X1000000Y2000000D03*", head + "%FSLAX26Y26*%\n");
        QCOMPARE(image.features.at(0).a, (model::Point{25'400'000, 50'800'000}));
        QVERIFY(image.diagnostics.entries().empty());
    }

    void numbersFollowTheFormat() {
        const std::string body = "%ADD10C,0.01*%D10*X1Y-25D03*";
        QCOMPARE(parse(body, "%FSLAX24Y24*%%MOIN*%").features[0].a, (model::Point{2540, -63500}));
        QCOMPARE(parse(body, "%FSTAX24Y24*%%MOIN*%").features[0].a, (model::Point{254'000'000, -635'000'000}));
        QCOMPARE(parse(body, "%FSLAX33Y33*%G71*").features[0].a, (model::Point{1'000, -25'000}));
        QCOMPARE(parse("%ADD10C,1*%D10*X1.5Y2D03*").features[0].a, (model::Point{1'500'000, 2}));
        QVERIFY(isReported(parse(body, ""), "how its coordinates are written"));
        QVERIFY(isReported(parse(body, "%FSLAX24Y24*%"), "does not say its unit"));
    }

    void aCoordinateBeyondTheLargestIsReportedAndLeftOut() {
        const Image image = parse("%ADD10C,1*%D10*X9999000000D03*X1000000D03*");
        QCOMPARE(image.features.size(), std::size_t{1});
        QVERIFY(isReported(image, "larger than any board"));
    }

    void operationsAreModal() {
        const Image image = parse("%ADD10C,1*%G54D10*X0Y0D02*G01X1000000D01*Y1000000*X0*");
        QCOMPARE(image.features.size(), std::size_t{3});
        QCOMPARE(image.features[2].b, (model::Point{0, 1'000'000}));
        const Image flashes = parse("%ADD10C,1*%D10*X1Y1D03*X2*");
        QCOMPARE(flashes.features.size(), std::size_t{2});
        QVERIFY(isReported(flashes, "without an operation"));
    }

    void standardAperturesHaveTheirSizes() {
        const Image image = parse(
            "%ADD10C,2X1*%%ADD11R,2X3*%%ADD12O,3X1*%%ADD13P,2X4X45*%%ADD14R,2X2X1*%%ADD15C,0*%"
            "D10*X0Y0D03*D11*D03*D12*D03*D13*D03*D14*D03*D15*D03*");
        QCOMPARE(image.features.size(), std::size_t{6});
        QCOMPARE(shapeOf(image, 0).kind, PadShape::Kind::Ring);
        QCOMPARE(shapeOf(image, 0).height, 1'000'000);
        QVERIFY(std::abs(areaOf(shapeOf(image, 1)) - 6.0) < 1e-9);
        QCOMPARE(shapeOf(image, 2).kind, PadShape::Kind::Oval);
        QVERIFY(std::abs(areaOf(shapeOf(image, 3)) - 2.0) < 1e-5);
        QVERIFY(std::abs(areaOf(shapeOf(image, 4)) - (4.0 - 0.785398)) < 1e-2);
        QCOMPARE(shapeOf(image, 5).kind, PadShape::Kind::Nothing);
    }

    void expressionsFollowTheRulesOfArithmetic() {
        const model::gerber::MacroVariables variables = {{1, 2.0}, {2, 3.0}};
        const auto value = [&](const char* text) { return model::gerber::evaluate(text, variables).value_or(-99.0); };
        QCOMPARE(value("$1+$2x4"), 14.0);
        QCOMPARE(value("($1+$2)X4"), 20.0);
        QCOMPARE(value("-$1--3"), 1.0);
        QCOMPARE(value("1.08239X$1"), 2.16478);
        QCOMPARE(value("12/$2/2"), 2.0);
        QCOMPARE(value("$7"), 0.0);
        for (const char* bad : {"", "(1", "1)", "1+", "1/0", "a", "$", "1 2"}) {
            QVERIFY2(!model::gerber::evaluate(bad, variables), bad);
        }
    }

    void macrosDrawTheirPrimitives_data() {
        QTest::addColumn<QString>("body");
        QTest::addColumn<double>("area");
        QTest::newRow("circle") << "1,1,2,0,0" << 3.14159;
        QTest::newRow("vector line") << "20,1,1,0,0,2,0,0" << 2.0;
        QTest::newRow("centre line, rotated") << "21,1,2,1,0,0,30" << 2.0;
        QTest::newRow("lower left line") << "22,1,2,1,0,0,0" << 2.0;
        QTest::newRow("outline") << "4,1,3,0,0,2,0,0,2,0,0,0" << 2.0;
        QTest::newRow("polygon") << "5,1,4,0,0,2,0" << 2.0;
        QTest::newRow("exposure off") << "21,1,2,2,0,0,0*21,0,1,1,0,0,0" << 3.0;
        QTest::newRow("exposure off cuts only what is there") << "21,0,1,1,0,0,0*21,1,2,2,0,0,0" << 4.0;
        QTest::newRow("overlapping") << "21,1,2,1,0,0,0*21,1,1,2,0,0,0" << 3.0;
        QTest::newRow("variables") << "$3=$1x2*21,1,$3,$2,0,0,0" << 8.0;
        QTest::newRow("rounded box") << "4,1,4,1,1,-1,1,-1,-1,1,-1,1,1,0*1,1,1,1,1*1,1,1,-1,1*1,1,1,-1,-1*1,1,1,1,-1*"
                                        "20,1,1,1,1,-1,1,0*20,1,1,-1,1,-1,-1,0*20,1,1,-1,-1,1,-1,0*20,1,1,1,-1,1,1,0"
                                     << 8.785398;
        QTest::newRow("thermal") << "7,0,0,4,2,0.5,0" << 9.42478 - 4 * 0.5 * 0.9797;
        QTest::newRow("moire") << "6,0,0,4,0.5,0.5,1,0,0,0" << 5.49779;
    }
    void macrosDrawTheirPrimitives() {
        QFETCH(QString, body);
        QFETCH(double, area);
        const Image image = parse("%AMM*0 a comment*\n" + body.toStdString() + "*%%ADD10M,2X2*%D10*X0Y0D03*");
        QVERIFY2(std::abs(areaOf(shapeOf(image, 0)) - area) < 0.012 * area,
                 QByteArray::number(areaOf(shapeOf(image, 0))));
    }

    void primitivesThatAreNotDrawnAsWrittenAreReported_data() {
        QTest::addColumn<QString>("body");
        QTest::addColumn<double>("area");
        QTest::addColumn<QString>("words");
        QTest::newRow("outline without its corners")
            << "4,1,5,-.5,-.5,.5,-.5,.5,.5,-.5,.5" << 0.0 << "an outline (4) that lacks corners";
        QTest::newRow("outline that is not closed")
            << "4,1,3,0,0,1,0,1,1,0,1,0" << 1.0 << "does not end where it began";
        QTest::newRow("outline whose last corner is missing")
            << "4,1,4,0,0,1,0,1,1,0,1,90" << 1.0 << "does not end where it began";
        QTest::newRow("polygon of two corners") << "5,1,2,0,0,1,0" << 0.0 << "fewer than 3 corners";
        QTest::newRow("polygon of 20 corners") << "5,1,20,0,0,2,0" << 3.0902 << "more than the 12 corners";
        QTest::newRow("polygon of 5000 corners") << "5,1,5000,0,0,2,0" << 3.1416 << "drawn with 1000";
        QTest::newRow("polygon of 4.5 corners") << "5,1,4.5,0,0,2,0" << 2.0 << "rounded down";
        QTest::newRow("thermal of wide cuts") << "7,0,0,1,.6,.8,0" << 0.0 << "a thermal (7) whose hole or cuts";
        QTest::newRow("thermal with too large a hole") << "7,0,0,1,1.2,.1,0" << 0.0 << "a thermal (7) whose hole";
        QTest::newRow("moire of many rings") << "6,0,0,300,.1,.1,200,0,0,0" << -1.0 << "more than 100 rings";
        QTest::newRow("values that lack") << "21,1,2" << 0.0 << "lacks values";
        QTest::newRow("values without a meaning") << "1,1,2,0,0,0,7" << 3.1416 << "more values than it takes";
        QTest::newRow("a size below 0") << "1,1,-2,0,0" << 0.0 << "a size below 0";
        QTest::newRow("a code that does not exist") << "9,1,2,0,0" << 0.0 << "a primitive that cannot be read";
        QTest::newRow("nothing is left") << "1,1,1,0,0*1,0,2,0,0" << 0.0 << "takes away all that it draws";
    }
    void primitivesThatAreNotDrawnAsWrittenAreReported() {
        QFETCH(QString, body);
        QFETCH(double, area);
        QFETCH(QString, words);
        const Image image = parse("%AMM*\n" + body.toStdString() + "*%\n%ADD10M*%D10*X0Y0D03*");
        QVERIFY(isReported(image, words.toStdString()));
        QCOMPARE(image.diagnostics.entries()[0].line, 3U);
        const double drawn = areaOf(shapeOf(image, 0));
        QVERIFY2(area < 0 || std::abs(drawn - area) < 0.01, QByteArray::number(drawn));
    }

    void everyProblemOfAMacroIsReported() {
        const Image image = parse("%AMM*7,0,0,1,.6,.8,0*5,1,2,0,0,1,0*%%ADD10M*%D10*X0Y0D03*");
        QVERIFY(isReported(image, "a thermal (7)"));
        QVERIFY(isReported(image, "fewer than 3 corners"));
    }

    /// A zero is how programs leave a primitive out.
    void primitivesOfNoSizeAreNotReported() {
        const Image image = parse(
            "%AMM*1,1,2,0,0*1,1,0,0,0*20,1,1,0,0,0,0,0*21,1,0,1,0,0,0*5,1,8,0,0,0,0*7,0,0,0,0,0,0*"
            "4,1,3,0,0,1,0,1,1,0,0,0*%%ADD10M*%D10*X0Y0D03*");
        QVERIFY(image.diagnostics.entries().empty());
    }

    /// The corners of the gaps lie on the circles, where booleans are hardest.
    void thermalsKeepTheirGaps() {
        for (int degrees = 0; degrees < 90; degrees += 5) {
            const Image image =
                parse("%AMM*7,0,0,4,2,1.414213562373095," + std::to_string(degrees) + "*%%ADD10M*%D10*X0Y0D03*");
            const double area = areaOf(shapeOf(image, 0));
            QVERIFY2(area > 2.5 && area < 5.5, QByteArray::number(area));
        }
    }

    void standardAperturesThatAreNotDrawnAsWrittenAreReported_data() {
        QTest::addColumn<QString>("aperture");
        QTest::addColumn<double>("area");
        QTest::addColumn<QString>("words");
        QTest::newRow("two corners") << "P,2X2" << 0.0 << "fewer than 3 corners";
        QTest::newRow("20 corners") << "P,2X20" << 3.0902 << "more than the 12 corners";
        QTest::newRow("a hole as large as the disc") << "C,1X1" << 0.0 << "takes away all";
        QTest::newRow("a hole larger than the disc") << "C,1X2" << 0.0 << "takes away all";
        QTest::newRow("a hole beyond two sides") << "R,4X1X2" << 2.0868 << "a hole that reaches beyond it";
        QTest::newRow("a hole below 0") << "C,2X-1" << 3.1416 << "a hole of an absurd size";
        QTest::newRow("sizes without a meaning") << "C,2X1X1X7" << 2.1416 << "more sizes than its shape takes";
    }
    void standardAperturesThatAreNotDrawnAsWrittenAreReported() {
        QFETCH(QString, aperture);
        QFETCH(double, area);
        QFETCH(QString, words);
        const Image image = parse("%ADD10" + aperture.toStdString() + "*%D10*X0Y0D03*");
        QVERIFY(isReported(image, words.toStdString()));
        const double drawn = areaOf(shapeOf(image, 0));
        QVERIFY2(std::abs(drawn - area) < 0.01, QByteArray::number(drawn));
    }

    void aRoundedBoxKeepsItsArcs() {
        const Image image = parse(
            "%AMR*4,1,4,1,1,-1,1,-1,-1,1,-1,1,1,0*1,1,1,1,1*1,1,1,-1,1*1,1,1,-1,-1*1,1,1,1,-1*"
            "20,1,1,1,1,-1,1,0*20,1,1,-1,1,-1,-1,0*20,1,1,-1,-1,1,-1,0*20,1,1,1,-1,1,1,0*%"
            "%ADD10R,1*%%ADD11R,1X1*%D10*X0Y0D03*");
        const model::ShapeSketch& region = shapeOf(image, 0).region;
        QCOMPARE(region.contourCount(), std::size_t{1});
        QCOMPARE(region.contour(0).size(), std::size_t{8});
        QCOMPARE(std::ranges::count_if(region.contour(0), [](const auto& node) { return isArc(node.edge); }), 4);
    }

    void aTurnedFlashIsMirroredFirst() {
        // The corner of a triangle at 1, 0 is mirrored to -1, 0 and then turned to 0, -1.
        const Image image = parse("%AMT*4,1,3,0,0,1,0,0,0.2,0,0,0*%%ADD10T*%%LMX*%%LR90*%%LS2*%D10*X0Y0D03*");
        const DrawnFeature& flash = image.features[0];
        const model::Placement placement{flash.a, flash.clockwiseDeg, flash.isMirrored};
        model::ShapeSketch sketch;
        sketch.append(shapeOf(image, 0).region, placement);
        QCOMPARE(boxOf(sketch), (model::Box{{-400'000, -2'000'000}, {0, 0}}));
    }

    void blocksAreLaidWithTheirObjects() {
        const Image image = parse(
            "%ADD10C,1*%%ABD20*%D10*X1000000Y0D03*%LPC*%X0D03*%LPD*%%AB*%"
            "%LR90*%D20*X5000000Y5000000D03*%LPC*%X0Y0D03*");
        QCOMPARE(image.features.size(), std::size_t{4});
        QCOMPARE(image.features[0].a, (model::Point{5'000'000, 6'000'000}));
        QVERIFY(!image.features[0].isNegative);
        QVERIFY(image.features[1].isNegative);
        QVERIFY(image.features[2].isNegative);
        QVERIFY(!image.features[3].isNegative);
    }

    void explodingBlocksAreBounded() {
        std::string body = "%ADD10C,1*%D10*";
        for (int i = 20; i < 60; ++i) {
            body += "%ABD" + std::to_string(i) + "*%D" + std::to_string(i - 1 < 20 ? 10 : i - 1) + "*";
            body += "X1Y1D03*X2D03*X3D03*X4D03*%AB*%";
        }
        const Image image = parse(body + "D59*X0Y0D03*");
        QVERIFY(isReported(image, "more than 4000000 objects, the limit"));
        QVERIFY(image.features.size() <= 4'000'000);
        QVERIFY(isReported(parse("%ABD20*%D20*X0Y0D03*%AB*%D20*D03*"), "not defined"));
    }

    void repeatedStepsGoUpFirst() {
        const Image image = parse("%ADD10C,1*%D10*%SRX2Y3I5J1*%X0Y0D03*%SR*%X9000000D03*");
        QCOMPARE(image.features.size(), std::size_t{7});
        QCOMPARE(image.features[1].a, (model::Point{0, 1'000'000}));
        QCOMPARE(image.features[3].a, (model::Point{5'000'000, 0}));
    }

    void stepsBeyondAnyBoardAreLeftOut() {
        const std::string square = "%ADD10R,1X1*%D10*%SRX3Y2I5J5000000*%X0Y0D03*%SR*%";
        const Image image = parse(square);
        QCOMPARE(image.features.size(), std::size_t{3});
        QCOMPARE(image.features[2].a, (model::Point{10'000'000, 0}));
        QVERIFY(isReported(image, "repeated step lies beyond any board, more than 1.07 m from the origin;"));
        QVERIFY(parse("%SRX100000Y100000I1J1*%%SR*%").features.empty());  // at once
    }

    void contoursOfARegionAreRegionsOfTheirOwn() {
        const Image image = parse(
            "G36*X0Y0D02*G01X1000000D01*Y1000000D01*X0Y0D01*X5000000Y0D02*G75*"
            "G03X5000000Y0I1000000J0D01*G37*");
        QCOMPARE(image.features.size(), std::size_t{2});
        QCOMPARE(image.regions[0].contour(0).size(), std::size_t{3});
        QCOMPARE(image.regions[1].contour(0).size(), std::size_t{1});
        const Image open = parse("G36*X0Y0D02*G01X1000000D01*Y1000000D01*G37*");
        QCOMPARE(open.features.size(), std::size_t{1});
        QVERIFY(isReported(open, "not closed"));
        const Image cut = parse("G36*X0Y0D02*G01X1000000D01*Y1000000D01*");
        QVERIFY(isReported(cut, "ends within a region"));
        QCOMPARE(cut.diagnostics.count(model::Severity::Error), std::size_t{1});
    }

    void arcsOfASingleQuadrantFindTheirCentre() {
        const Image image = parse(
            "%ADD10C,0.1*%D10*G74*X1000000Y0D02*G03X0Y1000000I1000000J0D01*"
            "G02X1000000Y0I0J1000000D01*X1000000Y0I500000D01*");
        QCOMPARE(image.features[0].centre, (model::Point{0, 0}));
        QVERIFY(!image.features[0].isClockwise);
        QCOMPARE(image.features[1].centre, (model::Point{0, 0}));
        QCOMPARE(image.features[2].kind, DrawnKind::Line);  // equal ends: no length, not a circle
        const Image circle = parse("%ADD10C,0.1*%D10*G75*X0Y0D02*G02X0Y0I500000J0D01*");
        QCOMPARE(circle.features[0].kind, DrawnKind::Arc);
        QCOMPARE(circle.features[0].a, circle.features[0].b);
    }

    /// Old files have neither G74 nor G75: two corners of a rounded square, with and without signs.
    void arcsOfNoSaidQuadrantsFitTheirEnds() {
        for (const char* text : {"X0Y0D02*G03X1000000Y1000000J1000000D01*G01Y3000000D01*G03X0Y4000000I1000000D01*",
                                 "X0Y0D02*G03X1000000Y1000000J1000000D01*G01Y3000000D01*G03X0Y4000000I-1000000D01*"}) {
            const Image image = parse(std::string("%ADD10C,0.1*%D10*") + text);
            QCOMPARE(image.features[0].centre, (model::Point{0, 1'000'000}));
            QCOMPARE(image.features[2].kind, DrawnKind::Arc);
            QCOMPARE(image.features[2].centre, (model::Point{0, 3'000'000}));
            QVERIFY(isReported(image, "without G74 or G75"));
            QVERIFY(!isReported(image, "spiral"));
        }
    }

    void attributesHoldUntilTheyAreDeleted() {
        const Image image = parse(
            "%TF.FileFunction,Copper,L1,Top*%%TA.AperFunction,ViaPad*%%ADD10C,1*%%TD*%"
            "%TO.N,N\\u00e4t*%%TO.P,U1,A3,out*%D10*X0Y0D03*%TD.N*%X1D03*%TD*%X2D03*"
            "G04 #@! TO.N,old*X3D03*%TO.N,*%X4D03*");
        QCOMPARE(image.fileAttribute(".FileFunction"), std::string_view("Copper,L1,Top"));
        QCOMPARE(image.nets[static_cast<std::size_t>(image.features[0].net)], std::string("N\xc3\xa4t"));
        QCOMPARE(image.features[0].subnet, model::SubnetKind::Via);
        QCOMPARE(image.pins[static_cast<std::size_t>(image.features[0].pin)].name, std::string("A3"));
        QCOMPARE(image.features[1].net, model::formats::kNoRow);
        QVERIFY(image.features[1].pin >= 0);
        QVERIFY(image.features[2].pin < 0);
        QCOMPARE(image.nets[static_cast<std::size_t>(image.features[3].net)], std::string("old"));
        QCOMPARE(image.features[4].net, model::formats::kNoRow);
    }

    void outdatedCommandsOfTheWholeImageApply() {
        const std::string body = "%ADD10C,1*%D10*X1000000Y2000000D03*";
        QCOMPARE(parse("%OFA1B2*%" + body).features[0].a, (model::Point{2'000'000, 4'000'000}));
        QCOMPARE(parse("%MIA1B0*%" + body).features[0].a, (model::Point{-1'000'000, 2'000'000}));
        QCOMPARE(parse("%IR90*%" + body).features[0].a, (model::Point{-2'000'000, 1'000'000}));
        QCOMPARE(parse("%SFA2B2*%" + body).features[0].a, (model::Point{2'000'000, 4'000'000}));
        QCOMPARE(parse("%ASAYBX*%" + body).features[0].a, (model::Point{2'000'000, 1'000'000}));
        QCOMPARE(parse("%IR90*%%OFA1B2*%" + body).features[0].a, (model::Point{-4'000'000, 2'000'000}));
        QVERIFY(parse("%IPNEG*%" + body).isNegative);
        QVERIFY(isReported(parse("%MIA1B0*%" + body), "outdated"));
        QVERIFY(!isReported(parse("%OFA0B0*%%SFA1B1*%%IR0*%" + body), "outdated"));
    }

    /// Not apertures, nor the distances of repeated steps.
    void onlyCoordinatesAreMirroredAndScaled() {
        const Image image = parse(
            "%MIA1B0*%%SFA2B2*%%ADD10C,1*%%ADD11P,1X3*%%SRX2Y1I5J0*%D10*X1000000Y0D02*X2000000Y1000000D01*"
            "D11*X3000000Y0D03*%SR*%D10*X1000000Y0D02*G75*G03X0Y1000000I-1000000J0D01*");
        QCOMPARE(image.features[0].a, (model::Point{-2'000'000, 0}));
        QCOMPARE(image.features[0].b, (model::Point{-4'000'000, 2'000'000}));
        QCOMPARE(shapeOf(image, 0).width, 1'000'000);
        QCOMPARE(image.features[1].a, (model::Point{-6'000'000, 0}));
        QVERIFY(!image.features[1].isMirrored);
        QCOMPARE(image.features[2].a, (model::Point{3'000'000, 0}));
        QCOMPARE(image.features[4].centre, (model::Point{0, 0}));
        QCOMPARE(image.features[4].b, (model::Point{0, 2'000'000}));
        QVERIFY(image.features[4].isClockwise);
    }

    void whatMovesTheImageOnItsFilmIsReported() {
        for (const char* moving : {"IJAC.5B0", "IJALBL", "IJA0BC", "IOA1.0B1.0", "IOA0B.5", "IOAx"}) {
            QVERIFY2(isReported(parse(std::string("%") + moving + "*%"), "moved on its film"), moving);
        }
        for (const char* neutral : {"IJA0B0", "IJ", "IOA0B0", "IOA0.0B0.0", "PFFILM", "ICAS"}) {
            QVERIFY2(parse(std::string("%") + neutral + "*%").diagnostics.entries().empty(), neutral);
        }
    }

    void whatTheHeadSaysTwiceIsReported() {
        const std::string head = "%FSLAX46Y46*%%MOMM*%";
        QVERIFY(parse("%FSLAX46Y46*%%MOMM*%", head).diagnostics.entries().empty());
        QVERIFY(isReported(parse("%MOIN*%", head), "a second unit"));
        QVERIFY(isReported(parse("%FSLAX25Y25*%", head), "a second time"));
        QVERIFY(isReported(parse("%FSTAX46Y46*%", head), "a second time"));
        QVERIFY(isReported(parse("", "%FSLAX46Y45*%%MOMM*%"), "different digits"));
    }

    void commandsThatCannotBeReadAreReported_data() {
        QTest::addColumn<QString>("body");
        QTest::addColumn<QString>("words");
        QTest::newRow("IP") << "%IPFOO*%"
                            << "polarity of the image";
        QTest::newRow("OF") << "%OFAxB1*%"
                            << "of the image (OF, MI, IR, AS, SF) that cannot be read";
        QTest::newRow("OF beyond any board") << "%OFA5000B0*%"
                                             << "of the image (OF, MI, IR, AS, SF) that cannot be read";
        QTest::newRow("IR") << "%IRx*%"
                            << "of the image (OF, MI, IR, AS, SF) that cannot be read";
        QTest::newRow("AS") << "%ASFOO*%"
                            << "of the image (OF, MI, IR, AS, SF) that cannot be read";
        QTest::newRow("LM") << "%LMQ*%"
                            << "that cannot be read";
        QTest::newRow("SR") << "%SRXaY2I1J1*%"
                            << "repeated step whose counts cannot be read";
        QTest::newRow("M") << "M64*"
                           << "M code";
        QTest::newRow("behind the end") << "M02*\nX0Y0D03*"
                                        << "behind the end";
        QTest::newRow("beyond any board, once moved") << "%OFA600B0*%%ADD10C,1*%D10*X600000000Y0D03*"
                                                      << "draws beyond any board";
    }
    void commandsThatCannotBeReadAreReported() {
        QFETCH(QString, body);
        QFETCH(QString, words);
        QVERIFY(isReported(parse(body.toStdString()), words.toStdString()));
    }

    void whatMayStandBehindTheEndIsNotReported() {
        const std::string text = "%FSLAX46Y46*%%MOMM*%M01*M02*%\n*\n" + std::string(3, '\0') + "\x1a";
        QVERIFY(model::gerber::parseImage(text, "test.gbr").diagnostics.entries().empty());
    }

    void aFileThatIsCutOffIsReported() {
        const Image image = model::gerber::parseImage("%FSLAX46Y46*%%MOMM*%%ADD10C,1*%D10*X0Y0D03*", "test.gbr");
        QCOMPARE(image.features.size(), std::size_t{1});
        QVERIFY(isReported(image, "without M02"));
    }
};

QTEST_APPLESS_MAIN(GerberImageTest)
#include "gerber_image_test.moc"
