#include "render/culling/frame_plan.h"

#include <QtTest>

#include "render/scene/camera.h"

namespace {

/// A board from 0 to 1.6 mm and a layer of bodies from 2 to 5 mm on its top, one layer turned over with some copy.
render::SceneLayers sceneWithBodies(std::uint32_t growth) {
    render::SceneLayers scene;
    render::FrameLayer bodies;
    bodies.z0 = 2.0F;
    bodies.z1 = 5.0F;
    bodies.hasAreas = true;
    bodies.growth = growth;
    scene.layers.push_back(bodies);
    scene.styles.resize(1);
    scene.widthMm = 50.0F;
    scene.facesMm = {0.0F, 1.6F};
    scene.hasFlipped = true;
    return scene;
}

render::FramePlan planOf(const render::SceneLayers& scene, const render::Camera& camera) {
    return render::planFrame(scene, camera, {}, 800, 600);
}

}  // namespace

class FramePlanTest : public QObject {
    Q_OBJECT

private slots:
    void raisedLayerReachesBeyondTheOthersInTwoDOnly() {
        render::SceneLayers scene = sceneWithBodies(0);
        scene.layers.resize(3);
        scene.styles.resize(3);
        scene.styles[1].raised = 1;
        scene.styles[2].raised = 2;
        const auto solid = render::drawnHeights(scene, {});
        QCOMPARE(solid[1].z1, 0.0F);
        render::ViewSettings flat;
        flat.is2d = true;
        const auto heights = render::drawnHeights(scene, flat);
        QCOMPARE(heights[0].z1, solid[0].z1);
        QVERIFY(heights[1].z1 > heights[0].z1 && heights[1].z0 < heights[0].z0);
        QVERIFY(heights[2].z1 > heights[1].z1 && heights[2].z0 < heights[1].z0);
    }

    void turnedOverBodiesHangFromTheOtherSide() {
        const render::FramePlan plan = planOf(sceneWithBodies(shader::kLayerGrowsUp), {});
        const shader::LayerState& upright = plan.upright.states[0];
        const shader::LayerState& flipped = plan.flipped.states[0];
        QVERIFY((upright.flags & shader::kLayerGrowsUp) != 0 && (upright.flags & shader::kLayerGrowsDown) == 0);
        QVERIFY((flipped.flags & shader::kLayerGrowsUp) == 0 && (flipped.flags & shader::kLayerGrowsDown) != 0);
        QCOMPARE(flipped.z1, 1.6F - 2.0F);
        QCOMPARE(flipped.z0, 1.6F - 5.0F);
    }

    /// A print 0.02 mm over copper that is 0.1 mm thick, on a core of 1.4 mm over copper of 0.1 mm.
    void flippedPrintLiesOnTheBoardHoweverThickItIsDrawn() {
        render::SceneLayers scene = sceneWithBodies(0);
        scene.layers = {{1.6F, 1.62F}, {1.5F, 1.6F}, {0.1F, 1.5F}, {0.0F, 0.1F}};
        scene.layers[1].isCopper = scene.layers[3].isCopper = true;
        scene.layers[1].opposite = model::LayerId{std::size_t{3}};
        scene.layers[3].opposite = model::LayerId{std::size_t{1}};
        scene.styles.resize(scene.layers.size());
        render::ViewSettings settings;
        settings.zScale = {10.0F, 5.0F};
        const render::FramePlan plan = render::planFrame(scene, {}, settings, 800, 600);
        const auto& upright = plan.upright.states;
        const auto& flipped = plan.flipped.states;
        QVERIFY(std::abs(upright[0].z0 - upright[1].z1) < 1e-4F);
        QVERIFY(std::abs(flipped[0].z1 - flipped[1].z0) < 1e-4F);
        QVERIFY(std::abs(flipped[0].z1 - flipped[0].z0 - 0.1F) < 1e-4F);
        QVERIFY(std::abs(flipped[2].z0 - 1.0F) < 1e-4F && std::abs(flipped[2].z1 - 8.0F) < 1e-4F);
    }

    /// Upper left in the picture, on the side of the board that is seen.
    void theLampFollowsTheCamera() {
        render::Camera camera;
        const glm::vec3 box(20.0F, 10.0F, 1.0F);
        for (const render::NamedView view :
             {render::NamedView::Top, render::NamedView::Bottom, render::NamedView::Iso}) {
            camera.fit(-box, box, view, 1.0F);
            const shader::FrameData data = planOf(sceneWithBodies(0), camera).data;
            QVERIFY(std::abs(glm::length(data.keyLight) - 1.0F) < 1e-5F);
            QVERIFY(glm::dot(data.keyLight, data.screenRight) < 0.0F);
            QVERIFY(glm::dot(data.keyLight, data.screenDown) < 0.0F);
            QCOMPARE(data.keyLight.z > 0.0F, view != render::NamedView::Bottom);
        }
    }

    void whatStandsOutIsDarkerTheDeeperItLies() {
        render::SceneLayers scene;
        for (int i = 0; i < 3; ++i) {  // from the top: two of copper and one of something else
            render::FrameLayer layer;
            layer.z1 = 2.0F - static_cast<float>(i);
            layer.z0 = layer.z1 - 0.1F;
            layer.isCopper = i < 2;
            scene.layers.push_back(layer);
        }
        scene.styles.resize(3);
        scene.styles[1].opacity = 0.5F;
        const auto shades = [&](render::NamedView view, bool is2d) {
            render::Camera camera;
            camera.fit(glm::vec3(-1.0F), glm::vec3(1.0F), view, 1.0F);
            render::ViewSettings settings;
            settings.is2d = is2d;
            const auto plan = render::planFrame(scene, camera, settings, 80, 60, render::Subject::StandingOut);
            return glm::vec3(plan.upright.states[0].colour.a, plan.upright.states[1].colour.a,
                             plan.upright.states[2].colour.a);
        };
        const glm::vec3 fromAbove = shades(render::NamedView::Top, false);
        QVERIFY(fromAbove.y < 0.9F * fromAbove.x && fromAbove.y > 0.3F);
        QCOMPARE(fromAbove.z, fromAbove.x);
        QCOMPARE(shades(render::NamedView::Bottom, false), glm::vec3(fromAbove.y, fromAbove.x, fromAbove.x));
        const glm::vec3 flat = shades(render::NamedView::Top, true);
        QVERIFY(flat.x == 1.0F && flat.z == 1.0F && flat.y < 0.7F && flat.y > 0.3F);
        QCOMPARE(shades(render::NamedView::Bottom, true), glm::vec3(flat.y, 1.0F, 1.0F));
    }

    /// Lids of bodies and undersides of their parts lie anywhere between the faces of their layer.
    void fromBetweenTheFacesOfALayerOfBodiesBothSidesAreSeen() {
        const auto facesFrom = [](float z, std::uint32_t growth) {
            render::CameraPose pose;
            pose.target.z = z;
            render::Camera camera;
            camera.setPose(pose);  // looks along the board
            return planOf(sceneWithBodies(growth), camera).upright.faces[0];
        };
        for (const std::uint32_t growth : {shader::kLayerGrowsUp, shader::kLayerGrowsDown}) {
            const render::SeenFaces between = facesFrom(3.5F, growth);
            QVERIFY(between.upper && between.lower);
            const render::SeenFaces above = facesFrom(6.0F, growth);
            QVERIFY(above.upper && !above.lower);
            const render::SeenFaces below = facesFrom(1.0F, growth);
            QVERIFY(!below.upper && below.lower);
        }
        const render::SeenFaces within = facesFrom(3.5F, 0);
        QVERIFY(!within.upper && !within.lower);
    }

    void evenLayersStayEven() {
        const render::FramePlan plan = planOf(sceneWithBodies(0), {});
        constexpr std::uint32_t kUneven = shader::kLayerGrowsUp | shader::kLayerGrowsDown;
        QCOMPARE(plan.upright.states[0].flags & kUneven, 0U);
        QCOMPARE(plan.flipped.states[0].flags & kUneven, 0U);
    }
};

QTEST_APPLESS_MAIN(FramePlanTest)
#include "frame_plan_test.moc"
