#include "model/export/meshes/gltf_scene.h"

#include <QTemporaryDir>
#include <QtTest>
#include <cstring>

#include "model/text/file_writer.h"
#include "model/text/whole_file.h"
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

/// The file of a scene with one mesh in one node.
std::string fileOf(const model::SolidMesh& mesh, GlbPacking packing) {
    const QTemporaryDir folder;
    const std::string path = folder.filePath("a.glb").toStdString();
    model::FileWriter file(path);
    GltfScene scene(packing, file.scratchPlace());
    const auto added = scene.addMesh(mesh, scene.addMaterial("copper", 0x808080, 1.0, true), true);
    const std::uint32_t node = scene.addNode({"n", {}, added.row, added.transform, {}});
    if (!scene.finish(node, "test", file, base::Progress()) || !file.commit() ||
        scene.triangles() != mesh.triangleCount()) {
        qFatal("not written");
    }
    return *model::readWholeFile(path);
}

std::size_t wordAt(const std::string& file, std::size_t at) {
    std::uint32_t word = 0;
    std::memcpy(&word, file.data() + at, sizeof word);
    return word;
}

std::string jsonOf(const model::SolidMesh& mesh, GlbPacking packing) {
    const std::string file = fileOf(mesh, packing);
    return file.substr(20, wordAt(file, 12));
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

    void filesAreOfGlbsForm_data() {
        QTest::addColumn<int>("squares");
        QTest::addRow("kept in memory") << 1;
        QTest::addRow("in files meanwhile") << 17'000;
    }
    void filesAreOfGlbsForm() {
        QFETCH(int, squares);
        for (const GlbPacking packing : {GlbPacking::Plain, GlbPacking::Quantised, GlbPacking::Compressed}) {
            const std::string file = fileOf(strip(squares), packing);
            QVERIFY(file.starts_with(std::string("glTF\2\0\0\0", 8)));
            QCOMPARE(wordAt(file, 8), file.size());
            const std::size_t json = wordAt(file, 12);
            QCOMPARE(file.substr(16, 4), std::string("JSON"));
            QCOMPARE(file.at(20), '{');
            QVERIFY(file.substr(20, json).find_last_of('}') + 4 >= json);
            QCOMPARE(20 + json + 8 + wordAt(file, 20 + json), file.size());
            QCOMPARE(file.substr(24 + json, 4), std::string("BIN\0", 4));
            QCOMPARE(file.size() % 4, std::size_t{0});
        }
    }

    void placesWithoutRoomAreSaid() {
        GltfScene scene(GlbPacking::Plain, {"/nowhere", "/nowhere/a.glb"});
        static_cast<void>(scene.addMesh(strip(1), 0, true));
        QVERIFY(scene.status());
        static_cast<void>(scene.addMesh(strip(17'000), 0, true));
        QVERIFY(!scene.status() && scene.status().error().code == base::ErrorCode::OutputFailed);
    }

    void writingIsCancelled() {
        const QTemporaryDir folder;
        model::FileWriter file(folder.filePath("a.glb").toStdString());
        GltfScene scene(GlbPacking::Plain, file.scratchPlace());
        base::Progress progress;
        progress.cancel();
        const base::Status done = scene.finish(scene.addNode({}), "test", file, progress);
        QVERIFY(!done && done.error().code == base::ErrorCode::Cancelled);
    }
};

QTEST_GUILESS_MAIN(GltfSceneTest)
#include "gltf_scene_test.moc"
