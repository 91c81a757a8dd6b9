#include "model/export/meshes/stl_export.h"

#include <QtTest>
#include <cstring>

#include "model/text/whole_file.h"
#include "tests/unit/model/export/meshes/mesh_board.h"

using namespace mesh_board;

namespace {

using Corner = std::array<float, 3>;

struct Triangle {
    Corner normal;
    std::array<Corner, 3> corners;
};

std::vector<Triangle> trianglesIn(const std::string& file) {
    std::uint32_t count = 0;
    std::memcpy(&count, file.data() + 80, 4);
    if (file.size() != 84 + std::size_t{50} * count || file.starts_with("solid")) {
        qFatal("no binary STL");
    }
    std::vector<Triangle> triangles(count);
    for (std::size_t i = 0; i < count; ++i) {
        std::memcpy(triangles[i].normal.data(), file.data() + 84 + 50 * i, 12);
        std::memcpy(triangles[i].corners.data(), file.data() + 84 + 50 * i + 12, 36);
    }
    return triangles;
}

double volumeOf(const std::vector<Triangle>& triangles) {
    double sixfold = 0.0;
    for (const Triangle& t : triangles) {
        const auto& [a, b, c] = t.corners;
        sixfold += double{a[0]} * (double{b[1]} * c[2] - double{b[2]} * c[1]) +
                   double{a[1]} * (double{b[2]} * c[0] - double{b[0]} * c[2]) +
                   double{a[2]} * (double{b[0]} * c[1] - double{b[1]} * c[0]);
    }
    return sixfold / 6;
}

std::vector<Triangle> exported(const model::Document& document, model::MeshReport& report) {
    const QTemporaryDir folder;
    const std::string path = folder.filePath("board.stl").toStdString();
    base::Progress progress;
    auto done = model::exportStl(planOf(document), {{}, "board", {500.0}}, path, progress);
    if (!done) {
        qFatal("%s", done.error().text.c_str());
    }
    report = *done;
    const std::string file = *model::readWholeFile(path);
    if (file.size() != report.bytes) {
        qFatal("%zu bytes", file.size());
    }
    return trianglesIn(file);
}

}  // namespace

class StlExportTest : public QObject {
    Q_OBJECT

private slots:
    void trianglesCloseTheSolids() {
        model::MeshReport report;
        const std::vector<Triangle> triangles = exported(*board(), report);
        QCOMPARE(triangles.size(), static_cast<std::size_t>(report.triangles));
        QVERIFY(isNear(volumeOf(triangles), kBoard, 1e-3));
        std::map<Corner, std::uint32_t> rows;
        std::vector<std::uint32_t> corners;
        for (const Triangle& t : triangles) {
            for (const Corner& c : t.corners) {
                corners.push_back(rows.try_emplace(c, static_cast<std::uint32_t>(rows.size())).first->second);
            }
            const double length = std::hypot(t.normal[0], t.normal[1], t.normal[2]);
            QVERIFY(std::abs(length - 1.0) < 1e-5);
        }
        QVERIFY(isClosed(corners));
    }

    void copiesAreWrittenOut() {
        model::MeshReport report;
        QVERIFY(isNear(volumeOf(exported(*panel(), report)), 3 * kBoard, 1e-3));
    }

    void failuresLeaveNothing() { checkFailures(model::exportStl, model::MeshOptions{}); }
};

QTEST_GUILESS_MAIN(StlExportTest)
#include "stl_export_test.moc"
