#include "model/formats/paper/paper_reader.h"

#include <QtTest>
#include <algorithm>

#include "model/formats/paper/lexer.h"

using model::ElementKind;
using model::Severity;

namespace {

constexpr std::string_view kModel =
    "LAYERBEGIN\nLAYERTYPE,Top\nBASEPLANEHEIGHT,8.0\nTHICKNESS,1.2\nPOINTCOUNT,1\nSEGCOUNT,1\n"
    "LINEBEGIN\nLINEID,1\nLINEDATA,2\n0.0,0.0\nSTRAIGHT,1,20.0,100.0,0.0\nLINEEND\n"
    "LINEBEGIN\nLINEID,2\nLINEDATA,2\n0.0,0.0\nARC,1,10.0,50.0,0.0,100.0,0.0,CW\nLINEEND\n"
    "LINEBEGIN\nLINEID,3\nLINEDATA,3\n0.0,0.0\nSTRAIGHT,1,20.0,100.0,0.0\nSTRAIGHT,1,30.0,100.0,50.0\nLINEEND\n"
    "LAYEREND\n"
    "LAYERBEGIN\nLAYERTYPE,L4_Sig-h 3.3V\nBASEPLANEHEIGHT,0\nTHICKNESS,8.0\n"
    "SHAPEBEGIN\nSHAPEID,1\nSHAPEDATA,1\nCIRCLE,1,0.0,10.0,20.0,30.0\nVOIDDATA,1\nCIRCLE,1,0.0,10.0,20.0,12."
    "5\nSHAPEEND\n"
    "SHAPEBEGIN\nSHAPEID,2\nSHAPEDATA,4\n0,0\nSTRAIGHT,0,0,10,0\nSTRAIGHT,0,0,10,10\nSTRAIGHT,0,0,0,0\nSHAPEEND\n"
    "LAYEREND\n";

/// A quarter of a circle, nearly: from 1, 0 to 0, 1.
constexpr const char* kQuarter = "NURBS,1,0,2,3,1,1,1.00001,0.7071067811865476,0,1.000001,1,0,0,0,1,1,1";

/// A shape of three edges from 0, 0 over 1, 0 and the end of `edge`; then a line.
std::string shapeWith(const std::string& edge) {
    return "LAYERBEGIN\nLAYERTYPE,Top\nTHICKNESS,1.2\n"
           "SHAPEBEGIN\nSHAPEID,2\nSHAPEDATA,4\n0,0\nSTRAIGHT,0,0,1,0\n" +
           edge + "\nSTRAIGHT,0,0,0,0\nSHAPEEND\n" +
           "LINEBEGIN\nLINEID,1\nLINEDATA,2\n0.0,0.0\nSTRAIGHT,1,20.0,100.0,0.0\nLINEEND\nLAYEREND\n";
}

std::shared_ptr<const model::Document> read(std::string_view text) {
    base::Progress progress;
    base::Result<std::shared_ptr<const model::Document>> result = model::paper::readModel(text, "model.txt", progress);
    return result ? *result : nullptr;
}

}  // namespace

class PaperReaderTest : public QObject {
    Q_OBJECT

private slots:
    void recordsBecomeTheKindsOfTable3() {
        const auto document = read(kModel);
        QVERIFY(document);
        QCOMPARE(document->elementCounts(), (std::array<std::uint32_t, 5>{1, 1, 1, 1, 1}));
        QCOMPARE(document->layers.size(), 2U);
        QCOMPARE(document->layers[1].name, std::string("L4_Sig-h 3.3V"));
    }

    void milsBecomeExactNanometres() {
        const auto document = read(kModel);
        QCOMPARE(document->lines[0].width, 508'000);
        QVERIFY((document->lines[0].b == model::Point{2'540'000, 0}));
        QCOMPARE(document->circles[0].innerDiameter, 635'000);
        QCOMPARE(document->widthsOf(document->trails[0])[1], 762'000);
    }

    void heightsCountFromTheLowestFace() {
        const auto document = read(kModel);
        QCOMPARE(document->layers[0].z, 203'200);
        QCOMPARE(document->layers[0].thickness, 30'480);
        QCOMPARE(document->layers[1].z, 0);
        QCOMPARE(document->boardThickness, 233'680);
    }

    void bottomExtrudesDownwards() {
        const auto document = read(
            "LAYERBEGIN\nLAYERTYPE,Bottom\nBASEPLANEHEIGHT,0\nTHICKNESS,1\nLAYEREND\n"
            "LAYERBEGIN\nLAYERTYPE,Top\nBASEPLANEHEIGHT,0\nTHICKNESS,1\nLAYEREND\n");
        QCOMPARE(document->layers[0].z, 0);
        QCOMPARE(document->layers[1].z, 25'400);
    }

    void brokenRecordsAreListedAndTheRestIsRead() {
        std::string text(kModel);
        text.replace(text.find("STRAIGHT,1,20.0,100.0,0.0"), 8, "CURVED--");
        const auto document = read(text);
        QCOMPARE(document->elementCounts()[0], 0U);
        QCOMPARE(document->elementCounts()[1], 1U);
        QCOMPARE(document->diagnostics.count(Severity::Warning), 1U);
        QCOMPARE(document->diagnostics.entries()[0].line, 11U);
    }

    void nurbsOfShapesAreReadAsWritten() {
        const auto document = read(shapeWith(kQuarter));
        QCOMPARE(document->diagnostics.count(Severity::Warning), 0U);
        const auto nodes = document->shapes.nodesOf(document->shapes.contoursOf(document->areas[0].shape)[0]);
        QCOMPARE(nodes.size(), 3U);
        QVERIFY(nodes[1].edge == model::EdgeKind::Curve);
        QVERIFY((nodes[1].point == model::Point{25'400, 0}));
        const model::NurbsView curve = nodes.curveAt(1);
        QCOMPARE(curve.degree, 2);
        QCOMPARE(curve.knots.size(), 6U);
        QCOMPARE(curve.controls[0].weight, 1.0);
        QCOMPARE(curve.controls[1].weight, 0.7071067811865476);
        QVERIFY((curve.controls[1].at == model::PointD{25'400, 25'400.254}));  // not rounded, as ends are
        QVERIFY((curve.controls[2].at == model::PointD{0, 25'400}));
    }

    void curvesThatBreakTheRulesAreLeftOutWithTheReason_data() {
        QTest::addColumn<QString>("edge");
        QTest::addColumn<QString>("reason");
        const auto row = [](const char* edge, const char* reason) { QTest::addRow("%s", edge) << edge << reason; };
        row("NURBS,1,0,0,1,1,0,1", "degree");
        row("NURBS,1,0,1.5,2,1,1,1,1,0,0,1,1", "from 0 to 30");
        row("NURBS,1,0,31,40,1,1,1,1", "from 0 to 30");
        row("NURBS,1,0,2,1e9,1", "from 0 to 100000");
        row("NURBS,1,0,2,-1,1", "from 0 to 100000");
        row("NURBS,1,0,2,3,1,1,1,0,0,1,1,0,0,0,1,1,1", "weight");
        row("NURBS,1,0,2,3,1,1,1,1,0,1,1,0,0,1,1,1,1", "not clamped");
        row("NURBS,1,0,2,3,1,1,1,1,0,1,1,0,0,0,1,1", "a number belongs");
        row("NURBS,1,0,2,3,1,1,1e9,1,0,1,1,0,0,0,1,1,1", "beyond 1 m");
        row("SPLINE,1,0,2,3", "neither STRAIGHT, ARC, NURBS nor CIRCLE");
    }
    void curvesThatBreakTheRulesAreLeftOutWithTheReason() {
        QFETCH(QString, edge);
        QFETCH(QString, reason);
        const auto document = read(shapeWith(edge.toStdString()));
        QCOMPARE(document->areas.size(), 0U);
        QCOMPARE(document->lines.size(), 1U);  // what follows is read
        QCOMPARE(document->diagnostics.count(Severity::Warning), 1U);
        const QString text = QString::fromStdString(std::string(document->diagnostics.entries()[0].text));
        QVERIFY2(text.contains(reason), qPrintable(text));
    }

    void linesHaveNoCurves() {
        std::string text = shapeWith("STRAIGHT,0,0,5,5");
        text.replace(text.find("STRAIGHT,1,20"), 25, kQuarter);
        const auto document = read(text);
        QCOMPARE(document->elements.size(), 1U);  // the shape
        QCOMPARE(document->diagnostics.count(Severity::Warning), 1U);
        QVERIFY(std::string(document->diagnostics.entries()[0].text).find("only edges of a SHAPE") !=
                std::string::npos);
    }

    void everyTruncatedPrefixIsReadOrRefusedWithWords() {
        for (std::size_t length = 0; length < kModel.size(); ++length) {
            const std::string prefix(kModel.substr(0, length));  // a fresh buffer, so that sanitizers see an overrun
            base::Progress progress;
            const auto result = model::paper::readModel(prefix, "model.txt", progress);
            QVERIFY(result.ok() || !result.error().text.empty());
        }
    }

    void otherTextIsRefused() {
        base::Progress progress;
        QVERIFY(!model::paper::readModel("hello", "x.txt", progress).ok());
        QVERIFY(model::paper::looksLikeModel("# comment\n\nLAYERBEGIN\n"));
        QVERIFY(!model::paper::looksLikeModel("UNITS=MM\n"));
    }

    void lexerCountsLines() {
        model::paper::Lexer lexer("a,b\n# c\n\nd e");
        QCOMPARE(lexer.next(), std::string_view("a"));
        QCOMPARE(lexer.next(), std::string_view("b"));
        QCOMPARE(lexer.line(), 1U);
        QCOMPARE(lexer.peek(), std::string_view("d"));
        QCOMPARE(lexer.next(), std::string_view("d"));
        QCOMPARE(lexer.line(), 4U);
        QCOMPARE(lexer.next(), std::string_view("e"));
        QVERIFY(lexer.next().empty());
    }
};

QTEST_APPLESS_MAIN(PaperReaderTest)
#include "paper_reader_test.moc"
