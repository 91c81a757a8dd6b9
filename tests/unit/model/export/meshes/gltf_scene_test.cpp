#include "model/export/meshes/gltf_scene.h"

#include <QtTest>

#include "tests/unit/model/export/meshes/mesh_board.h"

using model::GlbPacking;
using model::GltfScene;

namespace {

/// A strip of so many squares beside each other.
model::SolidMesh strip(int squares) {
    std::vector<model::Point> corners;
    for (int i = 0; i <= squares; ++i) {
        corners.push_back({i * 1'000, (i % 2) * 10});
    }
    for (int i = squares; i >= 0; --i) {
        corners.push_back({i * 1'000, 1'000'000});
    }
    model::PolygonSet set;
    set.beginPolygon();
    set.addLoop(corners);
    model::SolidMesh mesh;
    if (!model::appendPrisms(set, {0, 1'000}, mesh)) {
        qFatal("no mesh");
    }
    return mesh;
}

std::string jsonOf(const model::SolidMesh& mesh, GlbPacking packing) {
    GltfScene scene(packing);
    const auto added = scene.addMesh(mesh, scene.addMaterial("copper", 0x808080, 1.0, true), true);
    const std::uint32_t node = scene.addNode({"n", {}, added.row, added.transform, {}});
    return scene.finish(node, "test").at(1);
}

}  // namespace

class GltfSceneTest : public QObject {
    Q_OBJECT

private slots:
    void textsAreQuoted() {
        QCOMPARE(model::jsonString("a\"b\\\n"), std::string("\"a\\\"b\\\\\\n\""));
        QCOMPARE(model::jsonString("\xFF"), std::string("\"\xEF\xBF\xBD\""));
    }

    void placementsAreTurnedCounterClockwise() {
        QCOMPARE(model::gltfPlacement({{1'000'000, -2'500}, 0.0, false}),
                 std::string(",\"translation\":[0.001,-2.5e-06,0]"));
        QCOMPARE(model::gltfPlacement({{}, 180.0, false}),
                 std::string(",\"translation\":[0,0,0],\"rotation\":[0,0,-1,6.123234e-17]"));
        QCOMPARE(model::gltfPlacement({{}, 360.0, false}), std::string(",\"translation\":[0,0,0]"));
    }

    /// 65535 means "no point" and is not used.
    void manyPointsNeedLongRows() {
        QVERIFY(jsonOf(strip(10), GlbPacking::Plain).find("\"componentType\":5123") != std::string::npos);
        const std::string large = jsonOf(strip(17'000), GlbPacking::Plain);
        QVERIFY(large.find("\"componentType\":5125") != std::string::npos);
        QVERIFY(large.find("\"componentType\":5123") == std::string::npos);
    }

    void extensionsAreNamed() {
        QVERIFY(jsonOf(strip(1), GlbPacking::Plain).find("extensions") == std::string::npos);
        const std::string quantised = jsonOf(strip(1), GlbPacking::Quantised);
        QVERIFY(quantised.find("\"extensionsRequired\":[\"KHR_mesh_quantization\"]") != std::string::npos);
        QVERIFY(quantised.find("\"scale\":[1e-09,1.52590") != std::string::npos);  // no finer than the grid
        const std::string packed = jsonOf(strip(1), GlbPacking::Compressed);
        QVERIFY(packed.find("[\"KHR_mesh_quantization\",\"EXT_meshopt_compression\"]") != std::string::npos);
        QVERIFY(packed.find("\"fallback\":true") != std::string::npos);
    }

    void filesAreOfGlbsForm() {
        GltfScene scene(GlbPacking::Plain);
        const auto mesh = scene.addMesh(strip(1), scene.addMaterial("m", 0, 1.0, false), false);
        const std::vector<std::string> pieces = scene.finish(scene.addNode({{}, {}, mesh.row, {}, {}}), "test");
        std::string file;
        for (const std::string& piece : pieces) {
            file += piece;
        }
        QVERIFY(file.starts_with(std::string("glTF\2\0\0\0", 8)));
        QCOMPARE(file.size() % 4, std::size_t{0});
        QCOMPARE(static_cast<std::size_t>(static_cast<unsigned char>(file[8])) +
                     256 * static_cast<std::size_t>(static_cast<unsigned char>(file[9])),
                 file.size());
        QCOMPARE(scene.triangles(), std::uint64_t{12});
    }
};

QTEST_GUILESS_MAIN(GltfSceneTest)
#include "gltf_scene_test.moc"
