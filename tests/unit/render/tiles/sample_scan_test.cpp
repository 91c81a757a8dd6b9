#include "render/tiles/sample_scan.h"

#include <QTest>
#include <algorithm>
#include <bit>
#include <memory>
#include <numbers>

using namespace render;

namespace {

int samplesOf(const MaskTile& tile) {
    int count = 0;
    for (const std::uint8_t bits : tile) {
        count += std::popcount(bits);
    }
    return count;
}

}  // namespace

class SampleScanTest : public QObject {
    Q_OBJECT

private slots:
    void tracksCoverWhatIsWithinTheirRadius() {
        auto tile = std::make_unique<MaskTile>();
        const glm::dvec2 a(40.3, 60.1);
        const glm::dvec2 b(120.7, 90.9);
        const double radius = 7.35;
        SampleScan(*tile, false).track(a, b, radius, 0.0);
        for (int y = 0; y < kTilePixels; ++y) {
            for (int x = 0; x < kTilePixels; ++x) {
                for (std::size_t i = 0; i < kSamplePlaces.size(); ++i) {
                    const glm::dvec2 at = glm::dvec2(x, y) + kSamplePlaces[i];
                    const double part = std::clamp(glm::dot(at - a, b - a) / glm::dot(b - a, b - a), 0.0, 1.0);
                    const double away = glm::length(at - a - part * (b - a)) - radius;
                    const bool isCovered = ((*tile)[static_cast<std::size_t>(y * kTilePixels + x)] >> i & 1) != 0;
                    QVERIFY(std::abs(away) < 0.01 || isCovered == (away < 0.0));
                }
            }
        }
    }

    void insidesOfHolesHaveBitsOfTheirOwn() {
        auto tile = std::make_unique<MaskTile>();
        SampleScan(*tile, true).track({30, 30}, {30, 30}, 5.0, 0.0);
        QVERIFY(samplesOf(*tile) > 0);
        QVERIFY(std::ranges::all_of(*tile, [](std::uint8_t bits) { return (bits & 0x0fU) == 0; }));
    }

    void cellsCoverWhatTheirCircleLeaves() {
        auto tile = std::make_unique<MaskTile>();
        SampleScan(*tile, false)
            .cell({glm::dvec2(20, 20), glm::dvec2(60, 20), glm::dvec2(60, 60), glm::dvec2(20, 60)}, {40, 40}, 10.0);
        const double samples = samplesOf(*tile) / 4.0;
        QVERIFY(std::abs(samples - (40.0 * 40.0 - 100.0 * std::numbers::pi)) < 2.0);
    }

    void shapesBesideATileLeaveItEmpty() {
        auto tile = std::make_unique<MaskTile>();
        SampleScan scan(*tile, false);
        scan.track({-50, 20}, {-20, 300}, 15.0, 0.0);
        scan.cell({glm::dvec2(300, 0), glm::dvec2(900, 40), glm::dvec2(880, 500), glm::dvec2(280, 500)}, {500, 200},
                  9.0);
        QCOMPARE(samplesOf(*tile), 0);
    }
};

QTEST_GUILESS_MAIN(SampleScanTest)
#include "sample_scan_test.moc"
