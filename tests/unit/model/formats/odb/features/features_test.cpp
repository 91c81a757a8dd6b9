#include "model/formats/odb/features/features.h"

#include "tests/unit/model/formats/odb/odb_testing.h"

using model::Diagnostics;
using model::EdgeKind;
using model::Point;
using model::odb::FeatureFile;
using model::odb::FeatureKind;
using model::odb::parseFeatures;
using model::odb::Unit;

namespace {

struct Result {
    FeatureFile file;
    Diagnostics diagnostics;
};

Result parse(std::string_view text, Unit unit = Unit::Millimetre) {
    Result result;
    result.file = parseFeatures(text, "features", unit, result.diagnostics);
    return result;
}

}  // namespace

class FeaturesTest : public QObject {
    Q_OBJECT

private slots:
    void unitComesFromTheFileThenFromTheJob_data() {
        QTest::addColumn<QString>("text");
        QTest::addColumn<bool>("jobIsInch");
        QTest::addColumn<int>("x");
        QTest::addColumn<bool>("symbolIsInch");
        const int mm = 1'000'000;
        const int inch = 25'400'000;
        QTest::newRow("v8 MM") << "UNITS=MM\n$0 r1\nP 1 0 0 P 0 0\n" << true << mm << false;
        QTest::newRow("v8 INCH") << "UNITS=INCH\n$0 r1\nP 1 0 0 P 0 0\n" << false << inch << true;
        QTest::newRow("v7 MM") << "#\n#Units\n#\nU MM\n$0 r1\nP 1 0 0 P 0 0\n" << true << mm << false;
        QTest::newRow("v7 INCH") << "U INCH\n$0 r1\nP 1 0 0 P 0 0\n" << false << inch << true;
        QTest::newRow("none, job in inch") << "$0 r1\nP 1 0 0 P 0 0\n" << true << inch << true;
        QTest::newRow("none, job in mm") << "$0 r1\nP 1 0 0 P 0 0\n" << false << mm << false;
        QTest::newRow("symbol in mil") << "UNITS=MM\n$0 r1 I\nP 1 0 0 P 0 0\n" << false << mm << true;
        QTest::newRow("symbol in um") << "UNITS=INCH\n$0 r1 M\nP 1 0 0 P 0 0\n" << true << inch << false;
        QTest::newRow("empty unit") << "UNITS=\n$0 r1\nP 1 0 0 P 0 0\n" << false << mm << false;
    }
    void unitComesFromTheFileThenFromTheJob() {
        QFETCH(QString, text);
        QFETCH(bool, jobIsInch);
        QFETCH(int, x);
        QFETCH(bool, symbolIsInch);
        const Result result = parse(text.toStdString(), jobIsInch ? Unit::Inch : Unit::Millimetre);
        QCOMPARE(result.file.features.size(), std::size_t{1});
        QCOMPARE(result.file.features[0].a.x, x);
        QCOMPARE(result.file.symbols[0].unit, symbolIsInch ? Unit::Inch : Unit::Millimetre);
        QVERIFY(result.diagnostics.entries().empty());
    }

    void padOrientationCodes_data() {
        QTest::addColumn<QString>("code");
        QTest::addColumn<double>("degrees");
        QTest::addColumn<bool>("isMirrored");
        for (int code = 0; code < 8; ++code) {
            const std::string name = std::to_string(code);
            QTest::newRow(name.c_str()) << QString::number(code) << (code % 4) * 90.0 << (code >= 4);
        }
        QTest::newRow("8 with angle") << "8 33.5" << 33.5 << false;
        QTest::newRow("9 with angle") << "9 270.0" << 270.0 << true;
        QTest::newRow("none") << "" << 0.0 << false;
    }
    void padOrientationCodes() {
        QFETCH(QString, code);
        QFETCH(double, degrees);
        QFETCH(bool, isMirrored);
        const Result result = parse("$0 r1\nP 1 2 0 P 0 " + code.toStdString() + ";0=1\n");
        QCOMPARE(result.file.features[0].kind, FeatureKind::Pad);
        QCOMPARE(result.file.features[0].clockwiseDeg, degrees);
        QCOMPARE(result.file.features[0].isMirrored, isMirrored);
    }

    void orientationEightWithoutAngleIsABadRecord() {
        const Result result = parse("$0 r1\nP 1 2 0 P 0 8\n");
        QCOMPARE(result.file.features[0].kind, FeatureKind::Bad);
    }

    void attributeTailVariants_data() {
        QTest::addColumn<QString>("tail");
        QTest::addColumn<int>("drill");
        QTest::newRow("none") << "" << -1;
        QTest::newRow("blank, then value") << " ;3=1" << 1;
        QTest::newRow("no blank") << ";3=2" << 2;
        QTest::newRow("among others") << ";0,1=12.5,3=0;ID=77" << 0;
        QTest::newRow("id only") << ";;ID=7" << -1;
        QTest::newRow("boolean and id") << ";0;ID=7" << -1;
        QTest::newRow("longer index that ends alike") << ";13=1" << -1;
        QTest::newRow("value of another type") << ";3=x" << -1;
        QTest::newRow("value in the id part") << ";0;3=1" << -1;
    }
    void attributeTailVariants() {
        QFETCH(QString, tail);
        QFETCH(int, drill);
        const std::string head = "@0 .pad_usage\n@1 .x\n@3 .drill\n&0 a;3=1\n$0 r1\n";
        for (const std::string record : {"P 1 2 0 P 0 0", "L 1 2 3 4 0 P 0", "A 1 2 3 4 5 6 0 P 0 Y"}) {
            const Result result = parse(head + record + tail.toStdString() + "\n");
            QCOMPARE(result.file.features.size(), std::size_t{1});
            QVERIFY(result.file.features[0].kind != FeatureKind::Bad);
            QCOMPARE(static_cast<int>(result.file.features[0].plating) - 1,
                     drill);  // the values are Plating's in their order
        }
    }

    void aFileThatIsCutOffInASurfaceHasAnError() {
        const Result result = parse("S P 0\nOB 0 0 I\nOS 1 0\nOS 1 1\nOE\n");
        QCOMPARE(result.diagnostics.count(model::Severity::Error), std::size_t{1});
    }

    void textsAndBarcodesAreReadInFull() {
        const Result result = parse(
            "UNITS=INCH\nT 1 2 standard N 9 30 0.1 0.2 0.5 'It's; 100' 1;0=1;ID=5\n"
            "B 1 2 UPC39 standard P 2 E 0.008 0.2 Y N Y Y B 'a'b';0\nT 0 0 standard P 0 0.1 0.2 0.5 'open\n");
        QCOMPARE(result.file.features.size(), std::size_t{3});
        const auto& text = result.file.features[0];
        QCOMPARE(text.kind, FeatureKind::Text);
        QVERIFY(text.isNegative && text.isMirrored);
        QCOMPARE(text.clockwiseDeg, 30.0);
        QCOMPARE(text.a, (Point{25'400'000, 50'800'000}));
        QCOMPARE(result.file.texts[0].line.text, std::string("It's; 100"));
        QCOMPARE(result.file.texts[0].line.xSize, 2'540'000);
        QCOMPARE(result.file.texts[0].line.ySize, 5'080'000);
        QCOMPARE(result.file.texts[0].line.widthFactor, 0.5);
        const auto& barcode = result.file.barcodes[0];
        QCOMPARE(result.file.features[1].clockwiseDeg, 180.0);
        QCOMPARE(barcode.code, std::string("UPC39"));
        QCOMPARE(barcode.text, std::string("a'b"));
        QCOMPARE(barcode.elementWidth, 203'200);
        QCOMPARE(barcode.height, 5'080'000);
        QVERIFY(barcode.isFullAscii && !barcode.hasChecksum && barcode.isInverted && barcode.hasString);
        QVERIFY(!barcode.isStringAbove);
        QCOMPARE(result.file.features[2].kind, FeatureKind::Bad);
    }

    void ordinalsCountEveryRecordOnce() {
        const Result result = parse(
            "$0 r1\nL 0 0 1 1 0 P 0\nT 0 0 standard P 0 1 1 1 'S P 0' 1\nS P 0\nOB 0 0 I\nOS 1 0\nOS 1 1\nOE\nSE\n"
            "B 0 0 UPC39 standard P 0 E 1 1 N Y N Y T 'x'\nL 0 0 x 1 0 P 0\nP 5 5 0 N 0 0\n");
        const std::vector<FeatureKind> expected = {FeatureKind::Line,    FeatureKind::Text, FeatureKind::Surface,
                                                   FeatureKind::Barcode, FeatureKind::Bad,  FeatureKind::Pad};
        QCOMPARE(result.file.features.size(), expected.size());
        for (std::size_t i = 0; i < expected.size(); ++i) {
            QCOMPARE(result.file.features[i].kind, expected[i]);
        }
        QVERIFY(result.file.hasNegatives);
        QVERIFY(result.file.features[5].isNegative);
        QCOMPARE(result.file.features[5].line, 12U);
    }

    void badRecordsAreReportedWithTheirLine_data() {
        QTest::addColumn<QString>("record");
        QTest::newRow("too short") << "L 0 0 1 1 0";
        QTest::newRow("no number") << "L 0 0 one 1 0 P 0";
        QTest::newRow("out of range") << "P 2000 0 0 P 0 0";
        QTest::newRow("polarity") << "P 1 0 0 X 0 0";
        QTest::newRow("symbol not listed") << "P 1 0 7 P 0 0";
        QTest::newRow("negative symbol") << "L 1 0 2 2 -1 P 0";
        QTest::newRow("arc without direction") << "A 0 0 1 1 1 0 0 P 0";
        QTest::newRow("surface polarity") << "S Q 0\nOB 0 0 I\nOS 1 0\nOS 1 1\nOS 0 0\nOE\nSE";
    }
    void badRecordsAreReportedWithTheirLine() {
        QFETCH(QString, record);
        const Result result = parse("$0 r1\n" + record.toStdString() + "\nP 1 1 0 P 0 0\n");
        QCOMPARE(result.file.features.size(), std::size_t{2});
        QCOMPARE(result.file.features[0].kind, FeatureKind::Bad);
        QCOMPARE(result.file.features[1].kind, FeatureKind::Pad);
        QCOMPARE(result.diagnostics.count(model::Severity::Error), std::size_t{1});
        QCOMPARE(result.diagnostics.entries()[0].line, 2U);
        QCOMPARE(result.diagnostics.entries()[0].file, std::string("features"));
    }

    void arcsKeepTheirDirection() {
        const Result result = parse("$4 r1\nA 1 0 0 1 0 0 4 P 0 Y\nA 1 0 0 1 0 0 4 P 0 N\n");
        QVERIFY(result.file.features[0].isClockwise);
        QVERIFY(!result.file.features[1].isClockwise);
        QCOMPARE(result.file.features[0].centre, (Point{0, 0}));
        QCOMPARE(result.file.features[0].b, (Point{0, 1'000'000}));
    }

    void resizedPadsMakeSymbolsOfTheirOwn() {
        const Result result =
            parse("UNITS=MM\n$0 r100 I\nP 1 2 -1 0 -50 P 0 8 45\nP 1 2 -1 0 -50 P 0 0\nP 1 2 0 P 0 0\n");
        QCOMPARE(result.file.symbols.size(), std::size_t{2});
        QCOMPARE(result.file.symbols[1].resize, -50'000);
        QCOMPARE(result.file.symbols[1].unit, Unit::Inch);
        QCOMPARE(result.file.features[0].index, 1U);
        QCOMPARE(result.file.features[0].clockwiseDeg, 45.0);
        QCOMPARE(result.file.features[1].index, 1U);
        QCOMPARE(result.file.features[2].index, 0U);
    }

    void surfacesKeepIslandsHolesAndExactArcs() {
        const Result result = parse(
            "S P 0\nOB 0 0 I\nOS 0 0\nOS 4 0\nOC 4 4 4 2 N\nOS 0 4\nOS 0 0\nOE\n"
            "OB 2 2 H\nOC 2 2 1 2 Y\nOE\nOB 9 9 I\nOS 10 9\nOS 10 10\nOE\nSE\n");
        const auto& table = result.file.surfaces;
        QCOMPARE(table.shapes.size(), std::size_t{1});
        QCOMPARE(table.contours.size(), std::size_t{3});
        QVERIFY(!table.contours[0].isHole);
        QVERIFY(table.contours[1].isHole);
        QVERIFY(!table.contours[2].isHole);
        const auto outline = table.nodesOf(table.contours[0]);
        QCOMPARE(outline.size(), std::size_t{4});  // neither the doubled first nor the closing vertex
        QCOMPARE(outline[1].edge, EdgeKind::ArcCounterClockwise);
        QCOMPARE(outline[1].centre, (Point{4'000'000, 2'000'000}));
        const auto hole = table.nodesOf(table.contours[1]);
        QCOMPARE(hole.size(), std::size_t{1});  // a full circle
        QCOMPARE(hole[0].edge, EdgeKind::ArcClockwise);
        QCOMPARE(table.shapes[0].box.max, (Point{10'000'000, 10'000'000}));
        // The bulge of the half circle counts: centre (4, 2), radius 2.
        QCOMPARE(model::boxOfPath(outline, true).max.x, 6'000'000);
    }

    void polygonsThatCannotBeUsedAreLeftOutAndReported_data() {
        QTest::addColumn<QString>("polygons");
        QTest::addColumn<int>("contours");
        QTest::addColumn<QString>("text");
        QTest::newRow("no area") << "OB 0 0 I\nOS 1 0\nOS 0 0\nOE\n" << 0 << "without area";
        QTest::newRow("a single point") << "OB 0 0 I\nOE\n" << 0 << "without area";
        QTest::newRow("hole first") << "OB 0 0 H\nOS 1 0\nOS 1 1\nOE\n" << 0 << "lies in no island";
        QTest::newRow("unknown letter") << "OB 0 0 X\nOS 1 0\nOS 1 1\nOE\n" << 0 << "unreadable";
        QTest::newRow("bad vertex") << "OB 0 0 I\nOS 1 zero\nOS 1 1\nOE\n" << 0 << "unreadable";
        QTest::newRow("open") << "OB 0 0 I\nOS 1 0\nOS 1 1\nOE\n" << 1 << "not closed";
        QTest::newRow("arc without radius") << "OB 0 0 I\nOC 1 0 1 0 Y\nOS 1 1\nOS 0 0\nOE\n"
                                            << 1 << "without a radius";
        QTest::newRow("no OE between") << "OB 0 0 I\nOS 1 0\nOS 1 1\nOB 5 5 I\nOS 6 5\nOS 6 6\nOE\n"
                                       << 2 << "begins before";
        QTest::newRow("edge outside") << "OS 1 1\nOB 0 0 I\nOS 1 0\nOS 1 1\nOE\n" << 1 << "outside of a polygon";
        QTest::newRow("OE outside") << "OE\n" << 0 << "has not begun";
    }
    void polygonsThatCannotBeUsedAreLeftOutAndReported() {
        QFETCH(QString, polygons);
        QFETCH(int, contours);
        QFETCH(QString, text);
        const Result result = parse("S P 0\n" + polygons.toStdString() + "SE\n$0 r1\nP 1 1 0 P 0 0\n");
        QCOMPARE(result.file.surfaces.contours.size(), static_cast<std::size_t>(contours));
        QVERIFY(odb_testing::findDiagnostic(result.diagnostics, text.toStdString()) != nullptr);
        QCOMPARE(result.file.features.size(), std::size_t{2});
    }

    void aSurfaceWithoutEndDoesNotSwallowTheNextRecord() {
        const Result result = parse("$0 r1\nS P 0\nOB 0 0 I\nOS 1 0\nOS 1 1\nOE\nP 1 1 0 P 0 0\n");
        QCOMPARE(result.file.features.size(), std::size_t{2});
        QCOMPARE(result.file.features[1].kind, FeatureKind::Pad);
        QCOMPARE(result.file.features[1].line, 7U);
        QVERIFY(odb_testing::findDiagnostic(result.diagnostics, "not ended by SE") != nullptr);
    }

    void aWrongFeatureCountIsReported() {
        const Result result = parse("F 3\n$0 r1\nP 1 1 0 P 0 0\n");
        QVERIFY(odb_testing::findDiagnostic(result.diagnostics, "its F line says 3") != nullptr);
        QVERIFY(parse("F 1\n$0 r1\nP 1 1 0 P 0 0\n").diagnostics.entries().empty());
    }

    void numbersInTablesMaySkip() {
        const Result result = parse("$7 r7\n$2 r2\nP 0 0 2 P 0 0\nP 0 0 7 P 0 0\nP 0 0 3 P 0 0\n$2000000000 r1\n");
        QCOMPARE(result.file.symbols[result.file.features[0].index].name, std::string("r2"));
        QCOMPARE(result.file.symbols[result.file.features[1].index].name, std::string("r7"));
        QCOMPARE(result.file.features[2].kind, FeatureKind::Bad);
        QCOMPARE(result.file.symbols.size(), std::size_t{2});
    }

    void everyTruncatedPrefixIsReadWithoutHarm() {
        const std::string text =
            odb_testing::readFile(odb_testing::dataJob("everything") / "steps/board/layers/top/features");
        const std::size_t all = parse(text).file.features.size();
        std::size_t last = 0;
        for (std::size_t length = 0; length <= text.size(); ++length) {
            // A buffer of its own, so that a read beyond the end is seen by the sanitizer.
            const std::vector<char> prefix(text.begin(), text.begin() + static_cast<std::ptrdiff_t>(length));
            const Result result = parse({prefix.data(), prefix.size()});
            // A cut "SE" looks like the start of another surface.
            QVERIFY(result.file.features.size() + 1 >= last);
            last = result.file.features.size();
        }
        QCOMPARE(last, all);
    }
};

QTEST_APPLESS_MAIN(FeaturesTest)
#include "features_test.moc"
