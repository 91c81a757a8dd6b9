#pragma once

#include <vector>

#include "render/gpu/deferred_destroy.h"

namespace render::gpu {

/// The images of a window's surface. Pictures are copied into them, so that any format the surface has will do.
class Swapchain {
public:
    enum class Outcome {
        Done,
        Skipped,    ///< nothing to draw on: the window has no size yet, or its surface is gone
        DeviceLost  ///< or out of memory: make a new device
    };

    /// An image to copy the next picture to, with the semaphores of the submission that does it.
    struct Target {
        VkImage image = VK_NULL_HANDLE;
        VkSemaphore available = VK_NULL_HANDLE;  ///< to wait for
        VkSemaphore finished = VK_NULL_HANDLE;   ///< to signal
        std::uint32_t index = 0;
    };

    Swapchain(Device& device, VkSurfaceKHR surface);
    ~Swapchain();
    Swapchain(Swapchain&&) noexcept = default;
    Swapchain& operator=(Swapchain&&) = delete;

    /// Used where the surface has no size of its own; a changed size remakes the images with the next `makeReady`.
    void resize(VkExtent2D size);
    /// Makes the images where there are none of the window's size. Waits for the device if it does.
    [[nodiscard]] Outcome makeReady();
    /// The next image, of size `extent()`. Skipped where the window has got another size since `makeReady`.
    [[nodiscard]] Outcome acquire(Target& target);
    /// After the submission that signals `target.finished`.
    [[nodiscard]] Outcome present(const Target& target);

    [[nodiscard]] VkExtent2D extent() const { return m_extent; }
    /// The format to draw in so that a plain copy into the images shows the right colours: their channel order, sRGB
    /// encoded.
    [[nodiscard]] VkFormat drawFormat() const { return m_drawFormat; }

private:
    bool remake();
    void createImages();
    void drop();

    Device* m_device;
    VkSurfaceKHR m_surface;
    VkExtent2D m_wanted{};
    VkExtent2D m_requested{};  ///< what `m_wanted` was when the images were made
    VkExtent2D m_extent{};
    VkSurfaceFormatKHR m_format{};
    VkFormat m_drawFormat = VK_FORMAT_UNDEFINED;
    bool m_isStale = true;
    Unique<VkSwapchainKHR> m_handle;
    std::vector<VkImage> m_images;
    std::vector<Unique<VkSemaphore>> m_finished;   ///< per image: presenting may read it long after the frame
    std::vector<Unique<VkSemaphore>> m_available;  ///< in turn
    std::size_t m_next = 0;
};

}  // namespace render::gpu
