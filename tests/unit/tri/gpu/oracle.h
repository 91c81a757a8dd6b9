#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "tri/gpu/forest_data.h"

namespace tri::gpu {

/// In which order the oracle calls a kernel for its indices. The results must not depend on it: on a device there is
/// none.
enum class CallOrder : std::uint8_t { Forward, Backward, Scattered };

/// Runs the kernels of shaders/tri/ on the CPU, compiled from the same source, one index after the other: what a device
/// has to have in its memory after every step. Not made for speed; the kernel for small trees is left out, so that all
/// trees grow step by step.
class Oracle {
public:
    Oracle(const ForestData& data, CallOrder order);

    /// One step; false if all is done.
    bool step();
    /// Erases and proves after the last step.
    void erase();

    [[nodiscard]] const shader::tri::Control& control() const { return m_forest.control.at[0]; }
    [[nodiscard]] const shader::tri::Forest& forest() const { return m_forest; }
    /// Corners and what lies across the edges; nothing where there is no triangle.
    [[nodiscard]] static std::vector<std::uint32_t> meshAt(const shader::tri::Triangle& triangle);
    /// After erase(): the triangles of a tree. Nothing if it is flagged.
    [[nodiscard]] std::vector<std::uint32_t> trianglesOf(std::size_t tree) const;

private:
    template <class Kernel>
    void forEach(std::uint32_t count, const Kernel& kernel) const;
    void insertRound();
    void contourRound();
    void flipRound();

    shader::tri::Forest m_forest;
    std::vector<std::vector<std::byte>> m_memory;
    CallOrder m_order;
};

}  // namespace tri::gpu
