// On which layers the shadows of bodies fall.
#include "render/culling/shadowed_layers.h"

#include <QtTest>

using namespace render;

class ShadowedLayersTest : public QObject {
    Q_OBJECT

    enum Row : std::uint32_t { BodiesTop, Print, Top, Prepreg, Inner, Core, Bottom, Drill, BodiesBottom, kRows };

    static SceneLayers board() {
        SceneLayers scene;
        scene.layers = {{1.6F, 4.0F, true, false, shader::kLayerGrowsUp, {}},
                        {1.6F, 1.62F, true, false, 0U, {}},
                        {1.565F, 1.6F, true, true, 0U, {}},
                        {0.9F, 1.565F, true, false, 0U, {}},
                        {0.865F, 0.9F, true, true, 0U, {}},
                        {0.035F, 0.865F, true, false, 0U, {}},
                        {0.0F, 0.035F, true, true, 0U, {}},
                        {0.0F, 1.6F, false, false, 0U, {}},
                        {-2.4F, 0.0F, true, false, shader::kLayerGrowsDown, {}}};
        scene.styles.resize(kRows);
        scene.facesMm = {0.0F, 1.6F};
        scene.hasShadows = true;
        return scene;
    }

    static bool isShadowed(const shader::LayerState& state) {
        return (state.flags >> shader::kLayerMaterialShift & shader::kMaterialShadowed) != 0;
    }

    /// One letter for each row: x has shadows.
    static QString marked(const SceneLayers& scene, bool isFromAbove, const ViewSettings& settings = {}) {
        std::vector<shader::LayerState> states(scene.layers.size());
        ShadowedLayers(scene, settings, isFromAbove).mark(states);
        QString text;
        for (const shader::LayerState& state : states) {
            text += isShadowed(state) ? 'x' : '.';
        }
        return text;
    }

    static constexpr const char* kNone = ".........";

private slots:
    void shadowsFallOnTheOutsideOfTheSideThatIsSeen() {
        QCOMPARE(marked(board(), true), ".xxx...x.");
        QCOMPARE(marked(board(), false), ".....xxx.");
    }

    /// In a zone without the outer layers.
    void shadowsFallOnInnerCopperThatBodiesStandOn() {
        SceneLayers scene = board();
        scene.layers[BodiesTop].z0 = 0.9F;
        QCOMPARE(marked(scene, true), ".xxxxx.x.");
        QCOMPARE(marked(scene, false), ".....xxx.");
    }

    void onlyBodiesThatAreDrawnCastThem() {
        SceneLayers scene = board();
        scene.styles[BodiesTop].isVisible = false;
        QCOMPARE(marked(scene, true), kNone);
        QCOMPARE(marked(scene, false), ".....xxx.");
        scene = board();
        scene.styles[BodiesTop].opacity = 0.5F;
        QCOMPARE(marked(scene, true), kNone);
        scene = board();
        scene.hasShadows = false;
        QCOMPARE(marked(scene, true), kNone);
    }

    void onlyViewsOfTheWholeBoardInThreeDimensionsHaveThem() {
        ViewSettings settings;
        settings.is2d = true;
        QCOMPARE(marked(board(), true, settings), kNone);
        settings = {};
        settings.isMono = true;
        QCOMPARE(marked(board(), true, settings), kNone);
        settings = {};
        settings.isOutlined = true;
        QCOMPARE(marked(board(), true, settings), kNone);
        settings = {};
        settings.explode = 0.1F;
        QCOMPARE(marked(board(), true, settings), kNone);
    }

    void theyFadeWithTheRestAndWithExplosion() {
        const SceneLayers scene = board();
        const float full = ShadowedLayers(scene, {}, true).strength();
        ViewSettings settings;
        settings.dim = 0.5F;
        QCOMPARE(ShadowedLayers(scene, settings, true).strength(), 0.5F * full);
        settings = {};
        settings.explode = 0.01F;
        const float apart = ShadowedLayers(scene, settings, true).strength();
        QVERIFY(apart > 0.0F && apart < full);
    }

    void flippedLayersWithoutACounterpartHaveThemOnTheirOtherSide() {
        const SceneLayers scene = board();
        const ShadowedLayers shadows(scene, {}, true);
        for (const std::uint32_t row : {Prepreg, Core}) {
            shader::LayerState state{};
            shadows.markMirrored(row, state);
            QCOMPARE(isShadowed(state), row == Core);
        }
    }
};

QTEST_APPLESS_MAIN(ShadowedLayersTest)
#include "shadowed_layers_test.moc"
