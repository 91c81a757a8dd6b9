#include "model/export/clearance_export.h"

#include <algorithm>
#include <iterator>

#include "model/base/units.h"
#include "model/text/formatting.h"
#include "model/text/json_text.h"

namespace model {

using nlohmann::ordered_json;

namespace {

constexpr std::string_view kFormats[][2] = {{"text", ".txt"}, {"json", ".json"}, {"csv", ".csv"}};

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

/// From the layer on; of clearances and of findings of rules.
template <class Found>
std::string csvOf(const Document& step, const Found& f) {
    return csvField(step.layer(f.layer).name) + formatted(",%.3f,", micrometres(f.spacing.distance)) +
           csvField(sideOf(step, f.a)) + ',' + csvField(sideOf(step, f.b)) +
           formatted(",%.6f,%.6f,%.6f,%.6f\n", base::toMm(f.spacing.from.x), base::toMm(f.spacing.from.y),
                     base::toMm(f.spacing.to.x), base::toMm(f.spacing.to.y));
}

template <class Found>
ordered_json jsonOf(const Document& step, const Found& f) {
    ordered_json elements{f.a.value};
    if (f.b.isValid()) {
        elements.push_back(f.b.value);
    }
    return {{"clearance_um", micrometres(f.spacing.distance)},
            {"gap_um", micrometres(f.spacing.distance)},
            {"layer", step.layer(f.layer).name},
            {"nets", {sideOf(step, f.a), sideOf(step, f.b)}},
            {"elements", elements},
            {"from_mm", inMm(f.spacing.from)},
            {"to_mm", inMm(f.spacing.to)}};
}

std::string textOf(const StepClearances& found) {
    const Document& step = *found.step;
    std::string text = "step " + step.job.step + ": " + std::to_string(found.clearances.size()) + " clearances\n";
    if (!found.clearances.empty()) {
        text += formatted("%10s  %-20s %11s %11s  %-32s %s\n", "clear. um", "layer", "x mm", "y mm", "net", "net");
    }
    for (const Clearance& c : found.clearances) {
        text += formatted("%10.3f  ", micrometres(c.spacing.distance)) + padded(step.layer(c.layer).name, 20) +
                formatted(" %11.4f %11.4f  ", base::toMm(c.spacing.from.x), base::toMm(c.spacing.from.y)) +
                padded(sideOf(step, c.a), 32) + ' ' + sideOf(step, c.b) + '\n';
    }
    return text;
}

std::string csvOf(const StepClearances& found) {
    const Document& step = *found.step;
    std::string text;
    for (const Clearance& c : found.clearances) {
        text += csvField(step.job.step) + ',' + csvOf(step, c);
    }
    return text;
}

ordered_json jsonOf(const StepClearances& found) {
    ordered_json list = ordered_json::array();
    for (const Clearance& c : found.clearances) {
        list.push_back(jsonOf(*found.step, c));
    }
    return {{"step", found.step->job.step}, {"clearances", list}};
}

/// The first ones of a rule.
std::span<const RuleFinding> findingsOf(const StepRules& step, std::size_t rule, std::size_t most) {
    const std::vector<RuleFinding>& all = step.report.findings;
    const auto first = std::ranges::lower_bound(all, rule, {}, &RuleFinding::rule);
    const auto last = std::ranges::upper_bound(all, rule, {}, &RuleFinding::rule);
    return std::span(first, last).first(std::min(most, static_cast<std::size_t>(last - first)));
}

const char* wordOf(const RuleTable& table, const StepRules& step, std::size_t rule) {
    return !table.rules[rule].isOn ? "off " : step.report.counts[rule] == 0 ? "pass" : "FAIL";
}

std::string textOf(const RuleTable& table, const StepRules& found, std::size_t most) {
    const Document& step = *found.step;
    std::string text = "step " + step.job.step + '\n';
    for (std::size_t rule = 0; rule < table.rules.size(); ++rule) {
        const std::size_t count = found.report.counts[rule];
        text += std::string(wordOf(table, found, rule)) + "  " + titleOf(table.rules[rule]) +
                formatted(", at least %.1f um: %zu %s\n", micrometres(static_cast<double>(table.rules[rule].least)),
                          count, count == 1 ? "location" : "locations");
        for (const RuleFinding& f : findingsOf(found, rule, most)) {
            text += formatted("  %10.3f um  ", micrometres(f.spacing.distance)) + padded(step.layer(f.layer).name, 20) +
                    formatted(" %11.4f %11.4f mm  ", base::toMm(f.spacing.from.x), base::toMm(f.spacing.from.y)) +
                    padded(sideOf(step, f.a), 28) + ' ' + sideOf(step, f.b) + '\n';
        }
    }
    return text;
}

std::string csvOf(const RuleTable& table, const StepRules& found, std::size_t most) {
    const Document& step = *found.step;
    std::string text;
    for (std::size_t row = 0; row < table.rules.size(); ++row) {
        const Rule& rule = table.rules[row];
        for (const RuleFinding& f : findingsOf(found, row, most)) {
            text += csvField(step.job.step) + ',' + csvField(titleOf(rule)) +
                    formatted(",%.3f,", micrometres(static_cast<double>(rule.least))) + csvOf(step, f);
        }
    }
    return text;
}

ordered_json jsonOf(const RuleTable& table, const StepRules& found, std::size_t most) {
    ordered_json rules = ordered_json::array();
    for (std::size_t row = 0; row < table.rules.size(); ++row) {
        const Rule& rule = table.rules[row];
        ordered_json json{{"rule", titleOf(rule)}, {"least_um", micrometres(static_cast<double>(rule.least))}};
        if (rule.isOn) {
            json["passed"] = found.report.counts[row] == 0;
        } else {
            json["on"] = false;
        }
        json["count"] = found.report.counts[row];
        json["findings"] = ordered_json::array();
        for (const RuleFinding& f : findingsOf(found, row, most)) {
            json["findings"].push_back(jsonOf(*found.step, f));
        }
        rules.push_back(json);
    }
    return {{"step", found.step->job.step}, {"rules", rules}};
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
        steps, format, "step,layer,clearance um,net a,net b,x mm on a,y mm on a,x mm on b,y mm on b\n",
        [](const StepClearances& step) { return jsonOf(step); }, [](const StepClearances& step) { return csvOf(step); },
        [](const StepClearances& step) { return textOf(step); });
}

std::string ruleReport(const RuleTable& table, std::span<const StepRules> steps, ReportFormat format,
                       std::size_t most) {
    return reportOf(
        steps, format, "step,rule,least um,layer,clearance um,a,b,x mm on a,y mm on a,x mm on b,y mm on b\n",
        [&](const StepRules& step) { return jsonOf(table, step, most); },
        [&](const StepRules& step) { return csvOf(table, step, most); },
        [&](const StepRules& step) { return textOf(table, step, most); });
}

}  // namespace model
