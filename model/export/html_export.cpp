#include "model/export/html_export.h"

#include "model/base/units.h"
#include "model/export/location_picture.h"
#include "model/export/rule_items.h"
#include "model/text/formatting.h"

namespace model {

namespace {

constexpr const char* kPageStyle =
    "body{font:14px/1.45 sans-serif;color:#222;max-width:1100px;margin:24px auto;padding:0 16px}h1{font-size:24px}h2{"
    "font-size:19px;margin-top:32px}h3{font-size:16px;margin:24px 0 "
    "6px}table{border-collapse:collapse;width:100%}th,td{"
    "border-bottom:1px solid #ddd;padding:5px "
    "8px;text-align:left;vertical-align:top}th{background:#f3f3f3}td.n{text-align:"
    "right;white-space:nowrap}.fail{color:#b00020;font-weight:600}.incomplete{color:#8a5a00;font-weight:600}.pass{"
    "color:"
    "#14692f;font-weight:600}.off,.unused{color:#777}.waived "
    "td{color:#777}i.a,i.b{display:inline-block;width:10px;height:"
    "10px;margin-right:6px}i.a{background:#d9731a}i.b{background:#2f7fc1}@media "
    "print{body{max-width:none;margin:0}tr,svg{"
    "break-inside:avoid}h2,h3{break-after:avoid}a{color:inherit;text-decoration:none}*{-webkit-print-color-adjust:"
    "exact;"
    "print-color-adjust:exact}}";

std::string tag(const char* name, const std::string& text, const char* className = "") {
    const std::string start =
        std::string("<") + name + (*className == 0 ? "" : std::string(" class=\"") + className + '"');
    return start + '>' + xmlText(text) + "</" + name + '>';
}

/// As a class of the page's styles.
const char* classOf(Verdict verdict) {
    return verdict == Verdict::Failed ? "fail" : toString(verdict);
}

std::string anchorOf(std::size_t step, std::size_t rule) {
    return formatted("s%zur%zu", step + 1, rule + 1);
}

std::string um(double nm) {
    return formatted("%.3f µm", nm / base::kNmPerUm);
}

std::string sidesCell(const SideNames& names, const RuleFinding& finding) {
    const auto [a, b] = names.of(finding);
    return "<td><i class=\"a\"></i>" + xmlText(textOf(a)) + "<br/><i class=\"b\"></i>" + xmlText(textOf(b));
}

/// One location; `waived` is why it does not count, or empty.
std::string rowOf(const Document& step, const SideNames& names, LocationPictures& pictures, const RuleFinding& finding,
                  const std::string& waived) {
    std::string sides = sidesCell(names, finding);
    for (const std::string& text : {reasonOf(finding), waived.empty() ? "" : "waived: " + waived}) {
        sides += text.empty() ? "" : "<br/>" + tag("b", text);
    }
    const Spacing& s = finding.spacing;
    return (waived.empty() ? "<tr>" : "<tr class=\"waived\">") + tag("td", um(s.distance), "n") +
           tag("td", step.layer(finding.layer).name) +
           tag("td", formatted("%.4f, %.4f", base::toMm(s.from.x), base::toMm(s.from.y)), "n") + sides + "</td><td>" +
           pictures.svgOf(finding) + "</td></tr>\n";
}

std::string locationsOf(const RuleTable& table, const StepRules& found, const SideNames& names,
                        LocationPictures& pictures, std::size_t at, std::size_t row, std::size_t most) {
    const auto listed = findingsOf(found, row, most);
    const auto waived = waivedOf(found, row, most);
    if (listed.empty() && waived.empty()) {
        return "";
    }
    std::string text = "<h3 id=\"" + anchorOf(at, row) + "\">" + xmlText(limitText(table.rules[row])) + ": " +
                       countsText(table, found.report, row) +
                       "</h3>\n<table><tr><th>Clearance</th><th>Layer</th><th>x, y in mm" +
                       "</th><th>Sides</th><th>Location</th></tr>\n";
    for (const RuleFinding& finding : listed) {
        text += rowOf(*found.step, names, pictures, finding, "");
    }
    for (const WaivedFinding& finding : waived) {
        text += rowOf(*found.step, names, pictures, finding.found, finding.reason);
    }
    text += "</table>\n";
    const std::size_t left = found.report.counts[row] - listed.size();
    return left == 0 ? text : text + tag("p", std::to_string(left) + " more locations are not listed.") + '\n';
}

std::string limitCell(const Rule& rule) {
    return hasLeast(rule.kind) ? formatted("%.1f µm", rule.least / base::kNmPerUm) : boundText(rule);
}

std::string rulesTable(const RuleTable& table, const StepRules& found, std::size_t at) {
    std::string text =
        "<table><tr><th>Result</th><th>Rule</th><th>Limit</th><th>Locations</th><th>Waived</th><th>"
        "Not checked</th></tr>\n";
    for (std::size_t row = 0; row < table.rules.size(); ++row) {
        const Verdict verdict = verdictOf(table, found.report, row);
        const std::size_t waived = waivedOf(found.report, row);
        const std::string title = xmlText(titleOf(table.rules[row]));
        const bool isListed = found.report.counts[row] + waived > 0;
        text += "<tr>" + tag("td", verdict == Verdict::Failed ? "fail" : toString(verdict), classOf(verdict)) + "<td>" +
                (isListed ? "<a href=\"#" + anchorOf(at, row) + "\">" + title + "</a>" : title) + "</td>" +
                tag("td", limitCell(table.rules[row]), "n") + tag("td", std::to_string(found.report.counts[row]), "n") +
                tag("td", std::to_string(waived), "n") +
                tag("td", verdict == Verdict::Unused ? found.report.unused[row]
                                                     : joined(uncheckedOf(found.report, row), "; ")) +
                "</tr>\n";
    }
    return text + "</table>\n";
}

std::string notesOf(const StepRules& found) {
    std::string items;
    for (const WaiverNote& note : found.report.waiverNotes) {
        items += tag("li", note.text, "incomplete") + '\n';
    }
    for (const NetTie& tie : found.report.netTies) {
        items += tag("li", "net tie: " + textOf(*found.step, tie)) + '\n';
    }
    for (const std::string& note : found.report.notes) {
        items += tag("li", note) + '\n';
    }
    return items.empty() ? "" : "<ul>\n" + items + "</ul>\n";
}

std::string stepHtml(const RuleTable& table, const StepRules& found, std::size_t at, std::size_t most) {
    const SideNames names(*found.step);
    LocationPictures pictures(*found.step);
    std::string text = tag("h2", "Step " + found.step->job.step) + '\n' + rulesTable(table, found, at) + notesOf(found);
    for (std::size_t row = 0; row < table.rules.size(); ++row) {
        text += locationsOf(table, found, names, pictures, at, row, most);
    }
    return text;
}

/// "FAIL: 3 locations of 2 rules, 1 waived; 1 rule is incomplete"
std::string summaryOf(const RuleTable& table, std::span<const StepRules> steps) {
    if (isNothingChecked(table, steps)) {
        return tag("p", kNothingChecked, classOf(Verdict::Incomplete));
    }
    std::size_t count = 0;
    std::size_t waived = 0;
    for (const StepRules& found : steps) {
        waived += found.report.waived.size();
        for (const std::size_t ofRule : found.report.counts) {
            count += ofRule;
        }
    }
    const std::size_t failed = rulesWith(table, steps, Verdict::Failed);
    const std::size_t incomplete = rulesWith(table, steps, Verdict::Incomplete);
    const Verdict all = failed > 0 ? Verdict::Failed : incomplete > 0 ? Verdict::Incomplete : Verdict::Passed;
    const std::string text = formatted("%s: %zu locations break %zu rules, %zu are waived; %zu rules are incomplete",
                                       toString(all), count, failed, waived, incomplete);
    return tag("p", text, classOf(all));
}

}  // namespace

std::string htmlReport(const RuleTable& table, std::span<const StepRules> steps, std::size_t most,
                       const ReportContext& context) {
    const std::string job = steps.empty() ? "" : steps.front().step->job.name;
    const std::string title = "Design rules of " + job;
    std::string text =
        "<!DOCTYPE html>\n<html xmlns=\"http://www.w3.org/1999/xhtml\" lang=\"en\"><head><meta charset=\""
        "utf-8\"/>" +
        tag("title", title) + "<style>" + kPageStyle + LocationPictures::kStyle + "</style></head>\n<body>\n" +
        tag("h1", title) + '\n' + summaryOf(table, steps) + '\n';
    text += tag("p", "Job " + context.board.string() + ", checked by Copperscope " + context.version +
                         formatted(", tolerance of limits %.3f µm.",
                                   static_cast<double>(table.tolerance) / base::kNmPerUm)) +
            '\n';
    for (std::size_t at = 0; at < steps.size(); ++at) {
        text += stepHtml(table, steps[at], at, most);
    }
    return text + "</body></html>\n";
}

}  // namespace model
