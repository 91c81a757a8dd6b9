#include "render/tiles/tile_painter.h"

#include <QTest>
#include <random>

using namespace render;

namespace {

constexpr glm::vec3 kGround(0.0F);
constexpr std::size_t kLayers = 5;

/// Covered at random, whole runs of pixels among it.
std::vector<std::unique_ptr<MaskTile>> randomMasks() {
    std::mt19937 random(7);
    std::vector<std::unique_ptr<MaskTile>> masks;
    for (std::size_t layer = 0; layer < kLayers; ++layer) {
        auto mask = std::make_unique<MaskTile>();
        for (std::size_t i = 0; i < mask->size(); i += 16) {
            const auto run = static_cast<std::uint8_t>(random() % 3 == 0 ? 0x0fU : random() & random());
            for (std::size_t j = i; j < i + 16; ++j) {
                (*mask)[j] = random() % 9 == 0 ? static_cast<std::uint8_t>(random()) : run;
            }
        }
        masks.push_back(std::move(mask));
    }
    return masks;
}

std::vector<Paint> paints() {
    std::vector<Paint> all;
    for (std::uint32_t layer = 0; layer < kLayers; ++layer) {
        const float part = static_cast<float>(layer + 1) / kLayers;
        const bool isTranslucent = layer % 2 == 1;
        all.push_back({layer, false, {part, 1.0F - part, 0.3F}, glm::vec3(isTranslucent ? 0.5F : 0.0F)});
        all.push_back({layer, true, {0.1F, part, part}, glm::vec3(0.0F)});
    }
    return all;
}

/// One sample after the other, all paints from the back.
std::uint32_t pixelAt(std::size_t at, const std::vector<Paint>& all, const SampleColours& colours,
                      const std::vector<std::unique_ptr<MaskTile>>& masks) {
    std::uint32_t samples = 0;
    for (std::uint32_t sample = 0; sample < 4; ++sample) {
        std::uint8_t colour = SampleColours::kBackground;
        for (std::size_t i = 0; i < all.size(); ++i) {
            const std::uint32_t bits = (*masks[all[i].layer])[at];
            const bool isSolid = (bits >> sample & 1U) != 0;
            const bool isBore = (bits >> (4 + sample) & 1U) != 0;
            if (all[i].isBore ? isBore : isSolid && (all[i].isOpaque() || !isBore)) {
                colour = colours.after()[i][colour];
            }
        }
        samples |= std::uint32_t{colour} << 8U * sample;
    }
    return colours.pixel(samples);
}

/// In one go.
void paintTile(std::span<const Paint> all, const SampleColours& colours,
               std::span<const std::unique_ptr<MaskTile>> masks, const PixelTile* over, const TilePart& part,
               PixelTile& picture) {
    auto samples = std::make_unique<PixelTile>();
    paintSamples(all, colours, masks, part, *samples);
    paintPixels(colours, *samples, over, part, picture);
}

}  // namespace

class TilePainterTest : public QObject {
    Q_OBJECT

private slots:
    void paintsWhatPaintingFromTheBackGives() {
        const std::vector<std::unique_ptr<MaskTile>> masks = randomMasks();
        const std::vector<Paint> all = paints();
        const std::optional<SampleColours> colours = SampleColours::make(kGround, all, {});
        QVERIFY(colours.has_value());
        auto picture = std::make_unique<PixelTile>();
        paintTile(all, *colours, masks, nullptr, {}, *picture);
        for (std::size_t i = 0; i < picture->size(); ++i) {
            QCOMPARE((*picture)[i], pixelAt(i, all, *colours, masks));
        }
    }

    void whatStandsOutLiesOverAll() {
        const std::vector<std::unique_ptr<MaskTile>> masks = randomMasks();
        const std::vector<Paint> all = paints();
        const std::vector<glm::vec3> over{{1.0F, 0.0F, 0.0F}};
        const std::optional<SampleColours> colours = SampleColours::make(kGround, all, over);
        QVERIFY(colours.has_value());
        auto mask = std::make_unique<MaskTile>();
        (*mask)[0] = 0x0f;
        auto samples = std::make_unique<PixelTile>();
        stamp(*mask, false, 1, *samples);
        auto picture = std::make_unique<PixelTile>();
        paintTile(all, *colours, masks, samples.get(), {}, *picture);
        QCOMPARE((*picture)[0], 0xffff0000U);
        QCOMPARE((*picture)[1], pixelAt(1, all, *colours, masks));
    }

    /// Other colours for the same stack need no new samples.
    void samplesServeOtherColours() {
        const std::vector<std::unique_ptr<MaskTile>> masks = randomMasks();
        const std::vector<Paint> all = paints();
        std::vector<Paint> dimmed = all;
        for (Paint& paint : dimmed) {
            paint.light *= 0.4F;
        }
        const std::optional<SampleColours> colours = SampleColours::make(kGround, all, {});
        const std::optional<SampleColours> dim = SampleColours::make(kGround, dimmed, {});
        QVERIFY(colours->after() == dim->after());
        auto samples = std::make_unique<PixelTile>();
        auto picture = std::make_unique<PixelTile>();
        paintSamples(all, *colours, masks, {}, *samples);
        paintPixels(*dim, *samples, nullptr, {}, *picture);
        for (std::size_t i = 0; i < picture->size(); ++i) {
            QCOMPARE((*picture)[i], pixelAt(i, dimmed, *dim, masks));
        }
    }

    /// What was painted with something over it, and then with something else, is as if painted with that at once.
    void isRepaintedWhereWhatStandsOutChanges() {
        const std::vector<std::unique_ptr<MaskTile>> masks = randomMasks();
        const std::vector<Paint> all = paints();
        const std::vector<glm::vec3> over{{1.0F, 0.0F, 0.0F}, {0.0F, 1.0F, 0.0F}};
        const std::optional<SampleColours> colours = SampleColours::make(kGround, all, over);
        auto samples = std::make_unique<PixelTile>();
        paintSamples(all, *colours, masks, {}, *samples);
        std::vector<std::unique_ptr<PixelTile>> overs(3);  // the last has nothing
        for (std::size_t i = 0; i < 2; ++i) {
            overs[i] = std::make_unique<PixelTile>();
            stamp(*masks[i], false, static_cast<std::uint8_t>(i + 1), *overs[i]);
        }
        auto repainted = std::make_unique<PixelTile>();
        auto anew = std::make_unique<PixelTile>();
        paintPixels(*colours, *samples, nullptr, {}, *repainted);
        const PixelTile* before = nullptr;
        for (const std::unique_ptr<PixelTile>& now : overs) {
            repaintPixels(*colours, *samples, before, now.get(), {}, *repainted);
            paintPixels(*colours, *samples, now.get(), {}, *anew);
            QVERIFY(*repainted == *anew);
            before = now.get();
        }
    }

    void onlyTheWantedPartIsPainted() {
        const std::vector<std::unique_ptr<MaskTile>> masks(kLayers);
        const std::vector<Paint> all = paints();
        const std::optional<SampleColours> colours = SampleColours::make({0.0F, 0.0F, 1.0F}, all, {});
        auto picture = std::make_unique<PixelTile>();
        paintTile(all, *colours, masks, nullptr, {{16, 8}, {32, 9}}, *picture);
        QCOMPARE((*picture)[8 * kTilePixels + 16], 0xff0000ffU);
        QCOMPARE((*picture)[8 * kTilePixels + 32], 0U);
        QCOMPARE((*picture)[9 * kTilePixels + 16], 0U);
    }
};

QTEST_GUILESS_MAIN(TilePainterTest)
#include "tile_painter_test.moc"
