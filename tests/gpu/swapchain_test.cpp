#include <vulkan/vulkan.h>

#include <QtTest>

#include "render/frame/swapchain_presenter.h"
#include "tests/gpu/gpu_fixture.h"

using namespace render;
using Outcome = SwapchainPresenter::Outcome;

/// On a surface without a screen (VK_EXT_headless_surface).
class SwapchainTest : public QObject {
    Q_OBJECT

    /// Instance, surface and device, in the order they must go.
    struct Window {
        gpu::Instance instance;
        VkSurfaceKHR surface = VK_NULL_HANDLE;
        std::unique_ptr<gpu::Device> device;

        explicit Window(gpu::Instance made) : instance(std::move(made)) {
            const auto create = reinterpret_cast<PFN_vkCreateHeadlessSurfaceEXT>(
                vkGetInstanceProcAddr(instance.handle(), "vkCreateHeadlessSurfaceEXT"));
            VkHeadlessSurfaceCreateInfoEXT info{};
            info.sType = VK_STRUCTURE_TYPE_HEADLESS_SURFACE_CREATE_INFO_EXT;
            if (create != nullptr && create(instance.handle(), &info, nullptr, &surface) == VK_SUCCESS) {
                if (auto opened = gpu::Device::create(instance, surface)) {
                    device = std::make_unique<gpu::Device>(std::move(*opened));
                }
            }
        }
        ~Window() {
            device.reset();
            if (surface != VK_NULL_HANDLE) {
                vkDestroySurfaceKHR(instance.handle(), surface, nullptr);
            }
        }
        Window(const Window&) = delete;
        Window& operator=(const Window&) = delete;
    };

    static constexpr std::uint64_t kPatienceNs = 60'000'000'000;

    static void show(SwapchainPresenter& presenter, BoardScene* scene, const Camera& camera) {
        QVERIFY(presenter.draw(scene, camera, {}));
        QVERIFY(presenter.isDrawn(kPatienceNs));
        QCOMPARE(presenter.present(), Outcome::Done);
    }

    std::unique_ptr<Window> m_window;

private slots:
    void init() {
        gpu::InstanceOptions options;
        options.extensions = {VK_KHR_SURFACE_EXTENSION_NAME, VK_EXT_HEADLESS_SURFACE_EXTENSION_NAME};
        auto instance = gpu::Instance::create(options);
        if (!instance) {
            QSKIP(instance.error().text.c_str());
        }
        m_window = std::make_unique<Window>(std::move(*instance));
        if (m_window->device == nullptr) {
            QSKIP("no device presents to a headless surface");
        }
        QVERIFY(m_window->device->canPresentTo(m_window->surface));
    }
    void cleanup() { m_window.reset(); }

    void windowWithoutSizeIsSkipped() {
        SwapchainPresenter presenter(*m_window->device, m_window->surface);
        QCOMPARE(presenter.setSize(0, 0), Outcome::Skipped);
        QCOMPARE(presenter.setSize(0, 200), Outcome::Skipped);
    }

    void framesAreDrawnThroughResizes() {
        const BoardModel model = test::everything().build();
        BoardScene scene(*m_window->device, model);
        scene.setStyles(test::everything().styles());
        Camera camera;
        SwapchainPresenter presenter(*m_window->device, m_window->surface);
        for (const std::uint32_t size : {300U, 200U, 200U, 350U}) {
            QCOMPARE(presenter.setSize(size, 200), Outcome::Done);
            camera.fit(model.boxMin, model.boxMax, NamedView::Iso, static_cast<float>(size) / 200.0F);
            for (int frame = 0; frame < 4; ++frame) {
                show(presenter, &scene, camera);
            }
            QCOMPARE(presenter.setSize(0, 0), Outcome::Skipped);  // minimised
        }
        QVERIFY(presenter.stats().cpuMs > 0.0);
        QVERIFY(presenter.stats().backend != Backend::Auto);
    }

    void emptyWindowIsDrawn() {
        SwapchainPresenter presenter(*m_window->device, m_window->surface);
        QCOMPARE(presenter.setSize(64, 64), Outcome::Done);
        show(presenter, nullptr, Camera());
    }

    void twoPresentersShareADeviceAndAScene() {
        const BoardModel model = test::everything().build();
        BoardScene scene(*m_window->device, model);
        scene.setStyles(test::everything().styles());
        Camera camera;
        camera.fit(model.boxMin, model.boxMax, NamedView::Top, 1.0F);
        SwapchainPresenter window(*m_window->device, m_window->surface);
        QCOMPARE(window.setSize(100, 100), Outcome::Done);
        OffscreenPresenter offscreen(*m_window->device);
        for (int frame = 0; frame < 3; ++frame) {
            show(window, &scene, camera);
            QVERIFY(offscreen.render(scene, camera, {}, 100, 100));
        }
    }
};

GPU_TEST_MAIN(SwapchainTest)
#include "swapchain_test.moc"
