#include "render/scene/scene_layers.h"

#include <QtTest>

#include "shaders/shared/board.h"

using namespace render;

/// Where layers and bodies are drawn once heights are scaled and layers apart.
class SceneLayersTest : public QObject {
    Q_OBJECT

    enum Row : std::uint32_t { BodiesTop, Top, Core, Bottom, BodiesBottom, kRows };

    /// Bodies of 3 mm above and of 2 mm below a board from 0 to 1.6 mm.
    static SceneLayers board() {
        SceneLayers scene;
        scene.layers = {{1.6F, 4.6F, true, false, shader::kLayerGrowsUp, {}},
                        {1.5F, 1.6F, true, true, 0U, {}},
                        {0.1F, 1.5F, true, false, 0U, {}},
                        {0.0F, 0.1F, true, true, 0U, {}},
                        {-2.0F, 0.0F, true, false, shader::kLayerGrowsDown, {}}};
        scene.styles.resize(kRows);
        scene.facesMm = {0.0F, 1.6F};
        scene.widthMm = 50.0F;
        return scene;
    }

    static bool near(float a, float b) { return std::abs(a - b) < 1e-4F; }
    /// Of a board that is as high as this.
    static ZRange reachOf(const SceneLayers& scene, const ViewSettings& settings, const ZRange& own) {
        const Box3 box = withBodies({glm::vec3(-1.0F, -1.0F, own.z0), glm::vec3(1.0F, 1.0F, own.z1)}, scene, settings);
        return {box.min.z, box.max.z};
    }

private slots:
    void bodiesReachAsHighAsTheyAre() {
        const ZRange reach = reachOf(board(), {}, {0.0F, 1.6F});
        QVERIFY(near(reach.z0, -2.0F) && near(reach.z1, 4.6F));
    }

    /// The board is from 0 to 9 mm then.
    void bodiesOnScaledLayersReachBeyondThem() {
        ViewSettings settings;
        settings.zScale = {10.0F, 5.0F};
        const ZRange reach = reachOf(board(), settings, {0.0F, 9.0F});
        QVERIFY(near(reach.z0, -2.0F) && near(reach.z1, 12.0F));
    }

    void bodiesOnLayersApartReachBeyondThem() {
        ViewSettings settings;
        settings.explode = 1.0F;
        const float half = 0.5F * kFullSpread * board().widthMm;
        const ZRange reach = reachOf(board(), settings, {-half, 1.6F + half});
        QVERIFY(near(reach.z0, -2.0F - half) && near(reach.z1, 4.6F + half));
    }

    void bodiesThatAreHiddenReachNowhere() {
        SceneLayers scene = board();
        scene.styles[BodiesTop].isVisible = scene.styles[BodiesBottom].isVisible = false;
        QVERIFY(reachOf(scene, {}, {0.0F, 1.6F}) == (ZRange{0.0F, 1.6F}));
    }

    void facesAreThoseOfTheBoardAsItIsDrawn() {
        QVERIFY(near(drawnFaces(board(), {}), 1.6F));
        ViewSettings settings;
        settings.zScale = {10.0F, 5.0F};
        QVERIFY(near(drawnFaces(board(), settings), 9.0F));
    }
};

QTEST_APPLESS_MAIN(SceneLayersTest)
#include "scene_layers_test.moc"
