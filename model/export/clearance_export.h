#pragma once

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

enum class ReportFormat { Text, Json, Csv };
/// "text", "json", "csv"; also as endings of files (".txt", ".json", ".csv"). None if it is none of them.
[[nodiscard]] std::optional<ReportFormat> reportFormatOf(std::string_view name);

/// The smallest clearances, step by step. Widths in micrometres, places in millimetres.
[[nodiscard]] std::string clearanceReport(std::span<const StepClearances> steps, ReportFormat format);
/// Every rule with its verdict (model::Verdict), what it could not check and why, and its locations, `most` of each at
/// most; in text and JSON the notes too.
[[nodiscard]] std::string ruleReport(const RuleTable& table, std::span<const StepRules> steps, ReportFormat format,
                                     std::size_t most);

}  // namespace model
