#include "app/reports/stackup_report.h"

#include <cmath>
#include <cstdio>
#include <numeric>

#include "model/board/holes.h"
#include "model/board/stackup.h"
#include "model/board/stackup_checks.h"
#include "model/board/stackup_table.h"

namespace app {

using model::DrillRow;
using model::StackupRow;
using nlohmann::ordered_json;

namespace {

template <class T>
ordered_json orNull(const std::optional<T>& value) {
    return value ? ordered_json(*value) : ordered_json();
}

ordered_json orNull(const std::string& text) {
    return text.empty() ? ordered_json() : ordered_json(text);
}

ordered_json rowJson(const model::Document& document, const StackupRow& row) {
    const std::optional<model::CopperWeight> weight = model::copperWeightOf(row);
    return {{"name", row.name},
            {"has_layer", row.layer.isValid()},
            {"type", model::toString(row.type)},
            {"kind", model::toString(model::kindOf(row, document))},
            {"z_nm", row.z},
            {"thickness_nm", row.thickness},
            {"thickness_source", model::toString(row.source)},
            {"material", orNull(row.material.name)},
            {"material_type", orNull(row.material.type)},
            {"form", orNull(row.material.form)},
            {"copper_oz", weight ? ordered_json(weight->oz) : ordered_json()},
            {"copper_oz_source", weight ? ordered_json(model::toString(weight->source)) : ordered_json()},
            {"dielectric_constant", orNull(row.material.dielectricConstant)},
            {"loss_tangent", orNull(row.material.lossTangent)},
            {"resistivity_nohm_m", orNull(row.material.resistivity)}};
}

std::string numberOr(std::optional<double> value, const char* format) {
    char text[32];
    std::snprintf(text, sizeof text, format, value.value_or(0.0));
    return value ? text : "-";
}

ordered_json substackJson(const model::Stackup& stackup, const model::Substack& part) {
    ordered_json rows = ordered_json::array();
    for (std::size_t i = 0; i < part.has.size(); ++i) {
        if (part.has[i]) {
            rows.push_back({{"name", stackup.rows[i].name}, {"cumulative_nm", orNull(part.cumulative[i])}});
        }
    }
    return {{"zone", orNull(part.name)},
            {"copper_to_copper_nm", part.copperToCopper},
            {"overall_nm", part.overall},
            {"rows", rows}};
}

ordered_json findingJson(const model::Stackup& stackup, const model::StackupFinding& finding) {
    ordered_json rows = ordered_json::array();
    for (const std::size_t row : finding.rows) {
        rows.push_back(stackup.rows[row].name);
    }
    return {{"check", model::toString(finding.check)},
            {"severity", model::toString(finding.severity)},
            {"text", finding.text},
            {"rows", rows}};
}

void printRow(const model::Document& document, const StackupRow& row) {
    const std::optional<model::CopperWeight> weight = model::copperWeightOf(row);
    const std::optional<double> oz = weight ? std::optional(weight->oz) : std::nullopt;
    std::printf("%-28s %-16s %-12s %10.2f %-8s %9s %-8s %8s %8s  %s%s%s\n", row.name.c_str(), model::toString(row.type),
                model::toString(model::kindOf(row, document)), row.thickness / base::kNmPerUm,
                model::toString(row.source), numberOr(oz, "%.3f").c_str(),
                weight ? model::toString(weight->source) : "", numberOr(row.material.dielectricConstant, "%g").c_str(),
                numberOr(row.material.lossTangent, "%g").c_str(), row.material.name.c_str(),
                row.material.type.empty() ? "" : (" (" + row.material.type + ")").c_str(),
                row.material.form.empty() ? "" : (" " + row.material.form).c_str());
}

void printSubstack(const model::Stackup& stackup, const model::Substack& part) {
    std::string names;
    for (std::size_t i = 0; i < part.has.size() && !part.name.empty(); ++i) {
        names += part.has[i] ? (names.empty() ? ": " : ", ") + stackup.rows[i].name : "";
    }
    std::printf("%s: copper to copper %.2f um, overall %.2f um%s\n",
                part.name.empty() ? "total" : ("zone " + part.name).c_str(), part.copperToCopper / base::kNmPerUm,
                part.overall / base::kNmPerUm, names.c_str());
}

std::string nameOf(const model::Document& document, model::LayerId id) {
    return id.isValid() ? document.layer(id).name : "";
}

ordered_json sizeOrNull(model::Nm size) {
    return size > 0 ? ordered_json(size) : ordered_json();
}

/// A plating that no tool states is taken as usual.
model::Source sourceOfInside(const DrillRow& row) {
    return row.isOpenAssumed ? model::Source::Assumed : model::Source::Job;
}

/// Null of holes of which only a box is known, and of those without a size.
ordered_json insideSourceJson(const DrillRow& row) {
    return model::hasDrilledSize(row) ? ordered_json(model::toString(sourceOfInside(row))) : ordered_json();
}

ordered_json drillJson(const model::Document& document, const DrillRow& row) {
    const model::Layer& layer = document.layer(row.layer);
    static const model::DrillTool kNone;
    const model::DrillTool& tool = row.tool != nullptr ? *row.tool : kNone;
    return {{"layer", layer.name},
            {"add_type", orNull(layer.useName)},
            {"from", nameOf(document, layer.spanTop)},
            {"to", nameOf(document, layer.spanBottom)},
            {"span", model::toString(row.span)},
            {"kind", model::toString(row.kind)},
            {"plated", row.kind != model::HoleKind::NonPlated},
            {"shape", row.shape},
            {"diameter_nm", row.diameter},
            {"inside_nm", row.open},
            {"open_nm", row.open},
            {"inside_source", insideSourceJson(row)},
            {"length_nm", sizeOrNull(row.length)},
            {"tool", row.tool != nullptr ? ordered_json(tool.number) : ordered_json()},
            {"other_tools", row.otherTools},
            {"process", orNull(tool.process)},
            {"bit", orNull(tool.bit)},
            {"finished_nm", sizeOrNull(tool.finishedSize)},
            {"drill_nm", sizeOrNull(tool.drillSize)},
            {"count", row.count}};
}

std::string inMm(model::Nm size) {
    return numberOr(size > 0 ? std::optional(base::toMm(size)) : std::nullopt, "%.4f");
}

}  // namespace

ordered_json stackupJson(const model::Document& document) {
    const model::Stackup& stackup = document.stackup;
    ordered_json rows = ordered_json::array();
    for (const StackupRow& row : stackup.rows) {
        rows.push_back(rowJson(document, row));
    }
    ordered_json substacks = ordered_json::array();
    for (const model::Substack& part : model::substacksOf(document)) {
        substacks.push_back(substackJson(stackup, part));
    }
    ordered_json findings = ordered_json::array();
    for (const model::StackupFinding& finding : model::checkStackup(document)) {
        findings.push_back(findingJson(stackup, finding));
    }
    const std::optional<double>& board = stackup.facts.boardNm;
    return {{"board_nm", board ? ordered_json(std::llround(*board)) : ordered_json()},
            {"rows", rows},
            {"substacks", substacks},
            {"findings", findings}};
}

void printStackup(const model::Document& document) {
    const std::vector<StackupRow>& rows = document.stackup.rows;
    if (rows.empty()) {
        return;
    }
    std::printf("\n%-28s %-16s %-12s %10s %-8s %8s %-8s %8s %8s  %s\n", "stackup from the top", "type", "kind",
                "height um", "from", "copper oz", "from", "Dk", "Df", "material");
    for (const StackupRow& row : rows) {
        printRow(document, row);
    }
    for (const model::Substack& part : model::substacksOf(document)) {
        printSubstack(document.stackup, part);
    }
}

ordered_json drillsJson(const model::Document& document, const std::vector<model::DrillRow>& rows) {
    ordered_json json = ordered_json::array();
    for (const DrillRow& row : rows) {
        json.push_back(drillJson(document, row));
    }
    return json;
}

void printDrills(const model::Document& document) {
    const std::vector<DrillRow> rows = model::drillTableWithCopies(document);
    if (rows.empty()) {
        return;
    }
    std::printf("\n%-28s %-9s %-10s %-6s %9s %9s %-8s %9s %5s %11s %9s %8s  %s\n", "holes on", "span", "kind", "shape",
                "hole mm", "inside mm", "from", "length mm", "tool", "finished mm", "drill mm", "count", "from - to");
    for (const DrillRow& row : rows) {
        const model::Layer& layer = document.layer(row.layer);
        const bool hasTool = row.tool != nullptr;
        std::printf("%-28s %-9s %-10s %-6s %9s %9s %-8s %9s %5s %11s %9s %8u  %s - %s\n", layer.name.c_str(),
                    model::toString(row.span), model::toString(row.kind), row.shape, inMm(row.diameter).c_str(),
                    inMm(row.open).c_str(), row.open > 0 ? model::toString(sourceOfInside(row)) : "-",
                    inMm(row.length).c_str(), hasTool ? model::toolsText(row).c_str() : "-",
                    hasTool ? inMm(row.tool->finishedSize).c_str() : "-",
                    hasTool ? inMm(row.tool->drillSize).c_str() : "-", row.count,
                    nameOf(document, layer.spanTop).c_str(), nameOf(document, layer.spanBottom).c_str());
    }
    if (!document.instances.empty()) {
        const auto all = std::accumulate(rows.begin(), rows.end(), std::uint64_t{0},
                                         [](std::uint64_t sum, const DrillRow& row) { return sum + row.count; });
        std::printf("%-123s %8llu\n", "in all, with the copies of other steps", static_cast<unsigned long long>(all));
    }
}

}  // namespace app
