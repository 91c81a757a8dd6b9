#pragma once

#include <memory>
#include <string>

#include "render/frame/offscreen_presenter.h"
#include "render/gpu/device.h"
#include "tests/gpu/synthetic_board.h"

namespace render::test {

/// One device per test program, and a short way from a board to a picture. A failure to open the device ends the
/// program.
class Gpu {
public:
    static Gpu& get();
    /// Before the program ends: Debian 13's validation layer gives back what it needs of a device before objects with
    /// static duration go.
    static void close();

    gpu::Instance instance;
    gpu::Device device;
    OffscreenPresenter presenter;

private:
    static std::unique_ptr<Gpu>& held();
    Gpu(gpu::Instance madeInstance, gpu::Device madeDevice);
};

/// A board on the device with a camera on it.
struct Scene {
    BoardModel model;
    BoardScene scene;
    Camera camera;

    explicit Scene(const SyntheticBoard& board);
    Image draw(const ViewSettings& settings, std::uint32_t width = 640, std::uint32_t height = 480);
    /// Straight down on a rectangle, mm.
    void lookDown(glm::vec2 min, glm::vec2 max);
};

/// These elements lit, all others plain.
[[nodiscard]] std::vector<ElementState> statesOf(std::span<const model::ElementId> highlighted);

/// sRGB bytes of a pixel.
struct Rgb {
    int r = 0;
    int g = 0;
    int b = 0;
    bool operator==(const Rgb&) const = default;
};
[[nodiscard]] Rgb pixel(const Image& image, std::uint32_t x, std::uint32_t y);
[[nodiscard]] std::string describe(const Rgb& colour);
/// Largest difference of a component.
[[nodiscard]] int distance(const Rgb& a, const Rgb& b);

}  // namespace render::test

/// As QTEST_GUILESS_MAIN (with <QtTest>), and the device is closed before the end.
#define GPU_TEST_MAIN(TestObject)                                \
    int main(int argc, char** argv) {                            \
        const QCoreApplication application(argc, argv);          \
        auto test = std::make_unique<TestObject>();              \
        const int status = QTest::qExec(test.get(), argc, argv); \
        test.reset();                                            \
        render::test::Gpu::close();                              \
        return status;                                           \
    }
