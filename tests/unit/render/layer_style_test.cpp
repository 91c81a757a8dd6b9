#include "render/layer_style.h"

#include <QtTest>

#include "model/document_builder.h"

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

std::vector<render::LayerStyle> stylesOf(const std::vector<Layer>& layers) {
    model::DocumentBuilder builder;
    for (const Layer& each : layers) {
        builder.addLayer(each);
    }
    return render::defaultStyles(*builder.finish(), render::Look::Flat);
}

}  // namespace

class LayerStyleTest : public QObject {
    Q_OBJECT

private slots:
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

    void theInnermostPrintOfEachSideIsShown() {
        const auto styles =
            stylesOf({layer(LayerType::SilkScreen, LayerSide::Top), layer(LayerType::SilkScreen, LayerSide::Top),
                      layer(LayerType::Signal, LayerSide::Top), layer(LayerType::SilkScreen, LayerSide::Bottom),
                      layer(LayerType::SilkScreen, LayerSide::Bottom)});
        QVERIFY(!styles[0].isVisible && styles[1].isVisible);
        QVERIFY(styles[3].isVisible && !styles[4].isVisible);
    }

    void lacquerIsShownOnASolidBoardOnly() {
        model::DocumentBuilder builder;
        Layer mask = layer(LayerType::SolderMask, LayerSide::Top);
        builder.addLayer(mask);
        mask.isSynthetic = true;
        builder.addLayer(mask);
        const auto document = builder.finish();
        const auto solid = render::defaultStyles(*document, render::Look::Solid);
        QVERIFY(!solid[0].isVisible && solid[1].isVisible && solid[1].opacity < 1.0F);
        const auto flat = render::defaultStyles(*document, render::Look::Flat);
        QVERIFY(!flat[0].isVisible && !flat[1].isVisible);
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
