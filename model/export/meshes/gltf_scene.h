#pragma once

#include <cstdint>
#include <deque>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "model/base/progress.h"
#include "model/base/result.h"
#include "model/export/meshes/solid_mesh.h"
#include "model/text/file_writer.h"
#include "model/text/scratch_file.h"

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
/// Corners in an order in which each uses what was just used, and points in the order of their first use: what both
/// caches and compression want.
[[nodiscard]] SolidMesh inGoodOrder(SolidMesh mesh);

/// Builds a scene of glTF 2.0: the JSON and the one buffer it refers to. Lengths are metres. Nodes are added before the
/// nodes that hold them. Nothing of it stays in memory: what stands behind something that is not known yet waits in
/// files without names.
class GltfScene {
public:
    /// `place` of those files: FileWriter::scratchPlace.
    GltfScene(GlbPacking packing, ScratchPlace place);

    /// `rgb` is sRGB; glTF wants linear.
    std::uint32_t addMaterial(std::string_view name, std::uint32_t rgb, double opacity, bool isMetal);
    /// What a mesh takes with it to its nodes.
    struct Mesh {
        std::uint32_t row = 0;
        std::string transform;  ///< from what is stored to metres; empty when that is the same
    };
    /// As it is: inGoodOrder comes before.
    Mesh addMesh(const SolidMesh& mesh, std::uint32_t material, bool isQuantised);
    std::uint32_t addNode(const GltfNode& node);
    /// GltfNode::transform of a node whose mesh is there once for each placement (EXT_mesh_gpu_instancing).
    [[nodiscard]] std::string addInstances(std::span<const Placement> placements);

    /// The first failure: OutputFailed.
    [[nodiscard]] base::Status status() const;
    /// Writes the whole file, "glTF" and all; `root` is the node that holds all others. Once, at the end. Errors: as
    /// status(), also where it would be larger than GLB allows (4 GiB); Cancelled. Failures of `file` stay there.
    base::Status finish(std::uint32_t root, std::string_view generator, FileWriter& file,
                        const base::Progress& progress);

    [[nodiscard]] std::uint64_t triangles() const { return m_triangles; }

private:
    /// A run of equal elements in the buffer.
    struct Stream {
        ScratchFile elements;
        std::uint32_t stride = 0;  ///< of an element in the file; corners that will be compressed wait in 32 bits each
        bool isIndex = false;
        int view = -1;
        std::uint64_t count = 0;

        [[nodiscard]] std::uint64_t size() const { return count * stride; }
    };
    /// A list of JSON.
    struct List {
        ScratchFile text;
        std::uint32_t count = 0;

        /// Its row.
        std::uint32_t add(std::string_view entry);
    };
    class Chunk;

    std::uint32_t addFloats(const SolidMesh& mesh);
    std::uint32_t addQuantised(const SolidMesh& mesh, std::string& transform);
    std::uint32_t addIndices(const SolidMesh& mesh);
    /// Of the last `count` elements that were put into the stream.
    std::uint32_t addAccessor(Stream& stream, int componentType, std::size_t count, const std::string& rest);
    [[nodiscard]] std::vector<Stream*> usedStreams();
    ScratchFile& compressed(Stream& stream);
    void packStreams(std::string& views, std::string& buffers, Chunk& binary);
    [[nodiscard]] std::string extensionsUsed() const;

    GlbPacking m_packing;
    ScratchPlace m_place;
    List m_materials{ScratchFile(m_place)};
    List m_meshes{ScratchFile(m_place)};
    List m_nodes{ScratchFile(m_place)};
    List m_accessors{ScratchFile(m_place)};
    int m_viewCount = 0;
    Stream m_floats{ScratchFile(m_place), 12, false};
    Stream m_quads{ScratchFile(m_place), 16, false};
    Stream m_words{ScratchFile(m_place), 8, false};
    Stream m_short{ScratchFile(m_place), 2, true};
    Stream m_long{ScratchFile(m_place), 4, true};
    std::deque<ScratchFile> m_packed;  ///< streams, compressed
    std::uint64_t m_triangles = 0;
    bool m_hasQuantised = false;
    bool m_hasInstances = false;
};

}  // namespace model
