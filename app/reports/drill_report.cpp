#include "app/reports/drill_report.h"

#include <cstdio>

#include "model/board/holes.h"

namespace app {

using model::DrillRow;
using nlohmann::ordered_json;

namespace {

std::string nameOf(const model::Document& document, model::LayerId id) {
    return id.isValid() ? document.layer(id).name : "";
}

ordered_json sizeOrNull(model::Nm size) {
    return size > 0 ? ordered_json(size) : ordered_json();
}

ordered_json textOrNull(const std::string& text) {
    return text.empty() ? ordered_json() : ordered_json(text);
}

ordered_json rowJson(const model::Document& document, const DrillRow& row) {
    const model::Layer& layer = document.layer(row.layer);
    static const model::DrillTool kNone;
    const model::DrillTool& tool = row.tool != nullptr ? *row.tool : kNone;
    return {{"layer", layer.name},
            {"add_type", textOrNull(layer.useName)},
            {"from", nameOf(document, layer.spanTop)},
            {"to", nameOf(document, layer.spanBottom)},
            {"span", model::toString(row.span)},
            {"kind", model::toString(row.kind)},
            {"plated", row.kind != model::HoleKind::NonPlated},
            {"shape", row.shape},
            {"diameter_nm", row.diameter},
            {"inside_nm", row.open},
            {"open_nm", row.open},
            {"tool", row.tool != nullptr ? ordered_json(tool.number) : ordered_json()},
            {"process", textOrNull(tool.process)},
            {"bit", textOrNull(tool.bit)},
            {"finished_nm", sizeOrNull(tool.finishedSize)},
            {"drill_nm", sizeOrNull(tool.drillSize)},
            {"count", row.count}};
}

std::string inMm(model::Nm size) {
    char text[32];
    std::snprintf(text, sizeof text, "%.4f", base::toMm(size));
    return size > 0 ? text : "-";
}

}  // namespace

ordered_json drillsJson(const model::Document& document) {
    ordered_json json = ordered_json::array();
    for (const DrillRow& row : model::drillTable(document)) {
        json.push_back(rowJson(document, row));
    }
    return json;
}

void printDrills(const model::Document& document) {
    const std::vector<DrillRow> rows = model::drillTable(document);
    if (rows.empty()) {
        return;
    }
    std::printf("\n%-28s %-9s %-10s %-6s %9s %9s %5s %11s %9s %8s  %s\n", "holes on", "span", "kind", "shape",
                "hole mm", "inside mm", "tool", "finished mm", "drill mm", "count", "from - to");
    for (const DrillRow& row : rows) {
        const model::Layer& layer = document.layer(row.layer);
        const bool hasTool = row.tool != nullptr;
        std::printf("%-28s %-9s %-10s %-6s %9s %9s %5s %11s %9s %8u  %s - %s\n", layer.name.c_str(),
                    model::toString(row.span), model::toString(row.kind), row.shape, inMm(row.diameter).c_str(),
                    inMm(row.open).c_str(), hasTool ? std::to_string(row.tool->number).c_str() : "-",
                    hasTool ? inMm(row.tool->finishedSize).c_str() : "-",
                    hasTool ? inMm(row.tool->drillSize).c_str() : "-", row.count,
                    nameOf(document, layer.spanTop).c_str(), nameOf(document, layer.spanBottom).c_str());
    }
}

}  // namespace app
