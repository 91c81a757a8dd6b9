#pragma once

#include <algorithm>
#include <optional>
#include <ranges>
#include <span>
#include <vector>

#include "render/gpu/buffer.h"
#include "render/gpu/stage_time.h"

namespace render::gpu {

/// Commands being recorded, with memory that lives as long as they are in flight.
class Frame {
public:
    /// Host memory that the device reads at `address`.
    struct Slice {
        std::span<std::byte> bytes;
        VkBuffer buffer = VK_NULL_HANDLE;
        std::uint64_t offset = 0;
        VkDeviceAddress address = 0;
    };

    [[nodiscard]] VkCommandBuffer commands() const { return m_commands; }
    /// Its time is not measured: FrameRing::gpuMs stays that of the frames before.
    void leaveUntimed() { m_isTimed = false; }
    /// What is recorded from here on is no part of what is timed.
    void endTiming();
    /// What is recorded from here on, up to the next stage, goes by this name, a literal: in frame debuggers, and where
    /// FrameRing::timeStages was called. Beyond 510 stages the last one goes on.
    void beginStage(const char* name);
    /// A copy of the values, aligned to 16.
    template <std::ranges::contiguous_range Values>
    Slice put(const Values& values) {
        const auto bytes = std::as_bytes(std::span(values));
        const Slice slice = allocate(bytes.size());
        std::ranges::copy(bytes, slice.bytes.begin());
        return slice;
    }

private:
    friend class FrameRing;
    [[nodiscard]] Slice allocate(std::uint64_t size);
    [[nodiscard]] std::uint32_t stampCount() const { return kFirstStage + static_cast<std::uint32_t>(m_stages.size()); }
    void endStage();
    void stamp(std::uint32_t query, VkPipelineStageFlags2 after) const;

    /// Of the query pool: when it began and ended, then when its stages began.
    static constexpr std::uint32_t kFirstStage = 2;
    static constexpr std::uint32_t kMostStamps = 512;

    Device* m_device = nullptr;
    Unique<VkCommandPool> m_pool;
    Unique<VkQueryPool> m_times;
    VkCommandBuffer m_commands = VK_NULL_HANDLE;
    Buffer m_memory;
    std::uint64_t m_used = 0;
    std::uint64_t m_number = 0;  ///< of the submission last made from here
    bool m_isTimed = true;
    bool m_areStagesTimed = false;
    bool m_hasStage = false;
    bool m_isTimingOver = false;
    std::vector<const char*> m_stages;  ///< those that are timed, in their order
};

/// Semaphores around a submission; see Submission.
struct FrameSemaphores {
    VkSemaphore waitFor = VK_NULL_HANDLE;
    VkSemaphore signal = VK_NULL_HANDLE;
};

/// Records and submits, `slots` frames at a time in flight.
class FrameRing {
public:
    FrameRing(Device& device, std::uint32_t slots, std::string_view label);

    /// Waits until the oldest slot is free and starts recording there. Null if the device is lost.
    [[nodiscard]] Frame* begin();
    /// Submits what was recorded since `begin`; false if the device is lost.
    bool end(const FrameSemaphores& semaphores = {});
    /// Waits for the frame last submitted; false if the device is lost.
    bool wait();
    /// Whether the device is done with the frame last submitted, and so with all before it. Waits so many nanoseconds
    /// for it at most. Never, once the device is lost.
    [[nodiscard]] bool poll(std::uint64_t patienceNs = 0);
    /// GPU time of the last timed frame that is known to be done, 0 without timestamps.
    [[nodiscard]] double gpuMs() const { return m_gpuMs; }
    /// Times stages of the frames to come too. Then less of a frame runs side by side.
    void timeStages() { m_areStagesTimed = true; }
    /// Those of the frame of gpuMs, in the order in which they first began.
    [[nodiscard]] std::span<const StageTime> stages() const { return m_stages; }

private:
    void readTimes(Frame& frame);
    bool finish(Frame& frame);

    Device* m_device;
    std::vector<Frame> m_frames;
    std::size_t m_current = 0;
    double m_gpuMs = 0.0;
    bool m_areStagesTimed = false;
    std::vector<StageTime> m_stages;
};

/// Copies `bytes` to `to` from byte `at` on (both multiples of 4), in pieces through the ring's frames. The copy is
/// ordered after all earlier work and before all later work.
bool upload(FrameRing& ring, const Buffer& to, std::span<const std::byte> bytes, std::uint64_t at = 0);

/// Fills `to` from byte `at` of a buffer on, after all earlier work, and waits for that; false if the device is lost.
[[nodiscard]] bool download(Device& device, FrameRing& ring, VkBuffer from, std::span<std::byte> to,
                            std::uint64_t at = 0);

}  // namespace render::gpu
