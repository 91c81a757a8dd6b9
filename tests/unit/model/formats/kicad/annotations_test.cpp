// Text boxes, tables, dimensions and what else is written on boards, back-drills, and webs of solder mask.
#include <QtTest>
#include <algorithm>
#include <array>
#include <cmath>
#include <set>

#include "model/formats/kicad/text/text_strokes.h"
#include "model/geometry/discretise.h"
#include "model/geometry/outlines.h"
#include "model/geometry/region.h"
#include "tests/unit/model/formats/kicad/kicad_testing.h"

using namespace kicad_testing;

namespace {

const DrawnJob& notes() {
    static const DrawnJob job = drawn(fileText("annotations.kicad_pcb"));
    return job;
}

std::uint32_t lineOf(std::string_view words) {
    const std::string text = fileText("annotations.kicad_pcb");
    const std::size_t at = text.find(words);
    return at == std::string::npos
               ? 0
               : static_cast<std::uint32_t>(
                     std::count(text.begin(), text.begin() + static_cast<std::ptrdiff_t>(at), '\n') + 1);
}

/// Lines with a pen of so many nanometres that an item of the file draws, from corner to corner.
std::multiset<std::array<Nm, 4>> linesOf(std::string_view layer, std::string_view item, Nm pen) {
    std::multiset<std::array<Nm, 4>> lines;
    for (const DrawnFeature& feature : on(notes(), layer)) {
        if (feature.line == lineOf(item) && feature.kind == DrawnKind::Line && shapeOf(notes(), feature).width == pen) {
            const Point a = std::min(feature.a, feature.b);
            const Point b = std::max(feature.a, feature.b);
            lines.insert({a.x / 1000, a.y / 1000, b.x / 1000, b.y / 1000});
        }
    }
    return lines;
}

/// The texts that a board draws, in its order.
std::vector<std::string> textsOf(const DrawnJob& job) {
    std::vector<std::string> texts;
    for (const formats::DrawnGroup& group : job.steps[0].groups) {
        texts.push_back(group.properties[0].second);
    }
    return texts;
}

/// A footprint R1 of 10k that holds this.
std::string footprintWith(const std::string& items) {
    return "(footprint \"x\" (layer \"F.Cu\") (at 0 0) (fp_text reference \"R1\" (at 0 0) (layer \"F.Cu\") hide) "
           "(fp_text value \"10k\" (at 0 0) (layer \"F.Cu\") hide)" +
           items + ")";
}

std::string userText(const std::string& text) {
    return "(fp_text user \"" + text + "\" (at 0 0) (layer \"F.Cu\") (effects (font (size 1 1))))";
}

std::string boardText(const std::string& text, const std::string& font = "(size 1 1)") {
    return "(gr_text \"" + text + "\" (at 1 1) (layer \"F.Cu\") (effects (font " + font + ")))";
}

using Lines = std::multiset<std::array<Nm, 4>>;

/// Around the strokes of a text, by what is written.
Box boxOfText(std::string_view text) {
    Box box;
    for (const formats::DrawnGroup& group : notes().steps[0].groups) {
        if (group.properties[0].second != text) {
            continue;
        }
        for (const auto& [layer, ordinal] : group.features) {
            const DrawnFeature& feature = notes().steps[0].features[static_cast<std::size_t>(layer)][ordinal];
            box.include(feature.a);
            box.include(feature.b);
        }
    }
    return box;
}

/// How high what lies on the top copper is, from middle to middle of its lines.
std::int64_t heightOf(const DrawnJob& job) {
    Box box;
    for (const DrawnFeature& feature : on(job, "F.Cu")) {
        box.include(feature.a);
        box.include(feature.b);
    }
    return box.height();
}

double mm2(const ShapeSketch& sketch) {
    return static_cast<double>(twiceArea(polygonsOf(sketch, {Discretisation::kMinChordNm, false}))) / 2e12;
}

double areaOf(const DrawnFeature& feature) {
    return mm2(notes().steps[0].regions[static_cast<std::size_t>(feature.region)]);
}

}  // namespace

class AnnotationsTest : public QObject {
    Q_OBJECT

private slots:
    void textsAreBrokenAtTheWidthOfTheirBox() {
        const kicad::TextStyle style;
        QCOMPARE(kicad::wrapped("one two", style, 1e9), std::string("one two"));
        const double width = kicad::widthOf("one two", style);
        QCOMPARE(kicad::wrapped("one two three", style, width), std::string("one two\nthree"));
        QCOMPARE(kicad::wrapped("a\n\nb", style, width), std::string("a\n\nb"));
        QCOMPARE(kicad::wrapped("toolongforit x", style, 1.0), std::string("toolongforit\nx"));
        QCOMPARE(kicad::wrapped("", style, 1.0), std::string());
        const Box box = boxOfText("Notes of\nthree\nwords");
        QVERIFY(box.min.x >= 3 * kMm && box.max.x <= 9'750'000);
        QVERIFY(box.max.y <= -2'500'000 && box.max.y > -3'500'000);
    }

    void bordersAreTheBox() {
        const Lines around = {{2000, -10000, 2000, -2000},
                              {2000, -2000, 10000, -2000},
                              {2000, -10000, 10000, -10000},
                              {10000, -10000, 10000, -2000}};
        QCOMPARE(linesOf("Cmts.User", "(gr_text_box \"${TITLE}", 200'000), around);
        // Of a footprint that is turned by a quarter, around (45, 35).
        const Lines turned = {{43000, -40000, 43000, -30000},
                              {43000, -40000, 47000, -40000},
                              {43000, -30000, 47000, -30000},
                              {47000, -40000, 47000, -30000}};
        Lines found = linesOf("F.Silkscreen", "(fp_text_box", 100'000);
        std::erase_if(found, [](const auto& l) { return (l[2] - l[0]) + (l[3] - l[1]) < 4000; });
        QCOMPARE(found, turned);
    }

    void turnedBoxesHaveTheirTextInTheMiddle() {
        const Box box = boxOfText("turned");
        QVERIFY(std::abs(box.middle().x - 19 * kMm) < 300'000);
        QVERIFY(std::abs(box.middle().y + 5 * kMm) < 300'000);
        QVERIFY(std::abs(box.width() - box.height()) < box.width() / 3);  // along 45°
    }

    void knockoutsAreBoxesWithoutTheirText() {
        for (const DrawnFeature& feature : on(notes(), "F.Silkscreen")) {
            if (feature.line == lineOf("(gr_text_box \"cut\"")) {
                QCOMPARE(feature.kind, DrawnKind::Region);
                QVERIFY(areaOf(feature) < 18.0 - 0.3 && areaOf(feature) > 16.0);
                return;
            }
        }
        QFAIL("the box is not there");
    }

    void tablesHaveTheirLinesAndCells() {
        const Lines thick = {{2000, -29000, 2000, -20000},
                             {2000, -20000, 22000, -20000},
                             {22000, -29000, 22000, -20000},
                             {2000, -29000, 22000, -29000},
                             {2000, -23000, 22000, -23000}};
        QCOMPARE(linesOf("Dwgs.User", "(table (column", 300'000), thick);
        const Lines thin = {{2000, -26000, 12000, -26000}, {12000, -26000, 22000, -26000}};
        QCOMPARE(linesOf("Dwgs.User", "(table (column", 100'000), thin);
        QVERIFY(std::abs(boxOfText("head").middle().x - 12 * kMm) < 200'000);
        QVERIFY(boxOfText("a").min.x > 2'500'000 && boxOfText("a").max.x < 4 * kMm);
        QVERIFY(std::abs(boxOfText("d").middle().y + 27'500'000) < 300'000);
    }

    void dimensionsHaveTheirLines() {
        const Lines lines = linesOf("Cmts.User", "(dimension (type orthogonal)", 200'000);
        QVERIFY(lines.contains({30000, -25500, 30000, -20250}));  // extensions, from the offset on
        QVERIFY(lines.contains({40000, -25500, 40000, -22250}));
        QVERIFY(!lines.contains({30000, -25000, 40000, -25000}));  // broken by the text
        QCOMPARE(std::ranges::count_if(lines, [](const auto& l) { return l[1] == -25000 && l[3] == -25000; }), 2);
        const Nm across = static_cast<Nm>(std::llround(1000 * std::cos(27.5 * M_PI / 180)));
        QVERIFY(std::ranges::any_of(lines, [&](const auto& l) {
            return l[0] == 30000 && l[1] == -25000 && std::abs(l[2] - 30000 - across) <= 1;
        }));
        QCOMPARE(lines.size(), std::size_t{8});
    }

    void leadersEndAtTheFrameOfTheirText() {
        const Lines lines = linesOf("Dwgs.User", "(dimension (type leader)", 200'000);
        QVERIFY(lines.contains({30500, -30000, 35000, -30000}));
        QCOMPARE(lines.size(), std::size_t{1 + 2 + 4 + 1});
        QVERIFY(std::ranges::any_of(
            lines, [](const auto& l) { return l[0] == 35000 && l[1] == -30000 && l[2] > 36000 && l[2] < 39000; }));
    }

    void crossesMarkCentres() {
        const Lines centre = {{48000, -30000, 52000, -30000}, {50000, -32000, 50000, -28000}};
        QCOMPARE(linesOf("Dwgs.User", "(dimension (type center)", 200'000), centre);
        const Lines radius = linesOf("Dwgs.User", "(dimension (type radial)", 200'000);
        QVERIFY(radius.contains({49000, -10000, 51000, -10000}));
        QVERIFY(radius.contains({53000, -10000, 55000, -10000}));
        QCOMPARE(radius.size(), std::size_t{2 + 1 + 2 + 1});
        QCOMPARE(linesOf("Dwgs.User", "(target", 150'000).size(), std::size_t{2});
    }

    void oldMarksNameReferenceAndValue() {
        const DrawnJob job = boardWith(footprintWith(userText("%R is %V, 5%")), "", "20171130");
        QCOMPARE(textsOf(job), (std::vector<std::string>{"R1 is 10k, 5%"}));
        const std::string value = "(property \"Value\" \"1%R\" (at 0 0) (layer \"F.Cu\") (effects (font (size 1 1))))";
        QCOMPARE(textsOf(boardWith(footprintWith(value))), (std::vector<std::string>{"1%R"}));
    }

    void barsAreMarkedByTheVersionsRules() {
        const std::string texts = boardText("~CS~ ~A B") + boardText("(~X) a~~b") + boardText("~") + boardText("~{Y}");
        QCOMPARE(textsOf(boardWith(texts, "", "20171130")),
                 (std::vector<std::string>{"~{CS} ~{A} B", "(~{X}) a~b", "~", "~{Y}"}));
        QCOMPARE(textsOf(boardWith(texts, "", "20211014")),
                 (std::vector<std::string>{"~CS~ ~A B", "(~X) a~~b", "~", "~{Y}"}));
        const std::string barred = userText("~%R~");
        QCOMPARE(textsOf(boardWith(footprintWith(barred), "", "4")), (std::vector<std::string>{"~{R1}"}));
    }

    void namesOfFilesAndFootprintsAreVariables() {
        const DrawnJob job =
            boardWith(boardText("${FILENAME} ${PROJECTNAME}") + "(footprint \"Lib:Part\" (layer \"F.Cu\") (at 0 0)" +
                      userText("${FOOTPRINT_NAME} of ${FOOTPRINT_LIBRARY}") + ")" +
                      footprintWith(userText("${FOOTPRINT_NAME},${FOOTPRINT_LIBRARY}")));
        QCOMPARE(textsOf(job), (std::vector<std::string>{"board.kicad_pcb board", "Part of Lib", "x,"}));
        QCOMPARE(messages(job.diagnostics, "has no value"), 0U);
    }

    void variablesAreFilledInOrReported() {
        kicad::Project project;
        project.variables = {{"A", "${B}!"}, {"B", "b"}, {"LOOP", "${LOOP}${LOOP}"}};
        const DrawnJob job =
            drawn("(kicad_pcb (version 20241229) (layers (0 \"F.Cu\" signal \"Top copper\") (2 \"B.Cu\" signal))" +
                      boardText("${LAYER} ${A}") + boardText("${C} ${}") + boardText("${C} ${D"),
                  project);
        QCOMPARE(textsOf(job), (std::vector<std::string>{"Top copper b!", "${C} ${}", "${C} ${D"}));
        QCOMPARE(messages(job.diagnostics, "variable ${C} of a text has no value"), 2U);
        QCOMPARE(messages(job.diagnostics, "has no value"), 3U);
        QVERIFY(textsOf(drawn("(kicad_pcb (version 20241229) (layers (0 \"F.Cu\" signal))" + boardText("${LOOP}"),
                              project))[0]
                    .size() < 20'000);
    }

    void fontsWithoutOutlinesAreReported() {
        const DrawnJob job =
            boardWith(boardText("a", "(face \"Arial\") (size 1 1)") + boardText("b", "(face \"Arial\")") +
                      boardText("c", "(face \"KiCad Font\") (size 1 1)"));
        QCOMPARE(messages(job.diagnostics, "font 'Arial'"), 2U);
        QCOMPARE(messages(job.diagnostics, "font '"), 2U);
    }

    void linesKeepTheirSpacing() {
        const auto spaced = [](const std::string& font) { return heightOf(boardWith(boardText("I\\nI", font))); };
        QCOMPARE(spaced("(size 1 1) (line_spacing 2)") - spaced("(size 1 1)"), std::int64_t{1'610'000});
    }

    void sizesThatOldBoardsLeaveOutAreSixtyMils() {
        const DrawnJob unsaid = boardWith(boardText("I", "(thickness 0.2)"), "", "4");
        QCOMPARE(heightOf(unsaid), heightOf(boardWith(boardText("I", "(size 1.524 1.524) (thickness 0.2)"))));
        QCOMPARE(messages(unsaid.diagnostics, "how large"), 0U);
    }

    void textsWithoutEffectsAreReported() {
        const DrawnJob job = boardWith(footprintWith("(fp_text user \"I\" (at 0 0) (layer \"F.Cu\"))"));
        QCOMPARE(textsOf(job), (std::vector<std::string>{"I"}));
        QCOMPARE(heightOf(job), heightOf(boardWith(boardText("I", "(size 1.27 1.27)"))));
        QCOMPARE(messages(job.diagnostics, "1.27 mm high"), 1U);
    }

    void linesAreDashedAsTheirStrokeSays() {
        const std::string dashed = " (stroke (width 0.2) (type dash)) (layer \"F.Cu\")";
        QCOMPARE(on(boardWith("(gr_line (start 0 0) (end 7 0)" + dashed + ")"), "F.Cu").size(), std::size_t{3});
        QCOMPARE(on(boardWith("(gr_text_box \"\" (start 0 0) (end 7 7)" + dashed + ")"), "F.Cu").size(),
                 std::size_t{12});
        const auto isRegion = [](const DrawnFeature& feature) { return feature.kind == DrawnKind::Region; };
        const DrawnJob filled = boardWith("(gr_rect (start 0 0) (end 7 7) (fill yes)" + dashed + ")");
        QVERIFY(std::ranges::none_of(on(filled, "F.Cu"), isRegion));  // KiCad plots none
        const DrawnJob other = boardWith("(gr_line (start 0 0) (end 7 0)" + dashed + ")",
                                         "(pcbplotparams (dashed_line_dash_ratio 5) (dashed_line_gap_ratio 1))");
        QCOMPARE(on(other, "F.Cu").size(), std::size_t{6});
    }

    void onlyTextsOfFootprintsCanBeHidden() {
        const std::string hidden = " (layer \"F.Cu\") (effects (font (size 1 1)) hide))";
        const DrawnJob job =
            boardWith("(gr_text \"a\" (at 1 1)" + hidden + "(gr_text_box \"b\" (start 0 0) (end 9 9)" + hidden +
                      "(dimension (type leader) (layer \"F.Cu\") (pts (xy 0 0) (xy 1 0)) (gr_text \"c\" (at 1 1)" +
                      hidden + ")" + footprintWith("(fp_text user \"d\" (at 0 0)" + hidden));
        QCOMPARE(textsOf(job), (std::vector<std::string>{"a", "b", "c"}));
    }

    void fieldsWithAPlaceAreDrawn() {
        const std::string placed = "(at 0 0) (layer \"F.Cu\")";
        const DrawnJob job =
            boardWith(footprintWith("(property \"Part\" \"a\" " + placed +
                                    ")(property \"Sheet\" \"b\")(property \"Maker\" \"c\" " + placed + "(hide yes))"));
        QCOMPARE(textsOf(job), (std::vector<std::string>{"a"}));
    }

    void whatCannotBeDrawnIsReported() {
        const Diagnostics& found = notes().diagnostics;
        QCOMPARE(messages(found, "text box has no place"), 1U);
        QCOMPARE(messages(found, "lacks its two points"), 1U);
        QCOMPARE(messages(found, "mages are"), 1U);
        QCOMPARE(messages(found, "back-drill has no size"), 1U);
        const DrawnJob odd = boardWith(
            "(table (column_count 0) (layer \"F.Cu\") (cells (table_cell \"x\") (table_cell \"y\" (start 0 0) (end 5 "
            "5) "
            "(effects (font (size 1 1))))))(table (column_count 1e30) (layer \"F.Cu\"))(target x (layer \"F.Cu\"))"
            "(gr_text_box \"a b\" (start 0 0) (end 1e7 1) (layer \"F.Cu\") (effects (font (size 1 1))))"
            "(dimension (type square) (layer \"F.Cu\") (pts (xy 0 0) (xy 1 0)))"
            "(dimension (type aligned) (layer \"F.Cu\") (pts (xy 0 0) (xy 1 0)) (height 1e5))");
        for (const char* words : {"cell of a table has no place", "no cells", "target has no place", "unknown type"}) {
            QCOMPARE(messages(odd.diagnostics, words), 1U);
        }
        QCOMPARE(messages(odd.diagnostics, "no number of columns"), 2U);
        QVERIFY(messages(odd.diagnostics, "coordinate range") >= 1U);
    }

    void backDrillsReachTheLastLayerTheyCut() {
        const DrawnJob& job = notes();
        const auto& drilled = on(job, "back_drill_In2.Cu-B.Cu");
        QCOMPARE(drilled.size(), std::size_t{1});
        QCOMPARE(shapeOf(job, drilled[0]).width, 600'000);
        QCOMPARE(drilled[0].plating, Plating::NonPlated);
        const formats::DrawnLayer& layer = job.layers[rowOf(job, "back_drill_In2.Cu-B.Cu")];
        QCOMPARE(layer.use, LayerUse::Backdrill);
        QCOMPARE(static_cast<std::size_t>(layer.spanTop), rowOf(job, "In2.Cu"));
        QCOMPARE(static_cast<std::size_t>(layer.spanBottom), rowOf(job, "B.Cu"));
    }

    void narrowWebsOfMaskAreOpened() {
        const auto& mask = on(notes(), "F.Mask");
        QCOMPARE(mask.size(), std::size_t{4});  // three pads, and one that joins those that are 0.15 mm apart
        QCOMPARE(mask[3].kind, DrawnKind::Region);
        QVERIFY(areaOf(mask[3]) > 2.14 && areaOf(mask[3]) < 2.15);  // less the notches that a pen of 0.2 mm leaves
        const std::string setup = "(solder_mask_min_width 0.1)";
        const std::string pads =
            "(footprint \"x\" (layer \"F.Cu\") (at 0 0) (pad \"1\" smd rect (at 0 0) (size 1 1) (layers \"F.Mask\"))"
            "(pad \"2\" smd rect (at 1.15 0) (size 1 1) (layers \"F.Mask\")))";
        const DrawnJob wider = boardWith(pads, setup);
        double area = 0.0;
        for (const DrawnFeature& feature : on(wider, "F.Mask")) {
            area += feature.kind == DrawnKind::Region
                        ? mm2(wider.steps[0].regions[static_cast<std::size_t>(feature.region)])
                        : 0.0;
        }
        QVERIFY(area < 2.01);
    }

    void coloursAreToldByTheMaterial() {
        const DrawnJob& job = notes();
        QCOMPARE(job.layers[rowOf(job, "F.Silkscreen")].facts.material.name, std::string("Liquid Ink, White"));
        QCOMPARE(job.layers[rowOf(job, "F.Mask")].facts.material.name, std::string("Blue"));
        QCOMPARE(job.layers[rowOf(job, "dielectric 1")].facts.material.name, std::string("FR4"));
    }
};

QTEST_APPLESS_MAIN(AnnotationsTest)
#include "annotations_test.moc"
