#include "render/modelling/board_model.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>

#include "model/base/parallel.h"
#include "model/base/stopwatch.h"
#include "render/modelling/area_meshes.h"
#include "render/modelling/area_pieces.h"
#include "render/modelling/lets.h"

namespace render {

using model::Document;
using model::ElementKind;
using model::Layer;

namespace {

void joinLets(const Document& document, std::vector<LayerLets>& perLayer, BoardModel& out) {
    std::size_t letCount = 0;
    for (const LayerLets& layer : perLayer) {
        letCount += layer.lets.size();
    }
    out.lets.reserve(letCount);
    out.clusters.reserve(letCount / shader::kClusterSize + perLayer.size());
    for (std::size_t row = 0; row < perLayer.size(); ++row) {
        const LayerLets& layer = perLayer[row];
        const auto firstCluster = static_cast<std::uint32_t>(out.clusters.size());
        appendLets(layer, model::LayerId{row}, out.lets, out.clusters);
        out.clustersOfLayer.push_back({firstCluster, static_cast<std::uint32_t>(out.clusters.size()) - firstCluster});
        if (layer.zeroWidthTracks > 0) {
            out.diagnostics.report(model::Severity::Info, document.layers[row].file, layer.firstZeroWidthLine,
                                   "layer " + document.layers[row].name + ": " + std::to_string(layer.zeroWidthTracks) +
                                       " tracks or pads without a width are not drawn");
        }
    }
}

std::vector<std::uint32_t> rowsOfShapes(const Document& document, const std::vector<model::ShapeId>& used) {
    std::vector<std::uint32_t> rows(document.shapes.size(), 0);
    for (std::uint32_t row = 0; row < used.size(); ++row) {
        rows[used[row].row()] = row;
    }
    return rows;
}

void makeAllLets(const Document& document, const model::Discretisation& how,
                 const std::vector<std::uint32_t>& rowOfShape, const std::vector<ShapeMesh>& meshes, BoardModel& out) {
    std::vector<LayerLets> perLayer(document.layers.size());
    const HolesOfShape holesOf = [&](model::ShapeId shape) { return std::span(meshes[rowOfShape[shape.row()]].holes); };
    base::parallelFor(perLayer.size(), [&](std::size_t row) {
        perLayer[row] = makeLets(document, model::LayerId{row}, out.origin, how.chordToleranceNm, holesOf);
    });
    joinLets(document, perLayer, out);
}

/// Puts the shapes' meshes one behind the other. Vertices are mm from the centre of the shape's box, so that floats
/// resolve them as finely as pads wherever the shape lies; the instance adds the centre's place on the board.
void joinMeshes(const Document& document, const std::vector<model::ShapeId>& used, const std::vector<ShapeMesh>& meshes,
                BoardModel& out) {
    for (std::size_t row = 0; row < meshes.size(); ++row) {
        const ShapeMesh& mesh = meshes[row];
        const model::Point centre = centreOf(document.shapes.shapes[used[row].row()].box);
        const auto firstVertex = static_cast<std::uint32_t>(out.vertices.size());
        out.shapes.push_back({firstVertex, static_cast<std::uint32_t>(mesh.polygons.points.size()),
                              static_cast<std::uint32_t>(out.indices.size()),
                              static_cast<std::uint32_t>(mesh.triangles.size() / 3), 0, 0});
        for (std::size_t i = 0; i < mesh.polygons.points.size(); ++i) {
            out.vertices.push_back(toGpu(base::toDouble(mesh.polygons.points[i]), centre));
            out.next.push_back(firstVertex + mesh.next[i]);
        }
        out.indices.insert(out.indices.end(), mesh.triangles.begin(), mesh.triangles.end());
    }
}

shader::AreaInstance instanceOf(const Document& document, model::ElementId element, std::uint32_t shape,
                                model::Point origin) {
    const model::AreaGeometry& area = document.areas[document.elements.geometry[element.row()]];
    const double angle = area.placement.clockwiseDeg * std::numbers::pi / 180.0;
    shader::AreaInstance instance{};
    const model::Point centre = centreOf(document.shapes.shapes[area.shape.row()].box);
    instance.origin = toGpu(area.placement.apply(base::toDouble(centre)), origin);
    instance.cosSin = {static_cast<float>(std::cos(angle)), static_cast<float>(std::sin(angle))};
    instance.shape = shape;
    instance.layer = document.elements.layer[element.row()].value;
    instance.element = element.value;
    instance.isMirrored = area.placement.isMirrored ? 1 : 0;
    if (const model::Body* body = document.bodyOf(element)) {
        instance.height = static_cast<float>(base::toMm(body->height));
    }
    return instance;
}

void addBatches(const std::vector<shader::AreaInstance>& instances, std::uint32_t layer, BoardModel& out) {
    const auto firstBatch = static_cast<std::uint32_t>(out.areaBatches.size());
    for (const shader::AreaInstance& instance : instances) {
        const bool isSame = out.areaBatches.size() > firstBatch && out.areaBatches.back().shape == instance.shape;
        if (!isSame) {
            out.areaBatches.push_back({instance.shape, layer, static_cast<std::uint32_t>(out.instances.size()), 0});
        }
        out.instances.push_back(instance);
        ++out.areaBatches.back().instanceCount;
    }
    out.areaBatchesOfLayer.push_back({firstBatch, static_cast<std::uint32_t>(out.areaBatches.size()) - firstBatch});
}

void makeInstances(const Document& document, const std::vector<std::uint32_t>& rowOfShape, BoardModel& out) {
    std::vector<shader::AreaInstance> ofLayer;
    for (std::size_t layer = 0; layer < document.layers.size(); ++layer) {
        ofLayer.clear();
        const model::Range range = document.layers[layer].elements;
        for (std::uint32_t row = range.first; row < range.first + range.count; ++row) {
            if (document.elements.kind[row] == ElementKind::Area) {
                const std::uint32_t shape = rowOfShape[document.areas[document.elements.geometry[row]].shape.row()];
                ofLayer.push_back(instanceOf(document, model::ElementId{row}, shape, out.origin));
            }
        }
        std::ranges::stable_sort(ofLayer, {}, &shader::AreaInstance::shape);
        addBatches(ofLayer, static_cast<std::uint32_t>(layer), out);
    }
}

/// Says which areas were repaired or hold nothing: once per layer, with the line of the first.
void reportMeshes(const Document& document, const std::vector<ShapeMesh>& meshes, BoardModel& out) {
    for (const shader::AreaInstance& instance : out.instances) {
        const ShapeMesh& mesh = meshes[instance.shape];
        const Layer& layer = document.layers[instance.layer];
        const std::uint32_t line = document.elements.line[instance.element];
        const auto report = [&](model::Severity severity, const char* text) {
            out.diagnostics.report(severity, layer.file, line, "layer " + layer.name + ": " + text,
                                   model::ElementId{instance.element});
        };
        if (mesh.failed) {
            report(model::Severity::Error, "an area could not be triangulated and is not drawn");
        } else if (mesh.triangles.empty()) {
            ++out.emptyAreas;
            report(model::Severity::Warning, "an area covers nothing");
        } else if (mesh.wasRepaired) {
            ++out.repairedAreas;
            report(model::Severity::Warning, "an area crosses itself and was cleaned up");
        }
    }
}

/// One step by itself.
base::Result<BoardModel> buildStepModel(const Document& document, const model::Discretisation& how,
                                        base::Progress& progress, const AreaTriangulator& triangulator) {
    const base::Error cancelled{base::ErrorCode::Cancelled, "cancelled"};
    BoardModel out;
    progress.beginPhase("Rounding curves");
    base::Stopwatch watch;
    const std::vector<model::ShapeId> used = shapesInUse(document);
    const std::vector<std::uint32_t> rowOfShape = rowsOfShapes(document, used);
    std::vector<ShapeMesh> meshes = punchShapes(document, used, how, progress);
    out.times.discretiseMs = watch.milliseconds();
    if (progress.isCancelled()) {
        return cancelled;
    }

    progress.beginPhase("Modelling traces and pads");
    watch = {};
    static_cast<BoardFrame&>(out) = frameOf(document);
    makeAllLets(document, how, rowOfShape, meshes, out);
    makeInstances(document, rowOfShape, out);
    out.times.createMs = watch.milliseconds();

    progress.beginPhase("Triangulating copper areas");
    watch = {};
    triangulateShapes(meshes, triangulator, progress);
    out.times.triangulateMs = watch.milliseconds();
    if (progress.isCancelled()) {
        return cancelled;
    }
    watch = {};
    joinMeshes(document, used, meshes, out);
    out.inSubstrate = findSubstrateMargins(document, out);
    out.times.createMs += watch.milliseconds();
    reportMeshes(document, meshes, out);
    watch = {};
    cutIntoPieces(out);
    out.times.createMs += watch.milliseconds();
    return out;
}

/// Takes what is said about a step over into what is said about the board, where its elements have no numbers.
void addMessages(model::Diagnostics messages, model::Diagnostics& board) {
    for (std::size_t row = 0; row < messages.entries().size(); ++row) {
        messages.locate(row, {}, std::nullopt);
    }
    board.append(messages);
}

}  // namespace

base::Result<BoardModel> buildBoardModel(const Document& document, const model::Discretisation& how,
                                         base::Progress& progress, const AreaTriangulator& triangulator) {
    auto board = buildWithSteps<BoardModel>(
        document, [&](const Document& step) { return buildStepModel(step, how, progress, triangulator); });
    if (board) {
        for (const BoardModel& step : board->steps) {
            addMessages(step.diagnostics, board->diagnostics);
        }
    }
    return board;
}

}  // namespace render
