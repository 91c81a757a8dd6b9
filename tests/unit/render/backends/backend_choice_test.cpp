#include "render/backends/backend_choice.h"

#include <QtTest>

#include "render/gpu/device.h"

using namespace render;

/// Which back end draws what, on devices of all kinds.
class BackendChoiceTest : public QObject {
    Q_OBJECT

    /// A frame of one layer, seen through this camera.
    static FramePlan planOf(const Camera& camera) {
        SceneLayers scene;
        scene.layers.emplace_back().z1 = 1.0F;
        scene.styles.resize(1);
        scene.widthMm = 10.0F;
        return planFrame(scene, camera, {}, 64, 48);
    }

    static FramePlan tilted() {
        Camera camera;
        camera.fit({-5, -5, 0}, {5, 5, 1}, NamedView::Iso, 4.0F / 3.0F);
        return planOf(camera);
    }

    static FramePlan flat() {
        Camera camera;
        camera.fitWindow({-5, -5}, {5, 5}, 1.0F, 4.0F / 3.0F);
        return planOf(camera);
    }

    /// Level with the layer's middle.
    static FramePlan inside() {
        Camera camera;
        camera.fit({-5, -5, 0}, {5, 5, 1}, NamedView::Top, 4.0F / 3.0F);
        camera.orbit(0.0F, std::asin(-camera.direction().z));
        return planOf(camera);
    }

    static gpu::Caps graphicsCard() {
        gpu::Caps caps;
        caps.hasMeshShader = true;
        caps.canShadeSamples = true;
        caps.hasAtomic64 = true;
        caps.maxAllocationBytes = 1U << 30U;
        return caps;
    }

    static gpu::Caps softwareDevice() {
        gpu::Caps caps = graphicsCard();
        caps.isCpu = true;
        return caps;
    }

private slots:
    void autoGoesByDeviceAndView() {
        const auto taken = [](const gpu::Caps& caps, const FramePlan& plan, bool isSmoothed) {
            return chooseBackend(Backend::Auto, caps, plan, isSmoothed).backend;
        };
        QCOMPARE(taken(graphicsCard(), tilted(), true), Backend::Pull);
        QCOMPARE(taken(graphicsCard(), tilted(), false), Backend::Raster);
        QCOMPARE(taken(graphicsCard(), inside(), false), Backend::Pull);
        QCOMPARE(taken(softwareDevice(), tilted(), false), Backend::Pull);
        QCOMPARE(taken({}, tilted(), false), Backend::Pull);
        QCOMPARE(taken(graphicsCard(), flat(), false), Backend::Impostor);
        QCOMPARE(taken({}, flat(), true), Backend::Impostor);
    }

    void whatIsAskedForIsTakenWhereItCan() {
        for (const Backend backend : {Backend::Mesh, Backend::Pull, Backend::Impostor, Backend::Raster}) {
            const BackendChoice choice = chooseBackend(backend, softwareDevice(), tilted(), false);
            QCOMPARE(choice.backend, backend);
            QVERIFY(choice.needs == nullptr);
        }
    }

    void whatCannotDrawSaysWhatItNeeds() {
        const BackendChoice mesh = chooseBackend(Backend::Mesh, {}, tilted(), false);
        QCOMPARE(mesh.backend, Backend::Pull);
        QVERIFY(QString(mesh.needs).contains("mesh shaders"));
        const BackendChoice impostor = chooseBackend(Backend::Impostor, {}, tilted(), false);
        QCOMPARE(impostor.backend, Backend::Pull);
        QVERIFY(QString(impostor.needs).contains("flat view"));
    }

    void rasterNeedsAtomicsAndRoomForItsPixels() {
        for (const auto& spoil : {+[](gpu::Caps& caps) { caps.hasAtomic64 = false; },
                                  +[](gpu::Caps& caps) { caps.maxAllocationBytes = 8 * 64 * 48 - 1; }}) {
            gpu::Caps caps = softwareDevice();
            spoil(caps);
            const BackendChoice choice = chooseBackend(Backend::Raster, caps, tilted(), false);
            QCOMPARE(choice.backend, Backend::Pull);
            QVERIFY(QString(choice.needs).contains("64-bit atomics"));
        }
    }

    void boxesAreNotLookedAtFromInside() {
        QCOMPARE(chooseBackend(Backend::Raster, softwareDevice(), inside(), false).backend, Backend::Pull);
        QCOMPARE(chooseBackend(Backend::Impostor, softwareDevice(), inside(), false).backend, Backend::Pull);
    }

    void whatWasMeasuredIsTakenInTiltedViews() {
        const MeasuredBackends measured{Backend::Mesh, Backend::Impostor};
        const auto taken = [&](const gpu::Caps& caps, const FramePlan& plan, bool isSmoothed) {
            return chooseBackend(Backend::Auto, caps, plan, isSmoothed, measured).backend;
        };
        QCOMPARE(taken(graphicsCard(), tilted(), false), Backend::Mesh);
        QCOMPARE(taken(graphicsCard(), tilted(), true), Backend::Impostor);
        QCOMPARE(taken(softwareDevice(), tilted(), false), Backend::Mesh);
        QCOMPARE(taken(graphicsCard(), flat(), false), Backend::Impostor);
        QCOMPARE(taken(graphicsCard(), flat(), true), Backend::Impostor);
    }

    void whatWasMeasuredButCannotDrawIsNotTaken() {
        const MeasuredBackends measured{Backend::Raster, Backend::Impostor};
        QCOMPARE(chooseBackend(Backend::Auto, graphicsCard(), inside(), false, measured).backend, Backend::Pull);
        QCOMPARE(chooseBackend(Backend::Auto, graphicsCard(), inside(), true, measured).backend, Backend::Pull);
        QCOMPARE(chooseBackend(Backend::Auto, {}, tilted(), false, measured).backend, Backend::Pull);
        QCOMPARE(chooseBackend(Backend::Auto, {}, tilted(), true, {Backend::Mesh, Backend::Mesh}).backend,
                 Backend::Pull);
    }

    void whatIsAskedForGoesBeforeWhatWasMeasured() {
        const MeasuredBackends measured{Backend::Mesh, Backend::Mesh};
        QCOMPARE(chooseBackend(Backend::Pull, graphicsCard(), tilted(), false, measured).backend, Backend::Pull);
        const BackendChoice instead = chooseBackend(Backend::Impostor, graphicsCard(), inside(), false, measured);
        QCOMPARE(instead.backend, Backend::Mesh);
        QVERIFY(instead.needs != nullptr);
    }

    void whatIsNotKnownIsLeftToTheRules() {
        const MeasuredBackends unknown;
        QCOMPARE(chooseBackend(Backend::Auto, graphicsCard(), tilted(), false, unknown).backend, Backend::Raster);
        QCOMPARE(chooseBackend(Backend::Auto, graphicsCard(), tilted(), true, {Backend::Mesh, Backend::Auto}).backend,
                 Backend::Pull);
    }

    void candidatesAreWhatTheDeviceCanDraw() {
        QCOMPARE(tiltedBackends(gpu::Caps{}, false), std::vector{Backend::Pull});
        QCOMPARE(tiltedBackends(graphicsCard(), false),
                 (std::vector{Backend::Pull, Backend::Mesh, Backend::Impostor, Backend::Raster}));
        QCOMPARE(tiltedBackends(graphicsCard(), true), (std::vector{Backend::Pull, Backend::Mesh, Backend::Impostor}));
    }

    void namesAreThoseOfTheCommandLine() {
        QCOMPARE(nameOf(Backend::Auto), "auto");
        QCOMPARE(nameOf(Backend::Impostor), "impostor");
        QCOMPARE(nameOf(Backend::Standard), "standard");
    }
};

QTEST_APPLESS_MAIN(BackendChoiceTest)
#include "backend_choice_test.moc"
