#pragma once

#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "model/clearance/clearance.h"
#include "model/clearance/rule_report.h"

/// What was found out about clearances, as text for people and files for programs.
namespace model {

/// The smallest clearances of one step.
struct StepClearances {
    const Document* step = nullptr;
    std::vector<Clearance> clearances;
};

/// What the rules say of one step.
struct StepRules {
    const Document* step = nullptr;
    RuleReport report;
};

/// Junit and everything behind it are forms of rules alone.
enum class ReportFormat { Text, Json, Csv, Junit, Sarif, Html };
/// "text", "json", "csv", "junit", "sarif", "html"; also as endings of files (".txt", ".json", ".csv", ".xml",
/// ".sarif",
/// ".html"). None if it is none of them.
[[nodiscard]] std::optional<ReportFormat> reportFormatOf(std::string_view name);
[[nodiscard]] constexpr bool isOfRulesAlone(ReportFormat format) {
    return format >= ReportFormat::Junit;
}

/// What reports name beside the findings.
struct ReportContext {
    std::filesystem::path board;  ///< the job, as the user names it
    std::string version;          ///< of Copperscope
};

/// The smallest clearances, step by step, in a format that is not of rules alone. Widths in micrometres, places in
/// millimetres.
[[nodiscard]] std::string clearanceReport(std::span<const StepClearances> steps, ReportFormat format);
/// Every rule with its verdict (model::Verdict), what it could not check and why, and its locations, `most` of each at
/// most; those that are waived with the reason, what is to be said of waivers, and but for CSV the notes too. `context`
/// is for JUnit (model/export/junit_export.h), SARIF and HTML.
[[nodiscard]] std::string ruleReport(const RuleTable& table, std::span<const StepRules> steps, ReportFormat format,
                                     std::size_t most, const ReportContext& context = {});

}  // namespace model
