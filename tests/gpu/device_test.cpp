#include <QtTest>
#include <numeric>
#include <thread>

#include "render/gpu/barrier.h"
#include "render/gpu/frame_ring.h"
#include "render/gpu/pipeline_store.h"
#include "tests/gpu/gpu_fixture.h"
#include "tests/gpu/synthetic_board.h"

using namespace render;

class DeviceTest : public QObject {
    Q_OBJECT

    /// Sets an environment variable for one test.
    class Environment {
    public:
        Environment(const char* name, const char* value)
            : m_name(name), m_was(qgetenv(name)), m_wasSet(qEnvironmentVariableIsSet(name)) {
            qputenv(name, value);
        }
        ~Environment() { m_wasSet ? qputenv(m_name, m_was) : qunsetenv(m_name); }
        Environment(const Environment&) = delete;
        Environment& operator=(const Environment&) = delete;

    private:
        const char* m_name;
        QByteArray m_was;
        bool m_wasSet;
    };

private slots:
    void missingDriverIsSaidInPlainWords() {
        const Environment drivers("VK_DRIVER_FILES", "/nonexistent");
        const Environment olderLoaders("VK_ICD_FILENAMES", "/nonexistent");
        auto instance = gpu::Instance::create({});
        // Loaders differ in where they notice: when the instance is made or when its devices are listed.
        base::Error error;
        if (instance) {
            const auto device = gpu::Device::create(*instance);
            QVERIFY(!device);
            error = device.error();
        } else {
            error = instance.error();
        }
        QCOMPARE(error.code, base::ErrorCode::DeviceFailed);
        QVERIFY2(error.text.starts_with("No Vulkan driver was found."), error.text.c_str());
    }

    void missingExtensionIsNamed() {
        gpu::InstanceOptions options;
        options.extensions = {"VK_NOBODY_has_this"};
        const auto instance = gpu::Instance::create(options);
        QVERIFY(!instance);
        QCOMPARE(instance.error().code, base::ErrorCode::DeviceFailed);
        QVERIFY(instance.error().text.find("VK_NOBODY_has_this") != std::string::npos);
    }

    void deviceNameFiltersDevices() {
        auto instance = gpu::Instance::create({});
        QVERIFY(instance);
        std::string name;
        {
            const auto device = gpu::Device::create(*instance);
            QVERIFY(device);
            name = device->caps().name;
            QVERIFY(!name.empty());
            QVERIFY(device->caps().maxImageSize >= 4096);
            QVERIFY(device->caps().memoryBudgetBytes > 0);
        }
        {
            const Environment wanted("COPPERSCOPE_DEVICE", name.substr(0, 5).c_str());
            QVERIFY(gpu::Device::create(*instance));
        }
        const Environment unwanted("COPPERSCOPE_DEVICE", "no such device");
        const auto none = gpu::Device::create(*instance);
        QVERIFY(!none);
        QVERIFY2(none.error().text.find(name) != std::string::npos, none.error().text.c_str());
    }

    /// Windows and pictures that come and go make none again.
    void pipelinesAreMadeOnceForADevice() {
        const auto countAfterAPicture = [] {
            test::Gpu& gpu = test::Gpu::get();
            const BoardModel nothing;
            BoardScene scene(gpu.device, nothing);
            OffscreenPresenter presenter(gpu.device);
            const auto image = presenter.render(scene, Camera(), {}, 64, 64);
            return image ? gpu.device.pipelines().count() : 0;
        };
        const std::size_t count = countAfterAPicture();
        QVERIFY(count > 0);
        QCOMPARE(countAfterAPicture(), count);
    }

    /// So a window need not wait for any: whoever asks before a picture can have them made on another thread.
    void aPictureMakesWhatIsMissingAndNoMore() {
        test::Gpu& gpu = test::Gpu::get();
        BoardScene scene(gpu.device, test::everything().build());
        OffscreenPresenter presenter(gpu.device);
        for (const Backend backend : {Backend::Pull, Backend::Impostor, Backend::Auto}) {
            for (const bool isSmoothed : {true, false}) {
                for (const NamedView view : {NamedView::Top, NamedView::Iso}) {
                    ViewSettings settings;
                    settings.backend = backend;
                    settings.isSmoothed = isSmoothed;
                    Camera camera;
                    camera.setOrthographic(true);
                    camera.fit({-20.0F, -20.0F, 0.0F}, {20.0F, 20.0F, 2.0F}, view, 1.0F);
                    if (const auto prepare = presenter.preparation(scene, camera, settings, 64, 64)) {
                        prepare();
                    }
                    const std::size_t count = gpu.device.pipelines().count();
                    QVERIFY(!presenter.preparation(scene, camera, settings, 64, 64));
                    QVERIFY(presenter.render(scene, camera, settings, 64, 64));
                    QCOMPARE(gpu.device.pipelines().count(), count);
                }
            }
        }
        QVERIFY(OffscreenPresenter(gpu.device).preparation(scene, Camera(), {}, 64, 64));
    }

    /// A device that draws may let whoever makes an image wait until it has drawn.
    void picturesOfAnotherSizeArePreparedToo() {
        test::Gpu& gpu = test::Gpu::get();
        const BoardModel nothing;
        BoardScene scene(gpu.device, nothing);
        OffscreenPresenter presenter(gpu.device);
        QVERIFY(presenter.render(scene, Camera(), {}, 64, 64));
        QVERIFY(!presenter.preparation(scene, Camera(), {}, 64, 64));
        const auto prepare = presenter.preparation(scene, Camera(), {}, 96, 48);
        QVERIFY(prepare);
        std::thread(prepare).join();
        QVERIFY(!presenter.preparation(scene, Camera(), {}, 96, 48));
        const auto image = presenter.render(scene, Camera(), {}, 96, 48);
        QVERIFY(image && image->width == 96 && image->height == 48);
    }

    void uploadsLargerThanTheStagingMemoryArriveWhole() {
        gpu::Device& device = test::Gpu::get().device;
        gpu::FrameRing ring(device, 2, "test");
        std::vector<std::uint32_t> values(9'000'000);  // 36 MB: three pieces, the last one partly filled
        std::iota(values.begin(), values.end(), 17U);
        const gpu::Buffer there(device, {"there", values.size() * 4, gpu::MemoryUse::Geometry});
        const gpu::Buffer back(device, {"back", values.size() * 4, gpu::MemoryUse::Staging, gpu::HostAccess::Reads});
        QVERIFY(gpu::upload(ring, there, std::as_bytes(std::span(values))));
        gpu::Frame* frame = ring.begin();
        QVERIFY(frame != nullptr);
        const VkBufferCopy region{0, 0, values.size() * 4};
        vkCmdCopyBuffer(frame->commands(), there.handle(), back.handle(), 1, &region);
        gpu::memoryBarrier(frame->commands(), gpu::kCopyWrite, gpu::kHostRead);
        QVERIFY(ring.end());
        QVERIFY(ring.wait());
        QVERIFY(std::memcmp(back.mapped().data(), values.data(), values.size() * 4) == 0);
    }

    void stagesOfAFrameAreTimedWhereAsked() {
        gpu::Device& device = test::Gpu::get().device;
        gpu::FrameRing ring(device, 1, "test");
        const auto draw = [&] {
            gpu::Frame* frame = ring.begin();
            for (const char* stage : {"first", "second", "first"}) {
                frame->beginStage(stage);
            }
            frame->endTiming();
            frame->beginStage("not timed");
            return ring.end() && ring.wait();
        };
        QVERIFY(draw());
        QVERIFY(ring.stages().empty());
        ring.timeStages();
        QVERIFY(draw());
        if (!device.caps().hasTimestamps) {
            QVERIFY(ring.stages().empty());
            return;
        }
        QCOMPARE(ring.stages().size(), std::size_t{2});
        QCOMPARE(ring.stages()[0].name, "first");
        QCOMPARE(ring.stages()[1].name, "second");
        QVERIFY(ring.stages()[0].ms + ring.stages()[1].ms <= ring.gpuMs() * 1.0001);
    }

    void aFrameOfManyStagesTimesTheFirst() {
        gpu::FrameRing ring(test::Gpu::get().device, 1, "test");
        ring.timeStages();
        gpu::Frame* frame = ring.begin();
        for (int i = 0; i < 2000; ++i) {
            frame->beginStage(i < 100 ? "first" : "last");
        }
        QVERIFY(ring.end() && ring.wait());
        QCOMPARE(ring.stages().size(), test::Gpu::get().device.caps().hasTimestamps ? std::size_t{2} : std::size_t{0});
    }

    void memoryHandedOutInAFrameStaysApart() {
        gpu::Device& device = test::Gpu::get().device;
        gpu::FrameRing ring(device, 1, "test");
        gpu::Frame* frame = ring.begin();
        QVERIFY(frame != nullptr);
        // Grows past the first 64 KiB while earlier slices are still in use.
        std::vector<gpu::Frame::Slice> slices;
        for (int i = 0; i < 40; ++i) {
            slices.push_back(frame->put(std::vector(10'001, static_cast<std::byte>(i))));
        }
        for (int i = 0; i < 40; ++i) {
            const auto& bytes = slices[static_cast<std::size_t>(i)].bytes;
            QCOMPARE(bytes.size(), std::size_t{10'001});
            QVERIFY(
                std::all_of(bytes.begin(), bytes.end(), [&](std::byte b) { return b == static_cast<std::byte>(i); }));
            QCOMPARE(slices[static_cast<std::size_t>(i)].address % 16, VkDeviceAddress{0});
        }
        QVERIFY(ring.end());
        QVERIFY(ring.wait());
    }

    void droppedBuffersAreFreedOnlyAfterTheNextSubmission() {
        gpu::Device& device = test::Gpu::get().device;
        device.waitIdle();
        const std::uint64_t before = device.memoryReport().of(gpu::MemoryUse::Transient);
        {
            const gpu::Buffer buffer(device, {"short-lived", 1 << 20, gpu::MemoryUse::Transient});
            QVERIFY(device.memoryReport().of(gpu::MemoryUse::Transient) >= before + (1 << 20));
        }
        QVERIFY(device.memoryReport().of(gpu::MemoryUse::Transient) > before);  // a frame being recorded may use it
        const std::uint64_t number = device.submit({});
        QVERIFY(device.wait(number));
        QCOMPARE(device.memoryReport().of(gpu::MemoryUse::Transient), before);
    }
};

GPU_TEST_MAIN(DeviceTest)
#include "device_test.moc"
