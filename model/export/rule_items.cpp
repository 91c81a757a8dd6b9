#include "model/export/rule_items.h"

#include <algorithm>
#include <limits>

#include "model/base/units.h"
#include "model/text/formatting.h"

namespace model {

namespace {

constexpr std::size_t kAll = std::numeric_limits<std::size_t>::max();

template <class Item, class RuleOf>
std::span<const Item> firstOf(const std::vector<Item>& all, std::size_t rule, std::size_t most, RuleOf ruleOf) {
    const auto first = std::ranges::lower_bound(all, rule, {}, ruleOf);
    const auto last = std::ranges::upper_bound(all, rule, {}, ruleOf);
    return std::span(first, last).first(std::min(most, static_cast<std::size_t>(last - first)));
}

std::string withoutElement(Side side) {
    side.element = {};
    return textOf(side);
}

}  // namespace

std::span<const RuleFinding> findingsOf(const StepRules& step, std::size_t rule, std::size_t most) {
    return firstOf(step.report.findings, rule, most, &RuleFinding::rule);
}

std::span<const WaivedFinding> waivedOf(const StepRules& step, std::size_t rule, std::size_t most) {
    return firstOf(step.report.waived, rule, most, [](const WaivedFinding& waived) { return waived.found.rule; });
}

std::vector<std::string> unlistedOf(const StepRules& step, std::size_t rule, std::size_t most) {
    std::vector<std::string> texts;
    const auto add = [&](std::size_t count, const std::string& what) {
        if (count > most) {
            texts.push_back(std::to_string(count - most) + " more " + what +
                            (count - most == 1 ? "location is not listed" : "locations are not listed"));
        }
    };
    add(findingsOf(step, rule, kAll).size(), "");
    add(waivedOf(step, rule, kAll).size(), "waived ");
    return texts;
}

std::vector<std::string> uncheckedOf(const RuleReport& report, std::size_t rule) {
    std::vector<std::string> texts;
    for (const Unchecked& unchecked : report.unchecked) {
        if (unchecked.rule == rule) {
            texts.push_back(textOf(unchecked));
        }
    }
    return texts;
}

std::string countsText(const RuleTable& table, const RuleReport& report, std::size_t rule) {
    const std::size_t count = report.counts[rule];
    const std::size_t waived = waivedOf(report, rule);
    const bool isOfRuns = table.rules[rule].kind == RuleKind::TrackWidth;  // tracks that lead on as one
    const char* one = isOfRuns ? " run of tracks" : " location";
    const char* many = isOfRuns ? " runs of tracks" : " locations";
    return std::to_string(count) + (count == 1 ? one : many) +
           (waived > 0 ? ", " + std::to_string(waived) + " waived" : "");
}

std::string boundText(const Rule& rule) {
    switch (limitOf(rule.kind)) {
        case RuleLimit::Length: return formatted("at least %.1f um", rule.least / base::kNmPerUm);
        case RuleLimit::Ratio: return "at most " + ratioText(rule.mostRatio);
        default: return {};
    }
}

std::string limitText(const Rule& rule) {
    const std::string bound = boundText(rule);
    return titleOf(rule) + (bound.empty() ? "" : ", " + bound);
}

std::string placeText(const Document& step, const SideNames& names, const RuleFinding& finding) {
    const auto [a, b] = names.of(finding);
    return step.layer(finding.layer).name +
           formatted(" at (%.4f, %.4f) mm: ", base::toMm(finding.spacing.from.x), base::toMm(finding.spacing.from.y)) +
           withoutElement(a) + (b.net.empty() ? "" : " and " + withoutElement(b));
}

std::string shortfallText(const Rule& rule, const RuleFinding& finding) {
    const std::string reason = reasonOf(finding);
    if (limitOf(rule.kind) == RuleLimit::None) {
        return reason;
    }
    return formatted("%.3f um of %.1f um", finding.spacing.distance / base::kNmPerUm,
                     requiredOf(rule, finding) / base::kNmPerUm) +
           (reason.empty() ? "" : ", " + reason);
}

std::size_t rulesWith(const RuleTable& table, std::span<const StepRules> steps, Verdict verdict) {
    std::size_t count = 0;
    for (const StepRules& step : steps) {
        for (std::size_t rule = 0; rule < table.rules.size(); ++rule) {
            count += verdictOf(table, step.report, rule) == verdict ? 1 : 0;
        }
    }
    return count;
}

bool isNothingChecked(const RuleTable& table, std::span<const StepRules> steps) {
    return std::ranges::none_of(steps, [&](const StepRules& step) {
        for (std::size_t rule = 0; rule < table.rules.size(); ++rule) {
            if (verdictOf(table, step.report, rule) > Verdict::Unused) {
                return true;
            }
        }
        return false;
    });
}

}  // namespace model
