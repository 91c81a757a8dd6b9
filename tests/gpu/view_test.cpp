#include <QtTest>
#include <cmath>

#include "render/culling/frame_plan.h"
#include "render/scene/scene_layers.h"
#include "tests/gpu/gpu_fixture.h"

using namespace render;
using namespace render::test;

/// What the settings of a view promise.
class ViewTest : public QObject {
    Q_OBJECT

    static ViewSettings flat() {
        ViewSettings settings;
        settings.is2d = true;
        settings.background = glm::vec3(0.0F);
        return settings;
    }

    /// One row of white on nothing.
    static std::vector<std::uint8_t> overlayOf(std::size_t width, std::size_t height, std::size_t row) {
        std::vector<std::uint8_t> rgba(width * height * 4);
        std::fill_n(rgba.begin() + static_cast<std::ptrdiff_t>(row * width * 4), width * 4, std::uint8_t{255});
        return rgba;
    }

    static int toByte(float linear) {
        const float srgb = linear <= 0.0031308F ? linear * 12.92F : 1.055F * std::pow(linear, 1.0F / 2.4F) - 0.055F;
        return static_cast<int>(std::lround(srgb * 255.0F));
    }

    static void comparePixel(const Image& image, std::uint32_t x, std::uint32_t y, const Rgb& expected,
                             int tolerance = 1) {
        const Rgb actual = pixel(image, x, y);
        QVERIFY2(distance(actual, expected) <= tolerance, describe(actual).c_str());
    }

private slots:
    void flatColoursAreThePanelsColours() {
        SyntheticBoard board;
        board.addLayer(0.0F, 0.035F, {0.8F, 0.4F, 0.2F});
        board.addDisc({0, 0}, 0.5F);
        Scene scene(board);
        scene.lookDown({-1, -1}, {1, 1});
        ViewSettings how = flat();
        how.background = {0.10F, 0.20F, 0.30F};
        const Image image = scene.draw(how, 200, 200);
        comparePixel(image, 100, 100, {204, 102, 51});
        comparePixel(image, 5, 5, {26, 51, 77});
    }

    /// With the board kept, another overlay lies over the same board; a picture of another size is drawn anew.
    void aKeptBoardIsTheSameUnderAnotherOverlay() {
        Scene scene(everything());
        scene.camera.fit(scene.model.boxMin, scene.model.boxMax, NamedView::Iso, 4.0F / 3.0F);
        const std::vector<std::uint8_t> spots[] = {overlayOf(200, 150, 40), overlayOf(200, 150, 90)};
        OffscreenPresenter presenter(Gpu::get().device);
        const auto draw = [&](int spot, bool isKept, std::uint32_t width) {
            ViewSettings how;
            how.cachesBoard = true;
            how.isBoardCached = isKept;
            how.overlay = {200, 150, spots[spot].data()};
            return *presenter.render(scene.scene, scene.camera, how, width, width * 3 / 4);
        };
        const Image first = draw(0, false, 200);
        QVERIFY(!presenter.stats().isOverlayAlone);
        const Image second = draw(1, false, 200);
        QVERIFY(differingPixels(first, second) > 10);
        QCOMPARE(differingPixels(draw(0, true, 200), first, 0), std::size_t{0});
        QVERIFY(presenter.stats().isOverlayAlone);
        QCOMPARE(differingPixels(draw(1, true, 200), second, 0), std::size_t{0});
        const Image larger = draw(1, true, 240);
        QVERIFY(!presenter.stats().isOverlayAlone);
        QCOMPARE(differingPixels(larger, draw(1, false, 240), 0), std::size_t{0});
    }

    void overlayLiesOverTheBoardPixelByPixel() {
        SyntheticBoard board;
        board.addLayer(0.0F, 0.035F, {0.8F, 0.4F, 0.2F});
        board.addDisc({0, 0}, 0.5F);
        Scene scene(board);
        scene.lookDown({-1, -1}, {1, 1});
        // Narrower than the picture: column 0 opaque, column 1 half transparent white, the others empty.
        constexpr std::uint32_t kWidth = 150;
        std::vector<std::uint8_t> rgba(std::size_t{kWidth} * 200 * 4);
        for (std::size_t row = 0; row < 200; ++row) {
            const std::uint8_t texels[8] = {10, 20, 30, 255, 128, 128, 128, 128};
            std::copy(std::begin(texels), std::end(texels),
                      rgba.begin() + static_cast<std::ptrdiff_t>(row * kWidth * 4));
        }
        for (const bool isSmoothed : {false, true}) {
            ViewSettings how = flat();
            how.isSmoothed = isSmoothed;
            const Image bare = scene.draw(how, 200, 200);
            how.overlay = {kWidth, 200, rgba.data()};
            const Image image = scene.draw(how, 200, 200);
            comparePixel(image, 0, 7, {10, 20, 30});
            const int half = toByte(128.0F / 255.0F);
            comparePixel(image, 1, 7, {half, half, half});
            for (const std::uint32_t x : {2U, 100U, 149U, 150U, 199U}) {
                comparePixel(image, x, 100, pixel(bare, x, 100), 0);
            }
        }
    }

    /// From straight above and from the side, in both projections: what is opaque and above the plane hides it, what is
    /// translucent or below does not.
    void aPictureInAPlaneIsHiddenByWhatIsAboveIt() {
        SyntheticBoard board;
        board.addLayer(0.0F, 0.1F, {0, 0, 1});
        board.addDisc({0, 0}, 0.9F);
        board.addLayer(0.5F, 0.6F, {1, 0, 0});
        board.addDisc({-0.4F, 0}, 0.2F);
        board.addLayer(0.7F, 0.8F, {1, 1, 1}, 0.3F);
        board.addDisc({0.4F, 0}, 0.2F);
        Scene scene(board);
        constexpr std::uint32_t kSide = 200;
        std::vector<std::uint8_t> green(std::size_t{kSide} * kSide * 4);
        for (std::size_t i = 0; i < green.size(); i += 4) {
            green[i + 1] = green[i + 3] = 255;
        }
        for (const bool isParallel : {true, false}) {
            for (const bool isSmoothed : {true, false}) {
                for (const bool isTilted : {false, true}) {
                    scene.camera = Camera();
                    scene.camera.setOrthographic(isParallel);
                    scene.camera.fit(scene.model.boxMin, scene.model.boxMax, isTilted ? NamedView::Iso : NamedView::Top,
                                     1.0F);
                    ViewSettings how;
                    how.isSmoothed = isSmoothed;
                    how.inPlane = {{kSide, kSide, green.data()}, 0.1F};
                    const Image image = scene.draw(how, kSide, kSide);
                    const auto at = [&](glm::vec3 mm) {
                        const glm::vec4 clip =
                            scene.camera.projection(1.0F) * scene.camera.view() * glm::vec4(mm, 1.0F);
                        return pixel(image, static_cast<std::uint32_t>((clip.x / clip.w + 1) / 2 * kSide),
                                     static_cast<std::uint32_t>((clip.y / clip.w + 1) / 2 * kSide));
                    };
                    const Rgb shown{0, 255, 0};
                    QVERIFY2(at({0, -0.5F, 0.1F}) == shown, describe(at({0, -0.5F, 0.1F})).c_str());
                    QVERIFY2(at({0.4F, 0, 0.8F}) == shown, describe(at({0.4F, 0, 0.8F})).c_str());
                    const Rgb above = at({-0.4F, 0, 0.6F});
                    QVERIFY2(above.g < 60 && above.r > 100, describe(above).c_str());
                }
            }
        }
    }

    /// Another picture in the plane needs no frame of the board once its depth is kept.
    void theDepthOfABoardIsKeptWithItsPicture() {
        Scene scene(everything());
        scene.camera.fit(scene.model.boxMin, scene.model.boxMax, NamedView::Iso, 4.0F / 3.0F);
        const std::vector<std::uint8_t> spots[] = {overlayOf(200, 150, 70), overlayOf(200, 150, 90)};
        OffscreenPresenter presenter(Gpu::get().device);
        const auto draw = [&](int spot, bool isKept) {
            ViewSettings how;
            how.cachesBoard = true;
            how.isBoardCached = isKept;
            if (spot >= 0) {
                how.inPlane = {{200, 150, spots[spot].data()}, scene.model.boxMax.z + 1.0F};
            }
            return *presenter.render(scene.scene, scene.camera, how, 200, 150);
        };
        const Image bare = draw(-1, false);
        const Image first = draw(0, true);
        QVERIFY(!presenter.stats().isOverlayAlone);  // there was no depth
        QVERIFY(differingPixels(bare, first) > 10);
        const Image second = draw(1, true);
        QVERIFY(presenter.stats().isOverlayAlone);
        QVERIFY(differingPixels(first, second) > 10);
        QCOMPARE(differingPixels(draw(0, true), first, 0), std::size_t{0});
        QCOMPARE(differingPixels(draw(-1, true), bare, 0), std::size_t{0});
        QVERIFY(presenter.stats().isOverlayAlone);
    }

    void translucentLayerIsBlendedOnceHoweverOftenItsShapesOverlap() {
        SyntheticBoard board;
        board.addLayer(0.0F, 0.035F, {1, 1, 1}, 0.5F);
        for (int i = 0; i < 5; ++i) {
            board.addDisc({-0.2F, 0}, 0.5F);
        }
        board.addTrack({0, 0}, {0.6F, 0}, 0.3F);
        board.addArea({{{-200, -200}, {200, -200}, {200, 200}, {-200, 200}}},
                      {{{0, 0}, {1, 0}, 0, 0, 0, 0, 0.0F, 0, 0.0F, 0}});
        Scene scene(board);
        scene.lookDown({-1, -1}, {1, 1});
        const Image image = scene.draw(flat(), 200, 200);
        const int half = toByte(0.5F);
        comparePixel(image, 60, 100, {half, half, half});   // discs only
        comparePixel(image, 100, 100, {half, half, half});  // all of them
        comparePixel(image, 160, 100, {half, half, half});  // the stroke only
    }

    void translucentLayersCoverWhatLiesBelowThem() {
        SyntheticBoard board;
        board.addLayer(1.0F, 1.1F, {0, 0, 1}, 0.5F);  // upper first: the order is by height, not by number
        board.addDisc({0, 0}, 0.5F);
        board.addLayer(0.0F, 0.1F, {1, 0, 0}, 0.5F);
        board.addDisc({0, 0}, 0.5F);
        Scene scene(board);
        scene.lookDown({-1, -1}, {1, 1});
        comparePixel(scene.draw(flat(), 200, 200), 100, 100, {toByte(0.25F), 0, toByte(0.5F)});
        scene.camera.fit(scene.model.boxMin, scene.model.boxMax, NamedView::Bottom, 1.0F);
        comparePixel(scene.draw(flat(), 200, 200), 100, 100, {toByte(0.5F), 0, toByte(0.25F)});
    }

    /// Stained glass lets its own hue through, a veil all hues alike; dimmed altogether, both are the background.
    void glossyFilmTintsWhatShowsThrough() {
        SyntheticBoard board;
        board.addLayer(0.0F, 0.1F, {1, 1, 1});
        board.addDisc({0, 0}, 0.5F);
        board.addLayer(0.1F, 0.12F, {0, 0.5F, 0}, 0.5F);
        board.addDisc({0, 0}, 0.5F);
        Scene scene(board);
        scene.lookDown({-1, -1}, {1, 1});
        ViewSettings how = flat();
        const Rgb veiled = pixel(scene.draw(how, 200, 200), 100, 100);
        std::vector<LayerStyle> styles = board.styles();
        styles[1].material = Material::Gloss;
        scene.scene.setStyles(styles);
        const Rgb tinted = pixel(scene.draw(how, 200, 200), 100, 100);
        QVERIFY(std::abs(veiled.r - toByte(0.5F)) <= 1);
        QVERIFY2(tinted.r < veiled.r - 60 && std::abs(tinted.g - veiled.g) <= 1, describe(tinted).c_str());
        how.background = {0.4F, 0.2F, 0.1F};
        how.dim = 1.0F;
        comparePixel(scene.draw(how, 200, 200), 100, 100, {102, 51, 26});
    }

    /// Seen straight from above, a face towards the lamp is brighter than one away from it; matt ones are alike. All
    /// back ends shine alike.
    void metalAndGlossMirrorTheLamp() {
        SyntheticBoard board;
        board.addLayer(0.0F, 0.1F, {0.2F, 0.15F, 0.1F});
        board.addTrack({-20, 0}, {20, 0}, 19.0F);
        Scene scene(board);
        scene.camera.fit(scene.model.boxMin, scene.model.boxMax, NamedView::Top, 1.0F);
        std::vector<LayerStyle> styles = board.styles();
        for (const Material material : {Material::Matt, Material::Metal, Material::Gloss}) {
            styles[0].material = material;
            scene.scene.setStyles(styles);
            ViewSettings how;
            how.backend = Backend::Pull;
            const Image pull = scene.draw(how, 200, 200);
            const int change = pixel(pull, 60, 80).r - pixel(pull, 140, 120).r;
            QVERIFY2(material == Material::Matt ? change == 0 : change > 5, qPrintable(QString::number(change)));
            for (const Backend other : {Backend::Mesh, Backend::Impostor, Backend::Raster}) {
                how.backend = other;
                QVERIFY(distance(pixel(scene.draw(how, 200, 200), 60, 80), pixel(pull, 60, 80)) <= 2);
            }
        }
    }

    /// The stencil tells 255 layers apart. The 256th has the number of the first again and must not be taken for it.
    void manyTranslucentLayersAreAllBlended() {
        SyntheticBoard board;
        constexpr int kLayers = 256;
        for (int i = 0; i < kLayers; ++i) {
            const bool isAtCentre = i == 0 || i == kLayers - 1;
            board.addLayer(static_cast<float>(i) * 0.01F, static_cast<float>(i) * 0.01F + 0.005F, {1, 1, 1}, 0.5F);
            board.addDisc({isAtCentre ? 0.0F : 0.7F, 0}, 0.2F);
        }
        Scene scene(board);
        scene.lookDown({-1, -1}, {1, 1});
        const int twice = toByte(0.75F);
        comparePixel(scene.draw(flat(), 32, 32), 16, 16, {twice, twice, twice}, 2);
    }

    void pictureDoesNotDependOnTheOrderInsideALayer() {
        const auto make = [](bool isReversed) {
            SyntheticBoard board;
            board.addLayer(0.0F, 0.3F, {1, 0.5F, 0.2F}, 0.5F);
            for (int i = 0; i < 40; ++i) {
                const auto at = static_cast<float>(isReversed ? 39 - i : i);
                board.addDisc({at * 0.05F - 1, std::sin(at)}, 0.4F);
            }
            return board;
        };
        Scene forward(make(false));
        Scene backward(make(true));
        for (Scene* scene : {&forward, &backward}) {
            scene->camera.fit(scene->model.boxMin, scene->model.boxMax, NamedView::Iso, 4.0F / 3.0F);
        }
        // Where walls meet at one depth either may show; everything else is the same.
        const std::size_t differing = differingPixels(forward.draw({}), backward.draw({}));
        QVERIFY2(differing <= 30, qPrintable(QString::number(differing)));
    }

    void laterLayersWinInOnePlane() {
        SyntheticBoard board;
        board.addLayer(0.0F, 0.035F, {1, 0, 0});
        board.addDisc({0, 0}, 0.9F);
        board.addLayer(0.0F, 0.035F, {0, 1, 0});
        board.addDisc({0, 0}, 0.6F);
        board.addLayer(0.0F, 0.035F, {0, 0, 1});
        board.addDisc({0, 0}, 0.3F);
        // Areas are drawn before lets: here only the tie-break makes them win.
        board.addArea({{{-100, -100}, {100, -100}, {100, 100}, {-100, 100}}},
                      {{{0, 0}, {1, 0}, 0, 0, 0, 0, 0.0F, 0, 0.0F, 0}});
        board.addLayer(0.0F, 0.035F, {1, 1, 0});
        board.addArea({{{-100, -100}, {100, -100}, {100, 100}, {-100, 100}}},
                      {{{0.45F, 0}, {1, 0}, 0, 0, 0, 0, 0.0F, 0, 0.0F, 0}});
        Scene scene(board);
        for (const NamedView view : {NamedView::Top, NamedView::Bottom}) {
            for (const bool isParallel : {false, true}) {
                scene.camera.setOrthographic(isParallel);
                scene.camera.fit(glm::vec3(-1, -1, 0), glm::vec3(1, 1, 0.035F), view, 1.0F);
                const Image image = scene.draw(flat(), 200, 200);
                comparePixel(image, 100, 100, {0, 0, 255});
                comparePixel(image, 100, 57, {0, 255, 0});
                comparePixel(image, 100, 28, {255, 0, 0});
                comparePixel(image, view == NamedView::Top ? 142 : 57, 100, {255, 255, 0});
            }
        }
    }

    void insideOfAHoleIsDark() {
        SyntheticBoard board;
        board.addLayer(1.0F, 1.035F, {1, 0, 0});
        board.addDisc({0, 0}, 0.8F);
        board.addLayer(0.0F, 1.035F, {0, 1, 0});
        board.addDisc({0, 0}, 0.4F, 0.3F);
        board.addDisc({0, 0}, 0.3F, 0.0F, shader::kLetBore);
        Scene scene(board);
        scene.lookDown({-1, -1}, {1, 1});
        const Image image = scene.draw(flat(), 200, 200);
        QVERIFY(pixel(image, 100, 100).g < 40);
        comparePixel(image, 100, 65, {0, 255, 0});  // the barrel
        comparePixel(image, 100, 40, {255, 0, 0});  // the pad around it
    }

    void highlightChangesItsElementOnly_data() {
        QTest::addColumn<int>("backend");
        QTest::newRow("pull") << int(Backend::Pull);
        QTest::newRow("mesh") << int(Backend::Mesh);
    }
    void highlightChangesItsElementOnly() {
        QFETCH(int, backend);
        SyntheticBoard board;
        board.addLayer(0.0F, 0.035F, {0.5F, 0.2F, 0.1F});
        board.addTrack({-0.9F, 0}, {0.9F, 0}, 0.2F);
        const std::uint32_t disc = board.addDisc({0, 0}, 0.4F);
        board.addTrack({-0.9F, 0.1F}, {0.9F, 0.1F}, 0.2F);
        Scene scene(board);
        scene.lookDown({-1, -1}, {1, 1});
        ViewSettings how = flat();
        how.backend = static_cast<Backend>(backend);
        const Image before = scene.draw(how, 200, 200);
        const model::ElementId highlighted[] = {model::ElementId{disc}, model::ElementId{1000000}};
        scene.scene.setStates(statesOf(highlighted));
        const Image after = scene.draw(how, 200, 200);
        for (std::uint32_t y = 0; y < 200; ++y) {
            for (std::uint32_t x = 0; x < 200; ++x) {
                const double fromCentre = std::hypot(x + 0.5 - 100.0, y + 0.5 - 100.0);
                if (fromCentre < 39.0) {
                    QVERIFY(pixel(after, x, y).r > pixel(before, x, y).r + 50);  // in front of its neighbours too
                } else if (fromCentre > 44.0) {                                  // behind its outline
                    QCOMPARE(pixel(after, x, y), pixel(before, x, y));
                }
            }
        }
        scene.scene.setStates({});
        QCOMPARE(differingPixels(before, scene.draw(how, 200, 200), 0), std::size_t{0});
    }

    void dimmingFadesTheOthersOnly() {
        SyntheticBoard board;
        board.addLayer(0.0F, 0.035F, {0.8F, 0.4F, 0.2F});
        const std::uint32_t left = board.addDisc({-0.5F, 0}, 0.3F);
        board.addDisc({0.5F, 0}, 0.3F);
        Scene scene(board);
        scene.lookDown({-1, -1}, {1, 1});
        ViewSettings how = flat();
        how.dim = kDimRest;
        const model::ElementId highlighted[] = {model::ElementId{left}};
        scene.scene.setStates(statesOf(highlighted));
        const Image image = scene.draw(how, 200, 200);
        QVERIFY(pixel(image, 50, 100).r > 204);
        QVERIFY(pixel(image, 150, 100).r < 120);
        QVERIFY(pixel(image, 150, 100).r > pixel(image, 150, 100).b);  // still its hue
    }

    /// From straight above in parallel projection impostors are flat rectangles, and shine no less.
    void flatImpostorsShineAlike() {
        SyntheticBoard board;
        board.addLayer(0.0F, 0.1F, {0.2F, 0.15F, 0.1F});
        board.addTrack({-20, 0}, {20, 0}, 19.0F);
        Scene scene(board);
        std::vector<LayerStyle> styles = board.styles();
        for (const NamedView view : {NamedView::Top, NamedView::Bottom}) {
            scene.camera.setOrthographic(true);
            scene.camera.fit(scene.model.boxMin, scene.model.boxMax, view, 1.0F);
            std::vector<Rgb> colours;
            for (const Material material : {Material::Matt, Material::Metal, Material::Gloss}) {
                styles[0].material = material;
                scene.scene.setStyles(styles);
                ViewSettings how;
                how.backend = Backend::Pull;
                colours.push_back(pixel(scene.draw(how, 200, 200), 100, 100));
                how.backend = Backend::Impostor;
                QVERIFY(distance(pixel(scene.draw(how, 200, 200), 100, 100), colours.back()) <= 1);
                QCOMPARE(Gpu::get().presenter.stats().backend, Backend::Impostor);
            }
            QVERIFY(colours[0] != colours[1] && colours[0] != colours[2]);
        }
    }

    /// In 3D what is dimmed is greyer, and its walls are told from its top.
    void dimmedSolidsKeepTheirDepth() {
        SyntheticBoard board;
        board.addLayer(0.0F, 1.0F, {0.8F, 0.3F, 0.2F});
        board.addArea({{{-800, -800}, {800, -800}, {800, 800}, {-800, 800}}},
                      {{{0, 0}, {1, 0}, 0, 0, 0, 0, 0.0F, 0, 0.0F, 0}});
        Scene scene(board);
        scene.camera.fit({-1, -1, 0}, {1, 1, 1}, NamedView::Iso, 1.0F);
        ViewSettings how;
        how.dim = kDimRest;
        const Image image = scene.draw(how, 200, 200);
        const Rgb top = pixel(image, 100, 80);
        const Rgb wall = pixel(image, 100, 150);
        QVERIFY2(top.r - top.b < 60 && top.r > top.b, describe(top).c_str());
        QVERIFY2(top.r - wall.r > 25, describe(wall).c_str());
    }

    void hiddenLayersAreNotDrawn() {
        SyntheticBoard board;
        board.addLayer(0.0F, 0.035F, {1, 0, 0});
        board.addDisc({0, 0}, 0.5F);
        board.addArea({{{-200, -200}, {200, -200}, {200, 200}, {-200, 200}}},
                      {{{0.7F, 0.7F}, {1, 0}, 0, 0, 0, 0, 0.0F, 0, 0.0F, 0}});
        Scene scene(board);
        scene.lookDown({-1, -1}, {1, 1});
        std::vector<LayerStyle> styles = board.styles();
        styles[0].isVisible = false;
        scene.scene.setStyles(styles);
        ViewSettings how = flat();
        how.isMono = true;
        for (const Backend backend : {Backend::Pull, Backend::Mesh}) {
            how.backend = backend;
            QCOMPARE(whitePixels(scene.draw(how, 200, 200)), std::size_t{0});
        }
    }

    /// Edge-on, so that the layers' heights can be read off the picture.
    void explosionMovesLayersApart() {
        SyntheticBoard board;
        board.addLayer(0.0F, 0.1F, {1, 0, 0});
        board.addTrack({-5, 0}, {5, 0}, 0.5F);
        board.addLayer(1.0F, 1.1F, {0, 1, 0});
        board.addTrack({-5, 0}, {5, 0}, 0.5F);
        Scene scene(board);
        scene.camera.setOrthographic(true);
        scene.camera.fit({-6, -6, -6}, {6, 6, 7}, NamedView::Iso, 1.0F);
        scene.camera.orbit(0.0F, std::asin(-scene.camera.direction().z));
        const auto gap = [&](float explode) {
            ViewSettings how = flat();
            how.explode = explode;
            const Image image = scene.draw(how, 300, 300);
            int red = -1;
            int green = -1;
            for (std::uint32_t y = 0; y < 300; ++y) {
                red = pixel(image, 150, y).r > 100 ? static_cast<int>(y) : red;
                green = pixel(image, 150, y).g > 100 ? static_cast<int>(y) : green;
            }
            return red >= 0 && green >= 0 ? red - green : -1000;
        };
        const float mmPerPixel = scene.camera.mmPerPixel(300.0F);
        QVERIFY(std::abs(static_cast<float>(gap(0.0F)) * mmPerPixel - 1.0F) < 2.0F * mmPerPixel);
        // The board is 11 mm long: at 1 the stack grows by half of that.
        QVERIFY(std::abs(static_cast<float>(gap(1.0F)) * mmPerPixel - 6.5F) < 2.0F * mmPerPixel);
    }

    /// Walls are culled by winding, which the mirror of an instance turns round: seen edge-on, those in front must hide
    /// what the block holds.
    void wallsInFrontAreTheOnesDrawn_data() {
        QTest::addColumn<bool>("isMirrored");
        QTest::newRow("as drawn") << false;
        QTest::newRow("mirrored") << true;
    }
    void wallsInFrontAreTheOnesDrawn() {
        QFETCH(bool, isMirrored);
        SyntheticBoard board;
        board.addLayer(0.0F, 2.0F, {1, 0, 0});
        board.addArea({{{-1000, -1000}, {1000, -1000}, {1000, 1000}, {-1000, 1000}}},
                      {{{0, 0}, {1, 0}, 0, 0, 0, isMirrored ? 1U : 0U, 0.0F, 0, 0.0F, 0}});
        board.addLayer(0.5F, 1.5F, {0, 1, 0});
        board.addDisc({0, 0}, 0.5F);
        Scene scene(board);
        for (const NamedView view : {NamedView::Top, NamedView::Iso}) {
            scene.camera.setOrthographic(true);
            scene.camera.fit({-1, -1, 0}, {1, 1, 2}, view, 1.0F);
            scene.camera.orbit(0.3F, std::asin(-scene.camera.direction().z));
            const Image image = scene.draw(flat(), 100, 100);
            QVERIFY(std::abs(scene.camera.direction().z) < 1e-5F);
            comparePixel(image, 50, 50, {255, 0, 0});
        }
    }

    void emptyBoardIsBackground() {
        SyntheticBoard board;
        board.addLayer(0.0F, 0.035F, {1, 0, 0});
        Scene scene(board);
        scene.lookDown({-1, -1}, {1, 1});
        for (const Backend backend : {Backend::Pull, Backend::Mesh}) {
            ViewSettings how;
            how.backend = backend;
            how.background = {1, 1, 1};
            QCOMPARE(whitePixels(scene.draw(how, 20, 20)), std::size_t{400});
        }
    }

    void impossibleSizesAreRefused() {
        Scene scene(randomTraces(1, 1));
        const std::uint32_t tooLarge = Gpu::get().device.caps().maxImageSize + 1;
        for (const auto& [width, height] : {std::pair{0U, 10U}, std::pair{10U, 0U}, std::pair{tooLarge, 10U}}) {
            const auto result = Gpu::get().presenter.render(scene.scene, scene.camera, {}, width, height);
            QVERIFY(!result);
            QCOMPARE(result.error().code, base::ErrorCode::BadUsage);
        }
    }

    void droppedScenesGiveTheirMemoryBack() {
        gpu::Device& device = Gpu::get().device;
        device.waitIdle();
        const std::uint64_t before = device.memoryReport().of(gpu::MemoryUse::Geometry);
        {
            Scene scene(randomTraces(5000, 3));
            scene.draw({}, 64, 64);
            QVERIFY(device.memoryReport().of(gpu::MemoryUse::Geometry) > before + 5000 * sizeof(shader::Let));
            QVERIFY(scene.scene.gpuBytes() > 5000 * sizeof(shader::Let));
        }
        device.waitIdle();
        QCOMPARE(device.memoryReport().of(gpu::MemoryUse::Geometry), before);
    }
};

GPU_TEST_MAIN(ViewTest)
#include "view_test.moc"
