#include "model/export/clearance_export.h"

#include <algorithm>
#include <iterator>

#include "model/base/units.h"
#include "model/clearance/side_names.h"
#include "model/export/html_export.h"
#include "model/export/junit_export.h"
#include "model/export/rule_items.h"
#include "model/export/sarif_export.h"
#include "model/export/side_json.h"
#include "model/text/formatting.h"
#include "model/text/json_text.h"

namespace model {

using nlohmann::ordered_json;

namespace {

constexpr std::string_view kFormats[][2] = {{"text", ".txt"},  {"json", ".json"},   {"csv", ".csv"},
                                            {"junit", ".xml"}, {"sarif", ".sarif"}, {"html", ".html"}};

double micrometres(double nm) {
    return nm / base::kNmPerUm;
}

std::string padded(std::string text, std::size_t width) {
    text.resize(std::max(text.size(), width), ' ');
    return text;
}

ordered_json inMm(PointD p) {
    return {base::toMm(p.x), base::toMm(p.y)};
}

/// A clearance as a finding of no rule.
RuleFinding asFinding(const Clearance& c) {
    return {0, c.layer, c.a, c.b, c.spacing};
}

std::string csvOf(const Side& side) {
    const std::string element = side.element.isValid() ? std::to_string(side.element.value) : "";
    return csvField(side.pin) + ',' + csvField(side.kind) + ',' + element;
}

/// From the layer on.
std::string csvOf(const Document& step, const SideNames& names, const RuleFinding& f) {
    const auto [a, b] = names.of(f);
    return csvField(step.layer(f.layer).name) + formatted(",%.3f,", micrometres(f.spacing.distance)) + csvField(a.net) +
           ',' + csvField(b.net) +
           formatted(",%.6f,%.6f,%.6f,%.6f,", base::toMm(f.spacing.from.x), base::toMm(f.spacing.from.y),
                     base::toMm(f.spacing.to.x), base::toMm(f.spacing.to.y)) +
           csvOf(a) + ',' + csvOf(b);
}

ordered_json jsonOf(const Document& step, const SideNames& names, const RuleFinding& f) {
    const auto [a, b] = names.of(f);
    ordered_json elements{f.a.value};
    if (f.b.isValid()) {
        elements.push_back(f.b.value);
    }
    return {{"clearance_um", micrometres(f.spacing.distance)},
            {"gap_um", micrometres(f.spacing.distance)},
            {"layer", step.layer(f.layer).name},
            {"nets", {a.net, b.net}},
            {"elements", elements},
            {"sides", {sideJson(a), sideJson(b)}},
            {"from_mm", inMm(f.spacing.from)},
            {"to_mm", inMm(f.spacing.to)}};
}

std::string textOf(const StepClearances& found) {
    const Document& step = *found.step;
    std::string text = "step " + step.job.step + ": " + std::to_string(found.clearances.size()) + " clearances\n";
    if (!found.clearances.empty()) {
        text += formatted("%10s  %-20s %11s %11s  %-48s %s\n", "clear. um", "layer", "x mm", "y mm", "one side",
                          "other side");
    }
    const SideNames names(step);
    for (const Clearance& c : found.clearances) {
        text += formatted("%10.3f  ", micrometres(c.spacing.distance)) + padded(step.layer(c.layer).name, 20) +
                formatted(" %11.4f %11.4f  ", base::toMm(c.spacing.from.x), base::toMm(c.spacing.from.y)) +
                padded(textOf(names.of(c.a)), 48) + ' ' + textOf(names.of(c.b)) + '\n';
    }
    return text;
}

std::string csvOf(const StepClearances& found) {
    const Document& step = *found.step;
    const SideNames names(step);
    std::string text;
    for (const Clearance& c : found.clearances) {
        text += csvField(step.job.step) + ',' + csvOf(step, names, asFinding(c)) + '\n';
    }
    return text;
}

ordered_json jsonOf(const StepClearances& found) {
    const SideNames names(*found.step);
    ordered_json list = ordered_json::array();
    for (const Clearance& c : found.clearances) {
        list.push_back(jsonOf(*found.step, names, asFinding(c)));
    }
    return {{"step", found.step->job.step}, {"clearances", list}};
}

std::string textOf(const Document& step, const SideNames& names, const RuleFinding& f) {
    const auto [a, b] = names.of(f);
    const std::string reason = reasonOf(f);
    return formatted("  %10.3f um  ", micrometres(f.spacing.distance)) + padded(step.layer(f.layer).name, 20) +
           formatted(" %11.4f %11.4f mm  ", base::toMm(f.spacing.from.x), base::toMm(f.spacing.from.y)) +
           padded(textOf(a), 48) + ' ' + textOf(b) + (reason.empty() ? "" : "  " + reason) + '\n';
}

std::string textOf(const Document& step, const SideNames& names, const WaivedFinding& waived) {
    return textOf(step, names, waived.found) + "              waived: " + waived.reason + '\n';
}

std::string textOf(const RuleTable& table, const StepRules& found, const SideNames& names, std::size_t rule,
                   std::size_t most) {
    std::string text = padded(toString(verdictOf(table, found.report, rule)), 12) + limitText(table.rules[rule]) +
                       ": " + countsText(table, found.report, rule) + '\n';
    if (verdictOf(table, found.report, rule) == Verdict::Unused) {
        text += "            " + found.report.unused[rule] + '\n';
    }
    for (const std::string& unchecked : uncheckedOf(found.report, rule)) {
        text += "            not checked: " + unchecked + '\n';
    }
    for (const RuleFinding& f : findingsOf(found, rule, most)) {
        text += textOf(*found.step, names, f);
    }
    for (const WaivedFinding& waived : waivedOf(found, rule, most)) {
        text += textOf(*found.step, names, waived);
    }
    return text;
}

std::string textOf(const RuleTable& table, const StepRules& found, std::size_t most) {
    std::string text =
        "step " + found.step->job.step + formatted(", tolerance of limits %.3f um\n", micrometres(table.tolerance));
    const SideNames names(*found.step);
    for (std::size_t rule = 0; rule < table.rules.size(); ++rule) {
        text += textOf(table, found, names, rule, most);
    }
    for (const WaiverNote& note : found.report.waiverNotes) {
        text += note.text + '\n';
    }
    for (const NetTie& tie : found.report.netTies) {
        text += "net tie: " + textOf(*found.step, tie) + '\n';
    }
    for (const std::string& note : found.report.notes) {
        text += "note: " + note + '\n';
    }
    return text;
}

/// Findings, those that are waived, then a row for all that is not listed, was not checked and is to be said of
/// waivers: without layer, sides and location.
std::string csvOf(const RuleTable& table, const StepRules& found, std::size_t most) {
    const Document& step = *found.step;
    const SideNames names(step);
    const std::string end = formatted(",%.3f\n", micrometres(table.tolerance));
    std::string text;
    for (std::size_t row = 0; row < table.rules.size(); ++row) {
        const Rule& rule = table.rules[row];
        const auto start = [&](double least) {
            return csvField(step.job.step) + ',' + csvField(titleOf(rule)) + formatted(",%.3f,", micrometres(least));
        };
        const auto addRow = [&](const char* result, const std::string& reason) {
            text += start(rule.least) + ",,,,,,,,,,,,,," + result + ',' + csvField(reason) + end;
        };
        const auto addFinding = [&](const RuleFinding& f, const char* result, const std::string& reason) {
            text += start(requiredOf(rule, f)) + csvOf(step, names, f) + ',' + result + ',' + csvField(reason) + end;
        };
        for (const RuleFinding& f : findingsOf(found, row, most)) {
            addFinding(f, toString(Verdict::Failed), reasonOf(f));
        }
        for (const WaivedFinding& waived : waivedOf(found, row, most)) {
            addFinding(waived.found, "waived", waived.reason);
        }
        for (const std::string& unlisted : unlistedOf(found, row, most)) {
            addRow("not listed", unlisted);
        }
        for (const std::string& unchecked : uncheckedOf(found.report, row)) {
            addRow(toString(Verdict::Incomplete), unchecked);
        }
    }
    for (const WaiverNote& note : found.report.waiverNotes) {
        text += csvField(step.job.step) + ",,,,,,,,,,,,,,,,,waiver " + toString(note.state) + ',' +
                csvField(note.text) + end;
    }
    return text;
}

ordered_json jsonOf(const Unchecked& unchecked) {
    return {{"count", unchecked.count}, {"items", unchecked.what}, {"reason", unchecked.why}};
}

ordered_json ruleJson(const Document& step, const SideNames& names, const RuleFinding& finding) {
    ordered_json json = jsonOf(step, names, finding);
    if (finding.reason == FindingReason::TooDeep) {
        json["depth_um"] = micrometres(finding.depth);
        json["aspect_ratio"] = finding.depth / finding.spacing.distance;
    }
    if (const std::string reason = reasonOf(finding); !reason.empty()) {
        json["reason"] = reason;
    }
    return json;
}

ordered_json jsonOf(const RuleTable& table, const StepRules& found, const SideNames& names, std::size_t row,
                    std::size_t most) {
    const Rule& rule = table.rules[row];
    const Verdict verdict = verdictOf(table, found.report, row);
    ordered_json json{{"rule", titleOf(rule)}};
    if (hasLeast(rule.kind)) {
        json["least_um"] = micrometres(static_cast<double>(rule.least));
    }
    if (limitOf(rule.kind) == RuleLimit::Ratio) {
        json["most_ratio"] = rule.mostRatio;
    }
    if (verdict == Verdict::Unused) {
        json["unused"] = found.report.unused[row];
    } else if (rule.isOn) {
        json["passed"] = verdict == Verdict::Passed;
    } else {
        json["on"] = false;
    }
    json["result"] = verdict == Verdict::Failed ? "fail" : toString(verdict);
    json["count"] = found.report.counts[row];
    json["waived_count"] = waivedOf(found.report, row);
    json["unchecked"] = ordered_json::array();
    for (const Unchecked& unchecked : found.report.unchecked) {
        if (unchecked.rule == row) {
            json["unchecked"].push_back(jsonOf(unchecked));
        }
    }
    json["findings"] = ordered_json::array();
    for (const RuleFinding& f : findingsOf(found, row, most)) {
        json["findings"].push_back(ruleJson(*found.step, names, f));
    }
    json["waived"] = ordered_json::array();
    for (const WaivedFinding& waived : waivedOf(found, row, most)) {
        json["waived"].push_back(ruleJson(*found.step, names, waived.found));
        json["waived"].back()["waiver"] = waived.reason;
    }
    return json;
}

ordered_json waiversJson(const RuleReport& report) {
    ordered_json list = ordered_json::array();
    for (const WaiverNote& note : report.waiverNotes) {
        list.push_back({{"waiver", note.waiver + 1}, {"state", toString(note.state)}, {"text", note.text}});
    }
    return list;
}

ordered_json tiesJson(const StepRules& found) {
    ordered_json list = ordered_json::array();
    for (const NetTie& tie : found.report.netTies) {
        const Document& step = *found.step;
        list.push_back({{"component", step.components[tie.component.row()].refdes},
                        {"nets", {step.nets[tie.netA.row()].name, step.nets[tie.netB.row()].name}},
                        {"layer", step.layer(tie.layer).name},
                        {"assumed", tie.isAssumed}});
    }
    return list;
}

ordered_json jsonOf(const RuleTable& table, const StepRules& found, std::size_t most) {
    ordered_json rules = ordered_json::array();
    const SideNames names(*found.step);
    for (std::size_t row = 0; row < table.rules.size(); ++row) {
        rules.push_back(jsonOf(table, found, names, row, most));
    }
    return {{"step", found.step->job.step},
            {"tolerance_um", micrometres(table.tolerance)},
            {"rules", rules},
            {"waivers", waiversJson(found.report)},
            {"net_ties", tiesJson(found)},
            {"notes", found.report.notes}};
}

/// All steps, each as one of the three has it.
template <class Step, class Json, class Csv, class Text>
std::string reportOf(std::span<const Step> steps, ReportFormat format, const char* csvHead, Json json, Csv csv,
                     Text text) {
    if (format == ReportFormat::Json) {
        ordered_json list = ordered_json::array();
        std::ranges::transform(steps, std::back_inserter(list), json);
        return jsonText({{"steps", list}});
    }
    std::string all = format == ReportFormat::Csv ? csvHead : "";
    for (const Step& step : steps) {
        all += format == ReportFormat::Csv ? csv(step) : text(step);
    }
    return all;
}

}  // namespace

std::optional<ReportFormat> reportFormatOf(std::string_view name) {
    const auto* const found =
        std::ranges::find_if(kFormats, [&](const auto& words) { return words[0] == name || words[1] == name; });
    return found == std::end(kFormats) ? std::nullopt
                                       : std::optional(static_cast<ReportFormat>(found - std::begin(kFormats)));
}

std::string clearanceReport(std::span<const StepClearances> steps, ReportFormat format) {
    return reportOf(
        steps, format,
        "step,layer,clearance um,net a,net b,x mm on a,y mm on a,x mm on b,y mm on b,pin a,kind a,element a,pin b,kind "
        "b,element b\n",
        [](const StepClearances& step) { return jsonOf(step); }, [](const StepClearances& step) { return csvOf(step); },
        [](const StepClearances& step) { return textOf(step); });
}

std::string ruleReport(const RuleTable& table, std::span<const StepRules> steps, ReportFormat format, std::size_t most,
                       const ReportContext& context) {
    switch (format) {
        case ReportFormat::Junit: return junitReport(table, steps, most, context);
        case ReportFormat::Sarif: return sarifReport(table, steps, most, context);
        case ReportFormat::Html: return htmlReport(table, steps, most, context);
        default: break;
    }
    const bool isBare = format == ReportFormat::Text && isNothingChecked(table, steps);
    const std::string report = reportOf(
        steps, format,
        "step,rule,least um,layer,clearance um,a,b,x mm on a,y mm on a,x mm on b,y mm on b,pin a,kind a,element a,pin "
        "b,kind b,element b,result,reason,tolerance "
        "um\n",
        [&](const StepRules& step) { return jsonOf(table, step, most); },
        [&](const StepRules& step) { return csvOf(table, step, most); },
        [&](const StepRules& step) { return textOf(table, step, most); });
    return isBare ? report + kNothingChecked + '\n' : report;
}

}  // namespace model
