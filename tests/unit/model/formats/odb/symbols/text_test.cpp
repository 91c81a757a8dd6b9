// Texts and barcodes: fonts, layout, code 39, and what becomes of them in a document. No job we have holds any.
#include <algorithm>
#include <cmath>

#include "model/figures/element_polygons.h"
#include "model/formats/odb/symbols/barcode.h"
#include "model/formats/odb/symbols/font_library.h"
#include "model/geometry/discretise.h"
#include "tests/unit/model/formats/odb/odb_testing.h"

using model::Box;
using model::Diagnostics;
using model::ElementKind;
using model::Point;
using model::formats::Font;
using model::formats::FontStroke;
using model::formats::standInFont;
using model::formats::TextLayout;
using model::formats::TextLine;
using model::odb::BarcodeLayout;
using model::odb::BarcodeRecord;
using model::odb::code39;
using model::odb::layOut;
using model::odb::parseFont;
using namespace odb_testing;

namespace {

/// L and I as in the fonts of real jobs: capitals from (-0.1, -0.1) to (0.1, 0.2).
const std::string kFont =
    "XSIZE  0.302000\nYSIZE  0.302000\nOFFSET 0.000000\n\n"
    "CHAR L\nLINE -0.1 0.2 -0.1 -0.1 P R 0.012\nLINE -0.1 -0.1 0.1 -0.1 P R 0.012\nECHAR\n"
    "CHAR I\nLINE 0 -0.1 0 0.2 P S 0.012\nECHAR\nCHAR ;\nLINE 0 -0.15 0 0 P R 0.012\nECHAR\n";

Font fontOf(const std::string& text) {
    Diagnostics diagnostics;
    return parseFont(text, "fonts/standard", diagnostics);
}

TextLine textOf(const std::string& text, model::Nm size = 3'020'000) {
    return {text, size, size, 0.5};
}

/// Bars and spaces as letters: capitals are bars, w and W wide.
std::string lettersOf(const std::vector<bool>& elements) {
    std::string letters;
    for (std::size_t i = 0; i < elements.size(); ++i) {
        letters += elements[i] ? (i % 2 == 0 ? 'W' : 'w') : (i % 2 == 0 ? 'N' : 'n');
    }
    return letters;
}

constexpr auto kStar = "NwNnWnWnN";

/// Reads code 39 back: an independent list of patterns, 16 narrow widths a character.
std::string decode(const std::string& letters) {
    static const std::map<std::string, char> kKnown = {{"WnNwNnNnW", '1'}, {"WnNnNwNnW", 'A'}, {"NnWnNwNnW", 'B'},
                                                       {"NwNnNwNwN", '+'}, {kStar, '*'},       {"NwNwNnNwN", '/'},
                                                       {"WnWnNwNnN", 'C'}, {"NnNwWnWnN", '0'}, {"NnWwNnNnW", '2'}};
    std::string text;
    for (std::size_t i = 0; i < letters.size(); i += 10) {
        const auto found = kKnown.find(letters.substr(i, 9));
        text += found == kKnown.end() ? '?' : found->second;
        if (i + 9 < letters.size() && letters[i + 9] != 'n') {
            return "no narrow space";
        }
    }
    return text;
}

Box boxOf(const model::ShapeSketch& sketch) {
    Box box;
    for (std::size_t i = 0; i < sketch.contourCount(); ++i) {
        box.include(model::boxOfPath(sketch.contour(i), true));
    }
    return box;
}

BarcodeRecord barcodeOf(const std::string& text) {
    BarcodeRecord record;
    record.code = "UPC39";
    record.text = text;
    record.elementWidth = 200'000;
    record.height = 5'000'000;
    return record;
}

}  // namespace

class TextTest : public QObject {
    Q_OBJECT

private slots:
    void charactersStandOnTheirLowerLeftCorner() {
        const TextLayout layout = layOut(textOf("LI"), fontOf(kFont));
        QVERIFY(layout.problem.empty());
        QCOMPARE(layout.strokes.size(), std::size_t{3});
        QCOMPARE(layout.strokes[0].a.x, 0.0);
        QVERIFY(std::abs(layout.strokes[0].a.y - 3e6) < 1);
        QVERIFY(std::abs(layout.strokes[1].b.x - 2e6) < 1 && layout.strokes[1].b.y == 0.0);
        // The I of the next character: its cell begins one xsize further, the stroke is in the middle of 2 mm.
        QVERIFY(std::abs(layout.strokes[2].a.x - (3.02e6 + 1e6)) < 1);
        QVERIFY(layout.strokes[2].isSquare && !layout.strokes[0].isSquare);
        QVERIFY(std::abs(layout.length - 2 * 3.02e6) < 1);
        // 12 mil × 0.5, whatever the size.
        QCOMPARE(layout.strokes[0].width, 152'400);
        QCOMPARE(layOut(textOf("L", 1'000'000), fontOf(kFont)).strokes[0].width, 152'400);
    }

    void fontsMayCountInAnyUnit() {
        // As a CAM system brings one: characters 0.021 wide, so that texts are many times as large as the font.
        const Font font = fontOf(
            "XSIZE 0.021\nYSIZE 0.021\nOFFSET 0\nCHAR L\nLINE 0.06 0.08 0.06 0.059 P R 0.012\n"
            "LINE 0.06 0.059 0.074 0.059 P R 0.012\nECHAR\n");
        const TextLayout layout = layOut(textOf("L", 6'000'000), font);
        QVERIFY(layout.problem.empty());
        QCOMPARE(layout.strokes.size(), std::size_t{2});
        QVERIFY(std::abs(layout.strokes[0].a.y - 6e6) < 1);
        QVERIFY(std::abs(layout.strokes[1].b.x - 4e6) < 1);
    }

    void descendersHangBelowTheCorner() {
        const TextLayout layout = layOut(textOf(";"), fontOf(kFont));
        QCOMPARE(layout.strokes.size(), std::size_t{1});
        QVERIFY(std::abs(layout.strokes[0].a.y + 0.5e6) < 1);
    }

    void whatAFontLacksIsSaidAndItsPlaceStaysEmpty() {
        const TextLayout layout = layOut(textOf("L\xc3\xa4L"), fontOf(kFont));
        QVERIFY(layout.problem.find("no character number 228") != std::string::npos);
        QCOMPARE(layout.strokes.size(), std::size_t{4});
        QVERIFY(std::abs(layout.strokes[2].a.x - 2 * 3.02e6) < 1);
        QVERIFY(layOut(textOf("L L"), fontOf(kFont)).problem.empty());
        QVERIFY(layOut(textOf("$$DATE"), standInFont()).problem.find("variable") != std::string::npos);
        QVERIFY(layOut(textOf("L", 1'000'000'000), fontOf(kFont)).strokes.empty());
    }

    void brokenFontsAreReportedWithTheirLine() {
        Diagnostics diagnostics;
        const Font font = parseFont(
            "XSIZE 1\nYSIZE 1\nCHAR A\nLINE 0 0 x 1 P R 0.012\nLINE 0 0 0 1 N R 0.012\n"
            "LINE 0 0 1e9 1 P R 0.012\nNOISE\nLINE 0 0 0 1 P R 0.012\nECHAR\n",
            "fonts/standard", diagnostics);
        QCOMPARE(font.strokes(U'A').size(), std::size_t{2});
        QVERIFY(font.strokes(U'A')[0].isNegative && !font.strokes(U'A')[1].isNegative);
        QCOMPARE(diagnostics.entries().size(), std::size_t{3});
        QCOMPARE(diagnostics.entries()[0].line, 4U);
        QVERIFY(fontOf("XSIZE 0\nYSIZE 1\nCHAR A\nECHAR\n").isEmpty());
        QVERIFY(fontOf("").isEmpty());
        for (std::size_t i = 0; i < kFont.size(); ++i) {  // every truncated prefix
            (void)layOut(textOf("LI;"), fontOf(kFont.substr(0, i)));
        }
    }

    void theStandInFontHasAllOfAsciiAndNoTwoAlike() {
        std::vector<std::vector<double>> seen;
        for (char32_t c = U'!'; c <= U'~'; ++c) {
            std::vector<double> glyph;
            for (const FontStroke& stroke : standInFont().strokes(c)) {
                glyph.insert(glyph.end(), {stroke.a.x, stroke.a.y, stroke.b.x, stroke.b.y});
                for (const double x : {stroke.a.x, stroke.b.x}) {
                    QVERIFY(x >= -1e-9 && x <= 0.2 + 1e-9);
                }
            }
            QVERIFY(!glyph.empty());
            seen.push_back(glyph);
        }
        std::ranges::sort(seen);
        QVERIFY(std::ranges::adjacent_find(seen) == seen.end());
    }

    void code39HasStartStopAndNarrowSpaces() {
        QCOMPARE(decode(lettersOf(code39("1A", false, false))), std::string("*1A*"));
        QCOMPARE(decode(lettersOf(code39("1a", false, false))), std::string("*1A*"));
        QVERIFY(code39("1!", false, false).empty());
        QVERIFY(code39("\xc3\xa4", true, false).empty());
    }

    void fullAsciiWritesPairs() {
        QCOMPARE(decode(lettersOf(code39("a!", true, false))), std::string("*+A/A*"));
        QCOMPARE(decode(lettersOf(code39("+", true, false))), std::string("*/?*"));  // /K
        for (char c = 1; c < 127; ++c) {
            QVERIFY(!code39(std::string{c}, true, true).empty());
        }
    }

    void theCheckCharacterIsTheSumOfAllModulo43() {
        // A = 10, B = 11, C = 12: 33 is X. 1 + A = 11 is B.
        QCOMPARE(lettersOf(code39("ABC", false, true)).substr(40, 9), std::string("NwNnWnNnW"));
        QCOMPARE(decode(lettersOf(code39("1A", false, true))), std::string("*1AB*"));
    }

    void everyPatternHasThreeWideElementsAndIsItsOwn() {
        std::vector<std::string> seen;
        for (const char c : std::string("0123456789ABCDEFGHIJKLMNOPQRSTUVWXYZ-. $/+%")) {
            seen.push_back(lettersOf(code39(std::string{c}, false, false)).substr(10, 9));
            QCOMPARE(std::ranges::count_if(seen.back(), [](char e) { return e == 'w' || e == 'W'; }), 3);
        }
        seen.emplace_back(kStar);
        std::ranges::sort(seen);
        QVERIFY(std::ranges::adjacent_find(seen) == seen.end());
    }

    void barsAreAsWideAsTheyShould() {
        const BarcodeLayout layout = layOut(barcodeOf("1A"), standInFont());
        // Four characters of 15 narrow widths, three spaces.
        QVERIFY(std::abs(layout.width - 63 * 200'000.0) < 1);
        QCOMPARE(boxOf(layout.bars), (Box{{0, 0}, {63 * 200'000, 5'000'000}}));
        QCOMPARE(layout.bars.contourCount(), std::size_t{4 * 5});
        BarcodeRecord inverted = barcodeOf("1A");
        inverted.isInverted = true;
        const BarcodeLayout dark = layOut(inverted, standInFont());
        QCOMPARE(dark.bars.contourCount(), std::size_t{1 + 4 * 5});
        QVERIFY(!dark.bars.isHole(0) && dark.bars.isHole(1));
        QCOMPARE(boxOf(dark.bars), (Box{{-2'000'000, -200'000}, {63 * 200'000 + 2'000'000, 5'200'000}}));
    }

    void theTextStandsAboveOrBelowInTheMiddle() {
        BarcodeRecord record = barcodeOf("1A");
        record.hasString = true;
        for (const bool isAbove : {true, false}) {
            record.isStringAbove = isAbove;
            const BarcodeLayout layout = layOut(record, standInFont());
            QVERIFY(!layout.string.empty());
            for (const auto& stroke : layout.string) {
                QVERIFY(isAbove ? stroke.a.y >= 5'000'000 : stroke.a.y < 0);
                QVERIFY(stroke.a.x > 0 && stroke.a.x < layout.width);
            }
        }
    }

    void otherBarcodesAreAFrameAndSaySo() {
        BarcodeRecord record = barcodeOf("1A");
        record.code = "QR";
        const BarcodeLayout layout = layOut(record, standInFont());
        QVERIFY(layout.problem.find("of kind QR are not known") != std::string::npos);
        QCOMPARE(layout.bars.contourCount(), std::size_t{2});
        QCOMPARE(boxOf(layout.bars), (Box{{0, 0}, {63 * 200'000, 5'000'000}}));
        record.code = "UPC39";
        record.text = "\x01";
        QVERIFY(layOut(record, standInFont()).problem.find("cannot hold") != std::string::npos);
    }

    void textsTurnAndMirrorLikePads() {
        const Folder folder;
        writeSmallJob(folder,
                      "UNITS=MM\nT 10 20 standard P 0 3.02 3.02 0.5 'L' 1\nT 10 20 standard P 1 3.02 3.02 0.5 'L' 1\n"
                      "T 10 20 standard P 4 3.02 3.02 0.5 'L' 1\nT 10 20 standard P 8 45 3.02 3.02 0.5 'I' 1\n");
        folder.write("fonts/standard", kFont);
        const auto d = read(folder.path());
        const auto nodes = [&](std::uint32_t feature) {
            const model::ElementId id = elementOf(*d, "TOP", feature);
            const auto span = d->nodesOf(d->trails[d->elements.geometry[id.row()]]);
            return std::vector<Point>{span[0].point, span[1].point, span[2].point};
        };
        const int mm = 1'000'000;
        QCOMPARE(nodes(0), (std::vector<Point>{{10 * mm, 23 * mm}, {10 * mm, 20 * mm}, {12 * mm, 20 * mm}}));
        QCOMPARE(nodes(1), (std::vector<Point>{{13 * mm, 20 * mm}, {10 * mm, 20 * mm}, {10 * mm, 18 * mm}}));
        QCOMPARE(nodes(2), (std::vector<Point>{{10 * mm, 23 * mm}, {10 * mm, 20 * mm}, {8 * mm, 20 * mm}}));
        // A square pen that is not upright covers an area.
        QCOMPARE(d->elements.kind[elementOf(*d, "TOP", 3).row()], ElementKind::Area);
        QVERIFY(findDiagnostic(d->diagnostics, "font") == nullptr);
    }

    void negativeStrokesTakeAwayWhatTheTextHasDrawn() {
        const Folder folder;
        writeSmallJob(folder, "UNITS=MM\n$0 r5000\nP 10 20 0 P 0 0\nT 10 20 standard P 0 3.02 3.02 0.5 '=' 1\n");
        // A stroke of 2 mm, its middle taken away, and a dot put back beside the gap's left end.
        folder.write("fonts/standard",
                     "XSIZE 0.302\nYSIZE 0.302\nOFFSET 0\nCHAR =\nLINE -0.1 0 0.1 0 P S 0.012\n"
                     "LINE -0.05 0 0.05 0 N S 0.012\nLINE 0 0 0 0 P S 0.012\nECHAR\n");
        const auto d = read(folder.path());
        const model::ElementId text = elementOf(*d, "TOP", 1);
        QCOMPARE(d->elements.kind[text.row()], ElementKind::Area);
        const model::PolygonSet region = model::discretise(*d, text, {});
        QCOMPARE(region.polygons.size(), std::size_t{3});
        const double pen = 0.012 * 25.4 * 0.5;
        QVERIFY(std::abs(static_cast<double>(model::twiceArea(region)) / 2e12 - (pen * 1.0 + pen * pen)) < 1e-5);
        QVERIFY(elementOf(*d, "TOP", 0).isValid());  // what lies below the text stays
        QVERIFY(d->diagnostics.entries().empty() || findDiagnostic(d->diagnostics, "character") == nullptr);
    }

    void aJobWithoutTheFontGetsTheStandIn() {
        const Folder folder;
        writeSmallJob(folder, "UNITS=MM\nT 10 20 standard P 0 3 3 0.5 'L' 1\nT 10 30 standard P 0 3 3 0.5 'L' 1\n");
        folder.write("fonts/standard", "XSIZE 0.302\nYSIZE 0.302\nOFFSET 0\n");  // DipTrace: no characters
        const auto d = read(folder.path());
        QCOMPARE(d->layers[d->findLayer("TOP").row()].counts[3], 2U);
        const model::Diagnostic* entry = findDiagnostic(d->diagnostics, "the job has no font standard");
        QVERIFY(entry != nullptr);
        QCOMPARE(entry->line, 2U);
        QCOMPARE(entry->count, 2U);
    }
};

QTEST_APPLESS_MAIN(TextTest)
#include "text_test.moc"
