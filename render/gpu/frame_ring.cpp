#include "render/gpu/frame_ring.h"

#include <algorithm>
#include <cstring>
#include <string>
#include <utility>

#include "render/gpu/barrier.h"
#include "render/gpu/check.h"

namespace render::gpu {
namespace {

constexpr std::uint64_t kAlignment = 16;
constexpr std::uint64_t kFirstSize = 64 * 1024;
constexpr std::uint64_t kUploadPiece = 16 * 1024 * 1024;

}  // namespace

Frame::Slice Frame::allocate(std::uint64_t size) {
    const std::uint64_t rounded = (size + kAlignment - 1) / kAlignment * kAlignment;
    if (m_used + rounded > m_memory.size()) {
        // What was handed out of the old buffer stays valid: DeferredDestroy keeps it until this frame is done.
        const std::uint64_t bigger = std::max({kFirstSize, 2 * m_memory.size(), rounded});
        m_memory = Buffer(*m_device, {"frame memory", bigger, MemoryUse::Staging, HostAccess::Writes});
        m_used = 0;
    }
    const Slice slice{m_memory.mapped().subspan(m_used, size), m_memory.handle(), m_used, m_memory.address() + m_used};
    m_used += rounded;
    return slice;
}

void Frame::beginStage(const char* name) {
    endStage();
    m_device->beginLabel(m_commands, name);
    m_hasStage = true;
    if (m_areStagesTimed && !m_isTimingOver && stampCount() < kMostStamps) {
        stamp(stampCount(), VK_PIPELINE_STAGE_2_ALL_COMMANDS_BIT);
        m_stages.push_back(name);
    }
}

void Frame::endTiming() {
    if (!std::exchange(m_isTimingOver, true)) {
        stamp(1, VK_PIPELINE_STAGE_2_BOTTOM_OF_PIPE_BIT);
    }
}

void Frame::endStage() {
    if (std::exchange(m_hasStage, false)) {
        m_device->endLabel(m_commands);
    }
}

void Frame::stamp(std::uint32_t query, VkPipelineStageFlags2 after) const {
    if (m_device->caps().hasTimestamps) {
        vkCmdWriteTimestamp2(m_commands, after, m_times.get(), query);
    }
}

FrameRing::FrameRing(Device& device, std::uint32_t slots, std::string_view label) : m_device(&device), m_frames(slots) {
    for (Frame& frame : m_frames) {
        frame.m_device = &device;
        auto pool = vkInfo<VkCommandPoolCreateInfo>(VK_STRUCTURE_TYPE_COMMAND_POOL_CREATE_INFO);
        pool.queueFamilyIndex = device.queueFamily();
        VkCommandPool handle = VK_NULL_HANDLE;
        VK_CHECK(vkCreateCommandPool(device.handle(), &pool, nullptr, &handle));
        frame.m_pool = {device, handle, label};
        auto commands = vkInfo<VkCommandBufferAllocateInfo>(VK_STRUCTURE_TYPE_COMMAND_BUFFER_ALLOCATE_INFO);
        commands.commandPool = handle;
        commands.level = VK_COMMAND_BUFFER_LEVEL_PRIMARY;
        commands.commandBufferCount = 1;
        VK_CHECK(vkAllocateCommandBuffers(device.handle(), &commands, &frame.m_commands));
        auto times = vkInfo<VkQueryPoolCreateInfo>(VK_STRUCTURE_TYPE_QUERY_POOL_CREATE_INFO);
        times.queryType = VK_QUERY_TYPE_TIMESTAMP;
        times.queryCount = Frame::kMostStamps;
        VkQueryPool queries = VK_NULL_HANDLE;
        VK_CHECK(vkCreateQueryPool(device.handle(), &times, nullptr, &queries));
        frame.m_times = {device, queries, label};
    }
}

void FrameRing::readTimes(Frame& frame) {
    if (!m_device->caps().hasTimestamps) {
        return;
    }
    std::uint64_t ticks[Frame::kMostStamps] = {};
    const std::uint32_t count = frame.stampCount();
    const VkResult result =
        vkGetQueryPoolResults(m_device->handle(), frame.m_times.get(), 0, count, count * sizeof(ticks[0]), ticks,
                              sizeof(ticks[0]), VK_QUERY_RESULT_64_BIT);
    if (result != VK_SUCCESS) {
        return;
    }
    const auto msBetween = [&](std::uint64_t from, std::uint64_t to) {
        return static_cast<double>(to - from) * m_device->caps().timestampPeriodNs * 1e-6;
    };
    m_gpuMs = msBetween(ticks[0], ticks[1]);
    m_stages.clear();
    for (std::uint32_t stage = Frame::kFirstStage; stage < count; ++stage) {
        const std::string_view name = frame.m_stages[stage - Frame::kFirstStage];
        auto sum = std::ranges::find(m_stages, name, [](const StageTime& time) { return std::string_view(time.name); });
        if (sum == m_stages.end()) {
            sum = m_stages.insert(sum, {name.data(), 0.0});
        }
        sum->ms += msBetween(ticks[stage], stage + 1 < count ? ticks[stage + 1] : ticks[1]);
    }
}

bool FrameRing::finish(Frame& frame) {
    if (frame.m_number == 0) {
        return !m_device->isLost();
    }
    if (!m_device->wait(frame.m_number)) {
        return false;
    }
    if (frame.m_isTimed) {
        readTimes(frame);
    }
    frame.m_number = 0;
    return true;
}

Frame* FrameRing::begin() {
    m_current = (m_current + 1) % m_frames.size();
    Frame& frame = m_frames[m_current];
    if (!finish(frame)) {
        return nullptr;
    }
    frame.m_used = 0;
    frame.m_isTimed = true;
    frame.m_areStagesTimed = m_areStagesTimed;
    frame.m_hasStage = false;
    frame.m_isTimingOver = false;
    frame.m_stages.clear();
    VK_CHECK(vkResetCommandPool(m_device->handle(), frame.m_pool.get(), 0));
    auto info = vkInfo<VkCommandBufferBeginInfo>(VK_STRUCTURE_TYPE_COMMAND_BUFFER_BEGIN_INFO);
    info.flags = VK_COMMAND_BUFFER_USAGE_ONE_TIME_SUBMIT_BIT;
    VK_CHECK(vkBeginCommandBuffer(frame.m_commands, &info));
    if (m_device->caps().hasTimestamps) {
        const std::uint32_t stamps = m_areStagesTimed ? Frame::kMostStamps : Frame::kFirstStage;
        vkCmdResetQueryPool(frame.m_commands, frame.m_times.get(), 0, stamps);
    }
    frame.stamp(0, VK_PIPELINE_STAGE_2_TOP_OF_PIPE_BIT);
    return &frame;
}

bool FrameRing::end(const FrameSemaphores& semaphores) {
    Frame& frame = m_frames[m_current];
    frame.endStage();
    frame.endTiming();
    VK_CHECK(vkEndCommandBuffer(frame.m_commands));
    frame.m_number = m_device->submit({frame.m_commands, semaphores.waitFor, semaphores.signal});
    return frame.m_number != 0;
}

bool FrameRing::poll(std::uint64_t patienceNs) {
    Frame& frame = m_frames[m_current];
    if (frame.m_number != 0 && !m_device->isDone(frame.m_number, patienceNs)) {
        return false;
    }
    // The ones before it are done too: there is nothing to wait for.
    return std::ranges::all_of(m_frames, [this](Frame& done) { return finish(done); });
}

bool FrameRing::wait() {
    return finish(m_frames[m_current]);
}

bool upload(FrameRing& ring, const Buffer& to, std::span<const std::byte> bytes, std::uint64_t at) {
    ASSERT(at + bytes.size() <= to.size());
    for (std::uint64_t done = 0; done < bytes.size(); done += kUploadPiece) {
        Frame* frame = ring.begin();
        if (frame == nullptr) {
            return false;
        }
        const std::span<const std::byte> piece = bytes.subspan(done, std::min(kUploadPiece, bytes.size() - done));
        const Frame::Slice staging = frame->put(piece);
        memoryBarrier(frame->commands(), kAnything, kCopyWrite);
        const VkBufferCopy region{staging.offset, at + done, piece.size()};
        vkCmdCopyBuffer(frame->commands(), staging.buffer, to.handle(), 1, &region);
        memoryBarrier(frame->commands(), kCopyWrite, kAnything);
        if (!ring.end()) {
            return false;
        }
    }
    return true;
}

bool download(Device& device, FrameRing& ring, VkBuffer from, std::span<std::byte> to, std::uint64_t at) {
    if (to.empty()) {
        return !device.isLost();
    }
    const Buffer host(device, {"readback", to.size(), MemoryUse::Staging, HostAccess::Reads});
    Frame* frame = ring.begin();
    if (frame == nullptr) {
        return false;
    }
    memoryBarrier(frame->commands(), kAnything, kCopyRead);
    const VkBufferCopy region{at, 0, to.size()};
    vkCmdCopyBuffer(frame->commands(), from, host.handle(), 1, &region);
    memoryBarrier(frame->commands(), kCopyWrite, kHostRead);
    if (!ring.end() || !ring.wait()) {
        return false;
    }
    std::memcpy(to.data(), host.mapped().data(), to.size());
    return true;
}

}  // namespace render::gpu
