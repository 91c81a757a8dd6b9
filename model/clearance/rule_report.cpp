#include "model/clearance/rule_report.h"

#include <algorithm>
#include <array>

#include "model/base/units.h"
#include "model/text/formatting.h"

namespace model {

const char* toString(FindingReason reason) {
    constexpr std::array<const char*, kFindingReasonCount> kTexts = {
        "", "the drill removes the whole pad",     "no copper around the hole on any layer",
        "", "tracks meet at less than 90 degrees", "reaches no pad and no plated hole",
        ""};
    return kTexts[static_cast<std::size_t>(reason)];
}

std::string reasonOf(const RuleFinding& finding) {
    if (finding.reason == FindingReason::TooDeep) {
        return formatted("%.2f : 1, %.1f um deep", finding.depth / finding.spacing.distance,
                         finding.depth / base::kNmPerUm);
    }
    return finding.isWithoutPad ? "no pad there on this layer: the copper around it counts" : toString(finding.reason);
}

double requiredOf(const Rule& rule, const RuleFinding& finding) {
    switch (limitOf(rule.kind)) {
        case RuleLimit::Length: return rule.least;
        case RuleLimit::Ratio: return finding.depth / rule.mostRatio;
        default: return 0.0;
    }
}

const char* toString(WaiverNote::State state) {
    constexpr const char* kWords[] = {"gone", "worse", "renamed", "unknown"};
    return kWords[static_cast<std::size_t>(state)];
}

std::size_t waivedOf(const RuleReport& report, std::size_t rule) {
    return static_cast<std::size_t>(
        std::ranges::count_if(report.waived, [&](const WaivedFinding& waived) { return waived.found.rule == rule; }));
}

std::string textOf(const Unchecked& unchecked) {
    return unchecked.count == 0 ? unchecked.why
                                : std::to_string(unchecked.count) + ' ' + unchecked.what + ": " + unchecked.why;
}

Verdict verdictOf(const RuleTable& table, const RuleReport& report, std::size_t rule) {
    const bool isComplete = std::ranges::count(report.unchecked, rule, &Unchecked::rule) == 0;
    return !table.rules[rule].isOn        ? Verdict::Off
           : report.counts[rule] > 0      ? Verdict::Failed
           : !isComplete                  ? Verdict::Incomplete
           : !report.unused[rule].empty() ? Verdict::Unused
                                          : Verdict::Passed;
}

const char* toString(Verdict verdict) {
    constexpr const char* kWords[] = {"off", "unused", "pass", "incomplete", "FAIL"};
    return kWords[static_cast<std::size_t>(verdict)];
}

std::string sideOf(const Document& step, ElementId element) {
    if (!element.isValid()) {
        return "(board edge)";
    }
    const NetId net = step.elements.net[element.row()];
    return net.isValid() ? step.nets[net.row()].name : "(no net)";
}

std::string secondSideOf(const Document& step, const RuleFinding& finding) {
    const bool isAlone = !finding.b.isValid() && finding.reason > FindingReason::NoPad;
    return finding.reason == FindingReason::NoPad ? "(no pad)" : isAlone ? "" : sideOf(step, finding.b);
}

}  // namespace model
