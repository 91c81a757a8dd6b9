#include "ui/views/layer_styles.h"

#include <QtTest>

#include "model/board/board_colours.h"
#include "model/board/document_builder.h"

using ui::LayerAppearance;

namespace {

/// Copper, and the film of solder mask on it.
std::shared_ptr<const model::Document> maskedCopper() {
    using namespace model;
    DocumentBuilder builder;
    Layer film;
    film.name = "mask";
    film.type = LayerType::SolderMask;
    film.side = LayerSide::Top;
    film.isSynthetic = true;
    builder.beginLayer(builder.addLayer(film));
    Layer copper;
    copper.name = "top";
    copper.type = LayerType::Signal;
    copper.side = LayerSide::Top;
    builder.beginLayer(builder.addLayer(copper));
    return builder.finish();
}

}  // namespace

class LayerStylesTest : public QObject {
    Q_OBJECT

private slots:
    void whatVeilsAllElseIsDrawnInTwoDimensionsWhereItIsAlone() {
        const auto board = maskedCopper();
        std::vector<LayerAppearance> looks = ui::defaultAppearances(*board, render::Palette::Standard);
        QVERIFY(looks[0].isVisible && looks[1].isVisible);
        QVERIFY(!ui::flatStyles(*board, looks)[0].isVisible && ui::flatStyles(*board, looks)[1].isVisible);
        looks[1].isVisible = false;
        QVERIFY(ui::flatStyles(*board, looks)[0].isVisible && !ui::flatStyles(*board, looks)[1].isVisible);
        looks[0].isVisible = false;
        QVERIFY(!ui::flatStyles(*board, looks)[0].isVisible);
    }

    void itHasTheColourItHasOnTheBoard() {
        const auto board = maskedCopper();
        model::BoardColourChoice chosen;
        for (const model::BoardColour colour : {model::BoardColour::Blue, model::BoardColour::Red}) {
            chosen.solderMask = colour;
            const std::vector<LayerAppearance> looks =
                ui::defaultAppearances(*board, render::Palette::Standard, chosen);
            const render::LayerStyle drawn = ui::toStyles(looks)[0];
            const render::LayerStyle solid = ui::solidStyles(*board, looks, render::Palette::Standard, chosen)[0];
            QVERIFY(glm::length(drawn.colour - solid.colour) < 0.01F);
            QVERIFY(colour == model::BoardColour::Red ? drawn.colour.r > drawn.colour.b
                                                      : drawn.colour.b > drawn.colour.r);
        }
    }
};

QTEST_APPLESS_MAIN(LayerStylesTest)
#include "layer_styles_test.moc"
