#include "render/culling/hidden_layers.h"

#include <QtTest>

#include "render/culling/frame_plan.h"
#include "render/scene/element_state.h"

using namespace render;
using Role = LayerInSubstrate::Role;

/// What opaque laminate hides, decided without a device.
class HiddenLayersTest : public QObject {
    Q_OBJECT

    enum Row : std::uint32_t { Top, Inner, Bottom, Drill, Substrate, kRows };

    /// A board of 100 x 80 mm: laminate, copper on it, in it and under it, a drill layer through everything.
    static SceneLayers board() {
        SceneLayers scene;
        scene.widthMm = 100.0F;
        scene.layers = {{1.565F, 1.6F, true, true, 0U, {}},
                        {0.8F, 0.835F, true, true, 0U, {}},
                        {0.0F, 0.035F, true, true, 0U, {}},
                        {0.0F, 1.6F, false, false, 0U, {}},
                        {0.035F, 1.565F, true, false, 0U, {}}};
        scene.inSubstrate = {{Role::Content, 0.5F},
                             {Role::Content, 0.5F},
                             {Role::Content, 0.5F},
                             {Role::Plug, 0.5F},
                             {Role::Substrate, -1.0F}};
        scene.styles.resize(kRows);
        return scene;
    }

    static LayerPlan plan(const SceneLayers& scene, NamedView view = NamedView::Iso, ViewSettings settings = {},
                          float zoom = 1.0F, Subject subject = Subject::Board) {
        Camera camera;
        camera.fit({-50, -40, 0}, {50, 40, 1.6F}, view, 1.5F);
        camera.focusOnHeight(1.6F);
        camera.zoom(zoom, {0.0F, 0.0F}, 1.5F);
        return planFrame(scene, camera, settings, 1200, 800, subject).upright;
    }

    static bool isDrawn(const LayerPlan& plan, std::uint32_t row) {
        return std::ranges::any_of(plan.batches, [&](const LayerBatch& b) { return std::ranges::count(b, row) > 0; });
    }

private slots:
    void innerAndFarLayersAreHidden() {
        for (const NamedView view : {NamedView::Iso, NamedView::Top}) {
            const LayerPlan seen = plan(board(), view);
            QVERIFY(isDrawn(seen, Top) && isDrawn(seen, Drill) && isDrawn(seen, Substrate));
            QVERIFY(!isDrawn(seen, Inner) && !isDrawn(seen, Bottom));
        }
        const LayerPlan fromBelow = plan(board(), NamedView::Bottom);
        QVERIFY(isDrawn(fromBelow, Bottom) && !isDrawn(fromBelow, Inner) && !isDrawn(fromBelow, Top));
    }

    void barrelsEndBelowTheSurface() {
        const LayerPlan above = plan(board());
        QCOMPARE(above.states[Drill].z1, 1.6F);
        QVERIFY(above.states[Drill].z0 > 1.5F && above.states[Drill].z0 < 1.565F);
        const LayerPlan below = plan(board(), NamedView::Bottom);
        QCOMPARE(below.states[Drill].z0, 0.0F);
        QVERIFY(below.states[Drill].z1 < 0.1F && below.states[Drill].z1 > 0.035F);
    }

    void whatCouldBeSeenIsDrawn_data() {
        QTest::addColumn<int>("change");
        QTest::newRow("translucent laminate") << 0;
        QTest::newRow("hidden laminate") << 1;
        QTest::newRow("hidden drills: holes are open") << 2;
        QTest::newRow("copper sticks out") << 3;
        QTest::newRow("no culling") << 4;
        QTest::newRow("exploded") << 5;
    }
    void whatCouldBeSeenIsDrawn() {
        QFETCH(int, change);
        SceneLayers scene = board();
        ViewSettings settings;
        switch (change) {
            case 0: scene.styles[Substrate].opacity = 0.5F; break;
            case 1: scene.styles[Substrate].isVisible = false; break;
            case 2: scene.styles[Drill].isVisible = false; break;
            case 3: scene.inSubstrate[Inner].marginMm = -1.0F; break;
            case 4: settings.cull = false; break;
            default: settings.explode = 1.0F; break;
        }
        QVERIFY(isDrawn(plan(scene, NamedView::Iso, settings), Inner));
    }

    /// Of a layer of which something ends at the board's edge that alone may be seen; and holes at the edge are open.
    void whatIsMilledIsDrawn() {
        SceneLayers scene = board();
        scene.inSubstrate[Inner].isMilled = true;
        scene.inSubstrate[Drill].isMilled = true;
        const LayerPlan seen = plan(scene);
        QVERIFY(isDrawn(seen, Inner) && !isDrawn(seen, Bottom));
        QVERIFY((seen.states[Inner].flags & shader::kLayerMilledOnly) != 0);
        QVERIFY((seen.states[Top].flags & shader::kLayerMilledOnly) == 0);
        QCOMPARE(seen.states[Drill].z0, 0.0F);
        scene.styles[Substrate].isVisible = false;
        QVERIFY((plan(scene).states[Inner].flags & shader::kLayerMilledOnly) == 0);
    }

    void whatStandsOutIsDrawnThroughEverything() {
        for (const NamedView view : {NamedView::Iso, NamedView::Top, NamedView::Bottom}) {
            const LayerPlan over = plan(board(), view, {}, 1.0F, Subject::StandingOut);
            for (const Row row : {Top, Inner, Bottom, Drill}) {
                QVERIFY(isDrawn(over, row));
            }
            QCOMPARE(over.batches.size(), std::size_t{1});  // nothing is blended
        }
    }

    /// Close up, one looks past the edge at the far copper unless it keeps well inside.
    void farLayersAreSeenPastTheEdgeCloseUp() {
        SceneLayers scene = board();
        scene.inSubstrate[Bottom].marginMm = 0.0F;
        QVERIFY(!isDrawn(plan(scene, NamedView::Iso, {}, 1.0F), Bottom));  // thinner than a pixel
        QVERIFY(isDrawn(plan(scene, NamedView::Iso, {}, 50.0F), Bottom));
        scene.inSubstrate[Bottom].marginMm = 1.0F;
        QVERIFY(!isDrawn(plan(scene, NamedView::Iso, {}, 50.0F), Bottom));
    }

    void wallsThinnerThanAPixelAreNotDrawn() {
        const LayerPlan far = plan(board());
        QVERIFY(!far.faces[Top].walls && far.faces[Substrate].walls);
        const LayerPlan close = plan(board(), NamedView::Iso, {}, 50.0F);
        QVERIFY(close.faces[Top].walls);
    }

    void sightFollowsTheCamera() {
        Camera camera;
        camera.fit({-50, -40, 0}, {50, 40, 1.6F}, NamedView::Top, 1.5F);
        camera.setOrthographic(true);
        const auto sight = [&] {
            const glm::dmat4 clip(camera.projection(1.5F) * camera.view());
            const float scale = std::abs(camera.projection(1.0F)[1][1]) * 400.0F;
            return sightOf({clip, glm::dvec3(0.0), scale}, 0.0F, 1.6F);
        };
        QVERIFY(sight().isOutside && sight().isFromAbove);
        QVERIFY(sight().flatness < 1e-3F);
        QVERIFY(std::abs(sight().pixelsPerMm * camera.mmPerPixel(800.0F) - 1.0F) < 1e-3F);
        camera.orbit(0.0F, 1.5707F);  // along the board
        QVERIFY(!sight().isOutside || sight().flatness > 100.0F);
    }
};

QTEST_APPLESS_MAIN(HiddenLayersTest)
#include "hidden_layers_test.moc"
