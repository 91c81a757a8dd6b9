// Barcodes of KiCad 10, and dimensions of footprints. The symbols are read back by what their standards say, not by the
// library that made them.
#include <QtTest>
#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <vector>

#include "model/formats/kicad/text/barcode_symbol.h"
#include "model/geometry/discretise.h"
#include "model/geometry/region.h"
#include "tests/unit/model/formats/kicad/kicad_testing.h"

using namespace kicad_testing;
using kicad::BarcodeKind;

namespace {

const DrawnJob& board() {
    static const DrawnJob job = drawn(fileText("barcodes.kicad_pcb"));
    return job;
}

std::uint32_t lineOf(std::string_view words) {
    const std::string text = fileText("barcodes.kicad_pcb");
    const auto end = text.begin() + static_cast<std::ptrdiff_t>(text.find(words));
    return static_cast<std::uint32_t>(std::count(text.begin(), end, '\n') + 1);
}

/// What an item of the file draws on a layer, as polygons.
PolygonSet regionOf(std::string_view layer, std::string_view item) {
    for (const DrawnFeature& feature : on(board(), layer)) {
        if (feature.line == lineOf(item) && feature.kind == DrawnKind::Region) {
            const ShapeSketch& sketch = board().steps[0].regions[static_cast<std::size_t>(feature.region)];
            return placed(polygonsOf(sketch), {feature.a, feature.clockwiseDeg, feature.isMirrored});
        }
    }
    return {};
}

Box boxOf(const PolygonSet& set) {
    Box box;
    for (const Point& point : set.points) {
        box.include(point);
    }
    return box;
}

bool covers(const PolygonSet& set, PointD p) {
    bool isIn = false;
    for (std::size_t i = 0; i < set.loopCount(); ++i) {
        const auto loop = set.loop(i);
        for (std::size_t k = 0, j = loop.size() - 1; k < loop.size(); j = k++) {
            const bool crosses = (loop[k].y > p.y) != (loop[j].y > p.y);
            const double x = crosses ? loop[k].x + (p.y - loop[k].y) / (double(loop[j].y) - loop[k].y) *
                                                       (double(loop[j].x) - loop[k].x)
                                     : 0.0;
            isIn = isIn != (crosses && p.x < x);
        }
    }
    return isIn;
}

/// Modules by row from the top and column.
class Modules {
public:
    Modules(const PolygonSet& region, const Box& box, int columns, int rows) {
        for (int row = 0; row < rows; ++row) {
            m_dark.emplace_back();
            for (int column = 0; column < columns; ++column) {
                const PointD middle{box.min.x + (column + 0.5) * static_cast<double>(box.width()) / columns,
                                    box.max.y - (row + 0.5) * static_cast<double>(box.height()) / rows};
                m_dark.back().push_back(covers(region, middle));
            }
        }
    }
    Modules(const PolygonSet& region, int columns, int rows) : Modules(region, boxOf(region), columns, rows) {}

    [[nodiscard]] bool at(int row, int column) const {
        return m_dark[static_cast<std::size_t>(row)][static_cast<std::size_t>(column)];
    }
    /// Dark and light modules of the middle row, as "X" and ".".
    [[nodiscard]] std::string line() const {
        std::string line;
        for (const bool isDark : m_dark[m_dark.size() / 2]) {
            line += isDark ? 'X' : '.';
        }
        return line;
    }

private:
    std::vector<std::vector<bool>> m_dark;
};

/// The eye in three corners of a QR code: a square in a ring in a light ring.
bool hasEyeAt(const Modules& code, int row, int column) {
    for (int y = 0; y < 7; ++y) {
        for (int x = 0; x < 7; ++x) {
            const int ring = std::max(std::abs(x - 3), std::abs(y - 3));
            if (code.at(row + y, column + x) != (ring != 2)) {
                return false;
            }
        }
    }
    return true;
}

/// The five bits of level and mask, without the pattern that is laid over them.
int formatOf(const Modules& code) {
    int bits = 0;
    for (int column = 0; column < 5; ++column) {
        bits = bits * 2 + (code.at(8, column) ? 1 : 0);
    }
    return bits ^ 0b10101;
}

bool isMasked(int mask, int i, int j) {
    switch (mask) {
        case 0: return (i + j) % 2 == 0;
        case 1: return i % 2 == 0;
        case 2: return j % 3 == 0;
        case 3: return (i + j) % 3 == 0;
        case 4: return (i / 2 + j / 3) % 2 == 0;
        case 5: return i * j % 2 + i * j % 3 == 0;
        case 6: return (i * j % 2 + i * j % 3) % 2 == 0;
        default: return ((i + j) % 2 + i * j % 3) % 2 == 0;
    }
}

/// The first bits of a code of 21 modules, from the lower right corner upwards and downwards in pairs of columns.
std::vector<int> dataOf(const Modules& code) {
    std::vector<int> bits;
    const int mask = formatOf(code) % 8;
    for (int pair = 0; pair < 4; ++pair) {
        for (int step = 0; step < 12; ++step) {
            const int row = pair % 2 == 0 ? 20 - step : 9 + step;
            for (const int column : {20 - 2 * pair, 19 - 2 * pair}) {
                bits.push_back(code.at(row, column) != isMasked(mask, row, column) ? 1 : 0);
            }
        }
    }
    return bits;
}

int number(const std::vector<int>& bits, std::size_t first, std::size_t count) {
    int value = 0;
    for (std::size_t i = first; i < first + count; ++i) {
        value = value * 2 + bits[i];
    }
    return value;
}

}  // namespace

class BarcodesTest : public QObject {
    Q_OBJECT

private slots:
    void qrCodesReadBackAsTheirText() {
        const PolygonSet region = regionOf("F.Silkscreen", "(barcode (at 10.5 10.5 0)");
        QCOMPARE(boxOf(region).min, Point(0, -21 * kMm));
        QCOMPARE(boxOf(region).max, Point(21 * kMm, 0));
        const Modules code(region, 21, 21);
        QVERIFY(hasEyeAt(code, 0, 0) && hasEyeAt(code, 0, 14) && hasEyeAt(code, 14, 0));
        for (int i = 8; i < 13; ++i) {
            QCOMPARE(code.at(6, i), i % 2 == 0);
            QCOMPARE(code.at(i, 6), i % 2 == 0);
        }
        QCOMPARE(formatOf(code) / 8, 0);  // level M
        const std::vector<int> bits = dataOf(code);
        QCOMPARE(number(bits, 0, 4), 1);   // digits
        QCOMPARE(number(bits, 4, 10), 5);  // so many
        QCOMPARE(number(bits, 14, 10), 123);
        QCOMPARE(number(bits, 24, 7), 45);
    }

    void smallQrCodesHaveOneEye() {
        const Modules code(regionOf("F.Cu", "(barcode (at 70 10 0)"), 17, 17);  // level H is none of theirs: Q
        QVERIFY(hasEyeAt(code, 0, 0));
        for (int i = 8; i < 17; ++i) {
            QCOMPARE(code.at(0, i), i % 2 == 0);
            QCOMPARE(code.at(i, 0), i % 2 == 0);
        }
    }

    void dataMatricesHaveTheirFrame() {
        const PolygonSet region = regionOf("F.Mask", "(barcode (at 40 10 0)");
        const Modules code(region, 10, 10);
        for (int i = 0; i < 10; ++i) {
            QVERIFY(code.at(9, i) && code.at(i, 0));
            QCOMPARE(code.at(0, i), i % 2 == 0);
            QCOMPARE(code.at(i, 9), i % 2 == 1);
        }
    }

    /// Of narrow and wide bars, 1 to 2, as Code 39 has * and 1.
    void bars39AreTheirText() {
        const auto modules = [](std::string_view widths) {
            std::string line;
            for (std::size_t i = 0; i < widths.size(); ++i) {
                line.append(widths[i] == 'w' ? 2 : 1, i % 2 == 0 ? 'X' : '.');
            }
            return line;
        };
        const std::string star = modules("nwnnwnwnn");
        const std::string expected = star + '.' + modules("wnnwnnnnw") + '.' + star;
        const PolygonSet region = regionOf("Dwgs.User", "(barcode (at 20 40 0)");
        QCOMPARE(boxOf(region).width(), std::int64_t{38} * kMm);
        QCOMPARE(boxOf(region).height(), std::int64_t{8} * kMm);
        QCOMPARE(Modules(region, static_cast<int>(expected.size()), 1).line(), expected);
    }

    /// Start B, A, their check digit 34, stop.
    void bars128AreTheirText() {
        std::string expected;
        bool isDark = true;
        for (const char width : std::string_view("2112141113231311232331112")) {
            expected.append(static_cast<std::size_t>(width - '0'), isDark ? 'X' : '.');
            isDark = !isDark;
        }
        const PolygonSet region = regionOf("Dwgs.User", "(barcode (at 60 40 0)");
        QCOMPARE(Modules(region, static_cast<int>(expected.size()), 1).line(), expected);
    }

    /// The same code as the first one, mirrored, turned by a quarter, and light on dark with its text.
    void whatIsOnTheBackIsMirrored() {
        const PolygonSet region = regionOf("B.Silkscreen", "(barcode (at 90 10 90)");
        const Modules front(regionOf("F.Silkscreen", "(barcode (at 10.5 10.5 0)"), 21, 21);
        Box symbol;
        symbol.include(Point(90 * kMm - 5'250'000, -10 * kMm - 5'250'000));
        symbol.include(Point(90 * kMm + 5'250'000, -10 * kMm + 5'250'000));
        const Modules back(region, symbol, 21, 21);
        for (int row = 0; row < 21; ++row) {
            for (int column = 0; column < 21; ++column) {
                QCOMPARE(back.at(column, row), !front.at(row, column));
            }
        }
    }

    void knockoutsReachAroundSymbolAndText() {
        const Box box = boxOf(regionOf("B.Silkscreen", "(barcode (at 90 10 90)"));
        // A tenth of 10.5 mm in whole tenths is 1.1 mm, more than the 0.5 asked for across; along it 2 mm were asked
        // for.
        QCOMPARE(box.height(), std::int64_t{10'500'000 + 2 * 1'100'000});
        QVERIFY(box.width() > 10'500'000 + 2 * 2'000'000 + 1'000'000 + 1'000'000);  // the text of 1 mm, 1 mm away
        QVERIFY(box.width() < 10'500'000 + 2 * 2'000'000 + 1'000'000 + 1'400'000);
    }

    /// Places are the board's in footprints too; variables are the footprint's.
    void barcodesOfFootprintsLieOnTheBoard() {
        const PolygonSet region = regionOf("F.Silkscreen", "(barcode (at 45 30 0)");
        const Box box = boxOf(region);
        QCOMPARE(box.min.x, 39 * kMm);
        QCOMPARE(box.max.x, 51 * kMm);
        QCOMPARE(box.max.y, -28 * kMm);
        QVERIFY(box.min.y < -34 * kMm && box.min.y > -34'500'000);
        const auto& groups = board().steps[0].groups;
        QVERIFY(std::ranges::any_of(groups, [](const auto& group) { return group.properties[0].second == "U7"; }));
    }

    void dimensionsOfFootprintsLieOnTheBoard() {
        bool isThere = false;
        for (const DrawnFeature& feature : on(board(), "Dwgs.User")) {
            isThere =
                isThere || (feature.kind == DrawnKind::Line && feature.line == lineOf("(dimension (type aligned)") &&
                            feature.a == Point(40 * kMm, -20'250'000) && feature.b == Point(40 * kMm, -25'500'000));
        }
        QVERIFY(isThere);
    }

    void whatCannotBeDrawnIsReported() {
        const Diagnostics& found = board().diagnostics;
        QCOMPARE(messages(found, "barcode is not drawn"), 2U);
        QCOMPARE(messages(found, "its type is unknown"), 1U);
        QCOMPARE(messages(found, "barcode has no place"), 1U);
        QCOMPARE(messages(boardWith("(barcode (at 1 1) (layer \"F.Cu\") (size 1 1) (text \"\") (type qr))").diagnostics,
                          "it has no text"),
                 1U);
        for (const char* size : {"(size 2211 2211)", "(size 1 1) (text_height 3000)", "(size 1 1) (margins 2000 1)"}) {
            const std::string wide =
                std::string("(barcode (at 1 1) (layer \"F.Cu\") ") + size + " (text \"1\") (type qr) (knockout yes))";
            QCOMPARE(messages(boardWith(wide).diagnostics, "it is larger than a board can be"), 1U);
        }
        QVERIFY(!kicad::barsOf(BarcodeKind::Code39,
                               "Gr\xc3\xbc\xc3\x9f"
                               "e",
                               1));
        QVERIFY(kicad::barsOf(BarcodeKind::Qr,
                              "Gr\xc3\xbc\xc3\x9f"
                              "e",
                              1)
                    .ok());
        QVERIFY(!kicad::barsOf(BarcodeKind::MicroQr, std::string(100, 'x'), 1));
    }
};

QTEST_APPLESS_MAIN(BarcodesTest)
#include "barcodes_test.moc"
