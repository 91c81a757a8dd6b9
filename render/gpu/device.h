#pragma once

#include <vulkan/vulkan.h>

#include <array>
#include <atomic>
#include <cstdint>
#include <memory>
#include <string>
#include <string_view>

#include "model/base/result.h"
#include "render/gpu/instance.h"
#include "render/gpu/pipeline_cache_file.h"

namespace render::gpu {

class DeferredDestroy;
class MemoryBlocks;
class PipelineStore;

/// What memory is spent on.
enum class MemoryUse : std::uint8_t {
    Geometry,   ///< the board itself
    Transient,  ///< rewritten every frame: draw lists, commands
    Targets,    ///< colour and depth images
    Staging     ///< on its way to or from the device
};
inline constexpr std::size_t kMemoryUseCount = 4;

/// Device memory of resources, by use, and what the device gave for them.
struct MemoryReport {
    std::array<std::uint64_t, kMemoryUseCount> bytes{};  ///< as many as the device says that each resource needs
    std::uint64_t heldBytes = 0;                         ///< with the room in blocks that is free (memory_blocks.h)
    std::uint64_t allocations = 0;                       ///< what is held, in so many pieces
    /// Of all resources.
    [[nodiscard]] std::uint64_t total() const;
    [[nodiscard]] std::uint64_t of(MemoryUse use) const { return bytes[static_cast<std::size_t>(use)]; }
};

/// What the device can do, decided once.
struct Caps {
    std::string name;
    std::string driver;          ///< driver and version in the driver's own words
    bool isCpu = false;          ///< a software device
    bool hasMeshShader = false;  ///< task and mesh shaders, enabled
    bool hasAtomic64 = false;    ///< 64-bit atomics on buffers, enabled
    bool hasTimestamps = false;
    double timestampPeriodNs = 0.0;
    bool canSmooth = false;                ///< 4x multisampling for our colour and depth formats
    bool canShadeSamples = false;          ///< fragment shaders for every sample by itself
    std::uint32_t maxImageSize = 0;        ///< pixels along one side
    std::uint32_t maxTaskGroups = 0;       ///< along x, 0 without mesh shaders
    std::uint64_t maxAllocationBytes = 0;  ///< of one image or buffer
    std::uint64_t memoryBudgetBytes = 0;   ///< of the largest device-local heap, when the device was made
    PipelineCacheOwner cacheOwner;         ///< of the pipelines it compiles
};

/// A physical device that can do all we need.
struct DeviceChoice {
    VkPhysicalDevice physical = VK_NULL_HANDLE;
    std::uint32_t queueFamily = 0;
    bool hasSwapchain = false;
    Caps caps;
};

/// Faults to order, for tests. Counts begin when they are set, the next one being 1; 0: none.
struct Faults {
    std::uint64_t failAllocation = 0;    ///< of memory for a resource: there is none
    bool failsFromThere = false;         ///< nor has any after it
    std::uint64_t loseAtSubmission = 0;  ///< finds the device lost
    std::uint64_t mostBytes = 0;         ///< of one allocation, where that is less than the device can
    std::uint64_t loseAtWait = 0;        ///< for a submission, or look whether it is done: finds the device lost
};

/// One submission to the queue.
struct Submission {
    VkCommandBuffer commands = VK_NULL_HANDLE;
    VkSemaphore waitFor = VK_NULL_HANDLE;  ///< waited for at colour output and transfer
    VkSemaphore signal = VK_NULL_HANDLE;
};

/// Of a device in software, which draws in threads of its own.
enum class DeviceThreads : std::uint8_t {
    Equal,     ///< they take their share of the processors
    StepBack,  ///< others of the program, and of other programs, come first (base::becomeBackground)
};

/// A Vulkan 1.3 device with one queue that draws, computes, copies and (when requested) presents. Compiled pipelines
/// are kept for the next start of the program (pipeline_cache_file.h). Everything on it happens on one thread.
/// Move-only; resources and presenters refer to it, so it neither moves nor dies before them.
class Device {
public:
    /// Takes the best device: discrete before integrated before software; COPPERSCOPE_DEVICE=text keeps only devices
    /// whose name contains the text. With `presentTo` only devices that can present to that surface count. Errors:
    /// DeviceFailed, naming the devices that were found and what they lack.
    [[nodiscard]] static base::Result<Device> create(const Instance& instance, VkSurfaceKHR presentTo = VK_NULL_HANDLE,
                                                     DeviceThreads threads = DeviceThreads::Equal);

    [[nodiscard]] VkDevice handle() const { return m_state->handle; }
    [[nodiscard]] VkPhysicalDevice physical() const { return m_state->choice.physical; }
    [[nodiscard]] VkQueue queue() const { return m_state->queue; }
    [[nodiscard]] std::uint32_t queueFamily() const { return m_state->choice.queueFamily; }
    [[nodiscard]] const Caps& caps() const { return m_state->choice.caps; }
    [[nodiscard]] bool canPresentTo(VkSurfaceKHR surface) const;
    [[nodiscard]] VkPipelineCache pipelineCache() const { return m_state->pipelineCache; }
    [[nodiscard]] PipelineStore& pipelines() const { return *m_state->pipelines; }

    /// Queues the commands and returns the number of this submission, or 0 if the device is lost.
    std::uint64_t submit(const Submission& submission);
    /// Waits until submission `number` is done; false if the device is lost.
    bool wait(std::uint64_t number);
    /// Whether submission `number` is done; waits so many nanoseconds for it at most. Never, once the device is lost.
    [[nodiscard]] bool isDone(std::uint64_t number, std::uint64_t patienceNs = 0);
    /// Waits for everything and frees what was retired.
    void waitIdle();
    /// From now on submit and wait fail.
    void markLost() { m_state->isLost = true; }
    /// Has a call found the device lost, by what it returned? Then marks it so.
    bool noteLoss(VkResult result);
    [[nodiscard]] bool isLost() const { return m_state->isLost; }
    void inject(const Faults& faults) { m_state->faults = faults; }
    /// Those to come.
    [[nodiscard]] const Faults& faults() const { return m_state->faults; }
    /// Counts memory for a resource; false if the device cannot have it: too large, or a fault.
    [[nodiscard]] bool mayAllocate(std::uint64_t bytes);
    /// Whether one allocation may have so many bytes.
    [[nodiscard]] bool isWithinLimits(std::uint64_t bytes) const;

    /// Where resources go when their owners drop them: freed after the submissions that may use them.
    [[nodiscard]] DeferredDestroy& deferred() const { return *m_state->deferred; }
    /// Where they get their memory.
    [[nodiscard]] MemoryBlocks& memory() const { return *m_state->memory; }
    [[nodiscard]] MemoryReport memoryReport() const;

    /// Gives a Vulkan object the name that validation messages and frame debuggers show.
    void name(VkObjectType type, std::uint64_t handle, std::string_view label) const;
    /// Names the commands between, for frame debuggers.
    void beginLabel(VkCommandBuffer commands, const char* label) const;
    void endLabel(VkCommandBuffer commands) const;

private:
    struct State {
        DeviceChoice choice;
        VkInstance instance = VK_NULL_HANDLE;
        VkDevice handle = VK_NULL_HANDLE;
        VkQueue queue = VK_NULL_HANDLE;
        VkPipelineCache pipelineCache = VK_NULL_HANDLE;
        std::unique_ptr<PipelineCacheFile> cacheFile;
        VkSemaphore timeline = VK_NULL_HANDLE;
        std::uint64_t submitted = 0;
        std::atomic<bool> isLost = false;
        Faults faults;
        PFN_vkSetDebugUtilsObjectNameEXT setName = nullptr;  ///< null, as the next two: nobody listens
        PFN_vkCmdBeginDebugUtilsLabelEXT beginLabel = nullptr;
        PFN_vkCmdEndDebugUtilsLabelEXT endLabel = nullptr;
        std::unique_ptr<MemoryBlocks> memory;
        std::unique_ptr<DeferredDestroy> deferred;
        std::unique_ptr<PipelineStore> pipelines;

        State();
        State(const State&) = delete;
        State& operator=(const State&) = delete;
        ~State();
        VkResult createDevice(DeviceThreads threads);
        void createObjects(bool hasDebugUtils);
        void createPipelineCache();
        void savePipelineCache();
        [[nodiscard]] VkResult waitFor(std::uint64_t number, std::uint64_t patienceNs);
    };
    explicit Device(std::unique_ptr<State> state) : m_state(std::move(state)) {}
    std::unique_ptr<State> m_state;
};

}  // namespace render::gpu
