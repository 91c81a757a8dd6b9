#include <QtTest>
#include <random>

#include "tests/gpu/gpu_fixture.h"

using namespace render;
using namespace render::test;

namespace {

constexpr std::uint32_t kSize = 200;
constexpr Rgb kBlack{0, 0, 0};

ViewSettings flat(Backend backend) {
    ViewSettings settings;
    settings.is2d = true;
    settings.background = glm::vec3(0.0F);
    settings.backend = backend;
    return settings;
}

/// Two discs side by side, a square area under either of them, and a second layer below that is seen between them.
SyntheticBoard discsAndSquares() {
    const std::vector<std::vector<base::Point>> square{{{-300, -300}, {300, -300}, {300, 300}, {-300, 300}}};
    SyntheticBoard board;
    board.addLayer(0.0F, 0.035F, {0.2F, 0.2F, 0.8F});
    for (const float x : {-0.5F, 0.5F}) {
        board.addArea(square, {{{x, -0.5F}, {1.0F, 0.0F}, 0, 0, 0, 0, 0.0F, 0, 0.0F, 0}});
    }
    board.addLayer(0.1F, 0.135F, {0.8F, 0.4F, 0.2F});
    board.addDisc({-0.5F, 0.5F}, 0.3F);
    board.addDisc({0.5F, 0.5F}, 0.3F);
    return board;
}
constexpr std::array<std::pair<std::uint32_t, std::uint32_t>, 4> kMiddles{
    {{50, 150}, {150, 150}, {50, 50}, {150, 50}}};  ///< of the elements in the picture, by number

std::array<Rgb, 4> middlesOf(const Image& image) {
    std::array<Rgb, 4> colours;
    for (std::size_t i = 0; i < colours.size(); ++i) {
        colours[i] = pixel(image, kMiddles[i].first, kMiddles[i].second);
    }
    return colours;
}

/// Pixels that are not of the background.
std::size_t drawnPixels(const Image& image) {
    std::size_t count = 0;
    for (std::size_t i = 0; i < image.rgba.size(); i += 4) {
        count += image.rgba[i] + image.rgba[i + 1] + image.rgba[i + 2] > 30 ? 1 : 0;
    }
    return count;
}

}  // namespace

/// What BoardScene::setStates promises, with every back end.
class ElementStateTest : public QObject {
    Q_OBJECT

    static void forAllBackends() {
        QTest::addColumn<int>("backend");
        for (const Backend backend : {Backend::Pull, Backend::Mesh, Backend::Impostor, Backend::Raster}) {
            QTest::newRow(nameOf(backend)) << static_cast<int>(backend);
        }
    }

private slots:
    void elementsAreHiddenOneByOne_data() { forAllBackends(); }
    void elementsAreHiddenOneByOne() {
        QFETCH(int, backend);
        Scene scene(discsAndSquares());
        scene.lookDown({-1, -1}, {1, 1});
        const ViewSettings how = flat(static_cast<Backend>(backend));
        const std::array<Rgb, 4> all = middlesOf(scene.draw(how, kSize, kSize));
        QCOMPARE(Gpu::get().presenter.stats().backend, how.backend);
        for (std::uint32_t hidden = 0; hidden < 16; ++hidden) {
            std::vector<ElementState> states(4);
            for (std::uint32_t i = 0; i < 4; ++i) {
                states[i] = (hidden >> i & 1U) != 0 ? kHidden : kPlain;
            }
            scene.scene.setStates(states);
            const std::array<Rgb, 4> some = middlesOf(scene.draw(how, kSize, kSize));
            for (std::uint32_t i = 0; i < 4; ++i) {
                QCOMPARE(some[i], states[i] == kHidden ? kBlack : all[i]);
            }
        }
    }

    void coloursComeFromThePaletteAndAreNotDimmed_data() { forAllBackends(); }
    void coloursComeFromThePaletteAndAreNotDimmed() {
        QFETCH(int, backend);
        Scene scene(discsAndSquares());
        scene.lookDown({-1, -1}, {1, 1});
        ViewSettings how = flat(static_cast<Backend>(backend));
        how.dim = 1.0F;
        const glm::vec3 palette[] = {{1.0F, 0.0F, 1.0F}, {0.0F, 0.6F, 0.0F}};
        scene.scene.setPalette(palette);
        const ElementState states[] = {inColour(0), kPlain, inColour(1),
                                       static_cast<ElementState>(inColour(1) | kHighlighted)};
        scene.scene.setStates(states);
        const std::array<Rgb, 4> colours = middlesOf(scene.draw(how, kSize, kSize));
        QVERIFY(distance(colours[0], {255, 0, 255}) <= 1);
        QCOMPARE(colours[1], kBlack);
        QVERIFY(distance(colours[2], {0, 153, 0}) <= 1);
        QVERIFY2(distance(colours[3], {0, 255, 0}) <= 1, describe(colours[3]).c_str());  // the same hue, brighter
    }

    void dimmingIsAsStrongAsAsked() {
        Scene scene(discsAndSquares());
        scene.lookDown({-1, -1}, {1, 1});
        ViewSettings how = flat(Backend::Auto);
        int last = 256;
        for (const float dim : {0.0F, 0.3F, 0.6F, 0.9F, 1.0F}) {
            how.dim = dim;
            const int red = middlesOf(scene.draw(how, kSize, kSize))[2].r;
            QVERIFY(red < last);
            last = red;
        }
        QCOMPARE(last, 0);
    }

    /// Words hold four elements: each change must reach its own and no other, whatever was sent before.
    void onlyWhatChangesChanges() {
        Scene scene(randomTraces(300, 7));
        scene.camera.fit(scene.model.boxMin, scene.model.boxMax, NamedView::Top, 1.0F);
        const ViewSettings how = flat(Backend::Pull);
        std::vector<ElementState> states(300);
        std::mt19937 random(5);
        for (int round = 0; round < 12; ++round) {
            for (int change = 0; change < 3; ++change) {
                states[random() % states.size()] ^= kHighlighted;
            }
            scene.scene.setStates(states);
            const Image step = scene.draw(how, kSize, kSize);
            scene.scene.setStates({});
            scene.scene.setStates(states);
            QCOMPARE(differingPixels(step, scene.draw(how, kSize, kSize), 0), std::size_t{0});
        }
    }

    void outlinesHaveNothingInThem() {
        Scene scene(discsAndSquares());
        scene.lookDown({-1, -1}, {1, 1});
        ViewSettings how = flat(Backend::Pull);
        const Image filled = scene.draw(how, kSize, kSize);
        how.isOutlined = true;
        const Image outlines = scene.draw(how, kSize, kSize);
        QCOMPARE(Gpu::get().presenter.stats().backend, Backend::Impostor);
        for (const auto& [x, y] : kMiddles) {
            QCOMPARE(pixel(outlines, x, y), kBlack);
        }
        // Two circles and two squares, 30 pixels from middle to side.
        const double length = 2 * (2 * 3.14159 * 30) + 2 * 240;
        const auto drawn = static_cast<double>(drawnPixels(outlines));
        QVERIFY2(drawn > length && drawn < 2.6 * length, qPrintable(QString::number(drawn / length)));
        for (std::uint32_t y = 2; y + 2 < kSize; ++y) {
            for (std::uint32_t x = 2; x + 2 < kSize; ++x) {
                if (pixel(outlines, x, y) == kBlack) {
                    continue;
                }
                bool isNearFilled = false;
                for (std::uint32_t i = 0; i < 9; ++i) {
                    isNearFilled |= pixel(filled, x + i % 3 - 1, y + i / 3 - 1) != kBlack;
                }
                QVERIFY(isNearFilled);
            }
        }
    }

    /// Seen from below and mirrored too, and of every kind of element; lines do not get thicker nearer by.
    void outlinesKeepTheirWidthAtAnyZoom() {
        Scene scene(everything());
        ViewSettings how = flat(Backend::Auto);
        how.isOutlined = true;
        for (const NamedView view : {NamedView::Top, NamedView::Bottom}) {
            scene.camera.fit(scene.model.boxMin, scene.model.boxMax, view, 1.0F);
            scene.camera.setOrthographic(true);
            const auto whole = static_cast<double>(drawnPixels(scene.draw(how, 400, 400)));
            const auto twice = static_cast<double>(drawnPixels(scene.draw(how, 800, 800)));
            QVERIFY2(twice > 1.5 * whole && twice < 2.4 * whole, qPrintable(QString::number(twice / whole)));
        }
    }

    void tiltedViewsHaveNoOutlines() {
        Scene scene(discsAndSquares());
        scene.camera.fit(scene.model.boxMin, scene.model.boxMax, NamedView::Iso, 1.0F);
        ViewSettings how;
        const Image solid = scene.draw(how, kSize, kSize);
        how.isOutlined = true;
        QCOMPARE(differingPixels(solid, scene.draw(how, kSize, kSize), 0), std::size_t{0});
    }
};

GPU_TEST_MAIN(ElementStateTest)
#include "element_state_test.moc"
