#include "render/scene/layer_style.h"

#include <QtTest>
#include <algorithm>
#include <array>
#include <cmath>

#include "model/board/document_builder.h"
#include "render/scene/element_state.h"
#include "tests/colour_vision.h"

using model::Layer;
using model::LayerSide;
using model::LayerType;
using vision::Vision;

namespace {

Layer layer(LayerType type, LayerSide side, model::LayerContext context = model::LayerContext::Board) {
    Layer made;
    made.type = type;
    made.side = side;
    made.context = context;
    return made;
}

/// Of the two styles that are hardest to tell apart.
double leastDistance(const std::vector<render::LayerStyle>& styles, const Vision& sight) {
    double least = 1e9;
    for (std::size_t i = 0; i < styles.size(); ++i) {
        for (std::size_t j = i + 1; j < styles.size(); ++j) {
            least = std::min(least, vision::distance(styles[i].colour, styles[j].colour, sight));
        }
    }
    return least;
}

std::vector<Layer> boardWithSixLayers() {
    std::vector<Layer> layers{layer(LayerType::SilkScreen, LayerSide::Top), layer(LayerType::Signal, LayerSide::Top)};
    layers.insert(layers.end(), 4, layer(LayerType::Signal, LayerSide::Inner));
    layers.push_back(layer(LayerType::Signal, LayerSide::Bottom));
    layers.push_back(layer(LayerType::SilkScreen, LayerSide::Bottom));
    layers.push_back(layer(LayerType::Drill, LayerSide::Through));
    layers.push_back(layer(LayerType::Rout, LayerSide::Through));
    return layers;
}

std::vector<render::LayerStyle> stylesOf(const std::vector<Layer>& layers,
                                         render::Palette palette = render::Palette::Standard) {
    model::DocumentBuilder builder;
    for (const Layer& each : layers) {
        builder.addLayer(each);
    }
    return render::defaultStyles(*builder.finish(), render::Appearance::Flat, palette);
}

}  // namespace

class LayerStyleTest : public QObject {
    Q_OBJECT

private slots:
    /// In one channel at least, as pictures are compared.
    void highlightsAreFarFromEveryLayer() {
        constexpr double kLevels = 70.0;
        model::DocumentBuilder builder;
        for (int type = 0; type <= static_cast<int>(LayerType::Other); ++type) {
            for (const LayerSide side : {LayerSide::Top, LayerSide::Inner, LayerSide::Bottom}) {
                builder.addLayer(layer(static_cast<LayerType>(type), side));
            }
        }
        for (int inner = 0; inner < 38; ++inner) {
            builder.addLayer(layer(LayerType::Signal, LayerSide::Inner));
        }
        const auto board = builder.finish();
        for (const auto palette : {render::Palette::Standard, render::Palette::ColourBlindSafe}) {
            for (const auto appearance : {render::Appearance::Flat, render::Appearance::Solid}) {
                for (const render::LayerStyle& style : render::defaultStyles(*board, appearance, palette)) {
                    for (const glm::vec3& highlight : render::kHighlightColours) {
                        const glm::vec3 apart = glm::abs(style.colour - highlight) * 255.0F;
                        QVERIFY(std::max({apart.r, apart.g, apart.b}) > kLevels);
                    }
                }
            }
        }
    }

    void innerLayersDifferFromEachOtherAndFromTheOuterOnes() {
        const auto styles =
            stylesOf({layer(LayerType::Signal, LayerSide::Top), layer(LayerType::Signal, LayerSide::Inner),
                      layer(LayerType::PowerGround, LayerSide::Inner), layer(LayerType::Signal, LayerSide::Bottom)});
        for (std::size_t i = 0; i < styles.size(); ++i) {
            for (std::size_t j = i + 1; j < styles.size(); ++j) {
                QVERIFY(glm::distance(styles[i].colour, styles[j].colour) > 0.2F);
            }
        }
    }

    void fortyCopperLayersAreToldApart() {
        std::vector<Layer> layers(40, layer(LayerType::Signal, LayerSide::Inner));
        layers.front().side = LayerSide::Top;
        layers.back().side = LayerSide::Bottom;
        const double standard = leastDistance(stylesOf(layers), vision::kVisions[0]);
        QVERIFY2(standard > 15.0, qPrintable(QString::number(standard)));
        const double safe = leastDistance(stylesOf(layers, render::Palette::ColourBlindSafe), vision::kVisions[0]);
        QVERIFY2(safe > 20.0, qPrintable(QString::number(safe)));
    }

    void safeLayersAreToldApartWithAnyVision() {
        constexpr double kLeast = 20.0;
        const auto safe = stylesOf(boardWithSixLayers(), render::Palette::ColourBlindSafe);
        QCOMPARE(safe.size(), std::size_t{10});
        for (const Vision& sight : vision::kCommonVisions) {
            const double least = leastDistance(safe, sight);
            QVERIFY2(least > kLeast, qPrintable(QString("%1: %2").arg(sight.name).arg(least)));
        }
        const auto standard = stylesOf(boardWithSixLayers());
        QVERIFY(leastDistance(standard, vision::kVisions[2]) < kLeast);  // why there is another palette
    }

    void safeCopperStandsOutFromLacquerAndLaminate() {
        model::DocumentBuilder builder;
        Layer mask = layer(LayerType::SolderMask, LayerSide::Top);
        mask.isSynthetic = true;
        builder.addLayer(mask);
        builder.addLayer(layer(LayerType::Signal, LayerSide::Top));
        builder.addLayer(layer(LayerType::Body, LayerSide::Through));
        builder.addLayer(layer(LayerType::Signal, LayerSide::Bottom));
        const auto styles =
            render::defaultStyles(*builder.finish(), render::Appearance::Solid, render::Palette::ColourBlindSafe);
        for (const Vision& sight : vision::kCommonVisions) {
            QVERIFY(leastDistance(styles, sight) > 15.0);
        }
    }

    void theInnermostPrintOfEachSideIsShown() {
        const auto styles =
            stylesOf({layer(LayerType::SilkScreen, LayerSide::Top), layer(LayerType::SilkScreen, LayerSide::Top),
                      layer(LayerType::Signal, LayerSide::Top), layer(LayerType::SilkScreen, LayerSide::Bottom),
                      layer(LayerType::SilkScreen, LayerSide::Bottom)});
        QVERIFY(!styles[0].isVisible && styles[1].isVisible);
        QVERIFY(styles[3].isVisible && !styles[4].isVisible);
    }

    void drawingCalledSilkscreenIsNoPrint() {
        Layer overlay = layer(LayerType::SilkScreen, LayerSide::Top);
        overlay.name = "DXF_OVERLAY";
        const auto styles = stylesOf({layer(LayerType::SilkScreen, LayerSide::Top), overlay,
                                      layer(LayerType::Signal, LayerSide::Top), layer(LayerType::Document, {})});
        QVERIFY(styles[0].isVisible && !styles[1].isVisible);
        QVERIFY(styles[1].colour == styles[3].colour);
    }

    void lacquerIsShownOnASolidBoardOnly() {
        model::DocumentBuilder builder;
        Layer mask = layer(LayerType::SolderMask, LayerSide::Top);
        builder.addLayer(mask);
        mask.isSynthetic = true;
        builder.addLayer(mask);
        const auto document = builder.finish();
        const auto solid = render::defaultStyles(*document, render::Appearance::Solid);
        QVERIFY(!solid[0].isVisible && solid[1].isVisible && solid[1].opacity < 1.0F);
        const auto flat = render::defaultStyles(*document, render::Appearance::Flat);
        QVERIFY(!flat[0].isVisible && !flat[1].isVisible);
    }

    /// Each mask, print and finish is another colour, and none is near that of a highlighted net.
    void boardColoursDifferAndLeaveHighlightsAlone() {
        model::DocumentBuilder builder;
        Layer mask = layer(LayerType::SolderMask, LayerSide::Top);
        mask.isSynthetic = true;
        builder.addLayer(mask);
        builder.addLayer(layer(LayerType::SilkScreen, LayerSide::Top));
        builder.addLayer(layer(LayerType::Signal, LayerSide::Top));
        const auto board = builder.finish();
        std::vector<render::LayerStyle> masks;
        std::vector<render::LayerStyle> metals;
        for (std::size_t i = 0; i < model::boardColourNames().size(); ++i) {
            const auto colour = static_cast<model::BoardColour>(i);
            const auto finish = static_cast<model::SurfaceFinish>(i % 3);
            const auto styles = render::defaultStyles(*board, render::Appearance::Solid, render::Palette::Standard,
                                                      {colour, colour, finish});
            masks.push_back(styles[0]);
            metals.push_back(styles[2]);
            QVERIFY(styles[0].material == render::Material::Gloss && styles[0].opacity < 1.0F);
            QVERIFY(styles[2].material == render::Material::Metal);
            for (const render::LayerStyle& style : styles) {
                const glm::vec3 apart = glm::abs(style.colour - render::kHighlightColours[0]) * 255.0F;
                QVERIFY(std::max({apart.r, apart.g, apart.b}) > 60.0F);
            }
        }
        metals.resize(3);
        QVERIFY(leastDistance(masks, vision::kVisions[0]) > 20.0);
        QVERIFY(leastDistance(metals, vision::kVisions[0]) > 10.0);
    }

    void bothSidesOfABoardArePrintedAndFinishedAlike() {
        model::DocumentBuilder builder;
        for (const LayerType type : {LayerType::SilkScreen, LayerType::Signal}) {
            builder.addLayer(layer(type, LayerSide::Top));
            builder.addLayer(layer(type, LayerSide::Bottom));
        }
        const auto styles = render::defaultStyles(*builder.finish());
        QVERIFY(styles[0].colour == styles[1].colour);
        QVERIFY(styles[2].colour == styles[3].colour);
    }

    void bodiesOfComponentsStartHidden() {
        const Layer bodies = layer(LayerType::ComponentBody, LayerSide::Top);
        QVERIFY(!stylesOf({bodies})[0].isVisible);
    }

    void rowsOutsideOfTheBoardStartHidden() {
        const auto styles = stylesOf({layer(LayerType::SilkScreen, LayerSide::Top, model::LayerContext::Misc)});
        QVERIFY(!styles[0].isVisible);
    }

    void dielectricsStandInForAMissingBody() {
        const Layer dielectric = layer(LayerType::Dielectric, LayerSide::Inner);
        QVERIFY(stylesOf({dielectric})[0].isVisible);
        QVERIFY(!stylesOf({dielectric, layer(LayerType::Body, LayerSide::Through)})[0].isVisible);
    }
};

QTEST_APPLESS_MAIN(LayerStyleTest)
#include "layer_style_test.moc"
