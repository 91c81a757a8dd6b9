#pragma once

#include <cstring>
#include <vector>

#include "model/base/parallel.h"
#include "render/gpu/frame_ring.h"

namespace render {

/// Makes geometry buffers and fills them: where the processor is the device, in place, else by copies.
class SceneLoader {
public:
    explicit SceneLoader(gpu::Device& device) : m_device(device), m_ring(device, 2, "load board") {}

    template <class T>
    [[nodiscard]] gpu::Buffer load(std::string_view label, const std::vector<T>& column) {
        const auto bytes = std::as_bytes(std::span(column));
        gpu::Buffer buffer(m_device, {label, bytes.size(), gpu::MemoryUse::Geometry,
                                      m_device.caps().isCpu ? gpu::HostAccess::Writes : gpu::HostAccess::None});
        if (buffer.mapped().empty()) {
            gpu::upload(m_ring, buffer, bytes);
        } else {
            fill(buffer.mapped(), bytes);
        }
        m_bytes += buffer.size();
        return buffer;
    }
    /// Of all buffers made.
    [[nodiscard]] std::uint64_t bytes() const { return m_bytes; }

private:
    /// Most of the time goes into pages that the system hands out at their first touch, and on every core.
    static void fill(std::span<std::byte> to, std::span<const std::byte> from) {
        constexpr std::size_t kPart = 1U << 20U;
        base::parallelFor((from.size() + kPart - 1) / kPart, [&](std::size_t part) {
            const auto bytes = from.subspan(part * kPart, std::min(kPart, from.size() - part * kPart));
            std::memcpy(to.data() + part * kPart, bytes.data(), bytes.size());
        });
    }

    gpu::Device& m_device;
    gpu::FrameRing m_ring;
    std::uint64_t m_bytes = 0;
};

}  // namespace render
