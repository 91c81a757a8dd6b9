#include "app/info_json.h"

#include "app/drill_report.h"
#include "app/stack_report.h"

namespace app {

using model::Document;
using model::ElementKind;
using model::Layer;
using nlohmann::ordered_json;

namespace {

ordered_json countsJson(const std::array<std::uint32_t, model::kElementKindCount>& counts) {
    ordered_json json;
    for (std::size_t kind = 0; kind < counts.size(); ++kind) {
        json[model::toString(static_cast<ElementKind>(kind))] = counts[kind];
    }
    return json;
}

ordered_json jobJson(const model::JobInfo& job) {
    return {{"name", job.name},   {"generator", job.generator}, {"version", job.version},
            {"units", job.units}, {"steps", job.steps},         {"step", job.step}};
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
            {"counts", counts}};
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

ordered_json elementsJson(const Document& document) {
    const auto counts = document.elementCounts();
    ordered_json json = countsJson(counts);
    std::uint64_t total = 0;
    for (const std::uint32_t count : counts) {
        total += count;
    }
    json["total"] = total;
    return json;
}

void addDiagnostics(const model::Diagnostics& diagnostics, ordered_json& json) {
    for (const model::Diagnostic& entry : diagnostics.entries()) {
        json.push_back({{"severity", model::toString(entry.severity)},
                        {"file", entry.file},
                        {"line", entry.line},
                        {"text", entry.text},
                        {"count", entry.count}});
    }
}

}  // namespace

ordered_json infoJson(const OpenBoard& board) {
    const Document& document = *board.document;
    ordered_json diagnostics = ordered_json::array();
    addDiagnostics(document.diagnostics, diagnostics);
    addDiagnostics(board.model.diagnostics, diagnostics);
    return {{"job", jobJson(document.job)},
            {"layers", layersJson(document)},
            {"stackup", stackupJson(document.stackup)},
            {"elements", elementsJson(document)},
            {"nets", {{"count", document.nets.size()}}},
            {"components", {{"count", document.components.size()}}},
            {"drills", drillsJson(document)},
            {"board",
             {{"width_nm", document.board.width()},
              {"height_nm", document.board.height()},
              {"thickness_nm", document.boardThickness}}},
            {"triangles",
             {{"standard_pipeline", board.model.trianglesPaperRule}, {"stored", board.model.indices.size() / 3}}},
            {"diagnostics", diagnostics},
            {"timing_ms",
             {{"parse", document.times.parseMs},
              {"create", document.times.createMs + board.model.times.createMs},
              {"discretise", board.model.times.discretiseMs},
              {"triangulate", board.model.times.triangulateMs}}}};
}

}  // namespace app
