#pragma once

#include <cstdint>
#include <deque>
#include <functional>
#include <mutex>
#include <tuple>
#include <utility>

#include "render/gpu/device.h"

namespace render::gpu {

// Handles are distinct pointer types on 64-bit machines, the only ones we build for.
static_assert(sizeof(void*) == 8);

/// What debuggers call objects of this type, and what frees them.
template <class Handle>
struct Kind {
    VkObjectType type;
    void(VKAPI_PTR* destroy)(VkDevice, Handle, const VkAllocationCallbacks*);
};
inline constexpr std::tuple kKinds{
    Kind<VkBuffer>{VK_OBJECT_TYPE_BUFFER, vkDestroyBuffer},
    Kind<VkImage>{VK_OBJECT_TYPE_IMAGE, vkDestroyImage},
    Kind<VkImageView>{VK_OBJECT_TYPE_IMAGE_VIEW, vkDestroyImageView},
    Kind<VkPipeline>{VK_OBJECT_TYPE_PIPELINE, vkDestroyPipeline},
    Kind<VkPipelineLayout>{VK_OBJECT_TYPE_PIPELINE_LAYOUT, vkDestroyPipelineLayout},
    Kind<VkShaderModule>{VK_OBJECT_TYPE_SHADER_MODULE, vkDestroyShaderModule},
    Kind<VkCommandPool>{VK_OBJECT_TYPE_COMMAND_POOL, vkDestroyCommandPool},
    Kind<VkQueryPool>{VK_OBJECT_TYPE_QUERY_POOL, vkDestroyQueryPool},
    Kind<VkSemaphore>{VK_OBJECT_TYPE_SEMAPHORE, vkDestroySemaphore},
    Kind<VkSwapchainKHR>{VK_OBJECT_TYPE_SWAPCHAIN_KHR, vkDestroySwapchainKHR},
};
template <class Handle>
inline constexpr Kind<Handle> kKind = std::get<Kind<Handle>>(kKinds);

/// Keeps dropped Vulkan objects and their memory until the submissions that may use them are done. Owned by the Device.
/// Objects may be dropped on any thread.
class DeferredDestroy {
public:
    explicit DeferredDestroy(VkDevice device) : m_device(device) {}
    DeferredDestroy(const DeferredDestroy&) = delete;
    DeferredDestroy& operator=(const DeferredDestroy&) = delete;

    /// The object may be used by all commands submitted until now and by those being recorded: the next submission
    /// still counts.
    template <class Handle>
    void retire(Handle handle) {
        later([this, handle] { kKind<Handle>.destroy(m_device, handle, nullptr); });
    }
    /// The same for what is no Vulkan object. `destroy` is called on the device's thread.
    void later(std::function<void()> destroy) {
        const std::lock_guard lock(m_mutex);
        m_retired.push_back({m_submitted + 1, std::move(destroy)});
    }
    void noteSubmission(std::uint64_t number) {
        const std::lock_guard lock(m_mutex);
        m_submitted = number;
    }
    /// Frees what no submission after `done` can use.
    void collect(std::uint64_t done);
    /// For an idle device.
    void collectAll() { collect(~std::uint64_t{0}); }

private:
    struct Retired {
        std::uint64_t after;
        std::function<void()> destroy;
    };

    VkDevice m_device;
    std::mutex m_mutex;  ///< of the next two
    std::uint64_t m_submitted = 0;
    std::deque<Retired> m_retired;
};

/// The one owner of a Vulkan object: move-only, hands it to DeferredDestroy when dropped. Classes above it default
/// their moves.
template <class Handle>
class Unique {
public:
    Unique() = default;
    /// Takes `handle`, names it `label`.
    Unique(Device& device, Handle handle, std::string_view label) : m_deferred(&device.deferred()), m_handle(handle) {
        device.name(kKind<Handle>.type, reinterpret_cast<std::uint64_t>(handle), label);
    }
    ~Unique() { reset(); }
    Unique(Unique&& other) noexcept
        : m_deferred(other.m_deferred), m_handle(std::exchange(other.m_handle, VK_NULL_HANDLE)) {}
    Unique& operator=(Unique&& other) noexcept {
        std::swap(m_deferred, other.m_deferred);
        std::swap(m_handle, other.m_handle);
        return *this;
    }

    [[nodiscard]] Handle get() const { return m_handle; }
    explicit operator bool() const { return m_handle != VK_NULL_HANDLE; }
    void reset() {
        if (m_handle != VK_NULL_HANDLE) {
            m_deferred->retire(std::exchange(m_handle, VK_NULL_HANDLE));
        }
    }

private:
    DeferredDestroy* m_deferred = nullptr;
    Handle m_handle = VK_NULL_HANDLE;
};

}  // namespace render::gpu
