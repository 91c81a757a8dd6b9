#include "render/tiles/warped_picture.h"

#include <QTest>
#include <cmath>
#include <vector>

#include "render/scene/camera.h"

using namespace render;

namespace {

constexpr glm::ivec2 kSize{320, 180};
constexpr float kAspect = 16.0F / 9.0F;
constexpr float kFace = 1.6F;
constexpr std::uint32_t kGround = 0xff102030U;

Camera wholeBoard(NamedView view, bool isOrthographic) {
    Camera camera;
    camera.setOrthographic(isOrthographic);
    camera.fit({0.0F, 0.0F, 0.0F}, {100.0F, 60.0F, kFace}, view, kAspect);
    return camera;
}

glm::dmat3 seenBy(const Camera& camera) {
    return clipFromPlane(camera.projection(kAspect) * camera.view(), kFace);
}

/// Where the line of sight through a pixel meets the face, mm.
glm::dvec2 placeOf(const Camera& camera, int x, int y) {
    const glm::dvec3 clip(2.0 * (x + 0.5) / kSize.x - 1.0, 2.0 * (y + 0.5) / kSize.y - 1.0, 1.0);
    const glm::dvec3 place = glm::inverse(seenBy(camera)) * clip;
    return glm::dvec2(place) / place.z;
}

bool isOnBoard(glm::dvec2 mm) {
    return mm.x > 0.0 && mm.y > 0.0 && mm.x < 100.0 && mm.y < 60.0;
}

/// Of a board that is redder to the right and greener behind.
std::uint32_t colourAt(glm::dvec2 mm) {
    const auto byte = [](double value) { return static_cast<std::uint32_t>(std::lround(value)); };
    return 0xff000000U | byte(55.0 + 2.0 * mm.x) << 16U | byte(55.0 + 3.0 * mm.y) << 8U;
}

std::vector<std::uint32_t> pictureBy(const Camera& camera) {
    std::vector<std::uint32_t> pixels;
    for (int y = 0; y < kSize.y; ++y) {
        for (int x = 0; x < kSize.x; ++x) {
            const glm::dvec2 mm = placeOf(camera, x, y);
            pixels.push_back(isOnBoard(mm) ? colourAt(mm) : kGround);
        }
    }
    return pixels;
}

int difference(std::uint32_t a, std::uint32_t b) {
    int most = 0;
    for (std::uint32_t shift = 0; shift < 32; shift += 8) {
        most = std::max(most, std::abs(static_cast<int>(a >> shift & 0xffU) - static_cast<int>(b >> shift & 0xffU)));
    }
    return most;
}

std::vector<std::uint32_t> warped(const Camera& from, const Camera& to) {
    const std::vector<std::uint32_t> source = pictureBy(from);
    const auto picture = WarpedPicture::make({source.data(), kSize, seenBy(from)}, seenBy(to), kSize);
    std::vector<std::uint32_t> pixels(source.size());
    if (picture) {
        picture->paint(kGround, nullptr, pixels.data());
    }
    return pixels;
}

}  // namespace

class WarpedPictureTest : public QObject {
    Q_OBJECT

private slots:
    void isThePictureOfAFlatBoardFromElsewhere_data() {
        QTest::addColumn<bool>("isOrthographic");
        QTest::addColumn<float>("yaw");
        QTest::addColumn<float>("pitch");
        QTest::addColumn<float>("zoom");
        QTest::newRow("the same") << false << 0.0F << 0.0F << 1.0F;
        QTest::newRow("turned") << false << 0.4F << 0.0F << 1.0F;
        QTest::newRow("tilted") << false << 0.0F << 0.3F << 1.0F;
        QTest::newRow("all of it") << false << -0.9F << -0.4F << 1.3F;
        QTest::newRow("parallel") << true << 0.7F << -0.2F << 0.8F;
    }
    void isThePictureOfAFlatBoardFromElsewhere() {
        QFETCH(bool, isOrthographic);
        QFETCH(float, yaw);
        QFETCH(float, pitch);
        QFETCH(float, zoom);
        const Camera from = wholeBoard(NamedView::Iso, isOrthographic);
        Camera to = from;
        to.orbit(yaw, pitch);
        to.zoom(zoom, {0.2F, 0.1F}, kAspect);
        to.pan({11.0F, -7.0F}, kSize.y);
        const std::vector<std::uint32_t> pixels = warped(from, to);
        int wrong = 0;
        int onBoard = 0;
        const std::vector<std::uint32_t> wanted = pictureBy(to);
        for (std::size_t i = 0; i < pixels.size(); ++i) {
            onBoard += wanted[i] != kGround ? 1 : 0;
            wrong += difference(pixels[i], wanted[i]) > 6 ? 1 : 0;
        }
        QVERIFY(onBoard > kSize.x * kSize.y / 8);
        QVERIFY2(wrong < kSize.x * kSize.y / 50, qPrintable(QString::number(wrong)));  // its rim is smooth or not
    }

    void whatItDoesNotReachLiesBehind() {
        const Camera to = wholeBoard(NamedView::Iso, false);
        Camera from = to;
        from.zoom(3.0F, {0.4F, 0.1F}, kAspect);
        Camera all = to;
        all.orbit(0.5F, -0.2F);
        all.fit({0.0F, 0.0F, 0.0F}, {100.0F, 60.0F, kFace}, kAspect);
        const std::vector<std::uint32_t> source = pictureBy(from);
        const std::vector<std::uint32_t> wholeSource = pictureBy(all);
        const auto picture = WarpedPicture::make({source.data(), kSize, seenBy(from)}, seenBy(to), kSize);
        const auto behind = WarpedPicture::make({wholeSource.data(), kSize, seenBy(all)}, seenBy(to), kSize);
        std::vector<std::uint32_t> pixels(source.size());
        const std::vector<std::uint32_t> wanted = pictureBy(to);
        const auto wrong = [&] {
            int count = 0;
            for (std::size_t i = 0; i < pixels.size(); ++i) {
                count += difference(pixels[i], wanted[i]) > 6 ? 1 : 0;
            }
            return count;
        };
        picture->paint(kGround, nullptr, pixels.data());
        QVERIFY(wrong() > kSize.x * kSize.y / 8);
        picture->paint(kGround, &*behind, pixels.data());
        QVERIFY2(wrong() < kSize.x * kSize.y / 50, qPrintable(QString::number(wrong())));
        // What it reaches itself is sharper than what lies behind.
        std::vector<std::uint32_t> alone(source.size());
        behind->paint(kGround, nullptr, alone.data());
        QVERIFY(alone != pixels);
    }

    /// Rows of pixels that cross the horizon have no streaks.
    void endsAtTheHorizon() {
        const Camera from = wholeBoard(NamedView::Iso, false);
        Camera to = from;
        CameraPose pose = to.pose();
        pose.target = {50.0F, 30.0F, kFace};
        pose.pitch = -0.1F;
        to.setPose(pose);
        const std::vector<std::uint32_t> source = pictureBy(from);
        const auto picture = WarpedPicture::make({source.data(), kSize, seenBy(from)}, seenBy(to), kSize);
        QVERIFY(picture);
        std::vector<std::uint32_t> pixels(source.size());
        picture->paint(kGround, nullptr, pixels.data());
        int missed = 0;
        for (int y = 0; y < kSize.y; ++y) {
            for (int x = 0; x < kSize.x; ++x) {
                const glm::dvec3 clip(2.0 * (x + 0.5) / kSize.x - 1.0, 2.0 * (y + 0.5) / kSize.y - 1.0, 1.0);
                if ((glm::inverse(seenBy(to)) * clip).z <= 0.0) {
                    ++missed;
                    QCOMPARE(pixels[static_cast<std::size_t>(y) * kSize.x + x], kGround);
                }
            }
        }
        QVERIFY(missed > 0);
    }

    void saysHowFarItsPixelsAreDrawnOut() {
        const Camera from = wholeBoard(NamedView::Iso, true);
        const std::vector<std::uint32_t> source = pictureBy(from);
        const auto stretch = [&](auto&& move) {
            Camera to = from;
            move(to);
            return WarpedPicture::make({source.data(), kSize, seenBy(from)}, seenBy(to), kSize)->stretch();
        };
        const auto isAbout = [](double value, double wanted) { return std::abs(value / wanted - 1.0) < 0.02; };
        QVERIFY(isAbout(stretch([](Camera&) {}), 1.0));
        QVERIFY(isAbout(stretch([](Camera& to) { to.zoom(2.0F, {0.0F, 0.0F}, kAspect); }), 2.0));
        QVERIFY(isAbout(stretch([](Camera& to) { to.orbit(0.7F, 0.0F); }), 1.0) == false);
        // Depth across the board grows as the sine of the pitch.
        const float pitch = from.pose().pitch;
        const double steeper = std::sin(pitch - 0.3F) / std::sin(pitch);
        QVERIFY(isAbout(stretch([](Camera& to) { to.orbit(0.0F, -0.3F); }), steeper));
    }

    void doesNotShowOneFaceForTheOther() {
        const Camera above = wholeBoard(NamedView::Top, false);
        const Camera below = wholeBoard(NamedView::Bottom, false);
        const std::vector<std::uint32_t> source = pictureBy(above);
        QVERIFY(WarpedPicture::make({source.data(), kSize, seenBy(above)}, seenBy(above), kSize));
        QVERIFY(!WarpedPicture::make({source.data(), kSize, seenBy(above)}, seenBy(below), kSize));
        QVERIFY(!WarpedPicture::make({nullptr, kSize, seenBy(above)}, seenBy(above), kSize));
    }

    void saysWhetherTheViewIsNear() {
        const Camera from = wholeBoard(NamedView::Iso, false);
        const std::vector<std::uint32_t> source = pictureBy(from);
        const auto isNear = [&](auto&& move) {
            Camera to = from;
            move(to);
            return WarpedPicture::make({source.data(), kSize, seenBy(from)}, seenBy(to), kSize)->isNear();
        };
        QVERIFY(isNear([](Camera&) {}));
        QVERIFY(isNear([](Camera& to) { to.orbit(0.03F, 0.02F); }));
        QVERIFY(isNear([](Camera& to) { to.pan({20.0F, 10.0F}, kSize.y); }));
        QVERIFY(!isNear([](Camera& to) { to.orbit(0.5F, 0.0F); }));
        QVERIFY(!isNear([](Camera& to) { to.pan({150.0F, 0.0F}, kSize.y); }));
        QVERIFY(!isNear([](Camera& to) { to.zoom(2.0F, {0.0F, 0.0F}, kAspect); }));
        QVERIFY(!isNear([](Camera& to) { to.zoom(0.5F, {0.0F, 0.0F}, kAspect); }));
    }
};

QTEST_GUILESS_MAIN(WarpedPictureTest)
#include "warped_picture_test.moc"
