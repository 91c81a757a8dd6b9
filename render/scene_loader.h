#pragma once

#include <vector>

#include "render/gpu/frame_ring.h"

namespace render {

/// Makes geometry buffers and fills them.
class SceneLoader {
public:
    explicit SceneLoader(gpu::Device& device) : m_device(device), m_ring(device, 2, "load board") {}

    template <class T>
    [[nodiscard]] gpu::Buffer load(std::string_view label, const std::vector<T>& column) {
        gpu::Buffer buffer(m_device, {label, column.size() * sizeof(T), gpu::MemoryUse::Geometry, false});
        gpu::upload(m_ring, buffer, std::as_bytes(std::span(column)));
        return buffer;
    }

private:
    gpu::Device& m_device;
    gpu::FrameRing m_ring;
};

}  // namespace render
