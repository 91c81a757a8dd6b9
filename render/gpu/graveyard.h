#pragma once

#include <cstdint>
#include <deque>
#include <unordered_map>
#include <utility>

#include "render/gpu/device.h"

namespace render::gpu {

/// Keeps dropped Vulkan objects until the submissions that may use them are done, and books memory by use. Owned by the
/// Device; the only place that calls vkDestroy*.
class Graveyard {
public:
    explicit Graveyard(VkDevice device) : m_device(device) {}
    Graveyard(const Graveyard&) = delete;
    Graveyard& operator=(const Graveyard&) = delete;

    /// The object may be used by all commands submitted until now and by those being recorded: the next submission
    /// still counts.
    void retire(VkObjectType type, std::uint64_t handle) { m_retired.push_back({m_submitted + 1, type, handle}); }
    void noteSubmission(std::uint64_t number) { m_submitted = number; }
    /// Frees what no submission after `done` can use.
    void collect(std::uint64_t done);
    /// For an idle device.
    void collectAll() { collect(~std::uint64_t{0}); }

    void noteAllocation(VkDeviceMemory memory, MemoryUse use, std::uint64_t bytes);
    [[nodiscard]] const MemoryReport& memory() const { return m_report; }

private:
    struct Retired {
        std::uint64_t after;
        VkObjectType type;
        std::uint64_t handle;
    };
    struct Allocation {
        MemoryUse use;
        std::uint64_t bytes;
    };
    void destroy(const Retired& object);
    void noteFree(std::uint64_t memory);

    VkDevice m_device;
    std::uint64_t m_submitted = 0;
    std::deque<Retired> m_retired;
    std::unordered_map<std::uint64_t, Allocation> m_allocations;
    MemoryReport m_report;
};

// Handles are distinct pointer types on 64-bit machines, the only ones we build for.
static_assert(sizeof(void*) == 8);
template <class Handle>
inline constexpr VkObjectType kObjectType = VK_OBJECT_TYPE_UNKNOWN;
template <>
inline constexpr VkObjectType kObjectType<VkBuffer> = VK_OBJECT_TYPE_BUFFER;
template <>
inline constexpr VkObjectType kObjectType<VkImage> = VK_OBJECT_TYPE_IMAGE;
template <>
inline constexpr VkObjectType kObjectType<VkImageView> = VK_OBJECT_TYPE_IMAGE_VIEW;
template <>
inline constexpr VkObjectType kObjectType<VkDeviceMemory> = VK_OBJECT_TYPE_DEVICE_MEMORY;
template <>
inline constexpr VkObjectType kObjectType<VkPipeline> = VK_OBJECT_TYPE_PIPELINE;
template <>
inline constexpr VkObjectType kObjectType<VkPipelineLayout> = VK_OBJECT_TYPE_PIPELINE_LAYOUT;
template <>
inline constexpr VkObjectType kObjectType<VkShaderModule> = VK_OBJECT_TYPE_SHADER_MODULE;
template <>
inline constexpr VkObjectType kObjectType<VkCommandPool> = VK_OBJECT_TYPE_COMMAND_POOL;
template <>
inline constexpr VkObjectType kObjectType<VkQueryPool> = VK_OBJECT_TYPE_QUERY_POOL;
template <>
inline constexpr VkObjectType kObjectType<VkSemaphore> = VK_OBJECT_TYPE_SEMAPHORE;
template <>
inline constexpr VkObjectType kObjectType<VkSwapchainKHR> = VK_OBJECT_TYPE_SWAPCHAIN_KHR;

/// The one owner of a Vulkan object: move-only, hands it to the graveyard when dropped. Classes above it default their
/// moves.
template <class Handle>
class Unique {
public:
    Unique() = default;
    /// Takes `handle`, names it `label`.
    Unique(Device& device, Handle handle, std::string_view label) : m_graveyard(&device.graveyard()), m_handle(handle) {
        device.name(kObjectType<Handle>, reinterpret_cast<std::uint64_t>(handle), label);
    }
    ~Unique() { reset(); }
    Unique(Unique&& other) noexcept
        : m_graveyard(other.m_graveyard), m_handle(std::exchange(other.m_handle, VK_NULL_HANDLE)) {}
    Unique& operator=(Unique&& other) noexcept {
        std::swap(m_graveyard, other.m_graveyard);
        std::swap(m_handle, other.m_handle);
        return *this;
    }

    [[nodiscard]] Handle get() const { return m_handle; }
    explicit operator bool() const { return m_handle != VK_NULL_HANDLE; }
    void reset() {
        if (m_handle != VK_NULL_HANDLE) {
            m_graveyard->retire(kObjectType<Handle>, reinterpret_cast<std::uint64_t>(m_handle));
            m_handle = VK_NULL_HANDLE;
        }
    }

private:
    Graveyard* m_graveyard = nullptr;
    Handle m_handle = VK_NULL_HANDLE;
};

}  // namespace render::gpu
