#include "render/tiles/rough_picture.h"

#include <QTest>
#include <cmath>

using namespace render;

namespace {

constexpr glm::ivec2 kSize{90, 70};
constexpr std::uint32_t kGround = 0xff102030U;
constexpr double kMmPerPixel = 0.1;

/// Red grows with x, green with y, both evenly.
std::uint32_t slope(double x, double y) {
    const auto byte = [](double value) { return static_cast<std::uint32_t>(std::lround(value)); };
    return 0xff000000U | byte(2.0 * x) << 16U | byte(3.0 * y) << 8U;
}

std::vector<std::uint32_t> slopes() {
    std::vector<std::uint32_t> pixels;
    for (int y = 0; y < kSize.y; ++y) {
        for (int x = 0; x < kSize.x; ++x) {
            pixels.push_back(slope(x, y));
        }
    }
    return pixels;
}

/// Pixels of the picture per pixel of the source, and where the source begins in it.
PlaneMap zoomed(double zoom, glm::dvec2 offset) {
    return {glm::dvec2(zoom / kMmPerPixel), offset};
}

std::uint32_t channel(std::uint32_t pixel, std::uint32_t shift) {
    return pixel >> shift & 0xffU;
}

bool isClose(std::uint32_t a, std::uint32_t b) {
    const auto isNear = [&](std::uint32_t shift) {
        return std::abs(static_cast<int>(channel(a, shift)) - static_cast<int>(channel(b, shift))) <= 2;
    };
    return isNear(0) && isNear(8) && isNear(16) && isNear(24);
}

}  // namespace

class RoughPictureTest : public QObject {
    Q_OBJECT

private slots:
    void stretchesWhatIsThere_data() {
        QTest::addColumn<double>("zoom");
        QTest::newRow("nearer") << 1.7;
        QTest::newRow("as it is") << 1.0;
        QTest::newRow("farther") << 0.6;
    }
    void stretchesWhatIsThere() {
        QFETCH(double, zoom);
        const std::vector<std::uint32_t> pixels = slopes();
        const RoughSource source{pixels.data(), kSize, zoomed(1.0, {0.0, 0.0})};
        const glm::dvec2 offset(-4.25, 3.5);
        const RoughPicture rough(source, {}, kGround, zoomed(zoom, offset), kSize);
        std::vector<std::uint32_t> picture(pixels.size());
        // In parts, as threads do.
        rough.paint({0, 0}, {31, kSize.y}, picture.data());
        rough.paint({31, 0}, {kSize.x, 29}, picture.data());
        rough.paint({31, 29}, kSize, picture.data());
        int reached = 0;
        for (int y = 0; y < kSize.y; ++y) {
            for (int x = 0; x < kSize.x; ++x) {
                const glm::dvec2 at = (glm::dvec2(x, y) + 0.5 - offset) / zoom - 0.5;
                const std::uint32_t own = picture[static_cast<std::size_t>(y * kSize.x + x)];
                const bool isIn = at.x >= 0.0 && at.y >= 0.0 && at.x < kSize.x - 1 && at.y < kSize.y - 1;
                reached += isIn ? 1 : 0;
                QVERIFY(isIn ? isClose(own, slope(at.x, at.y)) : own == kGround);
            }
        }
        QVERIFY(reached > 1000);
    }

    void showsTheRestWhereTheBestDoesNotReach() {
        const std::vector<std::uint32_t> best(pixelsOf(kSize), 0xffff0000U);
        const std::vector<std::uint32_t> rest(pixelsOf(kSize), 0xff00ff00U);
        const RoughSource small{best.data(), kSize, zoomed(1.0, {20.0, 10.0})};
        const RoughSource large{rest.data(), kSize, zoomed(1.0, {5.0, 5.0})};
        std::vector<std::uint32_t> picture(best.size());
        RoughPicture(small, large, kGround, zoomed(1.0, {0.0, 0.0}), kSize).paint({0, 0}, kSize, picture.data());
        const auto at = [&](int x, int y) { return picture[pixelsOf({kSize.x, y}) + static_cast<std::size_t>(x)]; };
        QCOMPARE(at(0, 0), 0xffff0000U);
        QCOMPARE(at(68, 58), 0xffff0000U);
        QCOMPARE(at(69, 58), 0xff00ff00U);
        QCOMPARE(at(68, 59), 0xff00ff00U);
        QCOMPARE(at(83, 63), 0xff00ff00U);
        QCOMPARE(at(84, 63), kGround);
        QCOMPARE(at(83, 64), kGround);
    }

private:
    static std::size_t pixelsOf(glm::ivec2 size) {
        return static_cast<std::size_t>(size.x) * static_cast<std::size_t>(size.y);
    }
};

QTEST_GUILESS_MAIN(RoughPictureTest)
#include "rough_picture_test.moc"
