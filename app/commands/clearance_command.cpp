#include "app/commands/clearance_command.h"

#include <algorithm>
#include <cstdio>
#include <span>

#include "app/common/console_progress.h"
#include "model/base/thickness_units.h"
#include "model/board/copies.h"
#include "model/export/clearance_export.h"

namespace app {

using model::Clearance;
using model::Document;
using model::StepClearances;
using model::StepRules;

namespace {

base::Error unknown(const char* kind, const std::string& name) {
    return {base::ErrorCode::BadUsage, "the board has no " + std::string(kind) + " " + name};
}

base::Result<model::ClearanceRequest> requestFor(const Document& document, const ClearanceArguments& arguments) {
    model::ClearanceRequest request;
    request.count = arguments.worst;
    if (!arguments.below.empty()) {
        ASSIGN_OR_RETURN(const base::Nm below, model::parseLength(arguments.below));
        request.below = static_cast<double>(below);
    }
    if (!arguments.layer.empty()) {
        request.layer = document.findLayer(arguments.layer);
        if (!request.layer.isValid() || !document.layer(request.layer).isCopper()) {
            return unknown("copper layer", arguments.layer);
        }
    }
    if (!arguments.nets.empty()) {
        const model::NetId a = document.findNet(arguments.nets.front());
        const model::NetId b = document.findNet(arguments.nets.back());
        if (!a.isValid() || !b.isValid()) {
            return unknown("net", a.isValid() ? arguments.nets.back() : arguments.nets.front());
        }
        if (a == b) {
            return base::Error{base::ErrorCode::BadUsage, "a net has no clearance to itself: --nets names two"};
        }
        request.between = {a, b};
    }
    return request;
}

void print(const std::string& report) {
    std::fwrite(report.data(), 1, report.size(), stdout);
}

model::ReportFormat formatOf(const ClearanceArguments& arguments) {
    return model::reportFormatOf(arguments.format).value_or(model::ReportFormat::Text);
}

/// Every step once; those without copper have nothing to say.
base::Result<std::vector<StepClearances>> measureSteps(const Document& board, const ClearanceArguments& arguments,
                                                       base::Progress& progress) {
    std::vector<StepClearances> found;
    bool hasNets = false;
    for (const Document* step : model::distinctSteps(board)) {
        hasNets = hasNets || !step->nets.empty();
        if (step->nets.empty()) {
            continue;
        }
        ASSIGN_OR_RETURN(const model::ClearanceRequest request, requestFor(*step, arguments));
        ASSIGN_OR_RETURN(std::vector<Clearance> clearances, model::smallestClearances(*step, request, progress));
        found.push_back({step, std::move(clearances)});
    }
    if (!hasNets) {
        return base::Error{
            base::ErrorCode::BadInput,
            "the board has no nets, so there are no clearances; --infer-nets infers them from the copper"};
    }
    for (const std::string& note : model::unmeasuredSteps(board)) {
        std::fprintf(stderr, "copperscope: %s\n", note.c_str());
    }
    return found;
}

/// "0" needs no unit.
base::Result<base::Nm> parseTolerance(const std::string& text) {
    ASSIGN_OR_RETURN(const base::Nm tolerance,
                     text == "0" ? base::Result<base::Nm>(base::Nm{0}) : model::parseLength(text));
    if (tolerance > model::kMostTolerance) {
        return base::Error{base::ErrorCode::BadUsage, "a tolerance of limits is at most 10 um, not " + text};
    }
    return tolerance;
}

base::Result<model::RuleTable> rulesFor(const ClearanceArguments& arguments) {
    model::RuleTable table = model::defaultRules();
    if (arguments.rules != "default") {
        ASSIGN_OR_RETURN(table, model::readRules(arguments.rules));
    }
    if (!arguments.tolerance.empty()) {
        ASSIGN_OR_RETURN(table.tolerance, parseTolerance(arguments.tolerance));
    }
    return table;
}

/// A rule that is broken counts, and one that could not check everything, unless that is allowed.
int exitCodeOf(std::span<const StepRules> steps, bool allowsIncomplete) {
    const bool isPassed = std::ranges::all_of(steps, [](const StepRules& s) { return s.report.isPassed(); });
    const bool isComplete = std::ranges::all_of(steps, [](const StepRules& s) { return s.report.isComplete(); });
    if (!isComplete) {
        std::fprintf(stderr, "copperscope: not everything could be checked; see \"incomplete\" and \"not checked\"%s\n",
                     allowsIncomplete ? "" : " (--allow-incomplete accepts that)");
    }
    return isPassed && (isComplete || allowsIncomplete) ? kDone : kTooClose;
}

Outcome runRules(const ClearanceArguments& arguments, const Document& board, base::Progress& progress) {
    ASSIGN_OR_RETURN(const model::RuleTable table, rulesFor(arguments));
    std::vector<StepRules> steps;
    for (const Document* step : model::distinctSteps(board)) {
        ASSIGN_OR_RETURN(model::RuleReport report, model::checkRules(*step, table, progress));
        steps.push_back({step, std::move(report)});
    }
    print(model::ruleReport(table, steps, formatOf(arguments), arguments.worst));
    return exitCodeOf(steps, arguments.allowsIncomplete);
}

}  // namespace

Outcome runClearance(const ClearanceArguments& arguments) {
    if (arguments.printsRules) {
        ASSIGN_OR_RETURN(const model::RuleTable table, rulesFor(arguments));
        print(model::commentedJson(table));
        return int{kDone};
    }
    ConsoleProgress console;
    ASSIGN_OR_RETURN(const auto board, openDocument(arguments.board, console.progress()));
    if (!arguments.rules.empty()) {
        return runRules(arguments, *board, console.progress());
    }
    ASSIGN_OR_RETURN(const auto found, measureSteps(*board, arguments, console.progress()));
    print(model::clearanceReport(found, formatOf(arguments)));
    const bool isAnyClose = std::ranges::any_of(found, [](const StepClearances& s) { return !s.clearances.empty(); });
    return int{!arguments.below.empty() && isAnyClose ? kTooClose : kDone};
}

}  // namespace app
