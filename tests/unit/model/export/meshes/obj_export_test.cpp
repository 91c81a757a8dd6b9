#include "model/export/meshes/obj_export.h"

#include <QtTest>
#include <sstream>

#include "model/text/whole_file.h"
#include "tests/unit/model/export/meshes/mesh_board.h"

using namespace mesh_board;

namespace {

struct Obj {
    std::vector<std::array<double, 3>> points;
    std::vector<std::uint32_t> corners;
    std::vector<std::string> lines;  ///< all but points and faces

    explicit Obj(const std::string& text) {
        std::istringstream in(text);
        for (std::string line; std::getline(in, line);) {
            std::istringstream words(line);
            std::string kind;
            words >> kind;
            if (kind == "v") {
                auto& p = points.emplace_back();
                words >> p[0] >> p[1] >> p[2];
            } else if (kind == "f") {
                for (std::uint32_t corner = 0; words >> corner;) {
                    corners.push_back(corner - 1);
                }
            } else {
                lines.push_back(line);
            }
        }
    }

    [[nodiscard]] double volume() const {
        double sixfold = 0.0;
        for (std::size_t i = 0; i < corners.size(); i += 3) {
            const auto& a = points.at(corners[i]);
            const auto& b = points.at(corners[i + 1]);
            const auto& c = points.at(corners[i + 2]);
            sixfold += a[0] * (b[1] * c[2] - b[2] * c[1]) + a[1] * (b[2] * c[0] - b[0] * c[2]) +
                       a[2] * (b[0] * c[1] - b[1] * c[0]);
        }
        return sixfold / 6;
    }
};

}  // namespace

class ObjExportTest : public QObject {
    Q_OBJECT

private slots:
    void objectsAreLayersAndGroupsNets() {
        const QTemporaryDir folder;
        const std::string path = folder.filePath("board.obj").toStdString();
        base::Progress progress;
        const auto document = board();
        const model::MeshOptions options{{{0xFF8000, 1.0}, {}, {0x0000FF, 0.5}, {}}, "board", {500.0}};
        const auto report = model::exportObj(planOf(*document), options, path, progress);
        QVERIFY(report);
        const Obj obj(*model::readWholeFile(path));
        const std::vector<std::string> expected{
            "# Copperscope, mm", "mtllib board.mtl", "o top", "usemtl top", "g A_\"1\"",    "g B",
            "o bottom",          "usemtl bottom",    "g B",   "o drill",    "usemtl drill", "g A_\"1\""};
        QCOMPARE(obj.lines, expected);
        QVERIFY(isClosed(obj.corners));
        QVERIFY(isNear(obj.volume(), kBoard, 1e-3));
        QCOMPARE(obj.corners.size(), static_cast<std::size_t>(3 * report->triangles));
        const std::string materials = *model::readWholeFile(folder.filePath("board.mtl").toStdString());
        QVERIFY(materials.find("newmtl top\nKd 1 0.502 0\nd 1\n") != std::string::npos);
        QVERIFY(materials.find("newmtl bottom\nKd 0 0 1\nd 0.5\n") != std::string::npos);
        QCOMPARE(report->bytes, std::filesystem::file_size(path) + materials.size());
    }

    void copiesAreWrittenOut() {
        const QTemporaryDir folder;
        const std::string path = folder.filePath("panel.obj").toStdString();
        base::Progress progress;
        const auto document = panel();
        QVERIFY(model::exportObj(planOf(*document), {{}, "panel", {500.0}}, path, progress));
        const Obj obj(*model::readWholeFile(path));
        QVERIFY(isNear(obj.volume(), 3 * kBoard, 1e-3));
        QCOMPARE(std::ranges::count(obj.lines, "o top_2"), 1);
    }

    void failuresLeaveNothing() { checkFailures(model::exportObj, model::MeshOptions{}); }
};

QTEST_GUILESS_MAIN(ObjExportTest)
#include "obj_export_test.moc"
