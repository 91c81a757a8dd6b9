#include "model/export/sarif_export.h"

#include <cmath>

#include "model/base/ascii.h"
#include "model/base/units.h"
#include "model/export/rule_items.h"
#include "model/text/formatting.h"
#include "model/text/json_text.h"

namespace model {

using nlohmann::ordered_json;

namespace {

/// A path as a URI: without ways there and back ("a/../b"), with percent signs for all but letters, digits and
/// "-._~/".
std::string uriOf(const std::filesystem::path& path) {
    std::string uri = path.is_absolute() ? "file://" : "";
    for (const char c : path.lexically_normal().generic_string()) {
        const bool isPlain =
            base::isLetter(c) || base::isDigit(c) || std::string_view("-._~/").find(c) != std::string_view::npos;
        uri += isPlain ? std::string(1, c) : formatted("%%%02X", static_cast<unsigned>(static_cast<unsigned char>(c)));
    }
    return uri;
}

/// Titles; of rules with the same one the later ones have a number.
std::vector<std::string> idsOf(const RuleTable& table) {
    std::vector<std::string> ids;
    for (const Rule& rule : table.rules) {
        const std::string title = titleOf(rule);
        const auto same = std::count_if(
            ids.begin(), ids.end(), [&](const std::string& id) { return id == title || id.starts_with(title + " #"); });
        ids.push_back(same == 0 ? title : title + " #" + std::to_string(same + 1));
    }
    return ids;
}

ordered_json limitJson(const Rule& rule) {
    return limitOf(rule.kind) == RuleLimit::Ratio ? ordered_json{{"most_ratio", rule.mostRatio}}
                                                  : ordered_json{{"least_um", rule.least / base::kNmPerUm}};
}

ordered_json rulesJson(const RuleTable& table, const std::vector<std::string>& ids) {
    ordered_json rules = ordered_json::array();
    for (std::size_t row = 0; row < table.rules.size(); ++row) {
        const Rule& rule = table.rules[row];
        rules.push_back({{"id", ids[row]},
                         {"name", nameOf(rule.kind)},
                         {"shortDescription", {{"text", limitText(rule)}}},
                         {"defaultConfiguration", {{"enabled", rule.isOn}, {"level", "error"}}},
                         {"properties", limitJson(rule)}});
    }
    return rules;
}

class Writer {
public:
    Writer(const RuleTable& table, std::size_t most, const ReportContext& context)
        : m_table(table), m_most(most), m_ids(idsOf(table)), m_uri(uriOf(context.board)) {}

    [[nodiscard]] const std::vector<std::string>& ids() const { return m_ids; }
    [[nodiscard]] const ordered_json& results() const { return m_results; }
    [[nodiscard]] const ordered_json& notes() const { return m_notes; }

    void add(const StepRules& found) {
        const SideNames names(*found.step);
        for (std::size_t row = 0; row < m_table.rules.size(); ++row) {
            addVerdict(found, row);
            for (const RuleFinding& finding : findingsOf(found, row, m_most)) {
                m_results.push_back(resultOf(found, names, finding));
            }
            for (const WaivedFinding& waived : waivedOf(found, row, m_most)) {
                m_results.push_back(resultOf(found, names, waived.found));
                m_results.back()["suppressions"].push_back(
                    {{"kind", "external"}, {"status", "accepted"}, {"justification", waived.reason}});
            }
            for (const std::string& unchecked : uncheckedOf(found.report, row)) {
                m_results.push_back(ofRule(found, row, "open", "not checked: " + unchecked));
            }
        }
        addNotes(found);
    }

    void notify(const char* level, const std::string& text) {
        m_notes.push_back({{"level", level}, {"message", {{"text", text}}}});
    }

private:
    /// Of rules without locations.
    void addVerdict(const StepRules& found, std::size_t row) {
        const Verdict verdict = verdictOf(m_table, found.report, row);
        if (verdict == Verdict::Passed) {
            m_results.push_back(ofRule(found, row, "pass", limitText(m_table.rules[row])));
        } else if (verdict == Verdict::Unused) {
            m_results.push_back(ofRule(found, row, "notApplicable", "unused: " + found.report.unused[row]));
        }
    }

    [[nodiscard]] ordered_json ofRule(const StepRules& found, std::size_t row, const char* kind,
                                      const std::string& message) const {
        const bool isFailed = std::string_view(kind) == "fail";
        const std::string& step = found.step->job.step;
        ordered_json location{
            {"physicalLocation", {{"artifactLocation", {{"uri", m_uri}}}, {"region", {{"startLine", 1}}}}},
            {"logicalLocations", {{{"name", step}, {"fullyQualifiedName", step}, {"kind", "module"}}}}};
        return {{"ruleId", m_ids[row]},
                {"ruleIndex", row},
                {"kind", kind},
                {"level", isFailed ? "error" : "none"},
                {"message", {{"text", message}}},
                {"locations", ordered_json::array({location})},
                {"suppressions", ordered_json::array()}};
    }

    [[nodiscard]] ordered_json resultOf(const StepRules& found, const SideNames& names,
                                        const RuleFinding& finding) const {
        const Rule& rule = m_table.rules[finding.rule];
        const Document& step = *found.step;
        const std::string place = placeText(step, names, finding);
        ordered_json result =
            ofRule(found, finding.rule, "fail", limitText(rule) + ": " + shortfallText(rule, finding) + " on " + place);
        const std::string layer = step.job.step + '/' + step.layer(finding.layer).name;
        ordered_json& logical = result["locations"][0]["logicalLocations"];
        logical.push_back(
            {{"name", step.layer(finding.layer).name}, {"fullyQualifiedName", layer}, {"kind", "namespace"}});
        const auto [a, b] = names.of(finding);
        for (const Side& side : {a, b}) {
            logical.push_back(
                {{"name", side.net}, {"fullyQualifiedName", layer + '/' + side.net}, {"kind", "variable"}});
        }
        const Spacing& s = finding.spacing;
        result["partialFingerprints"] = {{"copperscopeLocation/v1", m_ids[finding.rule] + ", " + place}};
        result["properties"] = {{"clearance_um", s.distance / base::kNmPerUm},
                                {"from_mm", {base::toMm(s.from.x), base::toMm(s.from.y)}},
                                {"to_mm", {base::toMm(s.to.x), base::toMm(s.to.y)}}};
        return result;
    }

    void addNotes(const StepRules& found) {
        for (const WaiverNote& note : found.report.waiverNotes) {
            notify("warning", note.text);
        }
        for (const NetTie& tie : found.report.netTies) {
            notify("note", "net tie: " + textOf(*found.step, tie));
        }
        for (const std::string& note : found.report.notes) {
            notify("note", note);
        }
        for (std::size_t row = 0; row < m_table.rules.size(); ++row) {
            const std::size_t listed = findingsOf(found, row, m_most).size();
            if (found.report.counts[row] > listed) {
                notify("warning", m_ids[row] + ": " + std::to_string(found.report.counts[row] - listed) +
                                      " more locations are not listed");
            }
        }
    }

    const RuleTable& m_table;
    std::size_t m_most;
    std::vector<std::string> m_ids;
    std::string m_uri;
    ordered_json m_results = ordered_json::array();
    ordered_json m_notes = ordered_json::array();
};

}  // namespace

std::string sarifReport(const RuleTable& table, std::span<const StepRules> steps, std::size_t most,
                        const ReportContext& context) {
    Writer writer(table, most, context);
    for (const StepRules& found : steps) {
        writer.add(found);
    }
    if (isNothingChecked(table, steps)) {
        writer.notify("warning", kNothingChecked);
    }
    ordered_json driver{{"name", "Copperscope"}};
    if (!context.version.empty()) {
        driver["version"] = context.version;
    }
    driver["rules"] = rulesJson(table, writer.ids());
    const ordered_json run{
        {"tool", {{"driver", driver}}},
        {"invocations", {{{"executionSuccessful", true}, {"toolExecutionNotifications", writer.notes()}}}},
        {"results", writer.results()}};
    return jsonText({{"$schema", "https://json.schemastore.org/sarif-2.1.0.json"},
                     {"version", "2.1.0"},
                     {"runs", ordered_json::array({run})}});
}

}  // namespace model
