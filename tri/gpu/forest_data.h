#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "shaders/tri/forest.h"
#include "tri/triangulate.h"

/// Triangulating all polygons of a board at once, by the kernels of shaders/tri/: on a Vulkan device, and on the CPU as
/// the device's oracle.
namespace tri::gpu {

/// How triangles outside are found; docs/triangulation.md compares them.
enum class Eraser : std::uint8_t {
    Sector,  ///< by the contours at one corner: right for every input
    Loop,    ///< the paper's: by the loops of the corners and the centroid; where loops touch, the CPU has to help
};

/// Polygons as the forest of shaders/tri/forest.h: vertices in insertion order, equal ones merged, contours added up.
struct ForestData {
    shader::tri::Control control{};
    std::vector<shader::tri::Tree> trees;
    std::vector<std::size_t> polygonOf;  ///< per tree
    std::vector<std::uint32_t> treeOf;   ///< and so on: the columns of Forest that the kernels only read
    std::vector<shader::tri::ivec2> points;
    std::vector<std::uint32_t> ids;
    std::vector<std::uint32_t> loops;
    std::vector<std::uint32_t> next;
    std::vector<std::uint32_t> previous;
    std::vector<std::uint32_t> rays;
    std::uint32_t tinyTrees = 0;   ///< the first so many have at most kTinyVertices vertices
    std::uint32_t smallTrees = 0;  ///< the next so many at most kSmallVertices
    Eraser eraser = Eraser::Sector;

    [[nodiscard]] std::uint32_t vertexCount() const { return static_cast<std::uint32_t>(points.size()); }
    [[nodiscard]] std::uint32_t rayCount() const { return static_cast<std::uint32_t>(rays.size() / 3); }
};

/// The vertices of one forest have to be fewer: two triangle slots each, in 31 bits together with a corner.
inline constexpr std::size_t kMaxForestVertices = std::size_t{1} << 28;
/// How many vertices polygons have in a forest.
[[nodiscard]] std::size_t forestVertices(std::span<const Polygon> polygons);

/// Polygons that can be no tree (no area, or the same edge twice) are not in it. On all cores.
[[nodiscard]] ForestData plant(std::span<const Polygon> polygons, Eraser eraser);

/// One array of the forest and where it goes: `offset` bytes into shader::tri::Forest.
struct Column {
    const char* label;
    std::size_t offset;
    std::size_t bytes;
    const void* initial;  ///< null: the kernels fill it
};
[[nodiscard]] std::vector<Column> columnsOf(const ForestData& data);

/// The forest's record but for the addresses of its columns.
[[nodiscard]] shader::tri::Forest recordOf(const ForestData& data);

}  // namespace tri::gpu
