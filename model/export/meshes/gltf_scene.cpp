#include "model/export/meshes/gltf_scene.h"

#include <meshoptimizer.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>
#include <numbers>

#include "model/text/number_text.h"

namespace model {

namespace {

constexpr double kNmPerMetre = 1e9;
constexpr int kFloat = 5126;
constexpr int kWord = 5123;  // unsigned short
constexpr int kLong = 5125;  // unsigned int
constexpr std::uint32_t kMostWord = 65535;
constexpr int kSignificant = 9;  // of a 32-bit float

template <class T>
void append(std::string& bytes, T value) {
    const auto raw =
        std::bit_cast<std::array<char, sizeof(T)>>(value);  // glTF is little-endian, and so is all we run on
    static_assert(std::endian::native == std::endian::little);
    bytes.append(raw.data(), raw.size());
}

void appendList(std::string& out, std::span<const double> values, int digits) {
    out += '[';
    for (std::size_t i = 0; i < values.size(); ++i) {
        out += i > 0 ? "," : "";
        appendSignificant(out, values[i], digits);
    }
    out += ']';
}

void separate(std::string& list) {
    list += list.empty() ? "" : ",";
}

/// As the transfer function of sRGB has it.
double linear(std::uint32_t byte) {
    const double c = byte / 255.0;
    return c <= 0.04045 ? c / 12.92 : std::pow((c + 0.055) / 1.055, 2.4);
}

struct Extent {
    std::array<double, 3> min;
    std::array<double, 3> max;
};

Extent extentOf(const std::vector<MeshPoint>& points) {
    Extent extent;
    extent.min.fill(std::numeric_limits<double>::infinity());
    extent.max.fill(-std::numeric_limits<double>::infinity());
    for (const MeshPoint& p : points) {
        const std::array<double, 3> at{static_cast<double>(p.x), static_cast<double>(p.y), static_cast<double>(p.z)};
        for (std::size_t i = 0; i < 3; ++i) {
            extent.min[i] = std::min(extent.min[i], at[i]);
            extent.max[i] = std::max(extent.max[i], at[i]);
        }
    }
    return extent;
}

/// Half the angle of a placement around z, radians: what its quaternion is made of.
double halfTurnOf(const Placement& placement) {
    return std::remainder(-placement.clockwiseDeg, 360.0) * std::numbers::pi / 360;
}

void pad(std::string& bytes, char with) {
    bytes.append((4 - bytes.size() % 4) % 4, with);
}

std::string member(const char* name, const std::string& list) {
    return list.empty() ? "" : ",\"" + std::string(name) + "\":[" + list + ']';
}

/// Corners in an order in which each uses what was just used, and points in the order of their first use: what both
/// caches and compression want.
SolidMesh inGoodOrder(const SolidMesh& mesh) {
    SolidMesh ordered{std::vector<MeshPoint>(mesh.points.size()), std::vector<std::uint32_t>(mesh.triangles.size())};
    meshopt_optimizeVertexCacheStrip(ordered.triangles.data(), mesh.triangles.data(), mesh.triangles.size(),
                                     mesh.points.size());
    const std::size_t used =
        meshopt_optimizeVertexFetch(ordered.points.data(), ordered.triangles.data(), ordered.triangles.size(),
                                    mesh.points.data(), mesh.points.size(), sizeof(MeshPoint));
    ordered.points.resize(used);
    return ordered;
}

/// In the form that the extension prescribes; newer ones of the library are not part of it.
std::string compressed(const std::string& bytes, std::uint32_t stride, bool isIndex) {
    meshopt_encodeVertexVersion(0);
    meshopt_encodeIndexVersion(1);
    const std::size_t count = bytes.size() / stride;
    std::string packed;
    if (!isIndex) {
        packed.resize(meshopt_encodeVertexBufferBound(count, stride));
        packed.resize(meshopt_encodeVertexBuffer(reinterpret_cast<unsigned char*>(packed.data()), packed.size(),
                                                 bytes.data(), count, stride));
        return packed;
    }
    std::vector<std::uint32_t> corners(count);
    for (std::size_t i = 0; i < count; ++i) {
        std::uint32_t corner = 0;
        std::copy_n(bytes.data() + i * stride, stride, reinterpret_cast<char*>(&corner));
        corners[i] = corner;
    }
    packed.resize(meshopt_encodeIndexBufferBound(count, *std::ranges::max_element(corners) + std::size_t{1}));
    packed.resize(meshopt_encodeIndexBuffer(reinterpret_cast<unsigned char*>(packed.data()), packed.size(),
                                            corners.data(), count));
    return packed;
}

}  // namespace

std::string jsonString(std::string_view text) {
    return nlohmann::json(text).dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
}

std::string gltfPlacement(const Placement& placement) {
    std::string out = ",\"translation\":";
    appendList(out, std::array{placement.origin.x / kNmPerMetre, placement.origin.y / kNmPerMetre, 0.0}, kSignificant);
    const double half = halfTurnOf(placement);
    if (half != 0.0) {
        out += ",\"rotation\":";
        appendList(out, std::array{0.0, 0.0, std::sin(half), std::cos(half)}, kSignificant);
    }
    return out;
}

std::uint32_t GltfScene::addMaterial(std::string_view name, std::uint32_t rgb, double opacity, bool isMetal) {
    separate(m_materials);
    m_materials += "{\"name\":" + jsonString(name) + ",\"pbrMetallicRoughness\":{\"baseColorFactor\":";
    appendList(m_materials,
               std::array{linear(rgb >> 16U & 0xFFU), linear(rgb >> 8U & 0xFFU), linear(rgb & 0xFFU), opacity}, 5);
    m_materials += std::string(",\"metallicFactor\":") + (isMetal ? "0.6" : "0") + ",\"roughnessFactor\":0.5}" +
                   (opacity < 1.0 ? ",\"alphaMode\":\"BLEND\"}" : "}");
    return m_materialCount++;
}

GltfScene::Mesh GltfScene::addMesh(const SolidMesh& given, std::uint32_t material, bool isQuantised) {
    const SolidMesh mesh = inGoodOrder(given);
    Mesh added;
    const std::uint32_t positions =
        isQuantised && m_packing != GlbPacking::Plain ? addQuantised(mesh, added.transform) : addFloats(mesh);
    const std::uint32_t corners = addIndices(mesh);
    separate(m_meshes);
    m_meshes += "{\"primitives\":[{\"attributes\":{\"POSITION\":" + std::to_string(positions) +
                "},\"indices\":" + std::to_string(corners) + ",\"material\":" + std::to_string(material) + "}]}";
    m_triangles += mesh.triangleCount();
    added.row = m_meshCount++;
    return added;
}

std::uint32_t GltfScene::addNode(const GltfNode& node) {
    separate(m_nodes);
    std::string members;
    if (!node.name.empty()) {
        members += ",\"name\":" + jsonString(node.name);
    }
    if (node.mesh) {
        members += ",\"mesh\":" + std::to_string(*node.mesh);
    }
    members += node.transform;
    if (!node.children.empty()) {
        members += ",\"children\":[";
        for (std::size_t i = 0; i < node.children.size(); ++i) {
            members += (i > 0 ? "," : "") + std::to_string(node.children[i]);
        }
        members += ']';
    }
    if (!node.extras.empty()) {
        members += ",\"extras\":{" + node.extras + '}';
    }
    m_nodes += '{' + members.substr(members.empty() ? 0 : 1) + '}';
    return m_nodeCount++;
}

std::string GltfScene::addInstances(std::span<const Placement> placements) {
    const std::uint64_t shifts = m_floats.bytes.size();
    const std::uint64_t turns = m_quads.bytes.size();
    for (const Placement& placement : placements) {
        const double half = halfTurnOf(placement);
        for (const double value : {placement.origin.x / kNmPerMetre, placement.origin.y / kNmPerMetre, 0.0}) {
            append(m_floats.bytes, static_cast<float>(value));
        }
        for (const double value : {0.0, 0.0, std::sin(half), std::cos(half)}) {
            append(m_quads.bytes, static_cast<float>(value));
        }
    }
    m_hasInstances = true;
    const std::uint32_t shift = addAccessor(m_floats, shifts, kFloat, placements.size(), ",\"type\":\"VEC3\"");
    const std::uint32_t turn = addAccessor(m_quads, turns, kFloat, placements.size(), ",\"type\":\"VEC4\"");
    return ",\"extensions\":{\"EXT_mesh_gpu_instancing\":{\"attributes\":{\"TRANSLATION\":" + std::to_string(shift) +
           ",\"ROTATION\":" + std::to_string(turn) + "}}}";
}

std::uint32_t GltfScene::addFloats(const SolidMesh& mesh) {
    const std::uint64_t offset = m_floats.bytes.size();
    const Extent extent = extentOf(mesh.points);
    for (const MeshPoint& p : mesh.points) {
        for (const Nm value : {p.x, p.y, p.z}) {
            append(m_floats.bytes, static_cast<float>(value / kNmPerMetre));
        }
    }
    std::string rest = ",\"type\":\"VEC3\"";
    for (const auto& [name, corner] : {std::pair{",\"min\":", &extent.min}, {",\"max\":", &extent.max}}) {
        std::array<double, 3> stored{};
        std::ranges::transform(*corner, stored.begin(),
                               [](double nm) { return static_cast<double>(static_cast<float>(nm / kNmPerMetre)); });
        rest += name;
        appendList(rest, stored, kSignificant);
    }
    return addAccessor(m_floats, offset, kFloat, mesh.points.size(), rest.c_str());
}

std::uint32_t GltfScene::addQuantised(const SolidMesh& mesh, std::string& transform) {
    const std::uint64_t offset = m_words.bytes.size();
    const Extent extent = extentOf(mesh.points);
    // The same step along x, y and z would lose thin layers; along each its own keeps both faces exactly.
    std::array<double, 3> step{};
    std::array<double, 3> most{};
    for (std::size_t i = 0; i < 3; ++i) {
        step[i] = std::max(1.0, (extent.max[i] - extent.min[i]) / kMostWord);
        most[i] = std::round((extent.max[i] - extent.min[i]) / step[i]);
    }
    for (const MeshPoint& p : mesh.points) {
        const std::array<double, 3> at{static_cast<double>(p.x), static_cast<double>(p.y), static_cast<double>(p.z)};
        for (std::size_t i = 0; i < 3; ++i) {
            append(m_words.bytes, static_cast<std::uint16_t>(std::lround((at[i] - extent.min[i]) / step[i])));
        }
        append(m_words.bytes, std::uint16_t{0});
    }
    m_hasQuantised = true;
    transform = ",\"translation\":";
    appendList(transform,
               std::array{extent.min[0] / kNmPerMetre, extent.min[1] / kNmPerMetre, extent.min[2] / kNmPerMetre},
               kSignificant);
    transform += ",\"scale\":";
    appendList(transform, std::array{step[0] / kNmPerMetre, step[1] / kNmPerMetre, step[2] / kNmPerMetre},
               kSignificant);
    std::string rest = ",\"type\":\"VEC3\",\"min\":[0,0,0],\"max\":";
    appendList(rest, most, kSignificant);
    return addAccessor(m_words, offset, kWord, mesh.points.size(), rest.c_str());
}

std::uint32_t GltfScene::addIndices(const SolidMesh& mesh) {
    const bool isShort = mesh.points.size() <= kMostWord;  // the largest value means no point
    Stream& stream = isShort ? m_short : m_long;
    const std::uint64_t offset = stream.bytes.size();
    for (const std::uint32_t corner : mesh.triangles) {
        if (isShort) {
            append(stream.bytes, static_cast<std::uint16_t>(corner));
        } else {
            append(stream.bytes, corner);
        }
    }
    return addAccessor(stream, offset, isShort ? kWord : kLong, mesh.triangles.size(), ",\"type\":\"SCALAR\"");
}

std::uint32_t GltfScene::addAccessor(Stream& stream, std::uint64_t offset, int componentType, std::size_t count,
                                     const char* rest) {
    if (stream.view < 0) {
        stream.view = m_viewCount++;
    }
    separate(m_accessors);
    m_accessors += "{\"bufferView\":" + std::to_string(stream.view) +
                   (offset > 0 ? ",\"byteOffset\":" + std::to_string(offset) : "") +
                   ",\"componentType\":" + std::to_string(componentType) + ",\"count\":" + std::to_string(count) +
                   rest + '}';
    return m_accessorCount++;
}

void GltfScene::packStreams(std::string& views, std::string& buffers, std::string& binary) {
    std::vector<Stream*> streams;
    for (Stream* stream : {&m_floats, &m_quads, &m_words, &m_short, &m_long}) {
        if (stream->view >= 0) {
            streams.push_back(stream);
        }
    }
    std::ranges::sort(streams, {}, &Stream::view);
    const bool isCompressed = m_packing == GlbPacking::Compressed;
    std::uint64_t unpacked = 0;
    for (const Stream* stream : streams) {
        const std::string packed =
            isCompressed ? compressed(stream->bytes, stream->stride, stream->isIndex) : std::string();
        const std::uint64_t offset = isCompressed ? unpacked : binary.size();
        separate(views);
        views += "{\"buffer\":" + std::string(isCompressed ? "1" : "0") + ",\"byteOffset\":" + std::to_string(offset) +
                 ",\"byteLength\":" + std::to_string(stream->bytes.size());
        views += stream->isIndex ? ",\"target\":34963"
                                 : ",\"byteStride\":" + std::to_string(stream->stride) + ",\"target\":34962";
        if (isCompressed) {
            views += ",\"extensions\":{\"EXT_meshopt_compression\":{\"buffer\":0,\"byteOffset\":" +
                     std::to_string(binary.size()) + ",\"byteLength\":" + std::to_string(packed.size()) +
                     ",\"byteStride\":" + std::to_string(stream->stride) +
                     ",\"count\":" + std::to_string(stream->bytes.size() / stream->stride) + ",\"mode\":\"" +
                     (stream->isIndex ? "TRIANGLES" : "ATTRIBUTES") + "\"}}";
        }
        views += '}';
        binary += isCompressed ? packed : stream->bytes;
        pad(binary, '\0');
        unpacked += (stream->bytes.size() + 3) / 4 * 4;
    }
    buffers = "{\"byteLength\":" + std::to_string(binary.size()) + '}';
    if (isCompressed) {
        buffers += ",{\"byteLength\":" + std::to_string(unpacked) +
                   ",\"extensions\":{\"EXT_meshopt_compression\":{\"fallback\":true}}}";
    }
}

std::vector<std::string> GltfScene::finish(std::uint32_t root, std::string_view generator) {
    std::string views;
    std::string buffers;
    std::string binary;
    packStreams(views, buffers, binary);
    std::string extensions = m_hasQuantised ? "\"KHR_mesh_quantization\"" : "";
    if (m_packing == GlbPacking::Compressed) {
        separate(extensions);
        extensions += "\"EXT_meshopt_compression\"";
    }
    if (m_hasInstances) {
        separate(extensions);
        extensions += "\"EXT_mesh_gpu_instancing\"";
    }
    std::string json = "{\"asset\":{\"version\":\"2.0\",\"generator\":" + jsonString(generator) + '}' +
                       member("extensionsUsed", extensions) + member("extensionsRequired", extensions) +
                       ",\"scene\":0,\"scenes\":[{\"nodes\":[" + std::to_string(root) + "]}]" +
                       member("nodes", m_nodes) + member("meshes", m_meshes) + member("materials", m_materials) +
                       member("accessors", m_accessors) + member("bufferViews", views) + member("buffers", buffers) +
                       '}';
    pad(json, ' ');
    const std::uint64_t size = 12 + 8 + json.size() + 8 + binary.size();
    if (size > std::numeric_limits<std::uint32_t>::max()) {
        return {};
    }
    std::string head = "glTF";
    append(head, std::uint32_t{2});
    append(head, static_cast<std::uint32_t>(size));
    append(head, static_cast<std::uint32_t>(json.size()));
    head += "JSON";
    std::string middle;
    append(middle, static_cast<std::uint32_t>(binary.size()));
    middle += std::string("BIN\0", 4);
    return {std::move(head), std::move(json), std::move(middle), std::move(binary)};
}

}  // namespace model
