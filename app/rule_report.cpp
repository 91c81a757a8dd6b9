#include "app/rule_report.h"

#include <algorithm>
#include <cstdio>
#include <functional>
#include <span>

#include "app/json_text.h"
#include "model/base/units.h"
#include "model/export_text.h"

namespace app {

using model::Rule;
using model::RuleFinding;
using model::RuleTable;

namespace {

/// "copper-copper between power and any"
std::string titleOf(const Rule& rule) {
    std::string title = model::nameOf(rule.kind);
    if (rule.classes != std::array<std::string, 2>{}) {
        const auto word = [](const std::string& name) { return name.empty() ? std::string("any") : name; };
        title += " between " + word(rule.classes[0]) + " and " + word(rule.classes[1]);
    }
    return title;
}

/// "+3V3", "(no net)", "board edge"
std::string sideOf(const model::Document& step, model::ElementId element) {
    if (!element.isValid()) {
        return "board edge";
    }
    const model::NetId net = step.elements.net[element.row()];
    return net.isValid() ? step.nets[net.row()].name : "(no net)";
}

double micrometres(double nm) {
    return nm / base::kNmPerUm;
}

std::span<const RuleFinding> findingsOf(const StepRules& step, std::size_t rule) {
    const auto [first, last] = std::ranges::equal_range(step.report.findings, rule, {}, &RuleFinding::rule);
    return {first, last};
}

/// Calls `print(finding)` for the first ones of every rule.
void forFindings(const RuleTable& table, const StepRules& step, std::size_t most,
                 const std::function<void(const RuleFinding&)>& print) {
    for (std::size_t rule = 0; rule < table.rules.size(); ++rule) {
        const std::span<const RuleFinding> all = findingsOf(step, rule);
        std::ranges::for_each(all.first(std::min(most, all.size())), print);
    }
}

void printText(const RuleTable& table, const StepRules& step, std::size_t most) {
    std::printf("step %s\n", step.step->job.step.c_str());
    for (std::size_t rule = 0; rule < table.rules.size(); ++rule) {
        const std::size_t count = step.report.counts[rule];
        std::printf("%s  %s, at least %.1f um: %zu %s\n", count == 0 ? "pass" : "FAIL",
                    titleOf(table.rules[rule]).c_str(), micrometres(table.rules[rule].least), count,
                    count == 1 ? "place" : "places");
        const std::span<const RuleFinding> all = findingsOf(step, rule);
        for (const RuleFinding& f : all.first(std::min(most, all.size()))) {
            std::printf("  %10.3f um  %-20s %11.4f %11.4f mm  %-28s %s\n", micrometres(f.gap.distance),
                        step.step->layer(f.layer).name.c_str(), base::toMm(f.gap.from.x), base::toMm(f.gap.from.y),
                        sideOf(*step.step, f.a).c_str(), sideOf(*step.step, f.b).c_str());
        }
    }
}

void printCsv(const RuleTable& table, const StepRules& step, std::size_t most) {
    forFindings(table, step, most, [&](const RuleFinding& f) {
        const Rule& rule = table.rules[f.rule];
        std::printf("%s,%s,%.3f,%s,%.3f,%s,%s,%.6f,%.6f,%.6f,%.6f\n", model::csvField(step.step->job.step).c_str(),
                    model::csvField(titleOf(rule)).c_str(), micrometres(rule.least),
                    model::csvField(step.step->layer(f.layer).name).c_str(), micrometres(f.gap.distance),
                    model::csvField(sideOf(*step.step, f.a)).c_str(), model::csvField(sideOf(*step.step, f.b)).c_str(),
                    base::toMm(f.gap.from.x), base::toMm(f.gap.from.y), base::toMm(f.gap.to.x), base::toMm(f.gap.to.y));
    });
}

nlohmann::ordered_json toJson(const RuleTable& table, const StepRules& step, std::size_t most) {
    nlohmann::ordered_json rules = nlohmann::ordered_json::array();
    for (std::size_t rule = 0; rule < table.rules.size(); ++rule) {
        rules.push_back({{"rule", titleOf(table.rules[rule])},
                         {"least_um", micrometres(table.rules[rule].least)},
                         {"passed", step.report.counts[rule] == 0},
                         {"count", step.report.counts[rule]},
                         {"findings", nlohmann::ordered_json::array()}});
    }
    forFindings(table, step, most, [&](const RuleFinding& f) {
        nlohmann::ordered_json elements{f.a.value};
        if (f.b.isValid()) {
            elements.push_back(f.b.value);
        }
        rules[f.rule]["findings"].push_back({{"gap_um", micrometres(f.gap.distance)},
                                             {"layer", step.step->layer(f.layer).name},
                                             {"nets", {sideOf(*step.step, f.a), sideOf(*step.step, f.b)}},
                                             {"elements", elements},
                                             {"from_mm", {base::toMm(f.gap.from.x), base::toMm(f.gap.from.y)}},
                                             {"to_mm", {base::toMm(f.gap.to.x), base::toMm(f.gap.to.y)}}});
    });
    return {{"step", step.step->job.step}, {"rules", rules}};
}

}  // namespace

void printRules(const RuleTable& table, const std::vector<StepRules>& steps, const std::string& format,
                std::size_t most) {
    nlohmann::ordered_json json = nlohmann::ordered_json::array();
    if (format == "csv") {
        std::printf("step,rule,least um,layer,gap um,a,b,x mm on a,y mm on a,x mm on b,y mm on b\n");
    }
    for (const StepRules& step : steps) {
        if (format == "json") {
            json.push_back(toJson(table, step, most));
        } else {
            format == "csv" ? printCsv(table, step, most) : printText(table, step, most);
        }
        for (const std::string& remark : step.report.remarks) {
            std::fprintf(stderr, "copperscope: step %s: %s\n", step.step->job.step.c_str(), remark.c_str());
        }
    }
    if (format == "json") {
        std::fputs(jsonText({{"steps", json}}).c_str(), stdout);
    }
}

}  // namespace app
