#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "model/export/meshes/solid_mesh.h"

namespace model {

/// How positions and rows of corners are stored.
enum class GlbPacking : std::uint8_t {
    Plain,      ///< 32-bit floats: read by everything
    Quantised,  ///< 16 bits over the extent of each mesh (KHR_mesh_quantization)
    Compressed  ///< the same, compressed without loss (EXT_meshopt_compression): smallest, but not read by everything
};

/// A node of a scene: what it is called, and what is in it.
struct GltfNode {
    std::string name;
    std::string extras;  ///< members of a JSON object; empty: none
    std::optional<std::uint32_t> mesh;
    std::string transform;  ///< members of the node: gltfPlacement, GltfScene::addInstances
    std::vector<std::uint32_t> children;
};

/// Text in quotes as JSON has it.
[[nodiscard]] std::string jsonString(std::string_view text);
/// The transform of a node that is placed so, in metres; not for mirrored placements.
[[nodiscard]] std::string gltfPlacement(const Placement& placement);

/// Builds a scene of glTF 2.0: the JSON and the one buffer it refers to. Lengths are metres. Nodes are added before the
/// nodes that hold them.
class GltfScene {
public:
    explicit GltfScene(GlbPacking packing) : m_packing(packing) {}

    /// `rgb` is sRGB; glTF wants linear.
    std::uint32_t addMaterial(std::string_view name, std::uint32_t rgb, double opacity, bool isMetal);
    /// What a mesh takes with it to its nodes.
    struct Mesh {
        std::uint32_t row = 0;
        std::string transform;  ///< from what is stored to metres; empty when that is the same
    };
    Mesh addMesh(const SolidMesh& mesh, std::uint32_t material, bool isQuantised);
    std::uint32_t addNode(const GltfNode& node);
    /// GltfNode::transform of a node whose mesh is there once for each placement (EXT_mesh_gpu_instancing).
    [[nodiscard]] std::string addInstances(std::span<const Placement> placements);

    /// The whole file, "glTF" and all; `root` is the node that holds all others. Empty when it would be larger than GLB
    /// allows (4 GiB).
    [[nodiscard]] std::vector<std::string> finish(std::uint32_t root, std::string_view generator);

    [[nodiscard]] std::uint64_t triangles() const { return m_triangles; }

private:
    /// A run of equal elements in the buffer.
    struct Stream {
        std::string bytes;
        std::uint32_t stride = 0;
        bool isIndex = false;
        int view = -1;
    };

    std::uint32_t addFloats(const SolidMesh& mesh);
    std::uint32_t addQuantised(const SolidMesh& mesh, std::string& transform);
    std::uint32_t addIndices(const SolidMesh& mesh);
    std::uint32_t addAccessor(Stream& stream, std::uint64_t offset, int componentType, std::size_t count,
                              const char* rest);
    void packStreams(std::string& views, std::string& buffers, std::string& binary);

    GlbPacking m_packing;
    std::string m_materials;
    std::string m_meshes;
    std::string m_nodes;
    std::string m_accessors;
    std::uint32_t m_materialCount = 0;
    std::uint32_t m_meshCount = 0;
    std::uint32_t m_nodeCount = 0;
    std::uint32_t m_accessorCount = 0;
    int m_viewCount = 0;
    Stream m_floats{{}, 12, false};
    Stream m_quads{{}, 16, false};
    Stream m_words{{}, 8, false};
    Stream m_short{{}, 2, true};
    Stream m_long{{}, 4, true};
    std::uint64_t m_triangles = 0;
    bool m_hasQuantised = false;
    bool m_hasInstances = false;
};

}  // namespace model
