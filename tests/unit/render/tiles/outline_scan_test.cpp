#include "render/tiles/outline_scan.h"

#include <QTest>
#include <algorithm>
#include <bit>
#include <memory>
#include <random>
#include <vector>

using namespace render;

namespace {

using Line = std::vector<glm::dvec2>;

int samplesOf(const MaskTile& tile) {
    int count = 0;
    for (const std::uint8_t bits : tile) {
        count += std::popcount(bits);
    }
    return count;
}

/// Counter-clockwise as it is seen, y down.
Line box(double left, double top, double right, double bottom) {
    return {{left, top}, {left, bottom}, {right, bottom}, {right, top}};
}

Line reversed(Line line) {
    std::ranges::reverse(line);
    return line;
}

Line moved(Line line, glm::dvec2 by) {
    for (glm::dvec2& point : line) {
        point += by;
    }
    return line;
}

void addEdges(OutlineScan& scan, const Line& line) {
    for (std::size_t i = 0; i < line.size(); ++i) {
        scan.edge(line[i], line[(i + 1) % line.size()]);
    }
}

std::unique_ptr<MaskTile> drawn(const std::vector<Line>& lines, bool isMirrored = false) {
    auto tile = std::make_unique<MaskTile>();
    OutlineScan scan(*tile);
    scan.begin(isMirrored);
    for (const Line& line : lines) {
        addEdges(scan, line);
    }
    scan.fill();
    return tile;
}

/// A star with edges of all lengths, corners at whole steps of 1/256 pixel.
Line star(glm::dvec2 centre, double inner, double outer, int corners, unsigned seed) {
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> reach(inner, outer);
    Line line;
    for (int i = 0; i < corners; ++i) {
        const double angle = -2.0 * 3.14159265 * i / corners;
        const glm::dvec2 at = centre + reach(random) * glm::dvec2(std::cos(angle), std::sin(angle));
        line.push_back(glm::round(at * 256.0) / 256.0);
    }
    return line;
}

/// Winds a line around a place?
int winding(const Line& line, glm::dvec2 place) {
    int sum = 0;
    for (std::size_t i = 0; i < line.size(); ++i) {
        const glm::dvec2 a = line[i];
        const glm::dvec2 b = line[(i + 1) % line.size()];
        if ((a.y <= place.y) != (b.y <= place.y)) {
            const double x = a.x + (place.y - a.y) / (b.y - a.y) * (b.x - a.x);
            sum += x <= place.x ? (a.y < b.y ? 1 : -1) : 0;
        }
    }
    return sum;
}

}  // namespace

class OutlineScanTest : public QObject {
    Q_OBJECT

private slots:
    void samplesInsideAreCovered_data() {
        QTest::addColumn<double>("x");
        QTest::newRow("in the tile") << 128.0;
        QTest::newRow("across its left edge") << 10.0;
        QTest::newRow("across its right edge") << 250.0;
        QTest::newRow("around it") << 128.5;
    }
    void samplesInsideAreCovered() {
        QFETCH(double, x);
        const double size = x == 128.5 ? 5.0 : 1.0;
        for (unsigned seed = 1; seed <= 2; ++seed) {
            const Line outline = star({x, 130.0}, 60.0 * size, 100.0 * size, 90, seed);
            const Line hole = reversed(star({x + 5.0, 120.0}, 10.0, 40.0, 30, seed + 100));
            const std::unique_ptr<MaskTile> tile = drawn({outline, hole});
            int wrong = 0;
            for (int y = 0; y < kTilePixels; ++y) {
                for (int column = 0; column < kTilePixels; ++column) {
                    for (std::size_t i = 0; i < kSamplePlaces.size(); ++i) {
                        const glm::dvec2 at = glm::dvec2(column, y) + kSamplePlaces[i];
                        const bool isInside = winding(outline, at) + winding(hole, at) > 0;
                        const int bits = (*tile)[static_cast<std::size_t>(y * kTilePixels + column)];
                        wrong += ((bits >> i & 1) != 0) != isInside ? 1 : 0;
                    }
                }
            }
            QCOMPARE(wrong, 0);
        }
    }

    /// A square of two triangles, whose diagonal and edges pass through samples.
    void neighboursShareNoSampleAndLeaveNoneOut() {
        const auto lower = drawn({{{10, 10}, {10, 50}, {50, 50}}});
        const auto upper = drawn({{{10, 10}, {50, 50}, {50, 10}}});
        for (std::size_t i = 0; i < lower->size(); ++i) {
            QCOMPARE((*lower)[i] & (*upper)[i], 0);
        }
        QCOMPARE(samplesOf(*lower) + samplesOf(*upper), 40 * 40 * 4);
    }

    void areasThatOverlapAreCoveredOnceAndHolesOfOneByTheOther() {
        const Line hole = reversed(box(20, 20, 40, 40));
        QCOMPARE(samplesOf(*drawn({box(10, 10, 50, 50), hole})), (40 * 40 - 20 * 20) * 4);
        QCOMPARE(samplesOf(*drawn({box(10, 10, 50, 50), box(30, 10, 70, 50)})), 60 * 40 * 4);
        QCOMPARE(samplesOf(*drawn({box(10, 10, 50, 50), hole, box(30, 10, 70, 50)})), (60 * 40 - 10 * 20) * 4);
    }

    void fromBelowLinesWindTheOtherWay() {
        const std::vector<Line> lines = {reversed(box(10, 10, 50, 50)), box(20, 20, 40, 40)};
        QCOMPARE(samplesOf(*drawn(lines, true)), (40 * 40 - 20 * 20) * 4);
        QCOMPARE(samplesOf(*drawn(lines, false)), 0);
    }

    /// Edges left of a tile may be told by their ends.
    void edgesOnTheLeftAreOne() {
        const Line whole = moved(star({0.0, 128.0}, 60.0, 100.0, 300, 7), {-5.0, 0.0});
        const std::unique_ptr<MaskTile> expected = drawn({whole});
        auto tile = std::make_unique<MaskTile>();
        OutlineScan scan(*tile);
        scan.begin(false);
        std::size_t from = 0;
        for (std::size_t i = 0; i < whole.size(); ++i) {
            const glm::dvec2 next = whole[(i + 1) % whole.size()];
            if (whole[i].x < 0.0 && next.x < 0.0) {
                continue;
            }
            if (from < i) {
                scan.edgesOnTheLeft(whole[from], whole[i]);
            }
            scan.edge(whole[i], next);
            from = i + 1;
        }
        scan.edgesOnTheLeft(whole[from % whole.size()], whole.front());
        scan.fill();
        QVERIFY(*tile == *expected);
        QVERIFY(samplesOf(*tile) > 10'000);
    }

    void areasBesideATileLeaveItEmpty() {
        for (const glm::dvec2 by : {glm::dvec2(300, 0), glm::dvec2(-300, 0), glm::dvec2(0, 300), glm::dvec2(0, -300)}) {
            QCOMPARE(samplesOf(*drawn({moved(box(10, 10, 200, 200), by)})), 0);
        }
    }

    /// One scan for many areas: nothing of one is left to the next.
    void areasFollowEachOther() {
        auto tile = std::make_unique<MaskTile>();
        OutlineScan scan(*tile);
        for (int i = 0; i < 3; ++i) {
            scan.begin(i == 1);
            addEdges(scan, i == 1 ? reversed(box(10.0 + 40 * i, 10, 30.0 + 40 * i, 30))
                                  : box(10.0 + 40 * i, 10, 30.0 + 40 * i, 30));
            scan.fill();
        }
        QCOMPARE(samplesOf(*tile), 3 * 20 * 20 * 4);
    }
};

QTEST_GUILESS_MAIN(OutlineScanTest)
#include "outline_scan_test.moc"
