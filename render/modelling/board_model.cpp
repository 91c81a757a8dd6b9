#include "render/modelling/board_model.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "model/base/large_pages.h"
#include "model/base/parallel.h"
#include "model/base/stopwatch.h"
#include "model/board/copies.h"
#include "model/solids/drilled_print.h"
#include "model/solids/milling.h"
#include "render/modelling/area_meshes.h"
#include "render/modelling/area_pieces.h"
#include "render/modelling/body_details.h"
#include "render/modelling/lets.h"

namespace render {

using model::Document;
using model::ElementKind;
using model::Layer;

namespace {

void reportZeroWidths(const Document& document, const std::vector<LayerLets>& perLayer, BoardModel& out) {
    for (std::size_t row = 0; row < perLayer.size(); ++row) {
        const LayerLets& layer = perLayer[row];
        if (layer.zeroWidthTracks > 0) {
            out.diagnostics.report(model::Severity::Info, document.layers[row].file, layer.firstZeroWidthLine,
                                   "layer " + document.layers[row].name + ": " + std::to_string(layer.zeroWidthTracks) +
                                       " tracks or pads without a width are not drawn");
        }
    }
}

/// Layers by how much they hold, for parallelFor.
std::vector<std::uint32_t> largestLayersFirst(const Document& document) {
    return base::largestFirst(document.layers.size(),
                              [&](std::size_t row) { return document.layers[row].elements.count; });
}

void joinLets(const Document& document, const std::vector<LayerLets>& perLayer, BoardModel& out) {
    std::vector<std::uint32_t> firstLets;
    std::uint32_t lets = 0;
    std::uint32_t clusters = 0;
    for (const LayerLets& layer : perLayer) {
        const auto ownClusters = static_cast<std::uint32_t>(clusterCount(layer));
        out.clustersOfLayer.push_back({clusters, ownClusters});
        firstLets.push_back(lets);
        clusters += ownClusters;
        lets += static_cast<std::uint32_t>(layer.order.size());
    }
    base::resizeLarge(out.lets, lets);
    base::resizeLarge(out.clusters, clusters);
    const std::vector<std::uint32_t> order = largestLayersFirst(document);
    base::parallelFor(order.size(), [&](std::size_t i) {
        const std::uint32_t row = order[i];
        const LayerRun run = out.clustersOfLayer[row];
        placeLets(perLayer[row], model::LayerId{std::size_t{row}}, firstLets[row],
                  std::span(out.lets).subspan(firstLets[row], perLayer[row].order.size()),
                  std::span(out.clusters).subspan(run.first, run.count));
    });
}

std::vector<std::uint32_t> rowsOfShapes(const Document& document, const std::vector<model::ShapeId>& used) {
    std::vector<std::uint32_t> rows(document.shapes.size(), 0);
    for (std::uint32_t row = 0; row < used.size(); ++row) {
        rows[used[row].row()] = row;
    }
    return rows;
}

/// What is milled or, of print, drilled, and what of it becomes meshes behind those of the shapes.
class Milling {
public:
    Milling(const Document& document, model::MilledBoard milled, std::vector<model::MilledElement> drilledPrint)
        : m_isMilled(document.elements.size(), 0), m_isOutlineDoubtful(milled.isOutlineDoubtful) {
        std::ranges::transform(milled.elements, std::back_inserter(m_beyond), &model::MilledElement::element);
        m_elements = std::move(milled.elements);
        std::ranges::transform(drilledPrint, std::back_inserter(m_overHoles), &model::MilledElement::element);
        model::addDrilledPrint(std::move(drilledPrint), m_elements);
        for (const model::MilledElement& element : m_elements) {
            m_isMilled[element.element.row()] = 1;
        }
    }

    [[nodiscard]] bool isMilled(model::ElementId element) const { return m_isMilled[element.row()] != 0; }
    /// Those that reach beyond the outline, rising.
    [[nodiscard]] const std::vector<model::ElementId>& beyond() const { return m_beyond; }
    /// Print that lies over holes, rising.
    [[nodiscard]] const std::vector<model::ElementId>& overHoles() const { return m_overHoles; }
    [[nodiscard]] bool isOutlineDoubtful() const { return m_isOutlineDoubtful; }

    /// Appends a mesh of each rest; the region moves there.
    void takeRests(std::vector<ShapeMesh>& meshes) {
        for (model::MilledElement& element : m_elements) {
            if (!element.rest.polygons.empty()) {
                m_rests.push_back({element.element, static_cast<std::uint32_t>(meshes.size())});
                meshes.emplace_back().polygons = std::move(element.rest);
            }
        }
    }
    /// A mesh that is the rest of an element.
    struct Rest {
        model::ElementId element;
        std::uint32_t mesh = 0;
    };
    [[nodiscard]] const std::vector<Rest>& rests() const { return m_rests; }

private:
    std::vector<std::uint8_t> m_isMilled;  ///< by element
    bool m_isOutlineDoubtful;
    std::vector<model::ElementId> m_beyond;
    std::vector<model::ElementId> m_overHoles;
    std::vector<model::MilledElement> m_elements;  ///< rising
    std::vector<Rest> m_rests;
};

void makeAllLets(const Document& document, const model::Discretisation& how,
                 const std::vector<std::uint32_t>& rowOfShape, const std::vector<ShapeMesh>& meshes,
                 const Milling& milling, BoardModel& out) {
    std::vector<LayerLets> perLayer(document.layers.size());
    const HolesOfShape holesOf = [&](model::ShapeId shape) { return std::span(meshes[rowOfShape[shape.row()]].holes); };
    const std::vector<std::uint32_t> order = largestLayersFirst(document);
    base::parallelFor(order.size(), [&](std::size_t i) {
        const std::size_t row = order[i];
        perLayer[row] = makeLets(document, model::LayerId{row}, out.origin, how.chordToleranceNm, holesOf,
                                 [&](model::ElementId element) { return milling.isMilled(element); });
    });
    joinLets(document, perLayer, out);
    reportZeroWidths(document, perLayer, out);
}

/// Puts the shapes' meshes one behind the other. Vertices are mm from the centre of the shape's box, so that floats
/// resolve them as finely as pads wherever the shape lies; the instance adds the centre's place on the board.
void joinMeshes(const std::vector<ShapeMesh>& meshes, const std::vector<model::Point>& centres, BoardModel& out) {
    std::uint32_t vertices = 0;
    std::uint32_t indices = 0;
    for (const ShapeMesh& mesh : meshes) {
        const auto own = static_cast<std::uint32_t>(mesh.polygons.points.size());
        const auto triangles = static_cast<std::uint32_t>(mesh.triangles.size() / 3);
        out.shapes.push_back({vertices, own, indices, triangles, 0, 0});
        vertices += own;
        indices += 3 * triangles;
    }
    base::resizeLarge(out.vertices, vertices);
    base::resizeLarge(out.next, vertices);
    base::resizeLarge(out.indices, indices);
    const std::vector<std::uint32_t> order =
        base::largestFirst(meshes.size(), [&](std::size_t row) { return meshes[row].polygons.points.size(); });
    base::parallelFor(order.size(), [&](std::size_t task) {
        const std::uint32_t row = order[task];
        const ShapeMesh& mesh = meshes[row];
        const AreaShape& shape = out.shapes[row];
        for (std::uint32_t i = 0; i < shape.vertexCount; ++i) {
            out.vertices[shape.firstVertex + i] = toGpu(base::toDouble(mesh.polygons.points[i]), centres[row]);
            out.next[shape.firstVertex + i] = shape.firstVertex + mesh.next[i];
        }
        std::ranges::copy(mesh.triangles, out.indices.begin() + shape.firstIndex);
    });
}

/// A shape laid on the board; `centre` is what its vertices count from.
shader::AreaInstance instanceAt(const model::Placement& placement, model::Point centre, std::uint32_t shape,
                                model::Point origin) {
    const double angle = placement.clockwiseDeg * std::numbers::pi / 180.0;
    shader::AreaInstance instance{};
    instance.origin = toGpu(placement.apply(base::toDouble(centre)), origin);
    instance.cosSin = {static_cast<float>(std::cos(angle)), static_cast<float>(std::sin(angle))};
    instance.shape = shape;
    instance.isMirrored = placement.isMirrored ? 1 : 0;
    return instance;
}

shader::AreaInstance instanceOf(const Document& document, model::ElementId element, std::uint32_t shape,
                                model::Point origin) {
    const model::AreaGeometry& area = document.areas[document.elements.geometry[element.row()]];
    const model::Point centre = centreOf(document.shapes.shapes[area.shape.row()].box);
    shader::AreaInstance instance = instanceAt(area.placement, centre, shape, origin);
    instance.layer = document.elements.layer[element.row()].value;
    instance.element = element.value;
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

shader::AreaInstance instanceOfRest(const Milling::Rest& rest, model::Point centre, model::Point origin) {
    shader::AreaInstance instance = instanceAt({}, centre, rest.mesh, origin);
    instance.element = rest.element.value;
    instance.onlyAs = shader::kOnlyAsFabricated;
    return instance;
}

/// What is drawn besides the elements of a layer as they are, by layer: rests of what is milled, parts of bodies.
std::vector<std::vector<shader::AreaInstance>> additionsOfLayers(const Document& document, const Milling& milling,
                                                                 const BodyDetails& bodies,
                                                                 const std::vector<model::Point>& centres,
                                                                 model::Point origin) {
    std::vector<std::vector<shader::AreaInstance>> byLayer(document.layers.size());
    const auto add = [&](model::ElementId element, shader::AreaInstance instance) {
        instance.layer = document.elements.layer[element.row()].value;
        byLayer[instance.layer].push_back(instance);
    };
    for (const Milling::Rest& rest : milling.rests()) {
        add(rest.element, instanceOfRest(rest, centres[rest.mesh], origin));
    }
    for (const BodyDetails::Part& part : bodies.parts()) {
        shader::AreaInstance instance = instanceAt(part.placement, centres[part.mesh], part.mesh, origin);
        describePart(part, instance);
        add(part.element, instance);
    }
    return byLayer;
}

void makeInstances(const Document& document, const std::vector<std::uint32_t>& rowOfShape, const Milling& milling,
                   const BodyDetails& bodies, const std::vector<model::Point>& centres, BoardModel& out) {
    const auto additions = additionsOfLayers(document, milling, bodies, centres, out.origin);
    std::vector<shader::AreaInstance> ofLayer;
    for (std::size_t layer = 0; layer < document.layers.size(); ++layer) {
        ofLayer.clear();
        const model::Range range = document.layers[layer].elements;
        for (std::uint32_t row = range.first; row < range.first + range.count; ++row) {
            if (document.elements.kind[row] == ElementKind::Area) {
                const std::uint32_t shape = rowOfShape[document.areas[document.elements.geometry[row]].shape.row()];
                ofLayer.push_back(instanceOf(document, model::ElementId{row}, shape, out.origin));
                bodies.paint(model::ElementId{row}, ofLayer.back());
                if (milling.isMilled(model::ElementId{row})) {
                    ofLayer.back().onlyAs = shader::kOnlyAsDesigned;
                }
            }
        }
        ofLayer.insert(ofLayer.end(), additions[layer].begin(), additions[layer].end());
        std::ranges::stable_sort(ofLayer, {}, &shader::AreaInstance::shape);
        addBatches(ofLayer, static_cast<std::uint32_t>(layer), out);
    }
}

std::vector<model::Point> centresOf(const Document& document, const std::vector<model::ShapeId>& used,
                                    const std::vector<ShapeMesh>& meshes) {
    std::vector<model::Point> centres;
    for (const model::ShapeId shape : used) {
        centres.push_back(centreOf(document.shapes.shapes[shape.row()].box));
    }
    for (std::size_t row = used.size(); row < meshes.size(); ++row) {
        model::Box box;
        for (const model::Point point : meshes[row].polygons.points) {
            box.include(point);
        }
        centres.push_back(centreOf(box));
    }
    return centres;
}

bool isDrawing(const Layer& layer) {
    return layer.type == model::LayerType::Document || layer.context == model::LayerContext::Misc;
}

/// How many of these elements are on each layer, and which is the first.
struct CountsOfLayers {
    CountsOfLayers(const Document& document, const std::vector<model::ElementId>& elements)
        : counts(document.layers.size(), 0), firsts(document.layers.size()) {
        for (const model::ElementId element : elements) {
            const std::size_t layer = document.elements.layer[element.row()].row();
            if (counts[layer]++ == 0) {
                firsts[layer] = element;
            }
        }
    }

    std::vector<std::uint32_t> counts;
    std::vector<model::ElementId> firsts;
};

/// Says of which print something is left out because there is a hole: once per layer, with the line of the first.
void reportDrilledPrint(const Document& document, const Milling& milling, BoardModel& out) {
    const CountsOfLayers found(document, milling.overHoles());
    for (std::size_t row = 0; row < found.counts.size(); ++row) {
        if (found.counts[row] > 0) {
            const Layer& layer = document.layers[row];
            const model::ElementId first = found.firsts[row];
            out.diagnostics.report(model::Severity::Info, layer.file, document.elements.line[first.row()],
                                   "layer " + layer.name + ": " + std::to_string(found.counts[row]) +
                                       (found.counts[row] == 1 ? " element lies" : " elements lie") +
                                       " over open holes; 3D shows what print is left beside them",
                                   first);
        }
    }
}

/// Says what the board as fabricated leaves out: once per layer, with the line of the first. Drawings of the job mostly
/// reach beyond the board, and nothing is made of them: all of them are one entry.
void reportMilled(const Document& document, const Milling& milling, BoardModel& out) {
    if (milling.isOutlineDoubtful()) {
        out.diagnostics.report(model::Severity::Warning, {}, 0,
                               "more copper lies beyond the board outline than within; 3D shows all of it, as if the "
                               "outline were not that of the board");
    }
    const auto [counts, firsts] = CountsOfLayers(document, milling.beyond());
    std::string drawings;
    std::size_t firstDrawing = counts.size();
    for (std::size_t row = 0; row < counts.size(); ++row) {
        const Layer& layer = document.layers[row];
        if (counts[row] > 0 && isDrawing(layer)) {
            firstDrawing = std::min(firstDrawing, row);
            drawings += (drawings.empty() ? "" : ", ") + layer.name;
        } else if (counts[row] > 0) {
            out.diagnostics.report(
                model::Severity::Info, layer.file, document.elements.line[firsts[row].row()],
                "layer " + layer.name + ": " + std::to_string(counts[row]) +
                    (counts[row] == 1 ? " element reaches beyond the board outline; 3D shows it as it is milled"
                                      : " elements reach beyond the board outline; 3D shows them as they are milled"),
                firsts[row]);
        }
    }
    if (!drawings.empty()) {
        const model::ElementId first = firsts[firstDrawing];
        out.diagnostics.report(model::Severity::Info, document.layers[firstDrawing].file,
                               document.elements.line[first.row()],
                               "drawings reach beyond the board outline, where 3D ends them: " + drawings, first);
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

/// One step by itself, whose meshes do not lie one behind the other yet. All that can go wrong has been said.
struct LooseModel {
    BoardModel model;  ///< lets, instances, messages
    std::vector<ShapeMesh> meshes;
    std::vector<model::Point> centres;  ///< of meshes
};

base::Result<LooseModel> makeLoose(const Document& document, Milling milling, const model::Discretisation& how,
                                   base::Progress& progress, const AreaTriangulator& triangulator) {
    const base::Error cancelled{base::ErrorCode::Cancelled, "cancelled"};
    LooseModel loose;
    BoardModel& out = loose.model;
    progress.beginPhase("Rounding curves");
    base::Stopwatch watch;
    const std::vector<model::ShapeId> used = shapesInUse(document);
    const std::vector<std::uint32_t> rowOfShape = rowsOfShapes(document, used);
    loose.meshes = punchShapes(document, used, how, progress);
    std::vector<ShapeMesh>& meshes = loose.meshes;
    milling.takeRests(meshes);
    BodyDetails bodies(document);
    bodies.takeMeshes(meshes);
    loose.centres = centresOf(document, used, meshes);
    out.times.discretiseMs = watch.milliseconds();
    if (progress.isCancelled()) {
        return cancelled;
    }

    progress.beginPhase("Modelling traces and pads");
    watch = {};
    static_cast<BoardFrame&>(out) = frameOf(document);
    out.elementCount = static_cast<std::uint32_t>(document.elements.size());
    makeAllLets(document, how, rowOfShape, meshes, milling, out);
    makeInstances(document, rowOfShape, milling, bodies, loose.centres, out);
    out.times.createMs = watch.milliseconds();

    progress.beginPhase("Triangulating copper areas");
    watch = {};
    triangulateShapes(meshes, triangulator, progress);
    out.times.triangulateMs = watch.milliseconds();
    if (progress.isCancelled()) {
        return cancelled;
    }
    reportMeshes(document, meshes, out);
    out.milled = milling.beyond();
    reportMilled(document, milling, out);
    reportDrilledPrint(document, milling, out);
    return loose;
}

/// What drawing needs besides.
BoardModel putTogether(const Document& document, LooseModel loose) {
    const base::Stopwatch watch;
    BoardModel& out = loose.model;
    joinMeshes(loose.meshes, loose.centres, out);
    out.inSubstrate = findSubstrateMargins(document, out);
    out.shadows = castShadows(out);
    cutIntoPieces(out);
    out.times.createMs += watch.milliseconds();
    return std::move(out);
}

/// The steps of a panel are milled from it later; their cut-outs are open.
Milling millingOf(const Document& document, bool isBoard, const model::Discretisation& how, base::Progress& progress) {
    progress.beginPhase("Milling");
    return {document,
            isBoard ? model::findMilled(document, how, progress) : model::findInCutouts(document, how, progress),
            model::findDrilledPrint(document, how, progress)};
}

/// Takes what is said about a step over into what is said about the board, where its elements have no numbers.
void addMessages(model::Diagnostics messages, model::Diagnostics& board) {
    for (std::size_t row = 0; row < messages.entries().size(); ++row) {
        messages.locate(row, {}, std::nullopt);
    }
    board.append(messages);
}

}  // namespace

std::vector<std::vector<model::ElementId>> milledOfSteps(const BoardModel& board) {
    std::vector<std::vector<model::ElementId>> milled{board.milled};
    std::ranges::transform(board.steps, std::back_inserter(milled), &BoardModel::milled);
    return milled;
}

base::Result<BoardModel> buildBoardModel(const Document& document, const model::Discretisation& how,
                                         base::Progress& progress, const AreaTriangulator& triangulator) {
    auto board = buildWithSteps<BoardModel>(document, [&](const Document& step) -> base::Result<BoardModel> {
        ASSIGN_OR_RETURN(LooseModel loose, makeLoose(step, millingOf(step, &step == &document, how, progress), how,
                                                     progress, triangulator));
        return putTogether(step, std::move(loose));
    });
    if (board) {
        for (const BoardModel& step : board->steps) {
            addMessages(step.diagnostics, board->diagnostics);
        }
    }
    return board;
}

base::Result<ModelCounts> countBoardModel(const Document& document, const model::Discretisation& how,
                                          base::Progress& progress, const AreaTriangulator& triangulator) {
    ModelCounts counts;
    const model::StepTree tree = model::unfoldCopies(document);
    for (const Document* step : tree.steps) {
        const bool isBoard = step == &document;
        ASSIGN_OR_RETURN(const LooseModel loose,
                         makeLoose(*step, millingOf(*step, isBoard, how, progress), how, progress, triangulator));
        counts.lets += loose.model.lets.size();
        counts.instances += loose.model.instances.size();
        counts.shapes += loose.meshes.size();
        for (const ShapeMesh& mesh : loose.meshes) {
            counts.triangles += mesh.triangles.size() / 3;
        }
        counts.times += loose.model.times;
        if (isBoard) {
            counts.diagnostics = loose.model.diagnostics;
        } else {
            addMessages(loose.model.diagnostics, counts.diagnostics);
        }
    }
    return counts;
}

}  // namespace render
