#pragma once

#include <QtTest>
#include <numbers>
#include <string>
#include <vector>

#include "model/export/drawings/drawing.h"
#include "model/text/whole_file.h"
#include "tests/unit/model/hand_made.h"

/// What the tests of all kinds of drawings draw.
namespace drawn_board {

using hand_made::kMm;
using hand_made::kUm;

inline constexpr double kDisc = std::numbers::pi;               // mm², 2 mm wide
inline constexpr double kDonut = 3 * std::numbers::pi;          // 4 mm and 2 mm wide
inline constexpr double kTrack = 10.0 + std::numbers::pi / 4;   // 10 mm long, 1 mm wide
inline constexpr double kPlane = 400.0 - 4 * std::numbers::pi;  // 20 mm square, a hole 4 mm wide in it
inline constexpr double kBend = (16.0 - 9.0) * std::numbers::pi / 4 + std::numbers::pi / 4;  // a quarter of a ring
inline constexpr double kTop = kDisc + kDonut + kTrack + kBend;
inline constexpr double kBottom = kPlane;

/// "top <1>" with a disc at (3, 4) mm, a donut, a track, a quarter of a ring and one without width at line 77, "bottom"
/// with a square, a drill with a plated hole of 1 mm and an NPTH of 2 mm; the outline is 60 by 40 mm from (0, 0).
inline std::shared_ptr<const model::Document> board() {
    model::DocumentBuilder builder;
    builder.job().name = "job & co";
    const model::LayerId top = hand_made::addLayer(builder, "top <1>");
    const model::LayerId bottom = hand_made::addLayer(builder, "bottom");
    builder.layer(top).opposite = bottom;
    builder.layer(bottom).opposite = top;
    builder.layer(bottom).side = model::LayerSide::Bottom;
    builder.layer(top).file = "layers/top/features";
    const model::LayerId drill = hand_made::addDrill(builder, top, bottom);
    builder.beginLayer(top);
    builder.addCircle({{3 * kMm, 4 * kMm}, 2 * kMm, 0}, {});
    builder.addCircle({{10 * kMm, 10 * kMm}, 4 * kMm, 2 * kMm}, {});
    builder.addLine({{20 * kMm, 10 * kMm}, {30 * kMm, 10 * kMm}, kMm}, {});
    builder.addArc({{{43'500 * kUm, 20 * kMm}, {40 * kMm, 20 * kMm}, model::EdgeKind::ArcCounterClockwise},
                    {40 * kMm, 23'500 * kUm},
                    kMm},
                   {});
    model::DocumentBuilder::Origin nothing;
    nothing.line = 77;
    builder.addLine({{0, 0}, {kMm, 0}, 0}, nothing);
    builder.beginLayer(bottom);
    model::ShapeSketch plane = hand_made::rectangle({10 * kMm, 10 * kMm}, {30 * kMm, 30 * kMm});
    plane.addCircle({20 * kMm, 20 * kMm}, 2 * kMm, true);
    builder.addArea({builder.addShape(plane), {}}, {});
    builder.beginLayer(drill);
    builder.addCircle({{3 * kMm, 4 * kMm}, kMm, 900 * kUm}, hand_made::flagged(model::kHole | model::kPlated));
    builder.addCircle({{50 * kMm, 30 * kMm}, 2 * kMm, 2 * kMm}, hand_made::flagged(model::kHole));
    builder.setProfile(builder.addShape(hand_made::rectangle({0, 0}, {60 * kMm, 40 * kMm})));
    return builder.finish();
}

/// A layer of type Profile: a track, a disc and an area 20 mm square.
inline std::shared_ptr<const model::Document> boardOfOutlines() {
    model::DocumentBuilder builder;
    const model::LayerId outlines = hand_made::addLayer(builder, "Edge.Cuts");
    builder.layer(outlines).type = model::LayerType::Profile;
    builder.beginLayer(outlines);
    builder.addLine({{20 * kMm, 10 * kMm}, {30 * kMm, 10 * kMm}, kMm}, {});
    builder.addCircle({{3 * kMm, 4 * kMm}, 2 * kMm, 0}, {});
    builder.addArea({builder.addShape(hand_made::rectangle({10 * kMm, 10 * kMm}, {30 * kMm, 30 * kMm})), {}}, {});
    return builder.finish();
}

/// Bodies on a layer of the bottom: of R1, 4 by 2 mm around (2, 1) mm, of "U<10>", 1 by 8 mm around (10.5, 4), and of a
/// component without a designator.
inline std::shared_ptr<const model::Document> boardOfBodies() {
    model::DocumentBuilder builder;
    const model::LayerId bodies = hand_made::addLayer(builder, "bodies");
    builder.layer(bodies).type = model::LayerType::ComponentBody;
    builder.layer(bodies).side = model::LayerSide::Bottom;
    builder.beginLayer(bodies);
    const auto add = [&](const char* refdes, model::Point min, model::Point max) {
        model::Component component;
        component.refdes = refdes;
        const model::ComponentId id = builder.addComponent(component, {});
        const model::ShapeId shape = builder.addShape(hand_made::rectangle(min, max));
        builder.addBody({builder.addArea({shape, {}}, {}), id, kMm, model::Source::Job});
    };
    add("R1", {0, 0}, {4 * kMm, 2 * kMm});
    add("U<10>", {10 * kMm, 0}, {11 * kMm, 8 * kMm});
    add("", {20 * kMm, 0}, {24 * kMm, 4 * kMm});
    return builder.finish();
}

/// The board twice: 100 mm to the right, and turned over at x = 0.
inline std::shared_ptr<const model::Document> panel() {
    const auto step = board();
    model::DocumentBuilder builder;
    for (const model::Layer& layer : step->layers) {
        model::Layer own = layer;
        own.elements = {};
        builder.addLayer(own);
    }
    const std::uint32_t row = builder.addStep(step);
    builder.addInstance({row, {{100 * kMm, 0}, 0.0, false}, false});
    builder.addInstance({row, {{0, 0}, 0.0, true}, true});
    return builder.finish();
}

/// The file that a form writes; fails the test when it does not.
template <class Write>
std::string written(const Write& write) {
    const QTemporaryDir folder;
    const std::string path = folder.filePath("drawing").toStdString();
    model::FileWriter file(path);
    base::Progress progress;
    const auto report = write(file, progress);
    if (!report || !file.commit()) {
        qFatal("not written");
    }
    return *model::readWholeFile(path);
}

/// What every form does when the work is cancelled, when the disk is full, and when nothing is drawn.
template <class Write>
void checkFailures(const Write& write) {
    const QTemporaryDir folder;
    {
        model::FileWriter file(folder.filePath("drawing").toStdString());
        base::Progress cancelled;
        cancelled.cancel();
        const auto report = write(*board(), model::DrawingOptions{}, file, cancelled);
        QVERIFY(!report && report.error().code == base::ErrorCode::Cancelled);
        model::FileWriter full("/nowhere/drawing");
        base::Progress progress;
        const auto failed = write(*board(), model::DrawingOptions{}, full, progress);
        QVERIFY(!failed && failed.error().code == base::ErrorCode::OutputFailed);
        model::DrawingOptions none{std::vector<bool>(3, false), {}, false};
        const auto nothing = write(*board(), none, file, progress);
        QVERIFY(!nothing && nothing.error().code == base::ErrorCode::BadUsage);
    }
    QVERIFY(QDir(folder.path()).entryList(QDir::Files).isEmpty());
}

/// Twice the area under a chord, and the area between a chord and its arc.
inline double underChord(double ax, double ay, double bx, double by) {
    return (ax * by - bx * ay) / 2;
}
inline double besideChord(double chord, double sweep) {
    const double radius = chord / 2 / std::sin(std::abs(sweep) / 2);
    return std::copysign(radius * radius / 2 * (std::abs(sweep) - std::sin(std::abs(sweep))), sweep);
}

}  // namespace drawn_board
