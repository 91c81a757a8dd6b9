#include "render/tiles/flat_picture.h"

#include <QtTest>

#include "render/scene/scene_buffers.h"
#include "tests/gpu/gpu_fixture.h"

using namespace render;
using namespace render::test;

namespace {

constexpr int kWidth = 640;
constexpr int kHeight = 480;
constexpr float kAspect = 4.0F / 3.0F;

Image imageOf(const FlatPicture& flat) {
    Image image{kWidth, kHeight, {}};
    const std::shared_ptr<const FlatPicture::Pixels> pixels = flat.pixels();
    for (const std::uint32_t pixel : *pixels) {
        for (const std::uint32_t shift : {16U, 8U, 0U, 24U}) {
            image.rgba.push_back(static_cast<std::uint8_t>(pixel >> shift));
        }
    }
    return image;
}

/// Nothing but copies of a step, in rows of eight.
BoardModel panelOf(const BoardModel& step, std::uint32_t count) {
    BoardModel panel;
    panel.layers = step.layers;
    panel.clustersOfLayer.resize(step.layers.size());
    panel.areaBatchesOfLayer.resize(step.layers.size());
    const glm::dvec2 size(glm::vec2(step.boxMax - step.boxMin));
    for (std::uint32_t i = 0; i < count; ++i) {
        ModelCopy copy;
        copy.step = 1;
        copy.origin = size * glm::dvec2(i % 8, i / 8);  // NOLINT(bugprone-integer-division)
        panel.copies.push_back(copy);
    }
    panel.boxMin = step.boxMin;
    panel.boxMax = step.boxMax + glm::vec3(panel.copies.back().origin, 0.0F);
    panel.steps.push_back(step);
    return panel;
}

/// A scene on the device and the same board in tiles.
struct Both {
    Scene scene;
    FlatPicture flat;
    ViewSettings settings;
    std::vector<std::vector<ElementState>> states;

    explicit Both(const SyntheticBoard& board, std::uint64_t bytes = FlatPicture::kMaxBytes)
        : scene(board), flat(std::make_shared<const BoardModel>(board.build()), bytes) {
        settings.is2d = true;
        settings.backend = Backend::Impostor;
        look(NamedView::Top);
    }
    void look(NamedView view) {
        scene.camera.setOrthographic(true);
        scene.camera.fit(scene.model.boxMin, scene.model.boxMax, view, kAspect);
    }
    void setStates(std::vector<ElementState> own) {
        scene.scene.setStates(own);
        states = {std::move(own)};
    }

    FlatPicture::Quality drawFlat(Image& image, double budgetMs = 0.0) {
        const FlatPicture::Quality quality =
            flat.draw({&scene.scene.impl().layers, states, scene.camera, settings, kWidth, kHeight}, budgetMs);
        image = imageOf(flat);
        return quality;
    }
    /// Both pictures are the same but in few pixels.
    void compare() {
        Image flatImage;
        QCOMPARE(drawFlat(flatImage), FlatPicture::Quality::Exact);
        const Image device = scene.draw(settings, kWidth, kHeight);
        // Means of translucent samples are rounded twice.
        const std::size_t byTwo = differingPixels(device, flatImage, 1);
        const std::size_t byMore = differingPixels(device, flatImage, 2);
        QVERIFY2(byTwo <= kWidth * kHeight / 5000, qPrintable(QString("%1 pixels").arg(byTwo)));
        // Where an outline passes by a sample, cards round otherwise.
        const int most = kWidth * kHeight / (test::Gpu::get().device.caps().isCpu ? 10000 : 5000);
        QVERIFY2(byMore <= static_cast<std::size_t>(most), qPrintable(QString("%1 pixels").arg(byMore)));
    }
};

}  // namespace

class FlatPictureTest : public QObject {
    Q_OBJECT

private slots:
    void isThePictureOfTheDevice_data() {
        QTest::addColumn<int>("view");
        QTest::addColumn<float>("zoom");
        QTest::newRow("from above") << int(NamedView::Top) << 1.0F;
        QTest::newRow("from below") << int(NamedView::Bottom) << 1.0F;
        QTest::newRow("near") << int(NamedView::Top) << 7.3F;
        QTest::newRow("far") << int(NamedView::Top) << 0.21F;
    }
    void isThePictureOfTheDevice() {
        QFETCH(int, view);
        QFETCH(float, zoom);
        for (const SyntheticBoard& board : {everything(), randomTraces(400, 5)}) {
            Both both(board);
            both.look(static_cast<NamedView>(view));
            both.scene.camera.zoom(zoom, {0.21F, -0.13F}, kAspect);
            both.compare();
            both.scene.camera.pan({37.0F, -121.0F}, kHeight);
            both.compare();
        }
    }

    /// Every other element in turn is hidden, highlighted, of a colour of its own, or both; the rest is dimmed.
    void showsWhatElementsAre_data() {
        QTest::addColumn<ElementState>("state");
        QTest::addColumn<float>("dim");
        QTest::newRow("highlighted") << kHighlighted << 0.0F;
        QTest::newRow("highlighted among dimmed") << kHighlighted << kDimRest;
        QTest::newRow("in a colour") << inColour(3) << 0.0F;
        QTest::newRow("highlighted net") << highlightedAs(1) << 0.4F;
        QTest::newRow("hidden") << kHidden << 0.0F;
    }
    void showsWhatElementsAre() {
        QFETCH(ElementState, state);
        QFETCH(float, dim);
        Both both(everything());
        both.scene.scene.setPalette(std::vector<glm::vec3>{{0, 0, 0}, {0, 0, 0}, {0, 0, 0}, {0.3F, 0.9F, 0.2F}});
        both.compare();
        std::vector<ElementState> states = plainStates(64);
        for (std::size_t i = 0; i < states.size(); i += 3) {
            states[i] = state;
        }
        both.setStates(states);
        both.settings.dim = dim;
        both.compare();
        both.setStates(plainStates(64));
        both.compare();
    }

    void looksChangeWithoutDrawingAnew() {
        Both both(everything());
        both.compare();
        std::vector<LayerStyle> styles = both.scene.scene.impl().layers.styles;
        for (LayerStyle& style : styles) {
            style.isVisible = !style.isVisible;
            both.scene.scene.setStyles(styles);
            both.compare();
            style.isVisible = true;
            style.opacity = 0.4F;
            style.colour = {0.9F, style.colour.r, 0.1F};
            both.scene.scene.setStyles(styles);
            both.compare();
        }
    }

    void isRoughFirstAndExactThen() {
        Both both(everything());
        both.compare();
        both.scene.camera.zoom(1.7F, {0.0F, 0.0F}, kAspect);
        Image rough;
        QCOMPARE(both.drawFlat(rough, 1e-6), FlatPicture::Quality::Rough);
        const Image device = both.scene.draw(both.settings, kWidth, kHeight);
        QVERIFY(differingPixels(device, rough, 160) < kWidth * kHeight / 100);
        int steps = 1;
        while (!both.flat.refine(1e-6)) {
            ++steps;
        }
        QVERIFY(steps > 1);
        both.compare();
    }

    /// Its board may not be made yet: no frame waits for that, and none is left to the device.
    void isBackgroundUntilTheBoardIsThere() {
        Both both(randomTraces(20'000, 5));
        Image image;
        QCOMPARE(both.drawFlat(image, 1e-6), FlatPicture::Quality::Rough);
        QVERIFY(both.flat.isPartial());
        QCOMPARE(image.rgba.size(), std::size_t{kWidth} * kHeight * 4);
        while (both.flat.isPartial()) {
            QCOMPARE(both.drawFlat(image, 1e-6), FlatPicture::Quality::Rough);
            (void)both.flat.refine(1e-6);
        }
        both.compare();
    }

    void drawsAheadWhatIsAround() {
        Both both(randomTraces(400, 5));
        both.scene.camera.zoom(4.0F, {0.0F, 0.0F}, kAspect);
        both.compare();
        int steps = 1;
        while (!both.flat.prepare(1e-6)) {
            ++steps;
        }
        QVERIFY(steps > 1);
        both.scene.camera.pan({200.0F, -150.0F}, kHeight);
        Image image;
        QCOMPARE(both.drawFlat(image, 1e-6), FlatPicture::Quality::Exact);
        both.compare();
    }

    void zoomsBackToWhatItKept() {
        Both both(randomTraces(400, 5));
        both.compare();
        Image image;
        both.scene.camera.zoom(1.2F, {0.3F, -0.2F}, kAspect);
        QCOMPARE(both.drawFlat(image, 1e-6), FlatPicture::Quality::Rough);
        both.scene.camera.zoom(1.0F / 1.2F, {0.3F, -0.2F}, kAspect);
        QCOMPARE(both.drawFlat(image, 1e-6), FlatPicture::Quality::Exact);
        both.compare();
    }

    void movesByPartsOfAPixelOnlyAtRest() {
        Both both(everything());
        both.compare();
        both.scene.camera.pan({10.4F, 0.3F}, kHeight);
        Image moving;
        QCOMPARE(both.drawFlat(moving, 1e-6), FlatPicture::Quality::Rough);
        const Image device = both.scene.draw(both.settings, kWidth, kHeight);
        QVERIFY(differingPixels(device, moving, 100) < kWidth * kHeight / 20);
        QVERIFY(both.flat.refine(1e-6));
        both.compare();
    }

    void highlightsAreSeenFirstAndEdgedThen() {
        Both both(everything());
        both.compare();
        both.setStates(std::vector<ElementState>(64, kHighlighted));
        Image image;
        QCOMPARE(both.drawFlat(image, 1e-6), FlatPicture::Quality::Rough);
        int rough = 0;
        for (int i = 0; i < 10'000 && both.drawFlat(image, 1e-6) != FlatPicture::Quality::Exact; ++i) {
            ++rough;
            (void)both.flat.refine(1e-6);
        }
        QVERIFY(rough > 1 && rough < 10'000);
        both.compare();
    }

    /// Of so many elements nothing has one, and each copy of a step has its own.
    void darkEdgesAreLeftOutByWhatStandsOutInAllCopies() {
        constexpr std::uint32_t kCopies = 40;
        const SyntheticBoard one = randomTraces(60, 5);
        const auto panel = std::make_shared<const BoardModel>(panelOf(one.build(), kCopies));
        const std::vector<ElementState> own(panel->steps.front().elementCount, kHighlighted);
        BoardScene scene(Gpu::get().device, *panel);
        scene.setStyles(one.styles());
        scene.setStates(own, 1);
        Camera camera;
        camera.setOrthographic(true);
        camera.fit(panel->boxMin, panel->boxMax, NamedView::Top, kAspect);
        ViewSettings settings;
        settings.is2d = true;
        settings.backend = Backend::Impostor;
        FlatPicture flat(panel);
        const std::vector<std::vector<ElementState>> states{{}, own};
        QCOMPARE(flat.draw({&scene.impl().layers, states, camera, settings, kWidth, kHeight}, 0.0),
                 FlatPicture::Quality::Exact);
        const auto device = Gpu::get().presenter.render(scene, camera, settings, kWidth, kHeight);
        QVERIFY(device);
        QVERIFY(differingPixels(*device, imageOf(flat), 40) < kWidth * kHeight / 1000);
    }

    /// Its tiles keep what they showed while the view is elsewhere.
    void whatStandsOutAnewHasItsNewColourAlsoWhereItWasNotInView() {
        Both both(everything());
        both.scene.camera.zoom(4.0F, {0.0F, 0.0F}, kAspect);
        for (const ElementState state : {kHighlighted, highlightedAs(1)}) {
            both.setStates(std::vector<ElementState>(64, state));
            both.compare();
            both.scene.camera.pan({700.0F, 0.0F}, kHeight);
            both.setStates(std::vector<ElementState>(64, kPlain));
            both.compare();
            both.setStates(std::vector<ElementState>(64, state == kHighlighted ? highlightedAs(1) : kHighlighted));
            both.compare();
            both.scene.camera.pan({-700.0F, 0.0F}, kHeight);
            both.compare();
        }
    }

    void keepsWithinItsMemory() {
        constexpr std::uint64_t kBytes = 16ULL << 20U;
        Both both(randomTraces(400, 3), kBytes);
        for (int i = 0; i < 20; ++i) {
            both.compare();
            QVERIFY(both.flat.bytes() <= kBytes);
            both.scene.camera.pan({350.0F, 100.0F}, kHeight);
            both.scene.camera.zoom(1.1F, {0.3F, 0.3F}, kAspect);
        }
        Both small(randomTraces(400, 3), 100'000);
        Image image;
        QCOMPARE(small.drawFlat(image), FlatPicture::Quality::None);
        QVERIFY(small.flat.bytes() <= 100'000);
    }

    /// A window shows them until the device has drawn what does not fit here.
    void pixelsStayWithWhoHoldsThemWhereTheNextFrameNeedsTooMuch() {
        const SyntheticBoard board = everything();
        Both both(board);
        std::vector<LayerStyle> styles = both.scene.scene.impl().layers.styles;
        std::for_each(styles.begin() + 1, styles.end(), [](LayerStyle& style) { style.isVisible = false; });
        both.scene.scene.setStyles(styles);
        both.compare();
        Both tight(board, both.flat.bytes());
        tight.scene.scene.setStyles(styles);
        tight.compare();
        const std::shared_ptr<const FlatPicture::Pixels> held = tight.flat.pixels();
        QCOMPARE(held->size(), std::size_t{kWidth} * kHeight);
        tight.scene.scene.setStyles(board.styles());
        Image image;
        QCOMPARE(tight.drawFlat(image), FlatPicture::Quality::None);
        QVERIFY(tight.flat.pixels() != held);
        QCOMPARE(held->size(), std::size_t{kWidth} * kHeight);
    }

    void leavesToTheDeviceWhatItCannotDraw() {
        Both both(everything());
        Image image;
        both.settings.isOutlined = true;
        QCOMPARE(both.drawFlat(image), FlatPicture::Quality::None);
        both.settings.isOutlined = false;
        both.scene.camera.orbit(0.1F, 0.0F);
        QCOMPARE(both.drawFlat(image), FlatPicture::Quality::None);
        both.scene.camera.orbit(-0.1F, 0.3F);
        QCOMPARE(both.drawFlat(image), FlatPicture::Quality::None);
        both.look(NamedView::Top);
        both.compare();
    }
};

GPU_TEST_MAIN(FlatPictureTest)
#include "flat_picture_test.moc"
