#include "app/reports/info_json.h"

#include <numeric>

#include "app/reports/stackup_report.h"
#include "model/board/copies.h"
#include "model/board/holes.h"
#include "render/standard/standard_triangles.h"

namespace app {

using model::Document;
using model::ElementKind;
using model::Layer;
using nlohmann::ordered_json;

namespace {

template <class Count>
ordered_json countsJson(const std::array<Count, model::kElementKindCount>& counts) {
    ordered_json json;
    for (std::size_t kind = 0; kind < counts.size(); ++kind) {
        json[model::toString(static_cast<ElementKind>(kind))] = counts[kind];
    }
    return json;
}

ordered_json jobJson(const model::JobInfo& job, const std::string& format) {
    return {{"name", job.name},       {"format", format},   {"generator", job.generator},
            {"version", job.version}, {"units", job.units}, {"steps", job.steps},
            {"step", job.step}};
}

ordered_json layerJson(const Layer& layer) {
    ordered_json counts = countsJson(layer.counts);
    counts["features"] = layer.featureCount;
    return {{"name", layer.name},
            {"type", model::toString(layer.type)},
            {"side", model::toString(layer.side)},
            {"polarity", layer.isNegative ? "NEGATIVE" : "POSITIVE"},
            {"z_nm", layer.z},
            {"thickness_nm", layer.thickness},
            {"thickness_source", model::toString(layer.thicknessSource)},
            {"counts", counts},
            {"counts_with_copies", countsJson(layer.countsWithCopies)}};
}

ordered_json layersJson(const Document& document) {
    ordered_json json = ordered_json::array();
    for (const Layer& layer : document.layers) {
        if (!layer.isSynthetic) {
            json.push_back(layerJson(layer));
        }
    }
    return json;
}

ordered_json zonesJson(const Document& document) {
    ordered_json json = ordered_json::array();
    for (const model::Zone& zone : document.zones) {
        ordered_json layers = ordered_json::array();
        for (const model::LayerId layer : zone.layers) {
            layers.push_back(document.layer(layer).name);
        }
        json.push_back({{"name", zone.name}, {"layers", layers}});
    }
    return json;
}

template <class Count>
ordered_json elementsJson(const std::array<Count, model::kElementKindCount>& counts) {
    ordered_json json = countsJson(counts);
    json["total"] = std::accumulate(counts.begin(), counts.end(), std::uint64_t{0});
    return json;
}

ordered_json placedStepsJson(const Document& document) {
    ordered_json json = ordered_json::array();
    for (const PlacedStep& placed : placedSteps(document)) {
        json.push_back({{"name", placed.step->job.step},
                        {"copies", placed.copies},
                        {"elements", elementsJson(placed.step->elementCounts())},
                        {"nets", placed.step->nets.size()},
                        {"components", placed.step->components.size()}});
    }
    return json;
}

ordered_json pointJson(std::int64_t x, std::int64_t y) {
    return {{"x_nm", x}, {"y_nm", y}};
}

/// Where the first occurrence of a message is to be seen; nothing if it concerns no location.
ordered_json locationJson(const Document& document, const model::Diagnostic& entry) {
    if (entry.element.isValid()) {
        const model::Box box = document.boxOf(entry.element);
        ordered_json json =
            pointJson((std::int64_t{box.min.x} + box.max.x) / 2, (std::int64_t{box.min.y} + box.max.y) / 2);
        json["layer"] = document.layer(document.elements.layer[entry.element.row()]).name;
        json["element"] = entry.element.value;
        return json;
    }
    return entry.location ? pointJson(entry.location->x, entry.location->y) : ordered_json();
}

void addDiagnostics(const Document& document, const model::Diagnostics& diagnostics, ordered_json& json) {
    for (const model::Diagnostic& entry : diagnostics.entries()) {
        json.push_back({{"severity", model::toString(entry.severity)},
                        {"file", entry.file},
                        {"line", entry.line},
                        {"text", entry.text},
                        {"count", entry.count},
                        {"location", locationJson(document, entry)},
                        {"place", locationJson(document, entry)}});
    }
}

}  // namespace

std::vector<PlacedStep> placedSteps(const Document& document) {
    const model::StepTree tree = model::unfoldCopies(document);
    std::vector<PlacedStep> placed;
    for (const Document* step : tree.steps) {
        placed.push_back({step, 0});
    }
    for (const model::StepCopy& copy : tree.copies) {
        ++placed[copy.step].copies;
    }
    placed.erase(placed.begin());  // the board itself
    return placed;
}

ordered_json infoJson(const CountedBoard& board, const std::vector<model::StepCheck>* checks) {
    const Document& document = *board.document;
    ordered_json diagnostics = ordered_json::array();
    addDiagnostics(document, document.diagnostics, diagnostics);
    addDiagnostics(document, board.model.diagnostics, diagnostics);
    ordered_json json = {{"job", jobJson(document.job, board.format)},
                         {"layers", layersJson(document)},
                         {"stackup", stackupJson(document)},
                         {"zones", zonesJson(document)},
                         {"elements", elementsJson(document.elementCounts())},
                         {"elements_with_copies", elementsJson(document.elementCountsWithCopies())},
                         {"placed_steps", placedStepsJson(document)},
                         {"nets", netsJson(document)},
                         {"components", componentsJson(document)},
                         {"drills", drillsJson(document, model::drillTable(document))},
                         {"drills_with_copies", drillsJson(document, model::drillTableWithCopies(document))},
                         {"board",
                          {{"width_nm", document.board.width()},
                           {"height_nm", document.board.height()},
                           {"thickness_nm", document.boardThickness}}},
                         {"triangles",
                          {{"standard_pipeline", render::countStandardTriangles(document, board.how)},
                           {"stored", board.model.triangles}}},
                         {"diagnostics", diagnostics},
                         {"timing_ms",
                          {{"parse", document.times.parseMs},
                           {"create", document.times.createMs + board.model.times.createMs},
                           {"discretise", board.model.times.discretiseMs},
                           {"triangulate", board.model.times.triangulateMs}}}};
    if (checks != nullptr) {
        json["connectivity"] = connectivityJson(*checks);
    }
    return json;
}

}  // namespace app
