#include <QtTest>
#include <algorithm>

#include "model/formats/gerber/drills/drill_file.h"

using model::Plating;
using model::Point;
using model::formats::DrawnKind;
using model::gerber::Image;

namespace {

Image parse(const std::string& text) {
    const auto formats = model::gerber::likelyFormats(model::gerber::readDrillHead(text));
    return model::gerber::parseDrills(text, "test.drl", formats.front());
}

model::Nm sizeOf(const Image& image, std::size_t feature) {
    return image.symbols[static_cast<std::size_t>(image.features[feature].symbol)].shape.width;
}

}  // namespace

class GerberDrillsTest : public QObject {
    Q_OBJECT

private slots:
    void zerosAreKeptAsTheHeadSays_data() {
        QTest::addColumn<QString>("head");
        QTest::addColumn<QString>("hit");
        QTest::addColumn<int>("x");
        QTest::newRow("inch, leading zeros kept") << "INCH,LZ"
                                                  << "X0125" << 31'750'000;
        QTest::newRow("inch, trailing zeros kept") << "INCH,TZ"
                                                   << "X12500" << 31'750'000;
        QTest::newRow("metric") << "METRIC,TZ"
                                << "X12500" << 12'500'000;
        QTest::newRow("metric with digits") << "METRIC,TZ,0000.00"
                                            << "X1250" << 12'500'000;
        QTest::newRow("digits in a comment") << ";FILE_FORMAT=4:4\nMETRIC,LZ"
                                             << "X00125" << 12'500'000;
        QTest::newRow("Mentor") << "; Format  : 3.3 / Absolute / MM / Leading\nMETRIC,TZ"
                                << "X-12500" << -12'500'000;
        QTest::newRow("a point") << "METRIC,LZ"
                                 << "X12.5" << 12'500'000;
        QTest::newRow("M71") << "M71,TZ"
                             << "X12.5" << 12'500'000;
    }
    void zerosAreKeptAsTheHeadSays() {
        QFETCH(QString, head);
        QFETCH(QString, hit);
        QFETCH(int, x);
        const Image image = parse("M48\n" + head.toStdString() + "\nT1C0.5\n%\nT1\n" + hit.toStdString() + "Y0\nM30\n");
        QCOMPARE(image.features.at(0).a.x, x);
    }

    void unstatedZerosShowInTheDigits() {
        // PADS: no header; shorter numbers begin with zeros, so those are kept.
        const Image image = parse("%\nT1C.015F095S3\nX01095Y01056\nX01095Y0127\nM30\n");
        QCOMPARE(image.features.at(1).a, (Point{27'813'000, 32'258'000}));
        QCOMPARE(sizeOf(image, 0), 381'000);
    }

    void slotsAndRoutesAreTracks() {
        const Image image = parse(
            "M48\nMETRIC\nT1C1.0\n%\nT1\nX1.0Y1.0G85X2.0Y1.0\nG00X5.0Y5.0\nM15\nG01X6.0\n"
            "G03X6.0Y7.0A1.0\nM16\nG00X9.0\nG05\nX3.0Y3.0\nM30\n");
        QCOMPARE(image.features.size(), std::size_t{4});
        QCOMPARE(image.features[0].kind, DrawnKind::Line);
        QCOMPARE(image.features[0].b, (Point{2'000'000, 1'000'000}));
        QCOMPARE(image.features[1].b, (Point{6'000'000, 5'000'000}));
        QCOMPARE(image.features[2].kind, DrawnKind::Arc);
        QCOMPARE(image.features[2].centre, (Point{6'000'000, 6'000'000}));
        QCOMPARE(image.features[3].kind, DrawnKind::Pad);
    }

    void bothEndsOfASlotMayStandBehindItsCode() {
        const Image image = parse(
            "M48\nMETRIC,TZ\nT1C0.8\n%\nT1\nX9000Y9000\nG85X2000Y5000X6000Y4000\nG85X2000Y5000Y7000\n"
            "X1000Y1000G85X3000\nM30\n");
        QCOMPARE(image.features.size(), std::size_t{4});
        QCOMPARE(image.features[1].kind, DrawnKind::Line);
        QCOMPARE(image.features[1].a, (Point{2'000'000, 5'000'000}));
        QCOMPARE(image.features[1].b, (Point{6'000'000, 4'000'000}));
        QCOMPARE(image.features[2].b, (Point{2'000'000, 7'000'000}));
        QCOMPARE(image.features[3].a, (Point{1'000'000, 1'000'000}));
        QCOMPARE(image.features[3].b, (Point{3'000'000, 1'000'000}));
    }

    void platingFollowsAttributesSectionsAndComments() {
        const Image kicad = parse(
            "M48\nMETRIC\n; #@! TA.AperFunction,Plated,PTH,ViaDrill\nT1C0.3\n"
            "; #@! TA.AperFunction,NonPlated,NPTH,ComponentDrill\nT2C1.0\n%\nT1\nX1.Y1.\nT2\nX2.Y2.\nM30\n");
        QCOMPARE(kicad.features[0].plating, Plating::Via);
        QCOMPARE(kicad.features[1].plating, Plating::NonPlated);
        const Image altium =
            parse("M48\nMETRIC\n;TYPE=PLATED\nT1C0.3\n;TYPE=NON_PLATED\nT2C1.0\n%\nT1\nX1.Y1.\nT2\nX2.Y2.\nM30\n");
        QCOMPARE(altium.features[0].plating, Plating::Plated);
        QCOMPARE(altium.features[1].plating, Plating::NonPlated);
        const Image allegro = parse(
            ";T01 Holesize 1. = 12.000000 Tolerance = +0.000000/-0.000000 PLATED MILS Quantity = 1\n"
            ";T02 Holesize 2. = 40.000000 Tolerance = +0.000000/-0.000000 NON_PLATED MILS Quantity = 1\n"
            "%\nG90\nT01\nX004450Y000200\nT02\nX009874Y002026\nM30\n");
        QCOMPARE(sizeOf(allegro, 0), 304'800);
        QCOMPARE(allegro.features[0].a, (Point{11'303'000, 508'000}));
        QCOMPARE(allegro.features[1].plating, Plating::NonPlated);
    }

    void holesAreRepeated() {
        const Image image =
            parse("M48\nMETRIC\nT1C0.3\n%\nT1\nX1.0Y1.0\nR2X0.5\nM25\nX10.0Y0.0\nM01\nM02X0Y5.0\nM30\n");
        QCOMPARE(image.features.size(), std::size_t{5});
        QCOMPARE(image.features[2].a, (Point{2'000'000, 1'000'000}));
        QCOMPARE(image.features[4].a, (Point{10'000'000, 5'000'000}));
    }

    void repetitionsEndWhereBoardsEnd() {
        const Image image = parse("M48\nMETRIC\nT1C0.3\n%\nT1\nX1.0Y1.0\nR30000X100.0\nM30\n");
        QCOMPARE(image.features.size(), std::size_t{11});
        QCOMPARE(image.diagnostics.entries().size(), std::size_t{1});
        QCOMPARE(image.diagnostics.entries()[0].count, 1U);
    }

    void incrementalPlacesAndOriginsCount() {
        const Image image = parse("M48\nMETRIC\nT1C0.3\n%\nG93X1.0Y2.0\nT1\nX1.0Y1.0\nICI,ON\nX0.5\nM30\n");
        QCOMPARE(image.features[0].a, (Point{2'000'000, 3'000'000}));
        QCOMPARE(image.features[1].a, (Point{2'500'000, 3'000'000}));
    }

    void toolsWithoutASizeStayHoles() {
        const Image image = parse("M48\nMETRIC\nT1C0.000\n%\nT1\nX1.0Y1.0\nT7\nX2.0Y2.0\nM30\n");
        QCOMPARE(image.features.size(), std::size_t{2});
        QCOMPARE(sizeOf(image, 1), 10);
        QVERIFY(image.diagnostics.entries().empty());  // a netlist may tell it
    }
};

QTEST_APPLESS_MAIN(GerberDrillsTest)
#include "gerber_drills_test.moc"
