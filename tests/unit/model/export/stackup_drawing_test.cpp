#include "model/export/stackup_drawing.h"

#include <QTemporaryDir>
#include <QXmlStreamReader>
#include <QtTest>
#include <cmath>

#include "model/export/stackup_export.h"
#include "tests/locations.h"
#include "tests/unit/model/formats/gerber/gerber_testing.h"
#include "tests/unit/model/formats/odb/odb_testing.h"

using model::HoleSpan;
using model::StackupBarrel;
using model::StackupDrawing;
using model::StackupRow;

namespace {

std::shared_ptr<const model::Document> board(const char* name) {
    return odb_testing::read(odb_testing::dataJob(name));
}

const StackupBarrel& boreOf(const StackupDrawing& drawing, const model::Document& document, const char* layer) {
    const auto found = std::ranges::find_if(
        drawing.bores, [&](const StackupBarrel& bore) { return document.layer(bore.layer).name == layer; });
    if (found == drawing.bores.end()) {
        qFatal("no holes on %s", layer);
    }
    return *found;
}

std::size_t rowOf(const model::Document& document, const char* name) {
    const auto& rows = document.stackup.rows;
    return static_cast<std::size_t>(std::ranges::find(rows, name, &StackupRow::name) - rows.begin());
}

bool isNear(double a, double b) {
    return std::abs(a - b) < 1e-9 * (1.0 + std::abs(b));
}

/// Its elements of a kind, or -1 with a warning when the text is no well-formed XML.
int elementsOf(const std::string& svg, const QString& name) {
    QXmlStreamReader xml(QByteArray::fromStdString(svg));
    int count = 0;
    while (!xml.atEnd()) {
        count += xml.readNext() == QXmlStreamReader::StartElement && xml.name() == name ? 1 : 0;
    }
    if (xml.hasError()) {
        qWarning() << xml.errorString();
        return -1;
    }
    return count;
}

}  // namespace

class StackupDrawingTest : public QObject {
    Q_OBJECT

private slots:
    /// Its one copper layer is the bottom one: what is drilled passes the substrate above it, too.
    void holesOfSingleSidedBoardsPassAllOfThem() {
        using namespace gerber_testing;
        const Job job({{"b.GTO", image(kCopper)},
                       {"b.GBL", image(kCopper)},
                       {"b.GBS", image(kCopper)},
                       {"b.GKO", image(kOutline)},
                       {"b.drl", kDrills}});
        const Board read = job.open();
        QVERIFY(read.ok());
        const model::Document& document = **read;
        const auto& rows = document.stackup.rows;
        const std::size_t substrate = rowOf(document, "above bottom copper");
        QVERIFY(substrate < rows.size());
        const model::Layer& copper = document.layer(rows[substrate + 1].layer);
        QCOMPARE(copper.side, model::LayerSide::Bottom);
        const StackupDrawing drawing = model::drawStackup(document, {1000.0, 10.0, false});
        QCOMPARE(drawing.bores.size(), std::size_t{1});
        QCOMPARE(drawing.bores[0].span, HoleSpan::Through);
        QCOMPARE(drawing.bores[0].top, drawing.bands[substrate].top);
        QCOMPARE(drawing.bores[0].bottom, drawing.bands[substrate + 1].bottom);
    }

    void toScaleHeightsAreThicknesses() {
        const auto document = board("everything");
        const StackupDrawing drawing = model::drawStackup(*document, {1000.0, 10.0, false});
        QCOMPARE(drawing.bands.size(), document->stackup.rows.size());
        QCOMPARE(drawing.copperTimes, 1.0);
        double all = 0.0;
        for (const StackupRow& row : document->stackup.rows) {
            all += row.thickness;
        }
        double y = 0.0;
        for (std::size_t i = 0; i < drawing.bands.size(); ++i) {
            QVERIFY(isNear(drawing.bands[i].top, y));
            y += document->stackup.rows[i].thickness * 1000.0 / all;
            QVERIFY(isNear(drawing.bands[i].bottom, y));
        }
        QVERIFY(isNear(y, 1000.0));
    }

    void exaggeratedCopperIsThatManyTimesAsThick() {
        const auto document = board("everything");
        const StackupDrawing drawing = model::drawStackup(*document, {1000.0, 10.0, true});
        QCOMPARE(drawing.copperTimes, 10.0);  // 1460.2 µm of laminate, 139.8 µm of copper
        const auto perMm = [&](const char* name) {
            const model::StackupBand& band = drawing.bands[rowOf(*document, name)];
            return (band.bottom - band.top) / base::toMm(document->stackup.rows[rowOf(*document, name)].thickness);
        };
        QVERIFY(isNear(perMm("TOP"), 10.0 * perMm("CORE1")));
        QVERIFY(isNear(perMm("SMT"), perMm("CORE2")));
    }

    void labelsDoNotOverlapAndStayInside_data() {
        QTest::addColumn<double>("height");
        QTest::newRow("ample") << 1000.0;
        QTest::newRow("just enough") << 90.0;
        QTest::newRow("too little: grows") << 0.0;
    }
    void labelsDoNotOverlapAndStayInside() {
        QFETCH(double, height);
        const StackupDrawing drawing = model::drawStackup(*board("everything"), {height, 10.0, false});
        QVERIFY(drawing.height >= 90.0);
        double least = 5.0;
        for (const model::StackupBand& band : drawing.bands) {
            QVERIFY(band.label > least - 1e-9);
            least = band.label + 10.0;
        }
        QVERIFY(least <= drawing.height + 5.0 + 1e-9);
    }

    void holesPassWhatTheyPass() {
        const auto document = board("drills");
        const StackupDrawing drawing = model::drawStackup(*document, {1000.0, 10.0, true});
        const auto top = [&](const char* name) { return drawing.bands[rowOf(*document, name)].top; };
        const auto bottom = [&](const char* name) { return drawing.bands[rowOf(*document, name)].bottom; };
        const StackupBarrel& through = boreOf(drawing, *document, "THROUGH");
        QCOMPARE(through.top, top("L1"));
        QCOMPARE(through.bottom, bottom("L4"));
        QVERIFY(through.isPlated);
        const StackupBarrel& buried = boreOf(drawing, *document, "BURIED");
        QCOMPARE(buried.span, HoleSpan::Buried);
        QCOMPARE(buried.top, top("L2"));
        QCOMPARE(buried.bottom, bottom("L3"));
        const StackupBarrel& back = boreOf(drawing, *document, "BACK");
        QCOMPARE(back.span, HoleSpan::Backdrill);
        QVERIFY(!back.isPlated);
        std::uint32_t holes = 0;
        for (const model::DrillRow& row : model::drillTable(*document)) {
            holes += row.count;
        }
        for (const StackupBarrel& bore : drawing.bores) {
            holes -= bore.count;
            QVERIFY(bore.bottom > bore.top);
        }
        QCOMPARE(holes, 0U);
        QCOMPARE(model::boreText(*document, back), "BACK: backdrill, non-plated, 1 hole of 1.2 mm");
        const model::LengthWriter inUm = [](model::Nm nm) { return std::to_string(nm / 1000) + " um"; };
        QCOMPARE(model::boreText(*document, back, inUm), "BACK: backdrill, non-plated, 1 hole of 1200 um");
        model::StackupBarrel two = back;
        two.least = 800'000;
        QVERIFY(model::boreText(*document, two, inUm).ends_with(" of 800 to 1200 um"));
    }

    /// A path without a width cuts nothing.
    void aLineWithoutAWidthIsNoHole() {
        for (const auto& [symbol, bores] : {std::pair("r0", std::size_t{0}), std::pair("r1000", std::size_t{1})}) {
            const odb_testing::Folder job;
            odb_testing::writeSmallJob(job, "UNITS=MM\n$0 r1000\nP 5 5 0 P 0 0\n");
            job.write("matrix/matrix",
                      odb_testing::matrixOf({{"SIGNAL", "TOP"}, {"SIGNAL", "BOT"}, {"ROUT", "OUTLINE"}}));
            job.write("steps/board/layers/outline/features",
                      std::string("UNITS=MM\n$0 ") + symbol + "\nL 20 20 80 20 0 P 0\nL 80 20 80 80 0 P 0\n");
            QCOMPARE(model::drawStackup(*odb_testing::read(job.path()), {1000.0, 10.0, true}).bores.size(), bores);
        }
    }

    void areasAreNoDiameters() {
        const odb_testing::Folder job;
        odb_testing::writeSmallJob(job, "UNITS=MM\n$0 r1000\nP 5 5 0 P 0 0\n");
        job.write("matrix/matrix", odb_testing::matrixOf({{"SIGNAL", "TOP"}, {"SIGNAL", "BOT"}, {"ROUT", "CUT"}}));
        job.write("steps/board/layers/cut/features",
                  "UNITS=MM\nS P 0\nOB 20 20 I\nOS 40 20\nOS 40 50\nOS 20 50\nOS 20 20\nOE\nSE\n");
        const auto drawing = model::drawStackup(*odb_testing::read(job.path()), {1000.0, 10.0, true});
        QCOMPARE(drawing.bores.size(), std::size_t{1});
        QCOMPARE(drawing.bores[0].count, 1U);
        QCOMPARE(drawing.bores[0].most, 0);
    }

    void zonesStandSideBySideWithTheLayersTheyHave() {
        const auto document = board("rigid_flex");
        const StackupDrawing drawing = model::drawStackup(*document, {1000.0, 10.0, true});
        QCOMPARE(drawing.columns.size(), std::size_t{3});
        QCOMPARE(drawing.columns[1].part.name, "Flex");
        QVERIFY(!drawing.columns[1].part.has[rowOf(*document, "TOP")]);
        double right = 0.0;
        for (const model::StackupColumn& column : drawing.columns) {
            QVERIFY(column.left >= right && column.right > column.left);
            right = column.right;
        }
        for (const StackupBarrel& bore : drawing.bores) {
            QVERIFY(bore.x - bore.breadth / 2 >= right && bore.x + bore.breadth / 2 <= 1.0 + 1e-9);
        }
        const auto whole = model::drawStackup(*board("drills"), {1000.0, 10.0, true});
        QCOMPARE(whole.columns.size(), std::size_t{1});
        QVERIFY(whole.columns[0].left == 0.0 && whole.columns[0].right == 1.0);
    }

    void theSheetHasTotalsZonesAndFindings() {
        const std::string flex = model::stackupSvg(*board("rigid_flex"), true);
        for (const char* text : {">Rigid</text>", ">Stiffened end</text>", ">coverlay</text>", ">–</text>",
                                 "Zone Flex: copper to copper 556.67 µm, overall 606.67 µm"}) {
            QVERIFY2(flex.find(text) != std::string::npos, text);
        }
        auto changed = std::make_shared<model::Document>(*board("everything"));
        changed->stackup.rows[rowOf(*changed, "CORE1")].material.dielectricConstant = 42;
        const std::string svg = model::stackupSvg(*changed, true);
        QVERIFY(svg.find("Warning: CORE1: a Dk of 42") != std::string::npos);
        QVERIFY(svg.find(">copper to copper ") != std::string::npos);
        QVERIFY(model::stackupCsv(*changed).find(",CORE1: a Dk of 42;") != std::string::npos);
    }

    void longNamesAreShortenedBetweenCharacters() {
        auto document = std::make_shared<model::Document>(*board("drills"));
        for (const char* letter : {"x", "µ", "層"}) {
            std::string name;
            for (int i = 0; i < 60; ++i) {
                name += letter;
            }
            document->stackup.rows[0].name = name;
            const std::string svg = model::stackupSvg(*document, true);
            QVERIFY(svg.find(name) == std::string::npos);
            QVERIFY(svg.find("…</text>") != std::string::npos);
            QVERIFY(svg.find('?') == std::string::npos);  // what xmlText puts for a broken character
        }
    }

    void csvHasAColumnForEachZone() {
        const std::string csv = model::stackupCsv(*board("rigid_flex"));
        QVERIFY(csv.find(
                    ",kind,cumulative_nm in Rigid,cumulative_nm in Flex,cumulative_nm in Stiffened end,findings\r\n") !=
                std::string::npos);
        QVERIFY2(csv.find(",copper,60000,,,\r\n") != std::string::npos, csv.c_str());  // TOP is in the rigid zone
    }

    void svgHasABandPerLayerAndABarPerKindOfHole() {
        const auto document = board("drills");
        const StackupDrawing drawing = model::drawStackup(*document, {400.0, 10.0, true});
        const std::string svg = model::stackupSvg(*document, true);
        const auto bands = static_cast<int>(drawing.bands.size() + drawing.bores.size());
        QCOMPARE(elementsOf(svg, "rect"), bands + 1);  // and the ground
        QVERIFY(svg.find("BURIED: buried, plated") != std::string::npos);
        QVERIFY(svg.find("copper scale x") != std::string::npos);
        QVERIFY(model::stackupSvg(*document, false).find(", to scale") != std::string::npos);
    }

    void namesOfAnyBytesMakeWellFormedFiles() {
        auto document = std::make_shared<model::Document>(*board("drills"));
        document->stackup.rows[0].name = "<a> & \"b\", \x01\xff\xc3 µ\xe2\x82";
        document->stackup.rows[1].material.name = "2x106, \"prepreg\"";
        QVERIFY(elementsOf(model::stackupSvg(*document, true), "text") > 0);
        QVERIFY(model::stackupCsv(*document).find(",\"2x106, \"\"prepreg\"\"\",") != std::string::npos);
    }

    void csvHasTheStackAsItIs() {
        const std::string csv = model::stackupCsv(*board("everything"));
        QVERIFY(csv.starts_with("order,layer,type,thickness_nm,thickness_source,z_nm,copper_oz,material,"));
        QVERIFY2(csv.find("\r\n6,Inner Plane,POWER_GROUND,34800,job,") != std::string::npos, csv.c_str());
        QCOMPARE(std::ranges::count(csv, '\n'), 10);
    }

    void aFileHoldsWhatItsEndingSaysInEitherCase() {
        const auto document = board("everything");
        QCOMPARE(*model::stackupFile(*document, "stack.svg", true), model::stackupSvg(*document, true));
        QCOMPARE(*model::stackupFile(*document, "stack.csv", true), model::stackupCsv(*document));
        QCOMPARE(*model::stackupFile(*document, "stack.SVG", true), model::stackupSvg(*document, true));
        QCOMPARE(*model::stackupFile(*document, "stack.Csv", true), model::stackupCsv(*document));
        const auto other = model::stackupFile(*document, "stack.pdf", true);
        QVERIFY(!other && other.error().code == base::ErrorCode::BadUsage);
        const auto none = model::stackupFile(model::Document(), "stack.svg", true);
        QVERIFY(!none && none.error().code == base::ErrorCode::BadUsage);
    }

    void aBoardWithoutAStackIsAnEmptyDrawing() {
        const StackupDrawing drawing = model::drawStackup(model::Document(), {100.0, 10.0, true});
        QVERIFY(drawing.bands.empty() && drawing.bores.empty());
    }
};

QTEST_APPLESS_MAIN(StackupDrawingTest)
#include "stackup_drawing_test.moc"
