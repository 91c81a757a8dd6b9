#include "model/export/solids/step_export.h"

#include <QtTest>
#include <cmath>
#include <numbers>

#include "tests/unit/model/export/solids/step_file_reading.h"
#include "tests/unit/model/geometry/some_curves.h"
#include "tests/unit/model/hand_made.h"

using namespace hand_made;
using model::LayerType;
using model::SolidPlan;
using model::StepOptions;

namespace {

constexpr std::array<StackLayer, 4> kStackup{{{"top", LayerType::Signal, 1'600 * kUm, 35 * kUm, 2},
                                              {"inner", LayerType::Signal, 800 * kUm, 35 * kUm, 1},
                                              {"bottom", LayerType::Signal, 0, 35 * kUm, 0},
                                              {"drill", LayerType::Drill, 0, 1'635 * kUm, 3}}};

/// Two tracks that touch, three equal discs and two equal pads on top, a pour inside, two plated holes and an NPTH.
std::shared_ptr<const model::Document> board() {
    model::DocumentBuilder builder;
    addLayers(builder, kStackup);
    const model::NetId gnd = builder.addNet("GND");
    const model::NetId signal = builder.addNet("SIG'NAL");
    builder.beginLayer(model::LayerId{std::size_t{0}});
    builder.addLine({{0, 0}, {kMm, 0}, 200 * kUm, 0}, of(gnd));
    builder.addLine({{kMm, 0}, {kMm, kMm}, 200 * kUm, 0}, of(gnd));
    for (const model::Nm x : {5 * kMm, 6 * kMm, 7 * kMm}) {
        builder.addCircle({{x, 0}, 500 * kUm, 0}, of(signal, model::kPad));
    }
    const model::ShapeId pad = builder.addShape(rectangle({-300 * kUm, -100 * kUm}, {300 * kUm, 100 * kUm}));
    builder.addArea({pad, {{0, 5 * kMm}, 30.0, false}}, of(signal, model::kPad));
    builder.addArea({pad, {{0, 7 * kMm}, 0.0, true}}, of(signal, model::kPad));
    builder.beginLayer(model::LayerId{std::size_t{1}});
    builder.addArea({builder.addShape(rectangle({0, 0}, {9 * kMm, 9 * kMm})), {}}, of(gnd));
    builder.addLine({{0, 0}, {0, 0}, 0, 0}, of(gnd));
    builder.beginLayer(model::LayerId{std::size_t{3}});
    for (const model::Nm x : {5 * kMm, 6 * kMm}) {
        builder.addCircle({{x, 0}, 300 * kUm, 250 * kUm}, of(signal, model::kHole | model::kPlated | model::kVia));
    }
    builder.addCircle({{8 * kMm, 0}, 900 * kUm, 900 * kUm}, flagged(model::kHole));
    return std::move(builder).finish();
}

/// A plane with a jagged outline of so many corners among tracks of as many lengths.
std::shared_ptr<const model::Document> planeAmongTracks(int corners, int tracks) {
    model::DocumentBuilder builder;
    addLayers(builder, kStackup);
    builder.beginLayer(model::LayerId{std::size_t{0}});
    std::vector<model::Point> outline;
    for (int i = 0; i < corners; ++i) {
        outline.push_back({i * 50 * kUm, i % 2 * 100 * kUm});
    }
    outline.push_back({corners * 50 * kUm, 10 * kMm});
    outline.push_back({0, 10 * kMm});
    model::ShapeSketch plane;
    plane.addPolygon(outline, false);
    builder.addArea({builder.addShape(plane), {}}, {});
    for (int i = 0; i < tracks; ++i) {
        const model::Nm y = 20 * kMm + i * 200 * kUm;
        builder.addLine({{0, y}, {kMm + i * kUm, y}, 100 * kUm, 0}, {});
    }
    return std::move(builder).finish();
}

/// One square of copper whose corners are rounded with so many chords each; `side` is what is left straight between
/// them.
std::shared_ptr<const model::Document> roundedPlane(int chords, model::Nm side = 40 * kMm) {
    model::DocumentBuilder builder;
    addLayers(builder, kStackup);
    builder.beginLayer(model::LayerId{std::size_t{0}});
    const double radius = 5.0 * kMm;
    std::vector<model::Point> outline;
    for (int corner = 0; corner < 4; ++corner) {
        const model::Nm x = corner == 1 || corner == 2 ? 0 : side;
        const model::Nm y = corner < 2 ? side : 0;
        for (int i = 0; i <= chords; ++i) {
            const double angle = (corner + static_cast<double>(i) / chords) * std::numbers::pi / 2;
            const model::Point p{x + static_cast<model::Nm>(std::lround(radius * std::cos(angle))),
                                 y + static_cast<model::Nm>(std::lround(radius * std::sin(angle)))};
            if ((outline.empty() || outline.back() != p) && (outline.empty() || outline.front() != p)) {
                outline.push_back(p);
            }
        }
    }
    model::ShapeSketch plane;
    plane.addPolygon(outline, false);
    builder.addArea({builder.addShape(plane), {}}, {});
    return std::move(builder).finish();
}

struct Exported {
    model::SolidReport report;
    QString text;
    std::map<int, StepEntity> entities;
};

Exported exported(const model::Document& document, const model::SolidChoice& choice, const StepOptions& options) {
    const QTemporaryDir folder;
    base::Progress progress;
    const SolidPlan plan = *model::planSolids(document, choice, progress);
    const std::filesystem::path path = folder.filePath("board.step").toStdString();
    Exported result;
    result.report = *model::exportStep(plan, options, path, progress);
    QFile file(QString::fromStdString(path.string()));
    if (file.open(QFile::ReadOnly)) {
        result.text = file.readAll();
    }
    result.entities = entitiesOf(result.text);
    return result;
}

Exported exported(const model::SolidChoice& choice, const StepOptions& options = {}) {
    return exported(*board(), choice, options);
}

}  // namespace

class StepExportTest : public QObject {
    Q_OBJECT

private slots:
    void everyEdgeIsInTwoFacesAndEveryReferenceLeadsSomewhere() {
        const Exported all = exported({});
        QVERIFY(all.entities.size() > 100);
        QCOMPARE(faultOf(all.entities), QString());
        QVERIFY(all.text.startsWith("ISO-10303-21;\n") && all.text.endsWith("END-ISO-10303-21;\n"));
    }

    void cylindersFaceOutwardsButThoseOfHoles() {
        const Exported all = exported({});
        QStringList inward;
        for (const auto& [id, face] : all.entities) {
            if (face.name == "ADVANCED_FACE" && face.body.endsWith(",.F.)")) {
                const StepEntity& surface = all.entities.at(face.references.back());
                inward << (surface.name == "CYLINDRICAL_SURFACE" ? surface.body.section(',', -1) : QString());
            }
        }
        inward.removeAll(QString());
        inward.sort();
        // Within the barrel of a plated hole, around two barrels at the edge of the pour and one in a pad, of an NPTH.
        QCOMPARE(inward, QStringList({"0.125)", "0.15)", "0.15)", "0.15)", "0.45)"}));
    }

    void equalTracksPadsAndBarrelsAreWrittenOnce() {
        const Exported all = exported({});
        // One track, the pour, one disc that is drilled and one that is not, one pad and its mirror image, one barrel.
        QCOMPARE(all.report.solids, std::uint64_t{7});
        QCOMPARE(all.report.copies, std::uint64_t{6});
        QCOMPARE(countOf(all.entities, "MANIFOLD_SOLID_BREP"), 7);
        QCOMPARE(countOf(all.entities, "MAPPED_ITEM"), 6);
        QCOMPARE(countOf(all.entities, "STYLED_ITEM"), 7);
    }

    /// Two layers of drills at the same heights, two equal barrels on each.
    void layersOfTwoColoursShareNoShapes() {
        model::DocumentBuilder builder;
        addLayers(builder, kStackup);
        addLayers(builder, std::array{StackLayer{"vias", LayerType::Drill, 0, 1'635 * kUm, 4}});
        for (const std::size_t layer : {std::size_t{3}, std::size_t{4}}) {
            builder.beginLayer(model::LayerId{layer});
            for (const model::Nm x : {kMm, 2 * kMm}) {
                const auto y = static_cast<model::Nm>(layer) * kMm;
                builder.addCircle({{x, y}, 300 * kUm, 250 * kUm}, flagged(model::kHole | model::kPlated));
            }
        }
        const auto document = builder.finish();
        StepOptions options;
        options.looks.resize(5);
        const Exported alike = exported(*document, {}, options);
        QCOMPARE(alike.report.solids, std::uint64_t{1});
        QCOMPARE(alike.report.copies, std::uint64_t{4});
        options.looks[3].rgb = 0xff0000;
        options.looks[4].rgb = 0x0000ff;
        const Exported two = exported(*document, {}, options);
        QCOMPARE(two.report.solids, std::uint64_t{2});
        QCOMPARE(two.report.copies, std::uint64_t{4});
        QCOMPARE(countOf(two.entities, "COLOUR_RGB"), 2);
        QCOMPARE(faultOf(two.entities), QString());
    }

    void whatIsWrittenOutHasNoCopies() {
        StepOptions options;
        options.isWrittenOut = true;
        const Exported all = exported({}, options);
        QCOMPARE(all.report.solids, std::uint64_t{10});
        QCOMPARE(countOf(all.entities, "MAPPED_ITEM"), 0);
        QCOMPARE(faultOf(all.entities), QString());
    }

    void theTreeHasLayersAndNetsByName() {
        StepOptions options;
        options.name = "\xCE\xA9 board";
        const Exported all = exported({}, options);
        for (const char* name : {"'\\X2\\03A9\\X0\\ board'", "'top'", "'inner'", "'drill'", "'GND'", "'SIG''NAL'"}) {
            QVERIFY2(all.text.contains(QString("PRODUCT(%1,").arg(name)), name);
        }
        QCOMPARE(countOf(all.entities, "PRODUCT"), 8);  // the board, three layers, four nets on them
        QCOMPARE(countOf(all.entities, "NEXT_ASSEMBLY_USAGE_OCCURRENCE"), 7);
        model::SolidChoice choice;
        choice.isOnePart = true;
        QCOMPARE(countOf(exported(choice).entities, "PRODUCT"), 1);
    }

    void touchingCopperIsOneSolidWhenMerged() {
        model::SolidChoice choice;
        choice.isMerged = true;
        choice.layers = {model::LayerId{std::size_t{0}}};
        choice.nets = {"GND"};
        const Exported merged = exported(choice);
        QCOMPARE(merged.report.solids, std::uint64_t{1});
        QCOMPARE(faultOf(merged.entities), QString());
    }

    void curvesAreWrittenAsThemselves() {
        model::DocumentBuilder builder;
        addLayers(builder, kStackup);
        builder.beginLayer(model::LayerId{std::size_t{0}});
        const model::Nurbs rational = model::testing::circleCurve({0, 0}, 1e6);
        const model::Nurbs plain{3,
                                 {0, 0, 0, 0, 1, 2, 2, 2, 2},
                                 {{{4e6, 0}, 1}, {{5e6, 1e6}, 1}, {{6e6, -1e6}, 1}, {{7e6, 1e6}, 1}, {{8e6, 0}, 1}}};
        model::ShapeSketch disc;
        disc.beginContour(false);
        disc.addCurve({kMm, 0}, rational.view(), {kMm, 0});
        model::ShapeSketch bay;
        bay.beginContour(false);
        bay.addNode(model::Point{4 * kMm, 3 * kMm});
        bay.addCurve({4 * kMm, 0}, plain.view(), {8 * kMm, 0});
        bay.addNode(model::Point{8 * kMm, 0});
        bay.addNode(model::Point{8 * kMm, 3 * kMm});
        for (const model::ShapeSketch& sketch : {disc, bay}) {
            builder.addArea({builder.addShape(sketch), {{0, 0}, 0.0, &sketch == &bay}}, {});
        }
        const auto document = builder.finish();
        const QTemporaryDir folder;
        base::Progress progress;
        const SolidPlan plan = *model::planSolids(*document, {}, progress);
        const std::filesystem::path path = folder.filePath("curves.step").toStdString();
        QCOMPARE((*model::exportStep(plan, {}, path, progress)).solids, std::uint64_t{2});
        QFile file(QString::fromStdString(path.string()));
        QVERIFY(file.open(QFile::ReadOnly));
        const QString text = file.readAll();
        const auto entities = entitiesOf(text);
        QCOMPARE(faultOf(entities), QString());
        QCOMPARE(countOf(entities, "B_SPLINE_CURVE_WITH_KNOTS"), 2);
        QCOMPARE(text.count("RATIONAL_B_SPLINE_CURVE"), 2);
        QCOMPARE(countOf(entities, "SURFACE_OF_LINEAR_EXTRUSION"), 2);
        QCOMPARE(countOf(entities, "CYLINDRICAL_SURFACE"), 0);
    }

    void whatCannotBeBuiltIsListedWithItsReason() {
        const Exported all = exported({});
        QCOMPARE(all.report.missing.size(), std::size_t{1});
        QCOMPARE(QString::fromStdString(std::string(all.report.missing.front().reason)), QString("it has no width"));
    }

    void estimatesAreNear() {
        const auto document = board();
        base::Progress progress;
        const SolidPlan plan = *model::planSolids(*document, {}, progress);
        const double bytes = static_cast<double>(exported({}).text.size());
        const double estimate = model::estimateStep(plan, {}, progress)->bytes;
        QVERIFY2(estimate > 0.6 * bytes && estimate < 1.7 * bytes, qPrintable(QString::number(estimate / bytes)));
    }

    void estimatesCanBeCancelled() {
        const auto document = board();
        base::Progress progress;
        const SolidPlan plan = *model::planSolids(*document, {}, progress);
        progress.cancel();
        const auto estimate = model::estimateStep(plan, {}, progress);
        QVERIFY(!estimate && estimate.error().code == base::ErrorCode::Cancelled);
    }

    void estimatesOfPlanesAmongManyTracksAreNear() {
        const QTemporaryDir folder;
        const auto document = planeAmongTracks(9000, 4000);
        base::Progress progress;
        const SolidPlan plan = *model::planSolids(*document, {}, progress);
        const std::filesystem::path path = folder.filePath("board.step").toStdString();
        const double bytes = static_cast<double>((*model::exportStep(plan, {}, path, progress)).bytes);
        const double estimate = model::estimateStep(plan, {}, progress)->bytes;
        QVERIFY2(estimate > 0.7 * bytes && estimate < 1.4 * bytes, qPrintable(QString::number(estimate / bytes)));
    }

    void chordsAroundABendAreOnePolyline() {
        StepOptions options;
        options.hasPolylines = true;
        const auto document = roundedPlane(24);
        const Exported single = exported(*document, {}, {});
        const Exported chained = exported(*document, {}, options);
        QCOMPARE(faultOf(chained.entities), QString());
        // The long sides stay planes, each of the four corners becomes a wall with its bends.
        QCOMPARE(countOf(single.entities, "ADVANCED_FACE"), 2 + 4 + 4 * 24);
        QCOMPARE(countOf(chained.entities, "ADVANCED_FACE"), 2 + 4 + 4);
        QCOMPARE(countOf(chained.entities, "SURFACE_OF_LINEAR_EXTRUSION"), 4);
        QCOMPARE(countOf(chained.entities, "POLYLINE"), 8);
        for (const auto& [id, entity] : chained.entities) {
            QVERIFY(entity.name != "POLYLINE" || entity.references.size() == 25);
        }
        base::Progress progress;
        const double bytes = static_cast<double>(chained.text.size());
        const double estimate =
            model::estimateStep(*model::planSolids(*document, {}, progress), options, progress)->bytes;
        QVERIFY2(estimate > 0.5 * bytes && estimate < 1.5 * bytes, qPrintable(QString::number(estimate / bytes)));
    }

    void aLoopHasAtLeastThreeEdges() {
        StepOptions options;
        options.hasPolylines = true;
        const Exported round = exported(*roundedPlane(24, 0), {}, options);
        QCOMPARE(faultOf(round.entities), QString());
        QCOMPARE(countOf(round.entities, "ADVANCED_FACE"), 2 + 3);
    }

    void cancelledAndFailedExportsLeaveNothing() {
        const QTemporaryDir folder;
        const auto document = board();
        base::Progress progress;
        const SolidPlan plan = *model::planSolids(*document, {}, progress);
        const std::filesystem::path path = folder.filePath("board.step").toStdString();
        progress.cancel();
        const auto cancelled = model::exportStep(plan, {}, path, progress);
        QVERIFY(!cancelled && cancelled.error().code == base::ErrorCode::Cancelled);
        base::Progress other;
        const auto full = model::exportStep(plan, {}, "/dev/full", other);
        QVERIFY(!full && full.error().code == base::ErrorCode::OutputFailed);
        const auto nowhere = model::exportStep(plan, {}, path / "no" / "folder.step", other);
        QVERIFY(!nowhere && nowhere.error().code == base::ErrorCode::OutputFailed);
        QVERIFY(QDir(folder.path()).isEmpty());
    }
};

QTEST_APPLESS_MAIN(StepExportTest)
#include "step_export_test.moc"
