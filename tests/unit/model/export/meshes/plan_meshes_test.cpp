#include "model/export/meshes/plan_meshes.h"

#include <QtTest>

#include "model/base/parallel.h"
#include "tests/unit/model/export/meshes/mesh_board.h"

using namespace mesh_board;
using model::StepMeshes;

namespace {

constexpr double kMm3 = 1e18;

StepMeshes made(const model::SolidPlan& plan, std::uint32_t step = 0) {
    base::Progress progress;
    auto meshes = model::meshesOf(plan, step, {500.0}, progress);
    if (!meshes) {
        qFatal("%s", meshes.error().text.c_str());
    }
    return std::move(*meshes);
}

double volumeOf(const StepMeshes& meshes) {
    double volume = 0.0;
    for (const model::GroupMesh& group : meshes.groups) {
        volume += model::volumeOf(model::writtenOut(meshes, group)) / kMm3;
    }
    return volume;
}

}  // namespace

class PlanMeshesTest : public QObject {
    Q_OBJECT

private slots:
    void equalShapesAreMadeOnce() {
        const auto document = board();
        const model::SolidPlan plan = planOf(*document);
        const StepMeshes meshes = made(plan);
        QCOMPARE(meshes.shapes.size(), std::size_t{3});  // disc, pad, barrel
        QCOMPARE(meshes.groups.size(), std::size_t{4});
        QCOMPARE(meshes.groups[0].placed.size(), std::size_t{2});  // discs that are drilled alike
        const double disc = std::numbers::pi * kHigh;
        QVERIFY(isNear(model::volumeOf(meshes.groups[0].own) / kMm3, kTracks + disc, 2e-4));
        QVERIFY(meshes.groups[1].placed.empty());  // the plane
        QVERIFY(isNear(model::volumeOf(meshes.groups[1].own) / kMm3, kPlane, 2e-5));
        QVERIFY(meshes.groups[2].own.triangles.empty());
        QVERIFY(isNear(volumeOf(meshes), kBoard, 1e-3));
        for (const model::SolidMesh& shape : meshes.shapes) {
            QVERIFY(isClosed(shape.triangles));
        }
        QVERIFY(meshes.missing.empty());
    }

    void mergedNothingIsShared() {
        const auto document = board();
        model::SolidChoice choice;
        choice.isMerged = true;
        const StepMeshes meshes = made(planOf(*document, choice));
        QVERIFY(meshes.shapes.empty());
        for (const model::GroupMesh& group : meshes.groups) {
            QVERIFY(group.placed.empty() && isClosed(group.own.triangles));
        }
        QVERIFY(isNear(volumeOf(meshes), kBoard, 1e-3));
    }

    /// A pad with a via, a track that ends in it, a pad that its hole is larger than, and a plane with a hole in it and
    /// one across its edge.
    void copperIsDrilled() {
        model::DocumentBuilder builder;
        const hand_made::StackLayer layers[] = {{"top", model::LayerType::Signal, 1'000'000, 35'000, 2},
                                                {"core", model::LayerType::Dielectric, 0, 1'000'000, 1},
                                                {"bottom", model::LayerType::Signal, 0, 35'000, 0},
                                                {"drill", model::LayerType::Drill, 0, 0, 3}};
        hand_made::addLayers(builder, layers);
        const model::NetId net = builder.addNet("A");
        builder.beginLayer(model::LayerId{0});
        builder.addCircle({{0, 0}, 2 * kMm, 0}, hand_made::of(net));
        builder.addLine({{0, 0}, {10 * kMm, 0}, kMm}, hand_made::of(net));
        builder.addCircle({{0, -10 * kMm}, kMm, 0}, hand_made::of(net));
        builder.addCircle({{5 * kMm, -10 * kMm}, kMm, 0}, hand_made::of(net));
        const model::ShapeId plane = builder.addShape(hand_made::rectangle({0, 10 * kMm}, {10 * kMm, 20 * kMm}));
        builder.addArea({plane, {}}, hand_made::of(net));
        builder.beginLayer(model::LayerId{3});
        for (const model::Point at : {model::Point{0, 0}, {5 * kMm, 15 * kMm}, {0, 15 * kMm}}) {
            builder.addCircle({at, kMm, 900 * kUm}, hand_made::of(net, model::kHole | model::kPlated));
        }
        for (const model::Nm x : {0, 5 * kMm}) {
            builder.addCircle({{x, -10 * kMm}, 2 * kMm, 2 * kMm}, hand_made::flagged(model::kHole));
        }
        const auto document = builder.finish();
        const double pi = std::numbers::pi;
        const double overlap = std::sqrt(0.75) / 2 + pi / 6 + pi / 8;  // of the disc and the track
        const double merged = pi + (10 + pi / 4) - overlap - pi / 4 + 100 - pi / 4 - pi / 8;
        const double apart = pi - pi / 4 + 10 + 100 - pi / 4 - pi / 8;
        model::SolidChoice choice;
        choice.layers = {model::LayerId{0}};
        const StepMeshes single = made(planOf(*document, choice));
        QVERIFY(isNear(volumeOf(single), apart * 0.035, 2e-5));
        QVERIFY(single.missing.empty());  // a pad that is drilled away is none that failed
        choice.isMerged = true;
        const StepMeshes united = made(planOf(*document, choice));
        QVERIFY(isNear(volumeOf(united), merged * 0.035, 2e-5));
        for (const model::GroupMesh& group : united.groups) {
            QVERIFY(isClosed(group.own.triangles));
        }
    }

    void stepsThatAreTurnedOverLieOnTheOtherSide() {
        const auto document = panel();
        const model::SolidPlan plan = planOf(*document);
        QCOMPARE(plan.steps.size(), std::size_t{3});
        QVERIFY(isNear(volumeOf(made(plan, 1)), kBoard, 1e-3));
        const StepMeshes turned = made(plan, 2);
        QVERIFY(isNear(volumeOf(turned), kBoard, 1e-3));  // not inside out
        QVERIFY(std::ranges::all_of(turned.groups[1].own.points, [](const model::MeshPoint& p) {
            return p.z >= 0 && p.z <= 35'000;  // the plane, on the bottom now
        }));
    }

    void threadsDoNotMatter() {
        const auto document = board();
        const model::SolidPlan plan = planOf(*document);
        const StepMeshes all = made(plan);
        const base::ThreadLimit one(1);
        const StepMeshes alone = made(plan);
        for (std::size_t i = 0; i < all.groups.size(); ++i) {
            QVERIFY(all.groups[i].own.points == alone.groups[i].own.points);
            QVERIFY(all.groups[i].own.triangles == alone.groups[i].own.triangles);
        }
    }

    void workIsCancelled() {
        const auto document = board();
        const model::SolidPlan plan = planOf(*document);
        base::Progress progress;
        progress.cancel();
        const auto meshes = model::meshesOf(plan, 0, {}, progress);
        QVERIFY(!meshes && meshes.error().code == base::ErrorCode::Cancelled);
    }

    /// Narrower than the grid: a solid by its outline, but no triangles.
    void whatCannotBeTriangulatedIsSaid() {
        model::DocumentBuilder builder;
        const hand_made::StackLayer layers[] = {{"top", model::LayerType::Signal, 0, 35'000, 0}};
        hand_made::addLayers(builder, layers);
        builder.beginLayer(model::LayerId{0});
        builder.addCircle({{}, 1, 0}, {});
        builder.addCircle({{}, kMm, 0}, {});
        const auto document = builder.finish();
        const StepMeshes meshes = made(planOf(*document));
        QCOMPARE(meshes.missing.size(), std::size_t{1});
        QCOMPARE(meshes.missing[0].element, model::ElementId{0});
        QVERIFY(!meshes.missing[0].reason.empty());
    }
};

QTEST_GUILESS_MAIN(PlanMeshesTest)
#include "plan_meshes_test.moc"
