#include <QTemporaryDir>
#include <QtTest>

#include "model/export/meshes/glb_export.h"
#include "tests/counted_memory.h"
#include "tests/unit/model/export/meshes/mesh_board.h"

namespace {

constexpr int kNets = 160;
constexpr int kTeeth = 2'000;

/// A rectangle with so many teeth on one side.
model::ShapeSketch comb() {
    std::vector<model::Point> corners = {{kTeeth * mesh_board::kUm, mesh_board::kMm}, {0, mesh_board::kMm}};
    for (int i = 0; i <= kTeeth; ++i) {
        corners.push_back({i * mesh_board::kUm, i % 2 * mesh_board::kUm});
    }
    model::ShapeSketch sketch;
    sketch.addPolygon(corners, false);
    return sketch;
}

std::shared_ptr<const model::Document> combs() {
    model::DocumentBuilder builder;
    const hand_made::StackLayer layers[] = {{"top", model::LayerType::Signal, 0, 35'000, 0}};
    hand_made::addLayers(builder, layers);
    builder.beginLayer(model::LayerId{0});
    for (int i = 0; i < kNets; ++i) {
        const model::NetId net = builder.addNet("N" + std::to_string(i));
        builder.addArea({builder.addShape(comb()), {{0, i * 5 * mesh_board::kMm}, 0.0, false}}, hand_made::of(net));
    }
    return builder.finish();
}

}  // namespace

class GlbMemoryTest : public QObject {
    Q_OBJECT

private slots:
    /// The mesh of a net is in memory, those of all nets and the file are not.
    void lessIsTakenThanTheFileIsLarge() {
        const auto document = combs();
        const model::SolidPlan plan = mesh_board::planOf(*document);
        const QTemporaryDir folder;
        base::Progress progress;
        const std::size_t before = counted::memory().live;
        counted::resetPeak();
        const auto report = model::exportGlb(plan, {}, folder.filePath("a.glb").toStdString(), progress);
        const std::size_t taken = counted::memory().peak - before;
        QVERIFY(report);
        qInfo("%zu MB taken for a file of %zu MB", taken / 1'000'000,
              static_cast<std::size_t>(report->bytes) / 1'000'000);
        QVERIFY(taken < report->bytes);
    }
};

QTEST_GUILESS_MAIN(GlbMemoryTest)
#include "glb_memory_test.moc"
