#include "render/scene/layer_style.h"

#include <QtTest>
#include <algorithm>
#include <array>
#include <cmath>

#include "model/board/document_builder.h"
#include "render/scene/element_state.h"

using model::Layer;
using model::LayerSide;
using model::LayerType;

namespace {

Layer layer(LayerType type, LayerSide side, model::LayerContext context = model::LayerContext::Board) {
    Layer made;
    made.type = type;
    made.side = side;
    made.context = context;
    return made;
}

/// What a colour is with missing cones: Machado, Oliveira and Fernandes 2009, severity 1, on linear sRGB. Rows are r, g
/// and b.
struct Vision {
    const char* name;
    std::array<glm::dvec3, 3> rows;
};
constexpr Vision kVisions[] = {
    {"normal", {{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}}},
    {"protanopia",
     {{{0.152286, 1.052583, -0.204868}, {0.114503, 0.786281, 0.099216}, {-0.003882, -0.048116, 1.051998}}}},
    {"deuteranopia",
     {{{0.367322, 0.860646, -0.227968}, {0.280085, 0.672501, 0.047413}, {-0.011820, 0.042940, 0.968881}}}}};

double linear(double part) {
    return part <= 0.04045 ? part / 12.92 : std::pow((part + 0.055) / 1.055, 2.4);
}

/// CIE L*a*b* with the white of sRGB: distances of 2 to 3 are just seen side by side.
glm::dvec3 labOf(const glm::vec3& colour, const Vision& vision) {
    const glm::dvec3 rgb(linear(colour.r), linear(colour.g), linear(colour.b));
    glm::dvec3 seen;
    for (int row = 0; row < 3; ++row) {
        seen[row] = std::clamp(glm::dot(vision.rows[static_cast<std::size_t>(row)], rgb), 0.0, 1.0);
    }
    const auto f = [](double t) { return t > 0.008856 ? std::cbrt(t) : 7.787 * t + 16.0 / 116.0; };
    const double x = f(glm::dot(glm::dvec3(0.4124, 0.3576, 0.1805), seen) / 0.95047);
    const double y = f(glm::dot(glm::dvec3(0.2126, 0.7152, 0.0722), seen));
    const double z = f(glm::dot(glm::dvec3(0.0193, 0.1192, 0.9505), seen) / 1.08883);
    return {116.0 * y - 16.0, 500.0 * (x - y), 200.0 * (y - z)};
}

/// Of the two styles that are hardest to tell apart.
double leastDistance(const std::vector<render::LayerStyle>& styles, const Vision& vision) {
    double least = 1e9;
    for (std::size_t i = 0; i < styles.size(); ++i) {
        for (std::size_t j = i + 1; j < styles.size(); ++j) {
            least = std::min(least, glm::distance(labOf(styles[i].colour, vision), labOf(styles[j].colour, vision)));
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
        const double standard = leastDistance(stylesOf(layers), kVisions[0]);
        QVERIFY2(standard > 15.0, qPrintable(QString::number(standard)));
        const double safe = leastDistance(stylesOf(layers, render::Palette::ColourBlindSafe), kVisions[0]);
        QVERIFY2(safe > 20.0, qPrintable(QString::number(safe)));
    }

    void safeLayersAreToldApartWithAnyVision() {
        constexpr double kLeast = 20.0;
        const auto safe = stylesOf(boardWithSixLayers(), render::Palette::ColourBlindSafe);
        QCOMPARE(safe.size(), std::size_t{10});
        for (const Vision& vision : kVisions) {
            const double least = leastDistance(safe, vision);
            QVERIFY2(least > kLeast, qPrintable(QString("%1: %2").arg(vision.name).arg(least)));
        }
        const auto standard = stylesOf(boardWithSixLayers());
        QVERIFY(leastDistance(standard, kVisions[2]) < kLeast);  // why there is another palette
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
        for (const Vision& vision : kVisions) {
            QVERIFY(leastDistance(styles, vision) > 15.0);
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
        QVERIFY(leastDistance(masks, kVisions[0]) > 20.0);
        QVERIFY(leastDistance(metals, kVisions[0]) > 10.0);
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
