#include "model/formats/kicad/text/text_strokes.h"

#include <QtTest>

#include "model/formats/kicad/text/stroke_font.h"

using namespace model::kicad;

namespace {

constexpr double kStep = 1e6 / kGlyphGrid;  ///< of a text of 1 mm

TextStyle styled(double across, double up) {
    TextStyle style;
    style.pen = 150'000.0;
    style.across = across;
    style.up = up;
    return style;
}

bool isNear(double a, double b) {
    return std::abs(a - b) < 1.0;
}

}  // namespace

class TextStrokesTest : public QObject {
    Q_OBJECT

private slots:
    void fontHasAllOfAscii() {
        for (char32_t c = U' '; c <= U'~'; ++c) {
            const std::optional<Glyph> glyph = glyphOf(c);
            QVERIFY2(glyph && glyph->advance > 0.0, qPrintable(QString::number(c)));
            QCOMPARE(glyph->lines.empty(), c == U' ');
            for (const auto& line : glyph->lines) {
                QVERIFY(line.size() > 1);
            }
        }
        QVERIFY(!glyphOf(U'\u4e00'));
    }
    /// As they lie in plots of KiCad 9.
    void signsAreAsWideAsKicadsAre() {
        for (const auto& [character, advance] :
             {std::pair(U'#', 21.0), std::pair(U'&', 26.0), std::pair(U'@', 27.0), std::pair(U'\\', 14.0),
              std::pair(U'^', 12.0), std::pair(U'|', 20.0), std::pair(U'~', 15.0), std::pair(U'\u00B5', 22.0),
              std::pair(U'\u03A9', 24.0), std::pair(U'\u2014', 24.0)}) {
            QCOMPARE(glyphOf(character)->advance, advance);
        }
    }
    void otherAlphabetsAreThere() {
        for (const char32_t character : {U'\u00E9', U'\u0159', U'\u0394', U'\u0416', U'\u044F', U'\u20AC', U'\u2192'}) {
            QVERIFY(glyphOf(character) && !glyphOf(character)->lines.empty());
        }
    }
    /// Locations as in what KiCad writes: 'I' is a stroke in the middle of ten steps.
    void anchorsAreWhereKicadHasThem() {
        const double baseLine = -(1.0 - 0.585) * 1e6 + 0.052 * 150'000.0 - kStep;
        const TextStrokes middle("I", styled(0.5, 0.5));
        QCOMPARE(middle.strokes().size(), std::size_t{1});
        QVERIFY(isNear(middle.min().x, 0.0) && isNear(middle.max().x, 0.0));
        QVERIFY(isNear(middle.min().y, baseLine) && isNear(middle.max().y, baseLine + 1e6));
        const TextStrokes left("I", styled(0.0, 0.5));
        QVERIFY(isNear(left.min().x, 5 * kStep + 150'000.0 / 1.52));
        const TextStrokes right("I", styled(1.0, 0.5));
        QVERIFY(isNear(right.min().x, -5 * kStep - 150'000.0 / 1.52));
        const TextStrokes bottom("I", styled(0.5, 0.0));
        QVERIFY(isNear(bottom.min().y, 170'000.0 + 7'800.0 - kStep));
    }
    void linesLie161HeightsApart() {
        const TextStrokes two("I\nI", styled(0.5, 0.0));
        QCOMPARE(two.strokes().size(), std::size_t{2});
        QVERIFY(isNear(two.max().y - two.min().y, 2'610'000.0));
        TextStyle style = styled(0.5, 0.0);
        style.lineSpacing = 2.0;
        const TextStrokes spaced("I\nI", style);
        QVERIFY(isNear(spaced.max().y - spaced.min().y, 4'220'000.0));
    }
    void marksAreNotDrawnButMeant() {
        const TextStrokes barred("~{I}", styled(0.5, 0.5));
        QCOMPARE(barred.strokes().size(), std::size_t{2});
        const TextStrokes raised("I^{I}", styled(0.0, 0.0));
        QCOMPARE(raised.strokes().size(), std::size_t{2});
        const auto& [a, b] = raised.strokes()[1];
        QVERIFY(isNear(std::abs(b.y - a.y), 800'000.0));
        QVERIFY(!raised.lacksCharacters());
    }
    void tabsGoToTheNextStop() {
        const auto between = [](std::string_view text) {
            const TextStrokes strokes(text, styled(0.0, 0.5));
            return strokes.strokes().back().first.x - strokes.strokes().front().first.x;
        };
        QVERIFY(isNear(between("I\tI"), 3e6 + 16 * kStep));
        QVERIFY(isNear(between("IIII\tI"), 7e6 + 16 * kStep));
        QVERIFY(isNear(between("I\t\tI"), 7e6 + 16 * kStep));
        QVERIFY(isNear(between("MMMMI\tI") - between("MMMMI") + 4 * 24 * kStep, 7e6 + 16 * kStep));
    }
    void italicsLeanAndMirroredTextsTurn() {
        TextStyle style = styled(0.5, 0.5);
        style.isItalic = true;
        const TextStrokes italic("I", style);
        QVERIFY(isNear(italic.max().x - italic.min().x, 125'000.0));
        const TextStrokes plain("L", styled(0.0, 0.5));
        TextStyle mirrored = styled(0.0, 0.5);
        mirrored.isMirrored = true;
        const TextStrokes turned("L", mirrored);
        QVERIFY(isNear(turned.min().x, -plain.max().x) && isNear(turned.max().x, -plain.min().x));
    }
    void whatTheFontLacksIsSaid() { QVERIFY(TextStrokes("\u4e00", styled(0.5, 0.5)).lacksCharacters()); }
};

QTEST_APPLESS_MAIN(TextStrokesTest)
#include "text_strokes_test.moc"
