// What a sheet of a section holds besides the cut, worked out by hand.
#include "model/export/section_sheet.h"

#include <QtTest>
#include <set>

#include "model/section/section_labels.h"
#include "model/text/utf8.h"
#include "tests/unit/model/hand_made.h"

using namespace model;
using namespace hand_made;

namespace {

enum BoardLayer : std::size_t { Top, Bottom, Substrate };

StackupRow row(const char* name, std::size_t layer, LayerType type, Nm z, Nm thickness) {
    StackupRow row;
    row.name = name;
    row.material.type = name;
    row.layer = type == LayerType::Dielectric ? LayerId{} : LayerId{layer};
    row.type = type;
    row.z = z;
    row.thickness = thickness;
    return row;
}

/// 20 mm by 20 mm; 100 µm of copper on both sides of 400 µm prepreg on 400 µm core on 200 µm prepreg. On top a track
/// from x = 0 to 12 mm.
std::shared_ptr<const Document> board() {
    DocumentBuilder builder;
    hand_made::addLayers(builder, std::array{StackLayer{"top", LayerType::Signal, 1'100'000, 100'000, Bottom},
                                             StackLayer{"bottom", LayerType::Signal, 0, 100'000, Top},
                                             StackLayer{"board", LayerType::Body, 100'000, 1'000'000, Substrate}});
    const ShapeSketch plate = rectangle({0, 0}, {20 * kMm, 20 * kMm});
    builder.beginLayer(LayerId{Top});
    builder.addArea({builder.addShape(rectangle({0, 0}, {12 * kMm, 20 * kMm})), {}}, {});
    builder.beginLayer(LayerId{Bottom});
    builder.addArea({builder.addShape(plate), {}}, {});
    builder.beginLayer(LayerId{Substrate});
    builder.addArea({builder.addShape(plate), {}}, {});
    builder.setBoardThickness(1'200'000);
    Stackup stackup;
    stackup.rows = {row("top", Top, LayerType::Signal, 1'100'000, 100'000),
                    row("PREPREG", 0, LayerType::Dielectric, 700'000, 400'000),
                    row("CORE", 0, LayerType::Dielectric, 300'000, 400'000),
                    row("PREPREG 2", 0, LayerType::Dielectric, 100'000, 200'000),
                    row("bottom", Bottom, LayerType::Signal, 0, 100'000)};
    builder.setStackup(stackup);
    return builder.finish();
}

Section cut(std::vector<PointD> line) {
    return *makeSection(*indexed(board()), {std::move(line), {}});
}

SectionPicture picture() {
    SectionPicture how{{0xff0000, 0x0000ff, 0x00ff00}, 1.0, 10.0};
    return how;
}

SectionSheet sheetOf(const std::vector<PointD>& line, const SectionPicture& how = picture()) {
    return sectionSheet(*board(), cut(line), how);
}

bool holdsText(const SectionSheet& sheet, const std::string& words) {
    return std::ranges::any_of(sheet.texts, [&](const SheetText& text) { return text.text.find(words) != words.npos; });
}

std::size_t filledWith(const SectionSheet& sheet, std::uint32_t colour) {
    return static_cast<std::size_t>(std::ranges::count(sheet.polygons, colour, &SheetPolygon::fill));
}

const std::uint32_t kPrepreg = *colourOf(SectionMaterial::Prepreg);
const std::uint32_t kCore = *colourOf(SectionMaterial::Core);

}  // namespace

class SectionSheetTest : public QObject {
    Q_OBJECT

private slots:
    /// Two polygons of one colour would let the paper through between them.
    void whatHasOneColourIsFilledAtOnce() {
        const SectionSheet sheet = sheetOf({{-5e6, 5e6}, {25e6, 5e6}});
        // Under all lies what the paper does not shine through; the legend has a swatch each.
        QCOMPARE(filledWith(sheet, kPrepreg), std::size_t{3});
        QCOMPARE(filledWith(sheet, kCore), std::size_t{2});
        QCOMPARE(sheet.polygons[0].fill, kPrepreg);
        QCOMPARE(sheet.polygons[0].contours.size(), std::size_t{5});  // three dielectrics, copper on both sides
        QCOMPARE(sheet.polygons[1].fill, kPrepreg);
        QCOMPARE(sheet.polygons[1].contours.size(), std::size_t{2});
    }

    void namesPointToWhereTheirRowsEnd() {
        const SectionSheet sheet = sheetOf({{-5e6, 5e6}, {25e6, 5e6}});
        const auto leadsFrom = [&](double along) {
            return std::ranges::count_if(sheet.lines, [&](const SheetLine& line) {
                return std::abs(line.x0 - (8.0 + 10.0 * along)) < 1e-6 && line.x1 > 8.0 + 300.0 && line.y0 == line.y1;
            });
        };
        QCOMPARE(leadsFrom(17.0), 1);  // the track on top
        QCOMPARE(leadsFrom(25.0), 4);
    }

    /// As of solder mask that is seen beside the copper that it covers, below the copper's upper face.
    void namesAreInTheOrderOfTheStackupWhereverRowsAreSeen() {
        Document other = *board();
        std::swap(other.stackup.rows[0], other.stackup.rows[1]);
        const SectionSheet sheet = sectionSheet(other, cut({{-5e6, 5e6}, {25e6, 5e6}}), picture());
        const auto heightOf = [&](const std::string& name) {
            return std::ranges::find(sheet.texts, name, &SheetText::text)->y;
        };
        QVERIFY(heightOf("PREPREG") < heightOf("top"));
        QVERIFY(heightOf("top") < heightOf("CORE"));
    }

    void theTitleNamesTheNet() {
        SectionPicture how = picture();
        QVERIFY(holdsText(sheetOf({{0, 5e6}, {20e6, 5e6}}, how), ": section from (0, 5) to (20, 5) mm, 20 mm long"));
        how.net = "USB_DP";
        QVERIFY(holdsText(sheetOf({{0, 5e6}, {20e6, 5e6}}, how), ": section along net USB_DP, from (0, 5) to (20, 5)"));
    }

    void theLegendHasAllColoursOfAMaterial() {
        const SectionSheet sheet = sheetOf({{0, 5e6}, {20e6, 5e6}});
        const auto legend = legendOf(merged(cut({{0, 5e6}, {20e6, 5e6}}).pieces), picture().colours);
        QCOMPARE(legend.size(), std::size_t{3});
        QCOMPARE(legend[0].colours, (std::vector<std::uint32_t>{0xff0000, 0x0000ff}));
        QCOMPARE(filledWith(sheet, 0xff0000), std::size_t{2});
        QCOMPARE(filledWith(sheet, 0x0000ff), std::size_t{2});
    }

    /// A mark each; a line only where the next one is 8 mm of paper away.
    void bendsHaveMarksAndLinesWhereThereIsRoom() {
        const SectionSheet sheet = sheetOf({{1e6, 1e6}, {5e6, 1e6}, {5e6, 1.5e6}, {8e6, 1.5e6}, {8e6, 6e6}});
        const auto dashed = std::ranges::count_if(sheet.lines, [](const SheetLine& line) { return line.isDashed; });
        QCOMPARE(dashed, 1);  // at 7.5 mm; those at 4 and 4.5 mm are close together
        const auto marks = std::ranges::count_if(sheet.polygons, [](const SheetPolygon& polygon) {
            return polygon.contours[0].size() == 3 && polygon.fill == 0;
        });
        QCOMPARE(marks, 3);
    }

    void partsThatAreTooHighEndInABreakLine() {
        Section section = cut({{0, 5e6}, {20e6, 5e6}});
        SectionPiece part;
        part.layer = LayerId{Top};
        part.from = 2e6;
        part.to = 4e6;
        part.bottom = 1'200'000;
        part.top = 2'000'000;
        part.material = SectionMaterial::Part;
        section.pieces.push_back(part);
        QCOMPARE(filledWith(sectionSheet(*board(), section, picture()), 0xffffff), std::size_t{0});
        section.pieces.back().top = 9'000'000;
        const SectionSheet sheet = sectionSheet(*board(), section, picture());
        QCOMPARE(filledWith(sheet, 0xffffff), std::size_t{1});
        for (const SheetPolygon& polygon : sheet.polygons) {
            if (polygon.fill == 0xffffff) {
                const auto [least, most] = std::ranges::minmax(polygon.contours[0]);
                QVERIFY(std::abs(least.first - 28.0) < 1e-6 && std::abs(most.first - 48.0) < 1e-6);
            }
        }
    }

    void linesOfNotesEndBehindWholeCharacters() {
        Section section = cut({{0, 5e6}, {20e6, 5e6}});
        for (const std::string before : {"", "a"}) {
            std::string note = before;
            for (int i = 0; i < 300; ++i) {
                note += "µ";
            }
            section.notes = {note};
            std::string written;
            std::size_t lines = 0;
            for (const SheetText& text : sectionSheet(*board(), section, picture()).texts) {
                QVERIFY(isUtf8(text.text));
                if (text.text.find("µµ") != std::string::npos) {
                    written += text.text;
                    ++lines;
                }
            }
            QCOMPARE(written, note);
            QVERIFY(lines > 1);
        }
    }

    void dimensionsAreWrittenApartAndStaleOnesDashed() {
        SectionPicture how = picture();
        const SectionDimension dimension{{5e6, 100e3, true, true}, {15e6, 100e3, true, true}};
        how.dimensions = {{dimension, "10 mm (393.7 mil)"}, {dimension, "10 mm, no longer on an edge", true}};
        const SectionSheet sheet = sheetOf({{0, 5e6}, {20e6, 5e6}}, how);
        std::set<double> heights;
        for (const SheetText& text : sheet.texts) {
            if (text.text.starts_with("10 mm")) {
                heights.insert(text.y);
            }
        }
        QCOMPARE(heights.size(), std::size_t{2});
        QVERIFY(*heights.rbegin() - *heights.begin() > 3.0);
        const auto isStale = [](const SheetLine& line) { return line.hasArrows && line.isDashed; };
        QCOMPARE(std::ranges::count_if(sheet.lines, isStale), 1);
    }
};

QTEST_APPLESS_MAIN(SectionSheetTest)
#include "section_sheet_test.moc"
