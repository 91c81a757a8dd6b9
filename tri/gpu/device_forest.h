#pragma once

#include <span>
#include <vector>

#include "render/gpu/buffer.h"
#include "render/gpu/frame_ring.h"
#include "render/gpu/pipeline.h"
#include "tri/gpu/forest_data.h"

namespace tri::gpu {

/// A program of shaders/tri/.
struct Kernel {
    const char* name = "";  ///< also of the stages of a frame that run it
    render::gpu::Pipeline pipeline;
};

/// All of them, as pipelines of a device. Made once.
struct Kernels {
    explicit Kernels(render::gpu::Device& device);

    Kernel init, tiny, small, advance;
    Kernel vote, claimPlace, split, relocateInserted;
    Kernel findContours, claimCorridor, rebuildCorridor;
    Kernel testEdges, flip, fixFlips, relocateFlipped, tail;
    Kernel fixLinks;
    Kernel decide, prove, countKept, sumKept, writeKept;
};

/// A forest in the memory of a device. Records the same steps as the oracle; how many threads each kernel needs is
/// decided on the device, so that a submission may hold any number of steps, and those after the last do nothing.
class DeviceForest {
public:
    /// Copies the columns to the device through `ring`. False from lost() afterwards if the device was lost.
    DeviceForest(render::gpu::Device& device, render::gpu::FrameRing& ring, const ForestData& data);

    void recordInit(render::gpu::Frame& frame, const Kernels& kernels) const;
    /// The small trees as a whole.
    void recordSmall(render::gpu::Frame& frame, const Kernels& kernels) const;
    void recordStep(render::gpu::Frame& frame, const Kernels& kernels) const;
    /// Erasing and compaction; nothing unless all is done by then.
    void recordErase(render::gpu::Frame& frame, const Kernels& kernels) const;

    /// The first values of a column, by its place in shader::tri::Forest; empty if the device was lost.
    template <class T>
    [[nodiscard]] std::vector<T> read(std::size_t offset, std::size_t count) const {
        std::vector<T> values(count);
        const auto bytes = std::as_writable_bytes(std::span(values));
        const bool isThere = render::gpu::download(*m_device, *m_ring, column(offset).handle(), bytes);
        return isThere ? values : std::vector<T>();
    }
    [[nodiscard]] shader::tri::Control control() const;
    [[nodiscard]] bool isLost() const { return m_device->isLost(); }

private:
    [[nodiscard]] const render::gpu::Buffer& column(std::size_t offset) const;
    void begin(render::gpu::Frame& frame, const Kernel& program, std::uint32_t stage, std::uint32_t firstTree) const;
    void run(render::gpu::Frame& frame, const Kernel& program, std::size_t groups, std::uint32_t stage = 0) const;
    void dispatch(render::gpu::Frame& frame, const Kernel& program, std::uint32_t groups,
                  std::uint32_t firstTree = 0) const;

    render::gpu::Device* m_device;
    render::gpu::FrameRing* m_ring;
    shader::tri::Forest m_record;
    std::vector<std::size_t> m_offsets;
    std::vector<render::gpu::Buffer> m_columns;
    render::gpu::Buffer m_forest;
};

}  // namespace tri::gpu
