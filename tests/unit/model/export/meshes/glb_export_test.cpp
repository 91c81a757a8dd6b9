#include "model/export/meshes/glb_export.h"

#include <meshoptimizer.h>
#include <tiny_gltf.h>

#include <QtTest>
#include <cstring>
#include <nlohmann/json.hpp>

#include "model/text/whole_file.h"
#include "tests/unit/model/export/meshes/mesh_board.h"

using namespace mesh_board;
using model::GlbPacking;

namespace {

using Vector = std::array<double, 3>;

std::uint32_t word(const std::string& bytes, std::size_t at) {
    std::uint32_t value = 0;
    std::memcpy(&value, bytes.data() + at, 4);
    return value;
}

void setWord(std::string& bytes, std::size_t at, std::size_t value) {
    const auto number = static_cast<std::uint32_t>(value);
    std::memcpy(bytes.data() + at, &number, 4);
}

std::string unpackedView(const nlohmann::json& view, const std::string& binary) {
    const nlohmann::json& how = view.at("extensions").at("EXT_meshopt_compression");
    const std::size_t count = how.at("count");
    const std::size_t stride = how.at("byteStride");
    const auto* packed =
        reinterpret_cast<const unsigned char*>(binary.data()) + how.at("byteOffset").get<std::size_t>();
    const std::size_t length = how.at("byteLength");
    std::string bytes(count * stride, '\0');
    const bool isIndex = how.at("mode") == "TRIANGLES";
    const int failed = isIndex ? meshopt_decodeIndexBuffer(bytes.data(), count, stride, packed, length)
                               : meshopt_decodeVertexBuffer(bytes.data(), count, stride, packed, length);
    if (failed != 0 || bytes.size() != view.at("byteLength")) {
        qFatal("cannot be unpacked");
    }
    return bytes;
}

/// The same file without EXT_meshopt_compression, which tinygltf does not know.
std::string unpacked(const std::string& file) {
    const std::size_t jsonSize = word(file, 12);
    auto json = nlohmann::json::parse(file.substr(20, jsonSize));
    const std::string binary = file.substr(28 + jsonSize);
    std::string whole(json.at("buffers").at(1).at("byteLength"), '\0');
    for (auto& view : json.at("bufferViews")) {
        const std::string bytes = unpackedView(view, binary);
        whole.replace(view.at("byteOffset"), bytes.size(), bytes);
        view["buffer"] = 0;
        view.erase("extensions");
    }
    json["buffers"] = {{{"byteLength", whole.size()}}};
    for (const char* list : {"extensionsUsed", "extensionsRequired"}) {
        if (json.at(list).size() != 2) {
            qFatal("extensions are not named");
        }
        json[list] = {"KHR_mesh_quantization"};
    }
    std::string text = json.dump();
    text.append((4 - text.size() % 4) % 4, ' ');
    std::string out = file.substr(0, 12) + "....JSON" + text + "...." + std::string("BIN\0", 4) + whole;
    setWord(out, 8, out.size());
    setWord(out, 12, text.size());
    setWord(out, 20 + text.size(), whole.size());
    return out;
}

/// A file as another library reads it.
struct Glb {
    tinygltf::Model model;

    explicit Glb(const std::string& path) {
        std::string file = *model::readWholeFile(path);
        if (file.find("EXT_meshopt_compression") != std::string::npos) {
            file = unpacked(file);
        }
        tinygltf::TinyGLTF reader;
        std::string error;
        std::string warning;
        if (!reader.LoadBinaryFromMemory(&model, &error, &warning, reinterpret_cast<const unsigned char*>(file.data()),
                                         static_cast<unsigned>(file.size())) ||
            !warning.empty()) {
            qFatal("%s%s", error.c_str(), warning.c_str());
        }
    }

    template <class T>
    [[nodiscard]] std::vector<double> numbers(int row, std::size_t perElement, std::size_t stride) const {
        const tinygltf::Accessor& accessor = model.accessors.at(static_cast<std::size_t>(row));
        const tinygltf::BufferView& view = model.bufferViews.at(static_cast<std::size_t>(accessor.bufferView));
        const unsigned char* bytes = model.buffers.at(0).data.data() + view.byteOffset + accessor.byteOffset;
        std::vector<double> out;
        for (std::size_t i = 0; i < accessor.count; ++i) {
            for (std::size_t k = 0; k < perElement; ++k) {
                T value{};
                std::memcpy(&value, bytes + i * stride + k * sizeof(T), sizeof(T));
                out.push_back(static_cast<double>(value));
            }
        }
        return out;
    }

    [[nodiscard]] std::vector<Vector> pointsOf(const tinygltf::Primitive& primitive) const {
        const int row = primitive.attributes.at("POSITION");
        const tinygltf::Accessor& accessor = model.accessors.at(static_cast<std::size_t>(row));
        const bool isFloat = accessor.componentType == TINYGLTF_COMPONENT_TYPE_FLOAT;
        const std::vector<double> all = isFloat ? numbers<float>(row, 3, 12) : numbers<std::uint16_t>(row, 3, 8);
        std::vector<Vector> points;
        for (std::size_t i = 0; i < all.size(); i += 3) {
            points.push_back({all[i], all[i + 1], all[i + 2]});
            for (std::size_t k = 0; k < 3; ++k) {
                if (all[i + k] < static_cast<float>(accessor.minValues[k]) ||
                    all[i + k] > static_cast<float>(accessor.maxValues[k])) {
                    qFatal("outside of its extent");
                }
            }
        }
        return points;
    }

    [[nodiscard]] std::vector<double> cornersOf(const tinygltf::Primitive& primitive) const {
        const auto type = model.accessors.at(static_cast<std::size_t>(primitive.indices)).componentType;
        return type == TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT ? numbers<std::uint16_t>(primitive.indices, 1, 2)
                                                              : numbers<std::uint32_t>(primitive.indices, 1, 4);
    }

    /// Of a mesh where it is drawn: volume in m³ times the scales above.
    [[nodiscard]] double volumeOf(const tinygltf::Mesh& mesh) const {
        double sixfold = 0.0;
        for (const tinygltf::Primitive& primitive : mesh.primitives) {
            const std::vector<Vector> points = pointsOf(primitive);
            const std::vector<double> corners = cornersOf(primitive);
            if (!isClosed(corners)) {
                qFatal("a mesh is open");
            }
            for (std::size_t i = 0; i < corners.size(); i += 3) {
                const Vector& a = points.at(static_cast<std::size_t>(corners[i]));
                const Vector& b = points.at(static_cast<std::size_t>(corners[i + 1]));
                const Vector& c = points.at(static_cast<std::size_t>(corners[i + 2]));
                sixfold += a[0] * (b[1] * c[2] - b[2] * c[1]) + a[1] * (b[2] * c[0] - b[0] * c[2]) +
                           a[2] * (b[0] * c[1] - b[1] * c[0]);
            }
        }
        return sixfold / 6;
    }

    /// mm³ of a node and all below it.
    [[nodiscard]] double volumeOf(int row) const {
        const tinygltf::Node& node = model.nodes.at(static_cast<std::size_t>(row));
        double volume = node.mesh >= 0 ? 1e9 * volumeOf(model.meshes.at(static_cast<std::size_t>(node.mesh))) : 0.0;
        for (const int child : node.children) {
            volume += volumeOf(child);
        }
        return node.scale.empty() ? volume : volume * node.scale[0] * node.scale[1] * node.scale[2];
    }

    [[nodiscard]] int root() const { return model.scenes.at(0).nodes.at(0); }
    [[nodiscard]] const tinygltf::Node& node(const std::vector<std::string>& path) const {
        int at = root();
        for (const std::string& name : path) {
            const auto& children = model.nodes.at(static_cast<std::size_t>(at)).children;
            const auto found = std::ranges::find_if(
                children, [&](int child) { return model.nodes.at(static_cast<std::size_t>(child)).name == name; });
            if (found == children.end()) {
                qFatal("no node %s", name.c_str());
            }
            at = *found;
        }
        return model.nodes.at(static_cast<std::size_t>(at));
    }
};

model::GlbOptions options(GlbPacking packing) {
    model::GlbOptions chosen;
    chosen.looks = {{0xFF8000, 1.0}, {}, {0x0000FF, 0.5}, {}};
    chosen.name = "my board";
    chosen.how.chordToleranceNm = 500.0;
    chosen.packing = packing;
    return chosen;
}

Glb exported(const model::Document& document, const model::SolidChoice& choice, GlbPacking packing,
             bool isInstanced = false) {
    const QTemporaryDir folder;
    const std::string path = folder.filePath("board.glb").toStdString();
    base::Progress progress;
    model::GlbOptions how = options(packing);
    how.isInstanced = isInstanced;
    const auto report = model::exportGlb(planOf(document, choice), how, path, progress);
    if (!report || report->bytes != std::filesystem::file_size(path)) {
        qFatal("not written");
    }
    return Glb(path);
}

}  // namespace

class GlbExportTest : public QObject {
    Q_OBJECT

private slots:
    void nodesAreLayersAndNets() {
        const Glb glb = exported(*board(), {}, GlbPacking::Plain);
        const tinygltf::Node& root = glb.node({});
        QCOMPARE(root.name, std::string("my board"));
        QVERIFY(std::abs(root.rotation.at(0) + std::sqrt(0.5)) < 1e-8 &&
                std::abs(root.rotation.at(3) - std::sqrt(0.5)) < 1e-8);
        QCOMPARE(root.children.size(), std::size_t{3});
        const tinygltf::Node& net = glb.node({"top", "A \"1\""});
        QCOMPARE(net.extras.Get("net").Get<std::string>(), std::string("A \"1\""));
        QCOMPARE(net.extras.Get("layer").Get<std::string>(), std::string("top"));
        QCOMPARE(net.extras.Get("z").Get(0).GetNumberAsDouble(), 0.001035);
        QCOMPARE(net.extras.Get("z").Get(1).GetNumberAsDouble(), 0.00107);
        QVERIFY(net.mesh >= 0);                         // the tracks, and a disc that is not drilled
        QCOMPARE(net.children.size(), std::size_t{2});  // the discs that are drilled alike, of one mesh
        const auto& disc = glb.model.nodes.at(static_cast<std::size_t>(net.children[1]));
        QCOMPARE(disc.mesh, glb.model.nodes.at(static_cast<std::size_t>(net.children[0])).mesh);
        QCOMPARE(disc.translation.at(0), 0.01);
        QVERIFY(glb.node({"drill", "A \"1\""}).mesh < 0);
        QCOMPARE(glb.model.meshes.size(), std::size_t{5});
        const auto& pads = glb.node({"bottom", "B"}).children;
        QVERIFY(std::abs(glb.model.nodes.at(static_cast<std::size_t>(pads[1])).rotation.at(2) + std::sqrt(0.5)) < 1e-8);
    }

    void equalPadsAreInstancesOfOneNode() {
        const Glb plain = exported(*board(), {}, GlbPacking::Plain);
        const Glb instanced = exported(*board(), {}, GlbPacking::Plain, true);
        QCOMPARE(instanced.model.extensionsRequired, std::vector<std::string>{"EXT_mesh_gpu_instancing"});
        QCOMPARE(instanced.model.meshes.size(), plain.model.meshes.size());
        for (const auto& path : {std::vector<std::string>{"top", "A \"1\""}, {"bottom", "B"}}) {
            const std::vector<int>& pads = plain.node(path).children;
            QCOMPARE(instanced.node(path).children.size(), std::size_t{1});
            const auto& node = instanced.model.nodes.at(static_cast<std::size_t>(instanced.node(path).children[0]));
            const auto& attributes = node.extensions.at("EXT_mesh_gpu_instancing").Get("attributes");
            const auto shifts = instanced.numbers<float>(attributes.Get("TRANSLATION").GetNumberAsInt(), 3, 12);
            const auto turns = instanced.numbers<float>(attributes.Get("ROTATION").GetNumberAsInt(), 4, 16);
            QCOMPARE(shifts.size(), 3 * pads.size());
            QCOMPARE(turns.size(), 4 * pads.size());
            for (std::size_t i = 0; i < pads.size(); ++i) {
                const auto& pad = plain.model.nodes.at(static_cast<std::size_t>(pads[i]));
                const bool isTurned = !pad.rotation.empty();
                QVERIFY(std::abs(shifts[3 * i] - pad.translation[0]) < 1e-9);
                QVERIFY(std::abs(shifts[3 * i + 1] - pad.translation[1]) < 1e-9);
                QVERIFY(std::abs(turns[4 * i + 2] - (isTurned ? pad.rotation[2] : 0.0)) < 1e-6);
                QVERIFY(std::abs(turns[4 * i + 3] - (isTurned ? pad.rotation[3] : 1.0)) < 1e-6);
            }
        }
    }

    void volumesAreThoseOfTheBoard_data() {
        QTest::addColumn<int>("packing");
        QTest::addColumn<bool>("isOnePart");
        for (const bool isOnePart : {false, true}) {
            const char* part = isOnePart ? "one part" : "tree";
            QTest::addRow("plain, %s", part) << static_cast<int>(GlbPacking::Plain) << isOnePart;
            QTest::addRow("quantised, %s", part) << static_cast<int>(GlbPacking::Quantised) << isOnePart;
            QTest::addRow("compressed, %s", part) << static_cast<int>(GlbPacking::Compressed) << isOnePart;
        }
    }

    void volumesAreThoseOfTheBoard() {
        QFETCH(const int, packing);
        QFETCH(const bool, isOnePart);
        model::SolidChoice choice;
        choice.isOnePart = isOnePart;
        const Glb glb = exported(*board(), choice, static_cast<GlbPacking>(packing));
        QVERIFY(isNear(glb.volumeOf(glb.root()), kBoard, 2e-3));
        const bool isPlain = static_cast<GlbPacking>(packing) == GlbPacking::Plain;
        QCOMPARE(glb.model.extensionsRequired.empty(), isPlain);
        QCOMPARE(glb.model.extensionsRequired, glb.model.extensionsUsed);
        if (isOnePart) {
            QCOMPARE(glb.model.nodes.size(), std::size_t{4});
        }
        const Glb three = exported(*panel(), choice, static_cast<GlbPacking>(packing));
        QVERIFY(isNear(three.volumeOf(three.root()), 3 * kBoard, 2e-3));
    }

    /// Steps of a panel that lie alike have the same meshes.
    void copiesShareMeshes() {
        const Glb one = exported(*board(), {}, GlbPacking::Plain);
        const Glb three = exported(*panel(), {}, GlbPacking::Plain);
        QCOMPARE(three.model.meshes.size(), 2 * one.model.meshes.size());
        QCOMPARE(three.node({"card 2"}).translation.at(0), 0.2);
        const tinygltf::Node& first = three.node({"card 1", "top", "B"});
        QCOMPARE(first.mesh, three.node({"card 2", "top", "B"}).mesh);
        QVERIFY(first.mesh != three.node({"card 3", "top", "B"}).mesh);
    }

    void coloursAreLinear() {
        const Glb glb = exported(*board(), {}, GlbPacking::Plain);
        QCOMPARE(glb.model.materials.size(), std::size_t{3});
        const auto& top = glb.model.materials[0];
        QCOMPARE(top.name, std::string("top"));
        QCOMPARE(top.pbrMetallicRoughness.baseColorFactor.at(0), 1.0);
        QVERIFY(std::abs(top.pbrMetallicRoughness.baseColorFactor.at(1) - 0.21586) < 1e-4);
        QCOMPARE(top.alphaMode, std::string("OPAQUE"));
        QCOMPARE(glb.model.materials[1].alphaMode, std::string("BLEND"));
        QCOMPARE(glb.model.materials[1].pbrMetallicRoughness.baseColorFactor.at(3), 0.5);
    }

    void namesOfPadsAreThoseOfPins() {
        model::DocumentBuilder builder;
        const hand_made::StackLayer layers[] = {{"top", model::LayerType::Signal, 0, 35'000, 0}};
        hand_made::addLayers(builder, layers);
        const model::NetId net = builder.addNet("N");
        model::Component component;
        component.refdes = "U1";
        model::Pin pin;
        pin.name = builder.string("3");
        builder.addComponent(component, std::span(&pin, 1));
        model::Subnet subnet;
        subnet.net = net;
        subnet.kind = model::SubnetKind::PinPads;
        subnet.pin = model::PinId{0};
        model::DocumentBuilder::Origin origin = hand_made::of(net, model::kPad);
        origin.subnet = builder.addSubnet(subnet);
        builder.beginLayer(model::LayerId{0});
        builder.addCircle({{}, kMm, 0}, origin);
        builder.addCircle({{5 * kMm, 0}, kMm, 0}, hand_made::of(net));
        const auto document = builder.finish();
        const Glb glb = exported(*document, {}, GlbPacking::Plain);
        QCOMPARE(glb.node({"top", "N", "U1-3"}).extras.Get("refdes").Get<std::string>(), std::string("U1"));
        QCOMPARE(glb.node({"top", "N"}).children.size(), std::size_t{2});
    }

    void failuresLeaveNothing() { checkFailures(model::exportGlb, model::GlbOptions{}); }
};

QTEST_GUILESS_MAIN(GlbExportTest)
#include "glb_export_test.moc"
