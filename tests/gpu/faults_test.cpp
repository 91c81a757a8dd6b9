// A device that has no memory left, or is lost, at every place where that can happen: a picture or a plain error, and
// nothing left behind.
#include <QtTest>

#include "tests/gpu/gpu_fixture.h"

using namespace render;
using namespace render::test;

namespace {

constexpr std::uint32_t kWidth = 160;
constexpr std::uint32_t kHeight = 120;
/// More than one normal run makes of either.
constexpr std::uint64_t kMost = 200;

enum class Loaded { AtOnce, WithTheFrame };

/// When the device is lost.
enum class Loss { AtSubmission, AtWait };

base::Result<BoardScene> sceneOf(gpu::Device& device, const std::shared_ptr<const BoardModel>& model, Loaded when) {
    if (when == Loaded::AtOnce) {
        return BoardScene::make(device, *model);
    }
    return BoardScene::makeUnloaded(device, model);
}

/// Loads a board and draws it once.
base::Result<Image> loadAndDraw(gpu::Device& device, const SyntheticBoard& board, Loaded when = Loaded::AtOnce) {
    const auto shared = std::make_shared<const BoardModel>(board.build());
    const BoardModel& model = *shared;
    base::Result<BoardScene> scene = sceneOf(device, shared, when);
    if (!scene) {
        return scene.error();
    }
    scene->setStyles(board.styles());
    scene->setStates(statesOf(std::array{model::ElementId{1}}));
    Camera camera;
    camera.fit(model.boxMin, model.boxMax, NamedView::Iso, 4.0F / 3.0F);
    ViewSettings settings;
    settings.backend = Backend::Pull;
    const std::vector<std::uint8_t> laid(std::size_t{kWidth} * kHeight * 4, 128);
    settings.inPlane = {{kWidth, kHeight, laid.data()}, model.boxMax.z};
    OffscreenPresenter presenter(device);
    return presenter.render(*scene, camera, settings, kWidth, kHeight);
}

gpu::Device freshDevice() {
    return std::move(*gpu::Device::create(Gpu::get().instance));
}

bool isPlain(const base::Error& error) {
    const std::string& text = error.text;
    return error.code == base::ErrorCode::DeviceFailed && text.size() > 20 && text.ends_with(".") &&
           text.find("VK_") == std::string::npos && text.find("vk") == std::string::npos;
}

}  // namespace

class FaultsTest : public QObject {
    Q_OBJECT

private slots:
    void wheneverMemoryRunsOutThereIsAPictureOrAnError_data() {
        QTest::addColumn<bool>("isLasting");
        QTest::addColumn<Loaded>("when");
        QTest::newRow("once") << false << Loaded::AtOnce;
        QTest::newRow("for good") << true << Loaded::AtOnce;
        QTest::newRow("once, loaded with the frame") << false << Loaded::WithTheFrame;
        QTest::newRow("for good, loaded with the frame") << true << Loaded::WithTheFrame;
    }
    void wheneverMemoryRunsOutThereIsAPictureOrAnError() {
        QFETCH(bool, isLasting);
        QFETCH(Loaded, when);
        const SyntheticBoard board = everything();
        gpu::Device device = freshDevice();
        const base::Result<Image> expected = loadAndDraw(device, board);
        QVERIFY(expected);
        device.waitIdle();
        const std::uint64_t atRest = device.memoryReport().total();
        int failures = 0;
        int rescues = 0;
        std::uint64_t n = 1;
        for (bool wasReached = true; wasReached; ++n) {
            QVERIFY(n < kMost);
            device.inject({n, isLasting, 0});
            const base::Result<Image> image = loadAndDraw(device, board, when);
            wasReached = isLasting ? !image : device.faults().failAllocation == 0;
            device.inject({});
            if (!image) {
                QVERIFY2(isPlain(image.error()), image.error().text.c_str());
                QVERIFY(wasReached);
                ++failures;
            } else {
                QCOMPARE(image->rgba.size(), expected->rgba.size());
                rescues += wasReached ? 1 : 0;
            }
            if (device.isLost()) {
                device = freshDevice();
            }
            device.waitIdle();
            QCOMPARE(device.memoryReport().total(), atRest);
        }
        qInfo("faults injected: %d times device memory refused, %d errors and %d pictures of it", int(n) - 2, failures,
              rescues);
        QVERIFY(isLasting ? failures > 10 : failures > 1 && rescues > 8);
        const base::Result<Image> again = loadAndDraw(device, board, when);
        QVERIFY(again);
        QCOMPARE(differingPixels(*again, *expected, 0), std::size_t{0});
    }

    /// Devices limit what one buffer may hold. Buffers are read by address, so no smaller limit of storage buffers
    /// counts (no descriptors are made).
    void aBufferThatMayNotBeSoLargeIsAnErrorOrAPictureWithLess() {
        const SyntheticBoard board = everything();
        gpu::Device device = freshDevice();
        const base::Result<Image> expected = loadAndDraw(device, board);
        int errors = 0;
        int pictures = 0;
        for (std::uint64_t most = 64; most <= 128ULL << 20U; most *= 2) {
            device.inject({.mostBytes = most});
            const base::Result<Image> image = loadAndDraw(device, board);
            errors += image ? 0 : 1;
            pictures += image ? 1 : 0;
            QVERIFY2(image || isPlain(image.error()), image ? "" : image.error().text.c_str());
            QVERIFY(image || pictures == 0);  // more room never does worse
            if (most == 128ULL << 20U) {
                QCOMPARE(differingPixels(*image, *expected, 0), std::size_t{0});
            }
            if (device.isLost()) {
                device = freshDevice();
            }
        }
        qInfo("faults injected: %d limits of a buffer, %d errors and %d pictures of it", errors + pictures, errors,
              pictures);
        QVERIFY(errors > 3 && pictures > 3);
    }

    /// A scene that could not be loaded can be later.
    void whatDidNotFitIsLoadedOnceItDoes() {
        const SyntheticBoard board = everything();
        gpu::Device device = freshDevice();
        BoardScene scene = BoardScene::makeUnloaded(device, std::make_shared<const BoardModel>(board.build()));
        device.inject({.mostBytes = 64});
        const base::Status first = scene.load();
        QVERIFY(!first && isPlain(first.error()));
        QCOMPARE(scene.geometryBytes(), std::uint64_t{0});
        device.inject({});
        QVERIFY(scene.load());
        QVERIFY(scene.geometryBytes() > 0);
    }

    void wheneverTheDeviceIsLostThereIsAnError_data() {
        QTest::addColumn<Loss>("loss");
        QTest::newRow("when work is given to it") << Loss::AtSubmission;
        QTest::newRow("while it works") << Loss::AtWait;
    }
    void wheneverTheDeviceIsLostThereIsAnError() {
        QFETCH(Loss, loss);
        const auto fault = loss == Loss::AtWait ? &gpu::Faults::loseAtWait : &gpu::Faults::loseAtSubmission;
        const SyntheticBoard board = everything();
        std::uint64_t n = 1;
        for (bool wasReached = true; wasReached; ++n) {
            QVERIFY(n < kMost);
            gpu::Device device = freshDevice();
            gpu::Faults faults;
            faults.*fault = n;
            device.inject(faults);
            const base::Result<Image> image = loadAndDraw(device, board);
            wasReached = device.faults().*fault == 0;
            QCOMPARE(!image, wasReached);
            QCOMPARE(device.isLost(), wasReached);
            if (!image) {
                QVERIFY2(isPlain(image.error()), image.error().text.c_str());
                QVERIFY(image.error().text.find("lost") != std::string::npos);
            }
        }
        qInfo("faults injected: %d times the device was lost", int(n) - 2);
        QVERIFY(n > 2);
    }

    /// Nobody waits for a window's frames: they look whether they are done.
    void aDeviceThatIsLostWhileItDrawsIsNoticed() {
        const SyntheticBoard board = everything();
        gpu::Device device = freshDevice();
        const BoardModel model = board.build();
        base::Result<BoardScene> scene = BoardScene::make(device, model);
        QVERIFY(scene);
        scene->setStyles(board.styles());
        Camera camera;
        camera.fit(model.boxMin, model.boxMax, NamedView::Iso, 4.0F / 3.0F);
        OffscreenPresenter presenter(device);
        QVERIFY(presenter.begin(*scene, camera, {}, kWidth, kHeight));
        device.inject({.loseAtWait = 1});
        QVERIFY(!presenter.isDone());
        QVERIFY(device.isLost());
        QVERIFY(!presenter.isDone(1'000'000'000));
    }
};

GPU_TEST_MAIN(FaultsTest)
#include "faults_test.moc"
