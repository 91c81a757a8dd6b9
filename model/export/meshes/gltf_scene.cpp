#include "model/export/meshes/gltf_scene.h"

#include <meshoptimizer.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <limits>
#include <memory>
#include <nlohmann/json.hpp>
#include <numbers>
#include <variant>

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

/// Writes what `put` appends for each of the items.
template <class Items, class Put>
void writeEach(const Items& items, ScratchFile& file, const Put& put) {
    constexpr std::size_t kAtOnce = 1U << 16U;
    std::string bytes;
    for (const auto& item : items) {
        put(item, bytes);
        if (bytes.size() >= kAtOnce) {
            file.write(bytes);
            bytes.clear();
        }
    }
    file.write(bytes);
}

void appendList(std::string& out, std::span<const double> values, int digits) {
    out += '[';
    for (std::size_t i = 0; i < values.size(); ++i) {
        out += i > 0 ? "," : "";
        appendSignificant(out, values[i], digits);
    }
    out += ']';
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

std::string member(const char* name, const std::string& list) {
    return list.empty() ? "" : ",\"" + std::string(name) + "\":[" + list + ']';
}

/// Text of JSON with a comma where one is before it.
void addEntry(std::string& list, std::string_view entry) {
    list += list.empty() ? "" : ",";
    list += entry;
}

/// What meshoptimizer encodes, in the form that the extension prescribes; newer ones of the library are not part of it.
void compressVertices(std::string_view elements, std::size_t stride, ScratchFile& to) {
    meshopt_encodeVertexVersion(0);
    const std::size_t count = elements.size() / stride;
    const std::size_t most = meshopt_encodeVertexBufferBound(count, stride);
    const auto packed = std::make_unique_for_overwrite<unsigned char[]>(most);
    const std::size_t size = meshopt_encodeVertexBuffer(packed.get(), most, elements.data(), count, stride);
    to.write({reinterpret_cast<const char*>(packed.get()), size});
}

void compressCorners(std::span<const std::uint32_t> corners, ScratchFile& to) {
    meshopt_encodeIndexVersion(1);
    const std::size_t points = *std::ranges::max_element(corners) + std::size_t{1};
    const std::size_t most = meshopt_encodeIndexBufferBound(corners.size(), points);
    const auto packed = std::make_unique_for_overwrite<unsigned char[]>(most);
    const std::size_t size = meshopt_encodeIndexBuffer(packed.get(), most, corners.data(), corners.size());
    to.write({reinterpret_cast<const char*>(packed.get()), size});
}

}  // namespace

/// What a chunk of a file consists of, in its order.
class GltfScene::Chunk {
public:
    void add(std::string text) {
        m_size += text.size();
        m_pieces.emplace_back(std::move(text));
    }
    void add(ScratchFile& bytes) {
        m_size += bytes.size();
        m_pieces.emplace_back(&bytes);
    }
    /// A member of an object, where the list has entries.
    void add(const char* name, List& list) {
        if (list.count > 0) {
            add(",\"" + std::string(name) + "\":[");
            add(list.text);
            add("]");
        }
    }
    void pad(char with) { add(std::string((4 - m_size % 4) % 4, with)); }
    [[nodiscard]] std::uint64_t size() const { return m_size; }

    void writeTo(const char* type, FileWriter& file, const base::Progress& progress) {
        std::string head;
        append(head, static_cast<std::uint32_t>(m_size));
        file.write(head.append(type, 4));
        for (const auto& piece : m_pieces) {
            if (const auto* text = std::get_if<std::string>(&piece)) {
                file.write(*text);
            } else {
                std::get<ScratchFile*>(piece)->moveTo(file, progress);
            }
        }
    }

private:
    std::vector<std::variant<std::string, ScratchFile*>> m_pieces;
    std::uint64_t m_size = 0;
};

std::uint32_t GltfScene::List::add(std::string_view entry) {
    if (count > 0) {
        text.write(",");
    }
    text.write(entry);
    return count++;
}

GltfScene::GltfScene(GlbPacking packing, ScratchPlace place) : m_packing(packing), m_place(std::move(place)) {}

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

SolidMesh inGoodOrder(SolidMesh mesh) {
    std::vector<std::uint32_t> ordered(mesh.triangles.size());
    meshopt_optimizeVertexCacheStrip(ordered.data(), mesh.triangles.data(), mesh.triangles.size(), mesh.points.size());
    mesh.triangles = std::move(ordered);
    const std::size_t used =
        meshopt_optimizeVertexFetch(mesh.points.data(), mesh.triangles.data(), mesh.triangles.size(),
                                    mesh.points.data(), mesh.points.size(), sizeof(MeshPoint));
    mesh.points.resize(used);
    return mesh;
}

std::uint32_t GltfScene::addMaterial(std::string_view name, std::uint32_t rgb, double opacity, bool isMetal) {
    std::string material = "{\"name\":" + jsonString(name) + ",\"pbrMetallicRoughness\":{\"baseColorFactor\":";
    appendList(material,
               std::array{linear(rgb >> 16U & 0xFFU), linear(rgb >> 8U & 0xFFU), linear(rgb & 0xFFU), opacity}, 5);
    material += std::string(",\"metallicFactor\":") + (isMetal ? "0.6" : "0") + ",\"roughnessFactor\":0.5}" +
                (opacity < 1.0 ? ",\"alphaMode\":\"BLEND\"}" : "}");
    return m_materials.add(material);
}

GltfScene::Mesh GltfScene::addMesh(const SolidMesh& mesh, std::uint32_t material, bool isQuantised) {
    Mesh added;
    const std::uint32_t positions =
        isQuantised && m_packing != GlbPacking::Plain ? addQuantised(mesh, added.transform) : addFloats(mesh);
    const std::uint32_t corners = addIndices(mesh);
    added.row =
        m_meshes.add("{\"primitives\":[{\"attributes\":{\"POSITION\":" + std::to_string(positions) +
                     "},\"indices\":" + std::to_string(corners) + ",\"material\":" + std::to_string(material) + "}]}");
    m_triangles += mesh.triangleCount();
    return added;
}

std::uint32_t GltfScene::addNode(const GltfNode& node) {
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
    return m_nodes.add('{' + members.substr(members.empty() ? 0 : 1) + '}');
}

std::string GltfScene::addInstances(std::span<const Placement> placements) {
    std::string shifts;
    std::string turns;
    for (const Placement& placement : placements) {
        const double half = halfTurnOf(placement);
        for (const double value : {placement.origin.x / kNmPerMetre, placement.origin.y / kNmPerMetre, 0.0}) {
            append(shifts, static_cast<float>(value));
        }
        for (const double value : {0.0, 0.0, std::sin(half), std::cos(half)}) {
            append(turns, static_cast<float>(value));
        }
    }
    m_hasInstances = true;
    m_floats.elements.write(shifts);
    m_quads.elements.write(turns);
    const std::uint32_t shift = addAccessor(m_floats, kFloat, placements.size(), ",\"type\":\"VEC3\"");
    const std::uint32_t turn = addAccessor(m_quads, kFloat, placements.size(), ",\"type\":\"VEC4\"");
    return ",\"extensions\":{\"EXT_mesh_gpu_instancing\":{\"attributes\":{\"TRANSLATION\":" + std::to_string(shift) +
           ",\"ROTATION\":" + std::to_string(turn) + "}}}";
}

std::uint32_t GltfScene::addFloats(const SolidMesh& mesh) {
    const Extent extent = extentOf(mesh.points);
    writeEach(mesh.points, m_floats.elements, [](const MeshPoint& p, std::string& bytes) {
        for (const Nm value : {p.x, p.y, p.z}) {
            append(bytes, static_cast<float>(value / kNmPerMetre));
        }
    });
    std::string rest = ",\"type\":\"VEC3\"";
    for (const auto& [name, corner] : {std::pair{",\"min\":", &extent.min}, {",\"max\":", &extent.max}}) {
        std::array<double, 3> stored{};
        std::ranges::transform(*corner, stored.begin(),
                               [](double nm) { return static_cast<double>(static_cast<float>(nm / kNmPerMetre)); });
        rest += name;
        appendList(rest, stored, kSignificant);
    }
    return addAccessor(m_floats, kFloat, mesh.points.size(), rest);
}

std::uint32_t GltfScene::addQuantised(const SolidMesh& mesh, std::string& transform) {
    const Extent extent = extentOf(mesh.points);
    // The same step along x, y and z would lose thin layers; along each its own keeps both faces exactly.
    std::array<double, 3> step{};
    std::array<double, 3> most{};
    for (std::size_t i = 0; i < 3; ++i) {
        step[i] = std::max(1.0, (extent.max[i] - extent.min[i]) / kMostWord);
        most[i] = std::round((extent.max[i] - extent.min[i]) / step[i]);
    }
    writeEach(mesh.points, m_words.elements, [&](const MeshPoint& p, std::string& bytes) {
        const std::array<double, 3> at{static_cast<double>(p.x), static_cast<double>(p.y), static_cast<double>(p.z)};
        for (std::size_t i = 0; i < 3; ++i) {
            append(bytes, static_cast<std::uint16_t>(std::lround((at[i] - extent.min[i]) / step[i])));
        }
        append(bytes, std::uint16_t{0});
    });
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
    return addAccessor(m_words, kWord, mesh.points.size(), rest);
}

std::uint32_t GltfScene::addIndices(const SolidMesh& mesh) {
    const bool isShort = mesh.points.size() <= kMostWord;  // the largest value means no point
    Stream& stream = isShort ? m_short : m_long;
    const bool isStoredShort = isShort && m_packing != GlbPacking::Compressed;
    writeEach(mesh.triangles, stream.elements, [&](std::uint32_t corner, std::string& bytes) {
        if (isStoredShort) {
            append(bytes, static_cast<std::uint16_t>(corner));
        } else {
            append(bytes, corner);
        }
    });
    return addAccessor(stream, isShort ? kWord : kLong, mesh.triangles.size(), ",\"type\":\"SCALAR\"");
}

std::uint32_t GltfScene::addAccessor(Stream& stream, int componentType, std::size_t count, const std::string& rest) {
    if (stream.view < 0) {
        stream.view = m_viewCount++;
    }
    const std::uint64_t offset = stream.size();
    stream.count += count;
    return m_accessors.add("{\"bufferView\":" + std::to_string(stream.view) +
                           (offset > 0 ? ",\"byteOffset\":" + std::to_string(offset) : "") + ",\"componentType\":" +
                           std::to_string(componentType) + ",\"count\":" + std::to_string(count) + rest + '}');
}

std::vector<GltfScene::Stream*> GltfScene::usedStreams() {
    std::vector<Stream*> streams;
    for (Stream* stream : {&m_floats, &m_quads, &m_words, &m_short, &m_long}) {
        if (stream->view >= 0) {
            streams.push_back(stream);
        }
    }
    std::ranges::sort(streams, {}, &Stream::view);
    return streams;
}

ScratchFile& GltfScene::compressed(Stream& stream) {
    ScratchFile& packed = m_packed.emplace_back(m_place);
    const std::string_view elements = stream.elements.bytes();
    if (!elements.empty() && stream.isIndex) {
        compressCorners({reinterpret_cast<const std::uint32_t*>(elements.data()), stream.count}, packed);
    } else if (!elements.empty()) {
        compressVertices(elements, stream.stride, packed);
    }
    return packed;
}

void GltfScene::packStreams(std::string& views, std::string& buffers, Chunk& binary) {
    const bool isCompressed = m_packing == GlbPacking::Compressed;
    std::uint64_t unpacked = 0;
    for (Stream* stream : usedStreams()) {
        std::string view = "{\"buffer\":" + std::string(isCompressed ? "1" : "0") +
                           ",\"byteOffset\":" + std::to_string(isCompressed ? unpacked : binary.size()) +
                           ",\"byteLength\":" + std::to_string(stream->size());
        view += stream->isIndex ? ",\"target\":34963"
                                : ",\"byteStride\":" + std::to_string(stream->stride) + ",\"target\":34962";
        ScratchFile& packed = isCompressed ? compressed(*stream) : stream->elements;
        if (isCompressed) {
            view += ",\"extensions\":{\"EXT_meshopt_compression\":{\"buffer\":0,\"byteOffset\":" +
                    std::to_string(binary.size()) + ",\"byteLength\":" + std::to_string(packed.size()) +
                    ",\"byteStride\":" + std::to_string(stream->stride) +
                    ",\"count\":" + std::to_string(stream->count) + ",\"mode\":\"" +
                    (stream->isIndex ? "TRIANGLES" : "ATTRIBUTES") + "\"}}";
        }
        addEntry(views, view + '}');
        binary.add(packed);
        binary.pad('\0');
        unpacked += (stream->size() + 3) / 4 * 4;
    }
    buffers = "{\"byteLength\":" + std::to_string(binary.size()) + '}';
    if (isCompressed) {
        buffers += ",{\"byteLength\":" + std::to_string(unpacked) +
                   ",\"extensions\":{\"EXT_meshopt_compression\":{\"fallback\":true}}}";
    }
}

std::string GltfScene::extensionsUsed() const {
    std::string extensions;
    if (m_hasQuantised) {
        addEntry(extensions, "\"KHR_mesh_quantization\"");
    }
    if (m_packing == GlbPacking::Compressed) {
        addEntry(extensions, "\"EXT_meshopt_compression\"");
    }
    if (m_hasInstances) {
        addEntry(extensions, "\"EXT_mesh_gpu_instancing\"");
    }
    return extensions;
}

base::Status GltfScene::status() const {
    for (const List* list : {&m_materials, &m_meshes, &m_nodes, &m_accessors}) {
        RETURN_IF_ERROR(list->text.status());
    }
    for (const Stream* stream : {&m_floats, &m_quads, &m_words, &m_short, &m_long}) {
        RETURN_IF_ERROR(stream->elements.status());
    }
    for (const ScratchFile& packed : m_packed) {
        RETURN_IF_ERROR(packed.status());
    }
    return base::Done{};
}

base::Status GltfScene::finish(std::uint32_t root, std::string_view generator, FileWriter& file,
                               const base::Progress& progress) {
    std::string views;
    std::string buffers;
    Chunk binary;
    packStreams(views, buffers, binary);
    const std::string extensions = extensionsUsed();
    Chunk json;
    json.add("{\"asset\":{\"version\":\"2.0\",\"generator\":" + jsonString(generator) + '}' +
             member("extensionsUsed", extensions) + member("extensionsRequired", extensions) +
             ",\"scene\":0,\"scenes\":[{\"nodes\":[" + std::to_string(root) + "]}]");
    json.add("nodes", m_nodes);
    json.add("meshes", m_meshes);
    json.add("materials", m_materials);
    json.add("accessors", m_accessors);
    json.add(member("bufferViews", views) + member("buffers", buffers) + '}');
    json.pad(' ');
    const std::uint64_t size = 12 + 8 + json.size() + 8 + binary.size();
    if (size > std::numeric_limits<std::uint32_t>::max()) {
        return base::Error{base::ErrorCode::OutputFailed, "this would be larger than GLB can be (4 GiB)"};
    }
    std::string head = "glTF";
    append(head, std::uint32_t{2});
    append(head, static_cast<std::uint32_t>(size));
    file.write(head);
    json.writeTo("JSON", file, progress);
    binary.writeTo("BIN\0", file, progress);
    if (progress.isCancelled()) {
        return base::Error{base::ErrorCode::Cancelled, "the export was cancelled"};
    }
    return status();
}

}  // namespace model
