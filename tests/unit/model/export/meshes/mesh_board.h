#pragma once

#include <QtTest>
#include <algorithm>
#include <array>
#include <map>
#include <numbers>
#include <vector>

#include "model/export/meshes/mesh_export.h"
#include "tests/unit/model/hand_made.h"

/// What the tests of triangles export, and what they ask of them.
namespace mesh_board {

using hand_made::kMm;
using hand_made::kUm;

/// Copper of 35 µm on both sides of 1 mm.
inline constexpr std::array<hand_made::StackLayer, 4> kStackup{
    {{"top", model::LayerType::Signal, 1'035'000, 35'000, 2},
     {"core", model::LayerType::Dielectric, 35'000, 1'000'000, 1},
     {"bottom", model::LayerType::Signal, 0, 35'000, 0},
     {"drill", model::LayerType::Drill, 0, 0, 3}}};

/// On that stackup: on top of net A three equal discs (2 mm), two tracks at a right angle (10 mm each, 1 mm wide) and
/// of net B a square with a round hole; two plated holes of net A through two of the discs; on the bottom two equal
/// pads.
inline std::shared_ptr<const model::Document> board() {
    model::DocumentBuilder builder;
    builder.job().name = "board";
    builder.job().step = "card";
    hand_made::addLayers(builder, kStackup);
    for (model::Layer& layer : builder.layers()) {
        layer.side = layer.name == "top" ? model::LayerSide::Top : model::LayerSide::Bottom;
    }
    const model::NetId a = builder.addNet("A \"1\"");
    const model::NetId b = builder.addNet("B");
    builder.beginLayer(model::LayerId{0});
    for (const int x : {5, 10, 15}) {
        builder.addCircle({{x * kMm, 5 * kMm}, 2 * kMm, 0}, hand_made::of(a, model::kPad));
    }
    builder.addLine({{20 * kMm, 5 * kMm}, {30 * kMm, 5 * kMm}, kMm}, hand_made::of(a));
    builder.addLine({{30 * kMm, 5 * kMm}, {30 * kMm, 15 * kMm}, kMm}, hand_made::of(a));
    model::ShapeSketch plane = hand_made::rectangle({0, 20 * kMm}, {20 * kMm, 40 * kMm});
    plane.addCircle({10 * kMm, 30 * kMm}, 2 * kMm, true);
    builder.addArea({builder.addShape(plane), {}}, hand_made::of(b));
    builder.beginLayer(model::LayerId{2});
    const model::ShapeId pad = builder.addShape(hand_made::rectangle({-kMm, -2 * kMm}, {kMm, 2 * kMm}));
    builder.addArea({pad, {{5 * kMm, 30 * kMm}, 0.0, false}}, hand_made::of(b));
    builder.addArea({pad, {{15 * kMm, 30 * kMm}, 90.0, false}}, hand_made::of(b));
    builder.beginLayer(model::LayerId{3});
    for (const int x : {5, 10}) {
        builder.addCircle({{x * kMm, 5 * kMm}, kMm, 950 * kUm}, hand_made::of(a, model::kHole | model::kPlated));
    }
    return builder.finish();
}

/// Three of them: one as it is, one turned by 90°, one turned over.
inline std::shared_ptr<const model::Document> panel() {
    const auto step = board();
    model::DocumentBuilder builder;
    builder.job().name = "panel";
    for (const model::Layer& layer : step->layers) {
        model::Layer own = layer;
        own.elements = {};
        builder.addLayer(own);
    }
    const std::uint32_t row = builder.addStep(step);
    builder.addInstance({row, {{100 * kMm, 0}, 0.0, false}, false});
    builder.addInstance({row, {{200 * kMm, 0}, 90.0, false}, false});
    builder.addInstance({row, {{300 * kMm, 0}, 0.0, true}, true});
    return builder.finish();
}

inline model::SolidPlan planOf(const model::Document& document, const model::SolidChoice& choice = {}) {
    base::Progress progress;
    auto plan = model::planSolids(document, choice, progress);
    if (!plan) {
        qFatal("%s", plan.error().text.c_str());
    }
    return std::move(*plan);
}

/// mm³, with true circles.
inline constexpr double kHigh = 0.035;
inline constexpr double kDiscs = (3 - 2 * 0.25) * std::numbers::pi * kHigh;
/// Two tracks, less the quarter of the pen's square and the three quarters of its disc that both have.
inline constexpr double kTracks = (2 * (10.0 + std::numbers::pi / 4) - 0.25 - 0.75 * std::numbers::pi / 4) * kHigh;
inline constexpr double kPlane = (400.0 - 4 * std::numbers::pi) * kHigh;
inline constexpr double kPads = 2 * 8.0 * kHigh;
inline constexpr double kBarrels = 2 * std::numbers::pi / 4 * (1.0 - 0.95 * 0.95) * 1.07;
inline constexpr double kBoard = kDiscs + kTracks + kPlane + kPads + kBarrels;

/// Does every edge of a triangle have its counterpart?
template <class Rows>
bool isClosed(const Rows& triangles) {
    std::map<std::pair<std::uint32_t, std::uint32_t>, int> runs;
    for (std::size_t i = 0; i < triangles.size(); i += 3) {
        for (std::size_t k = 0; k < 3; ++k) {
            const auto a = static_cast<std::uint32_t>(triangles[i + k]);
            const auto b = static_cast<std::uint32_t>(triangles[i + (k + 1) % 3]);
            runs[std::minmax(a, b)] += a < b ? 1 : -1;
        }
    }
    return !runs.empty() && std::ranges::all_of(runs, [](const auto& run) { return run.second == 0; });
}

inline bool isNear(double value, double expected, double part) {
    const bool is = std::abs(value - expected) <= part * std::abs(expected);
    if (!is) {
        qWarning("%.9g is not %.9g", value, expected);
    }
    return is;
}

/// A pad on top that is no wider than its hole.
inline std::shared_ptr<const model::Document> drilledAway() {
    model::DocumentBuilder builder;
    hand_made::addLayers(builder, kStackup);
    const model::NetId a = builder.addNet("A");
    builder.beginLayer(model::LayerId{0});
    builder.addCircle({{5 * kMm, 5 * kMm}, 800 * kUm, 0}, hand_made::of(a, model::kPad));
    builder.beginLayer(model::LayerId{3});
    builder.addCircle({{5 * kMm, 5 * kMm}, kMm, 950 * kUm}, hand_made::of(a, model::kHole | model::kPlated));
    return builder.finish();
}

/// What every kind of file does when the work is cancelled, when the folder is not there, and when nothing is left.
template <class Export, class Options>
void checkFailures(const Export& write, const Options& options) {
    const QTemporaryDir folder;
    const auto document = board();
    const model::SolidPlan plan = planOf(*document);
    base::Progress cancelled;
    cancelled.cancel();
    const auto stopped = write(plan, options, folder.filePath("board").toStdString(), cancelled);
    QVERIFY(!stopped && stopped.error().code == base::ErrorCode::Cancelled);
    base::Progress progress;
    const auto nowhere = write(plan, options, "/nowhere/board", progress);
    QVERIFY(!nowhere && nowhere.error().code == base::ErrorCode::OutputFailed);
    const auto pad = drilledAway();
    model::SolidChoice top;
    top.layers = {model::LayerId{0}};
    const auto nothing = write(planOf(*pad, top), options, folder.filePath("board").toStdString(), progress);
    QVERIFY(!nothing && nothing.error().code == base::ErrorCode::OutputFailed);
    QVERIFY(QDir(folder.path()).entryList(QDir::Files).isEmpty());
}

}  // namespace mesh_board
