#include <QtTest>

#include "render/frame/frame_measures.h"
#include "render/scene/scene_layers.h"
#include "tests/gpu/gpu_fixture.h"

using namespace render;
using namespace render::test;

Q_DECLARE_METATYPE(glm::vec3)

/// The two back ends draw the same picture, and culling leaves nothing out.
class BackendsTest : public QObject {
    Q_OBJECT

    static ViewSettings settings(Backend backend) {
        ViewSettings result;
        result.backend = backend;
        return result;
    }

    static shader::AreaInstance at(glm::vec2 origin) {
        shader::AreaInstance instance{};
        instance.origin = origin;
        instance.cosSin = {1.0F, 0.0F};
        return instance;
    }

    /// Draws with both and compares; at most 0.01 % of the pixels may differ by more than 8 levels.
    static void compare(Scene& scene, ViewSettings how) {
        how.backend = Backend::Pull;
        const Image pull = scene.draw(how);
        QCOMPARE(Gpu::get().presenter.stats().backend, Backend::Pull);
        how.backend = Backend::Mesh;
        const Image mesh = scene.draw(how);
        QCOMPARE(Gpu::get().presenter.stats().backend, Backend::Mesh);
        const std::size_t differing = differingPixels(pull, mesh);
        QVERIFY2(differing * 10000 <= std::size_t{pull.width} * pull.height, qPrintable(QString::number(differing)));
    }

    /// Draws with pull and with `exact`, which knows true outlines. At most so many pixels differ by nearly all there
    /// is.
    static void compareSolids(Scene& scene, Backend exact, bool isSmoothed, ViewSettings how = {},
                              std::size_t mostFar = 0) {
        how.isSmoothed = isSmoothed;
        how.backend = Backend::Pull;
        const Image pull = scene.draw(how, 320, 240);
        how.backend = exact;
        const Image picture = scene.draw(how, 320, 240);
        QCOMPARE(Gpu::get().presenter.stats().backend, exact);
        const double mse = greyMse(pull, picture);
        QVERIFY2(mse < 0.0003, qPrintable(QString::number(mse)));
        if (isSmoothed) {
            constexpr int kNearlyFullContrast = 150;
            QVERIFY(differingPixels(pull, picture, kNearlyFullContrast) <= mostFar);
        }
    }

private slots:
    void initTestCase() {
        if (!Gpu::get().device.caps().hasMeshShader) {
            QSKIP("the device has no mesh shaders");
        }
    }

    void meshAndPullAgreeOnEveryKindOfElement_data() {
        QTest::addColumn<int>("view");
        QTest::addColumn<bool>("is2d");
        QTest::addColumn<bool>("isParallel");
        QTest::addColumn<float>("explode");
        QTest::addColumn<bool>("isSmoothed");
        QTest::newRow("top") << int(NamedView::Top) << false << false << 0.0F << true;
        QTest::newRow("top, unsmoothed") << int(NamedView::Top) << false << false << 0.0F << false;
        QTest::newRow("bottom") << int(NamedView::Bottom) << false << false << 0.0F << true;
        QTest::newRow("iso") << int(NamedView::Iso) << false << false << 0.0F << true;
        QTest::newRow("iso, parallel") << int(NamedView::Iso) << false << true << 0.0F << true;
        QTest::newRow("iso, exploded") << int(NamedView::Iso) << false << false << 0.5F << true;
        QTest::newRow("2d") << int(NamedView::Top) << true << true << 0.0F << true;
        QTest::newRow("2d from below") << int(NamedView::Bottom) << true << true << 0.0F << true;
    }
    void meshAndPullAgreeOnEveryKindOfElement() {
        QFETCH(int, view);
        QFETCH(bool, is2d);
        QFETCH(bool, isParallel);
        QFETCH(float, explode);
        QFETCH(bool, isSmoothed);
        Scene scene(everything());
        scene.camera.setOrthographic(isParallel);
        scene.camera.fit(scene.model.boxMin, scene.model.boxMax, static_cast<NamedView>(view), 4.0F / 3.0F);
        ViewSettings how;
        how.is2d = is2d;
        how.explode = explode;
        how.isSmoothed = isSmoothed;
        compare(scene, how);
    }

    void meshAndPullAgreeAtEveryLevelOfDetail_data() {
        QTest::addColumn<float>("zoom");
        // From discs of half a pixel to discs larger than the picture.
        for (const float zoom : {0.1F, 0.5F, 2.0F, 8.0F, 40.0F, 400.0F}) {
            QTest::addRow("zoom %g", static_cast<double>(zoom)) << zoom;
        }
    }
    void meshAndPullAgreeAtEveryLevelOfDetail() {
        QFETCH(float, zoom);
        Scene scene(randomTraces(1500, 7));
        scene.camera.fit(scene.model.boxMin, scene.model.boxMax, NamedView::Iso, 4.0F / 3.0F);
        scene.camera.zoom(zoom, {0.0F, 0.0F}, 4.0F / 3.0F);
        compare(scene, {});
    }

    /// Outlines of polygons stray up to 0.3 px from the true ones that impostors draw: pixels at outlines differ a
    /// little, none altogether.
    void impostorsDrawTheSameFlatPicture_data() {
        QTest::addColumn<int>("view");
        QTest::addColumn<bool>("isSmoothed");
        QTest::newRow("from above") << int(NamedView::Top) << true;
        QTest::newRow("from above, unsmoothed") << int(NamedView::Top) << false;
        QTest::newRow("from below") << int(NamedView::Bottom) << true;
    }
    void impostorsDrawTheSameFlatPicture() {
        QFETCH(int, view);
        QFETCH(bool, isSmoothed);
        for (const SyntheticBoard& board : {everything(), randomTraces(400, 5)}) {
            Scene scene(board);
            scene.camera.setOrthographic(true);
            scene.camera.fit(scene.model.boxMin, scene.model.boxMax, static_cast<NamedView>(view), 4.0F / 3.0F);
            ViewSettings how = settings(Backend::Pull);
            how.is2d = true;
            how.isSmoothed = isSmoothed;
            const Image pull = scene.draw(how);
            how.backend = Backend::Impostor;
            const Image impostor = scene.draw(how);
            QCOMPARE(Gpu::get().presenter.stats().backend, Backend::Impostor);
            QVERIFY(greyMse(pull, impostor) < 0.0005);
            if (isSmoothed) {
                // A gap between two shapes may close on both sides.
                constexpr int kNearlyFullContrast = 150;
                QVERIFY(differingPixels(pull, impostor, kNearlyFullContrast) <= 2);
            }
        }
    }

    static void addSolidViews() {
        QTest::addColumn<bool>("isParallel");
        QTest::addColumn<int>("view");
        QTest::addColumn<glm::vec3>("from");
        QTest::addColumn<glm::vec3>("to");
        const glm::vec3 low(-20, -15, 0);
        const glm::vec3 high(20, 15, 1.6F);
        QTest::newRow("iso") << false << int(NamedView::Iso) << low << high;
        QTest::newRow("iso, parallel") << true << int(NamedView::Iso) << low << high;
        QTest::newRow("from above") << false << int(NamedView::Top) << low << high;
        QTest::newRow("from below") << false << int(NamedView::Bottom) << low << high;
        QTest::newRow("strokes") << false << int(NamedView::Iso) << glm::vec3(-16, -5, 1.5F) << glm::vec3(-4, 13, 1.6F);
        QTest::newRow("rings, barrels") << false << int(NamedView::Iso) << glm::vec3(-1.5F, 1.5F, 0)
                                        << glm::vec3(1.5F, 4.5F, 1.6F);
        QTest::newRow("hole") << false << int(NamedView::Iso) << glm::vec3(11, 7, 1.5F) << glm::vec3(13, 9, 1.6F);
        QTest::newRow("arcs") << true << int(NamedView::Iso) << glm::vec3(1, -5, 1.5F) << glm::vec3(7, 1, 1.6F);
        QTest::newRow("edge") << false << int(NamedView::Iso) << glm::vec3(-5.2F, 11, 1.55F)
                              << glm::vec3(-4.8F, 11.4F, 1.6F);
    }

    /// Tilted, lines of sight are exact and polygons are not: outlines differ a little, nothing else does.
    void trueOutlinesMakeTheSameSolids_data() { addSolidViews(); }
    void trueOutlinesMakeTheSameSolids() {
        QFETCH(bool, isParallel);
        QFETCH(int, view);
        QFETCH(glm::vec3, from);
        QFETCH(glm::vec3, to);
        for (const SyntheticBoard& board : {everything(), randomTraces(300, 5)}) {
            Scene scene(board);
            scene.camera.setOrthographic(isParallel);
            scene.camera.fit(from, to, static_cast<NamedView>(view), 4.0F / 3.0F);
            for (const bool isSmoothed : {false, true}) {
                compareSolids(scene, Backend::Impostor, isSmoothed);
            }
            compareSolids(scene, Backend::Raster, false);
        }
    }

    /// Highlighted, dimmed, exploded: what changes in a frame reaches lines of sight too.
    void trueOutlinesFollowWhatChanges() {
        Scene scene(everything());
        scene.camera.fit(scene.model.boxMin, scene.model.boxMax, NamedView::Iso, 4.0F / 3.0F);
        const std::vector<model::ElementId> highlighted{model::ElementId{1}, model::ElementId{3}, model::ElementId{9}};
        scene.scene.setStates(statesOf(highlighted));
        ViewSettings how;
        how.dim = kDimRest;
        how.explode = 0.3F;
        compareSolids(scene, Backend::Impostor, true, how, 2);  // bright and dark lie side by side
        compareSolids(scene, Backend::Raster, false, how);
    }

    /// Both cast the same lines of sight, one in fragment shaders, one in compute shaders. Small lets, so that it is
    /// those that are compared; walls of a fiftieth of a pixel are left out of the boxes.
    void rasterAndImpostorsAgree() {
        Scene scene(randomTraces(2000, 3));
        scene.camera.fit(scene.model.boxMin, scene.model.boxMax, NamedView::Iso, 4.0F / 3.0F);
        scene.camera.zoom(0.25F, {0.0F, 0.0F}, 4.0F / 3.0F);
        ViewSettings how = settings(Backend::Raster);
        how.isSmoothed = false;
        const Image raster = scene.draw(how, 320, 240);
        QCOMPARE(Gpu::get().presenter.stats().backend, Backend::Raster);
        how.backend = Backend::Impostor;
        const std::size_t differing = differingPixels(raster, scene.draw(how, 320, 240));
        QVERIFY2(differing <= 20, qPrintable(QString::number(differing)));
    }

    /// More pixels than the last picture had, then fewer again.
    void rasterFollowsTheSizeOfThePicture() {
        Scene scene(randomTraces(300, 8));
        for (const std::uint32_t width : {40U, 320U, 97U}) {
            scene.camera.fit(scene.model.boxMin, scene.model.boxMax, NamedView::Iso, 1.0F);
            ViewSettings how = settings(Backend::Pull);
            how.isSmoothed = false;
            const Image pull = scene.draw(how, width, width);
            how.backend = Backend::Raster;
            QVERIFY(greyMse(pull, scene.draw(how, width, width)) < 0.002);
        }
    }

    /// The pull back end's lists of all batches lie side by side in one buffer.
    void tinyLetsOfOneBatchLeaveTheNextOneAlone() {
        SyntheticBoard board;
        board.addLayer(0.0F, 0.035F, {0.8F, 0.2F, 0.2F});
        for (int i = 0; i < 800; ++i) {
            const glm::vec2 at{static_cast<float>(i % 40) - 20.0F, static_cast<float>(i / 40) - 10.0F};
            board.addDisc(at, 0.01F);
        }
        board.addLayer(0.1F, 0.2F, {0.2F, 0.8F, 0.2F}, 0.5F);
        for (int i = 0; i < 8; ++i) {
            board.addDisc({static_cast<float>(i) * 4.0F - 14.0F, 2.0F}, 1.5F, i % 2 == 0 ? 1.0F : 0.0F);
        }
        Scene scene(board);
        compare(scene, {});
    }

    void pictureIsTheSameEveryTime() {
        Scene scene(everything());
        scene.camera.fit(scene.model.boxMin, scene.model.boxMax, NamedView::Iso, 4.0F / 3.0F);
        for (const Backend backend : {Backend::Pull, Backend::Mesh, Backend::Impostor, Backend::Raster}) {
            const Image first = scene.draw(settings(backend));
            const Image second = scene.draw(settings(backend));
            QCOMPARE(differingPixels(first, second, 0), std::size_t{0});
        }
    }

    void cullingLeavesNothingOut_data() {
        QTest::addColumn<int>("backend");
        QTest::addColumn<float>("zoom");
        for (const Backend backend : {Backend::Pull, Backend::Mesh, Backend::Impostor}) {
            for (const float zoom : {1.0F, 6.0F, 30.0F}) {
                QTest::addRow("%s, zoom %g", nameOf(backend), static_cast<double>(zoom)) << int(backend) << zoom;
            }
        }
    }
    /// Without culling every let has the 64-vertex level. A pixel at an outline changes by what its polygon strays (0.3
    /// px), never from full colour to background: that would be a let that is missing.
    void cullingLeavesNothingOut() {
        QFETCH(int, backend);
        QFETCH(float, zoom);
        Scene scene(randomTraces(800, 11));
        scene.camera.fit(scene.model.boxMin, scene.model.boxMax, NamedView::Iso, 4.0F / 3.0F);
        scene.camera.zoom(zoom, {0.3F, -0.2F}, 4.0F / 3.0F);
        ViewSettings how = settings(static_cast<Backend>(backend));
        const Image culled = scene.draw(how);
        how.cull = false;
        const Image all = scene.draw(how);
        constexpr int kNearlyFullContrast = 150;
        const std::size_t missing = differingPixels(culled, all, kNearlyFullContrast);
        QVERIFY2(missing <= 4, qPrintable(QString::number(missing)));
    }

    /// And only those: what has a notch, a hole or walls to be seen keeps its outline.
    void areasAsGoodAsTheirBoxAreDrawnAsBoxes() {
        SyntheticBoard board;
        board.addLayer(0.0F, 0.02F, {0.8F, 0.2F, 0.2F});
        std::vector<shader::AreaInstance> grid;
        for (int i = 0; i < 300; ++i) {
            grid.push_back(at({static_cast<float>(i % 20) * 2.0F - 20.0F, static_cast<float>(i / 20) * 2.0F - 15.0F}));
        }
        board.addArea(
            {{{-480, -300}, {480, -300}, {500, -280}, {500, 280}, {480, 300}, {-480, 300}, {-500, 280}, {-500, -280}}},
            grid);
        board.addArea({{{-1000, -1000}, {1000, -1000}, {1000, 0}, {0, 0}, {0, 1000}, {-1000, 1000}}},
                      {at({-22.0F, 0.0F})});
        board.addArea({{{-1000, -1000}, {1000, -1000}, {1000, 1000}, {-1000, 1000}},
                       {{-500, -500}, {-500, 500}, {500, 500}, {500, -500}}},
                      {at({22.0F, 0.0F})});
        Scene scene(board);
        scene.camera.setOrthographic(true);
        scene.camera.fit({-24, -18, 0}, {24, 18, 0.02F}, NamedView::Iso, 4.0F / 3.0F);
        ViewSettings how = settings(Backend::Pull);
        const auto triangles = [&] { return drawnTriangles(scene.scene, scene.camera, how, 640, 480).value_or(0); };
        const Image culled = scene.draw(how);
        QCOMPARE(triangles(), std::uint64_t{300 * 2 + 4 + 8});
        how.cull = false;
        const Image all = scene.draw(how);
        QVERIFY(triangles() > 300 * 6);
        constexpr int kHalfContrast = 90;
        QVERIFY(differingPixels(culled, all, kHalfContrast) <= 20);
        // Nearer, the walls are seen.
        how.cull = true;
        scene.camera.zoom(4.0F, {0.0F, 0.0F}, 4.0F / 3.0F);
        scene.draw(how);
        QVERIFY(triangles() % 2 == 0 && triangles() > 20 * (6 + 16));
    }

    /// More shapes on a layer than one list of commands takes. At one depth the later area wins.
    void areasOfManyShapesAreDrawnInTheirOrder() {
        constexpr std::uint32_t kColumns = 100;
        constexpr std::uint32_t kRows = shader::kMostAreaDraws / kColumns + 2;
        SyntheticBoard board;
        board.addLayer(0.0F, 0.02F, {0.8F, 0.2F, 0.2F});
        for (std::uint32_t i = 0; i < kColumns * kRows; ++i) {
            board.addArea({{{0, 0}, {600, 0}, {0, 600}}},
                          {at({0.4F * static_cast<float>(i % kColumns), static_cast<float>(i / kColumns)})});
        }
        Scene scene(board);
        const glm::vec3 palette[] = {{1.0F, 0.0F, 0.0F}, {0.0F, 1.0F, 0.0F}};
        scene.scene.setPalette(palette);
        std::vector<ElementState> states(scene.model.elementCount);
        for (std::size_t i = 0; i < states.size(); ++i) {
            states[i] = static_cast<ElementState>(1 + i % 2);
        }
        scene.scene.setStates(states);
        scene.camera.fit({0, 0, 0}, {0.4F * kColumns, kRows, 0.02F}, NamedView::Top, 1.0F);
        scene.lookDown({0, 0}, {0.4F * kColumns, kRows});
        ViewSettings how = settings(Backend::Pull);
        how.is2d = true;
        how.isSmoothed = false;
        constexpr std::uint32_t kPixelsPerMm = 20;
        constexpr std::uint32_t kHeight = kPixelsPerMm * kRows;
        const Image all = scene.draw(how, kPixelsPerMm * kColumns * 2 / 5, kHeight);
        const auto triangles = [&] {
            return drawnTriangles(scene.scene, scene.camera, how, kPixelsPerMm * kColumns * 2 / 5, kHeight).value_or(0);
        };
        QCOMPARE(triangles(), std::uint64_t{kColumns * kRows});
        for (std::uint32_t i = 0; i < kColumns * kRows; ++i) {
            if (i % kColumns == kColumns - 1) {
                continue;
            }
            // Where it and the next one overlap.
            const Rgb both = pixel(all, i % kColumns * 8 + 9, kHeight - 1 - i / kColumns * kPixelsPerMm - 2);
            QCOMPARE(both, (i % 2 == 0 ? Rgb{0, 255, 0} : Rgb{255, 0, 0}));
        }
        scene.lookDown({0, 0}, {0.4F * kColumns / 20, kRows / 20.0F});
        scene.draw(how, kPixelsPerMm * kColumns * 2 / 5, kHeight);
        QVERIFY2(triangles() > 0 && triangles() < 30, qPrintable(QString::number(triangles())));
    }

    /// More than a row of workgroups tests.
    void noneOfManyAreasIsLeftOut() {
        constexpr std::uint32_t kColumns = 350;
        constexpr std::uint32_t kRows = 200;
        static_assert(kColumns * kRows > shader::kCullRow * shader::kCullGroupSize);
        std::vector<shader::AreaInstance> places;
        for (std::uint32_t i = 0; i < kColumns * kRows; ++i) {
            places.push_back(at({0.4F * static_cast<float>(i % kColumns), 0.4F * static_cast<float>(i / kColumns)}));
        }
        SyntheticBoard board;
        board.addLayer(0.0F, 0.02F, {0.8F, 0.2F, 0.2F});
        board.addArea({{{0, 0}, {300, 0}, {0, 300}}}, places);
        Scene scene(board);
        scene.lookDown({-1, -1}, {141, 81});
        ViewSettings how = settings(Backend::Pull);
        how.is2d = true;
        how.isSmoothed = false;
        scene.draw(how, 1420, 820);
        const auto triangles = drawnTriangles(scene.scene, scene.camera, how, 1420, 820);
        QVERIFY(triangles);
        QCOMPARE(*triangles, std::uint64_t{kColumns * kRows});
    }

    /// A step of a hundredth of zoom moves all outlines. A level of detail that strays from the exact outlines by much
    /// less than that is not seen to come or go.
    void changesOfLevelAreNotSeen() {
        Scene scene(randomTraces(250, 21));
        scene.camera.fit(scene.model.boxMin, scene.model.boxMax, NamedView::Iso, 4.0F / 3.0F);
        double strays = 0.0;
        double moves = 0.0;
        for (int i = 0; i < 14; ++i) {
            scene.camera.zoom(1.15F, {0.1F, 0.1F}, 4.0F / 3.0F);
            const Image exact = scene.draw(settings(Backend::Impostor), 160, 120);
            strays += greyMse(exact, scene.draw(settings(Backend::Pull), 160, 120));
            scene.camera.zoom(1.01F, {0.1F, 0.1F}, 4.0F / 3.0F);
            moves += greyMse(exact, scene.draw(settings(Backend::Impostor), 160, 120));
        }
        QVERIFY2(strays < 0.09 * moves, qPrintable(QString::number(strays / moves)));
    }

    void autoTakesWhatSuitsTheDevice() {
        Scene scene(randomTraces(10, 1));
        scene.draw({});
        QCOMPARE(Gpu::get().presenter.stats().backend, Backend::Pull);
        ViewSettings unsmoothed;
        unsmoothed.isSmoothed = false;
        scene.draw(unsmoothed);
        const Backend expected = Gpu::get().device.caps().isCpu ? Backend::Pull : Backend::Raster;
        QCOMPARE(Gpu::get().presenter.stats().backend, expected);
        scene.lookDown({-10, -10}, {10, 10});
        scene.draw({});
        QCOMPARE(Gpu::get().presenter.stats().backend, Backend::Impostor);
    }
};

GPU_TEST_MAIN(BackendsTest)
#include "backends_test.moc"
