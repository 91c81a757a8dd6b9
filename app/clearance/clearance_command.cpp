#include "app/clearance/clearance_command.h"

#include <algorithm>
#include <cstdio>
#include <ctime>
#include <iterator>
#include <span>

#include "app/clearance/through_stackup.h"
#include "app/common/console_progress.h"
#include "app/common/incomplete_job.h"
#include "model/base/thickness_units.h"
#include "model/board/copies.h"
#include "model/clearance/kicad_project_rules.h"
#include "model/clearance/rule_file.h"
#include "model/clearance/rule_presets.h"
#include "model/design_rules/waived_check.h"
#include "model/export/clearance_export.h"
#include "model/export/rule_items.h"
#include "model/text/whole_file.h"

namespace app {

using model::Clearance;
using model::Document;
using model::StepClearances;
using model::StepRules;

namespace {

base::Error unknown(const char* kind, const std::string& name) {
    return {base::ErrorCode::BadUsage, "the board has no " + std::string(kind) + " " + name};
}

/// None if no net is named, or the step lacks it.
std::pair<model::NetId, model::NetId> netsOf(const Document& step, const std::vector<std::string>& names) {
    return names.empty() ? std::pair<model::NetId, model::NetId>()
                         : std::pair(step.findNet(names.front()), step.findNet(names.back()));
}

/// Why no step has all of these nets.
base::Error missing(std::span<const Document* const> steps, const std::vector<std::string>& names) {
    for (const std::string& name : names) {
        if (std::ranges::none_of(steps, [&](const Document* step) { return step->findNet(name).isValid(); })) {
            return unknown("net", name);
        }
    }
    return {base::ErrorCode::BadUsage,
            "no step of the board has both net " + names.front() + " and net " + names.back()};
}

bool hasBoth(const Document& step, const std::vector<std::string>& names) {
    const auto [first, second] = netsOf(step, names);
    return first.isValid() && second.isValid();
}

/// Steps without nets have nothing between two anyway.
void saySkipped(std::span<const Document* const> steps, const std::vector<std::string>& names) {
    for (const Document* step : steps) {
        if (!step->nets.empty() && !hasBoth(*step, names)) {
            const std::string& lacking = step->findNet(names.front()).isValid() ? names.back() : names.front();
            std::fprintf(stderr, "copperscope: step %s has no net %s; it was skipped\n", step->job.step.c_str(),
                         lacking.c_str());
        }
    }
}

/// Steps that have both nets of --nets, and stderr says which are skipped; without --nets all. None of a board without
/// nets. Errors: BadUsage where no step has both.
base::Result<std::vector<const Document*>> stepsWith(const std::vector<std::string>& names, const Document& board) {
    std::vector<const Document*> steps = model::distinctSteps(board);
    if (names.empty()) {
        return steps;
    }
    if (names.front() == names.back()) {
        return base::Error{base::ErrorCode::BadUsage, "a net has no clearance to itself: --nets names two"};
    }
    std::vector<const Document*> having;
    std::ranges::copy_if(steps, std::back_inserter(having),
                         [&](const Document* step) { return hasBoth(*step, names); });
    const bool hasNets = std::ranges::any_of(steps, [](const Document* step) { return !step->nets.empty(); });
    if (having.empty() && hasNets) {
        return missing(steps, names);
    }
    saySkipped(steps, names);
    return having;
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
        RETURN_IF_ERROR(checkOnlyOne(document, request.layer, arguments.layer));
    }
    request.between = netsOf(document, arguments.nets);
    return request;
}

base::Result<model::RuleScope> scopeFor(const Document& document, const ClearanceArguments& arguments) {
    model::RuleScope scope;
    if (!arguments.layer.empty()) {
        scope.layer = document.findLayer(arguments.layer);
        if (!scope.layer.isValid() || !model::isRuled(document.layer(scope.layer))) {
            return unknown("copper, solder mask or silkscreen layer", arguments.layer);
        }
        RETURN_IF_ERROR(checkOnlyOne(document, scope.layer, arguments.layer));
    }
    scope.between = netsOf(document, arguments.nets);
    return scope;
}

void print(const std::string& report) {
    std::fwrite(report.data(), 1, report.size(), stdout);
}

/// Where the user wants it.
base::Status deliver(const ClearanceArguments& arguments, const std::string& report) {
    if (!arguments.output.empty()) {
        return model::writeWholeFile(arguments.output, report);
    }
    print(report);
    return base::Done{};
}

model::ReportFormat formatOf(const ClearanceArguments& arguments) {
    return model::reportFormatOf(arguments.format).value_or(model::ReportFormat::Text);
}

/// Every step once; those without copper have nothing to say.
base::Result<std::vector<StepClearances>> measureSteps(const Document& board, const ClearanceArguments& arguments,
                                                       base::Progress& progress) {
    std::vector<StepClearances> found;
    ASSIGN_OR_RETURN(const std::vector<const Document*> steps, stepsWith(arguments.nets, board));
    for (const Document* step : steps) {
        if (step->nets.empty()) {
            continue;
        }
        ASSIGN_OR_RETURN(const model::ClearanceRequest request, requestFor(*step, arguments));
        ASSIGN_OR_RETURN(std::vector<Clearance> clearances, model::smallestClearances(*step, request, progress));
        found.push_back({step, std::move(clearances)});
    }
    if (found.empty()) {
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

void reportLeftOut(const model::RuleFile& file, const std::string& path) {
    for (const model::LeftOutRule& one : file.leftOut) {
        const std::string from = one.file.empty() ? path : one.file.string();
        std::fprintf(stderr, "copperscope: %s: %s\n", from.c_str(), model::textOf(one).c_str());
    }
    for (const std::string& unused : file.unused) {
        std::fprintf(stderr, "copperscope: %s: %s\n", path.c_str(), unused.c_str());
    }
}

/// The error with the file that is at fault, where it does not name one.
base::Error inFile(const std::string& path, base::Error error) {
    if (error.text.find(path) == std::string::npos) {
        error.text.insert(0, path + ": ");
    }
    return error;
}

/// `board`: what they are for; null: as the file has them.
base::Result<model::RuleTable> rulesFor(const ClearanceArguments& arguments, const model::Document* board) {
    model::RuleTable table = model::defaultRules();
    if (arguments.rules != "default") {
        base::Result<model::RuleFile> read = model::readRules(arguments.rules);
        if (!read) {
            return inFile(arguments.rules, read.error());
        }
        model::RuleFile& file = *read;
        if (board != nullptr) {
            model::leaveOutUnusedClasses(file, *board);
        }
        reportLeftOut(file, arguments.rules);
        table = std::move(file.table);
    }
    if (!arguments.tolerance.empty()) {
        ASSIGN_OR_RETURN(table.tolerance, parseTolerance(arguments.tolerance));
    }
    if (std::ranges::none_of(table.rules, &model::Rule::isOn)) {
        return base::Error{base::ErrorCode::BadInput, "all rules are off, so nothing would be checked"};
    }
    return table;
}

std::string counted(std::size_t count, const char* what) {
    return std::to_string(count) + ' ' + what + (count == 1 ? "" : "s");
}

/// What rules say of all steps together.
struct Outlook {
    std::size_t broken = 0;         ///< rules
    std::size_t locations = 0;      ///< where they are broken
    std::size_t incomplete = 0;     ///< rules that could not check everything, broken ones too
    bool isNothingChecked = false;  ///< all rules are off or unused
};

Outlook outlookOf(const model::RuleTable& table, std::span<const StepRules> steps) {
    Outlook outlook;
    outlook.isNothingChecked = model::isNothingChecked(table, steps);
    for (std::size_t rule = 0; rule < table.rules.size(); ++rule) {
        const auto isAnywhere = [&](const auto& holds) {
            return std::ranges::any_of(steps, [&](const StepRules& step) { return holds(step.report); });
        };
        const auto isPart = [&](const model::RuleReport& report) {
            return std::ranges::count(report.unchecked, rule, &model::Unchecked::rule) > 0;
        };
        outlook.broken += isAnywhere([&](const model::RuleReport& report) { return report.counts[rule] > 0; }) ? 1 : 0;
        outlook.incomplete += isAnywhere(isPart) ? 1 : 0;
        for (const StepRules& step : steps) {
            outlook.locations += step.report.counts[rule];
        }
    }
    return outlook;
}

/// "3 rules broken at 10 locations, 1 incomplete"; empty if there is nothing to say.
std::string textOf(const Outlook& outlook) {
    if (outlook.isNothingChecked) {
        return model::kNothingChecked;
    }
    const std::string incomplete = std::to_string(outlook.incomplete) + " incomplete";
    if (outlook.broken > 0) {
        return counted(outlook.broken, "rule") + " broken at " + counted(outlook.locations, "location") +
               (outlook.incomplete > 0 ? ", " + incomplete : "");
    }
    return outlook.incomplete > 0
               ? "not everything could be checked: " + counted(outlook.incomplete, "rule") + " incomplete"
               : "";
}

/// A rule that is broken counts. So does one that could not check everything, and that none had anything to check,
/// unless that is allowed. Says on stderr what counts, as the report may lie in a file.
int exitCodeOf(const Outlook& outlook, const ClearanceArguments& arguments) {
    const bool isPart = outlook.incomplete > 0 || outlook.isNothingChecked;
    const bool mayAccept = isPart && !arguments.allowsIncomplete;
    const std::string text = textOf(outlook);
    const std::string where = text.empty() || arguments.output.empty() ? "" : "; see " + arguments.output;
    const char* hint = !mayAccept           ? ""
                       : outlook.broken > 0 ? " (--allow-incomplete accepts what is incomplete)"
                                            : " (--allow-incomplete accepts that)";
    if (!text.empty()) {
        std::fprintf(stderr, "copperscope: %s%s%s\n", text.c_str(), where.c_str(), hint);
    }
    return outlook.broken > 0 || mayAccept ? kTooClose : kDone;
}

/// Leaves out of the list what is not closer than --below. Verdicts and counts stay: the rules are broken there too.
base::Status listBelow(const std::string& below, std::vector<StepRules>& steps) {
    if (below.empty()) {
        return base::Done{};
    }
    ASSIGN_OR_RETURN(const base::Nm limit, model::parseLength(below));
    for (StepRules& step : steps) {
        std::erase_if(step.report.findings,
                      [&](const model::RuleFinding& finding) { return finding.spacing.distance >= limit; });
        step.report.notes.push_back("only locations closer than " + below + " are listed, all are counted");
    }
    return base::Done{};
}

using Waivers = std::vector<model::Waiver>;

base::Result<Waivers> waiversFor(const ClearanceArguments& arguments) {
    base::Result<Waivers> waivers = Waivers{};
    if (!arguments.waivers.empty()) {
        waivers = model::readWaivers(arguments.waivers);
    }
    return waivers ? waivers : inFile(arguments.waivers, waivers.error());
}

std::string today() {
    const std::time_t now = std::time(nullptr);
    char text[16] = {};
    std::strftime(text, sizeof text, "%Y-%m-%d", std::localtime(&now));
    return text;
}

/// Waives what is not waived yet; of one location the waiver of the smaller distance counts.
void waiveAll(const ClearanceArguments& arguments, const model::RuleTable& table, const StepRules& found,
              Waivers& waivers) {
    const model::SideNames names(*found.step);
    model::Waiver said;
    said.reason = arguments.reason;
    said.author = arguments.author;
    said.date = today();
    for (const model::RuleFinding& finding : found.report.findings) {
        const model::Waiver waiver = model::waiverOf(*found.step, names, table, finding, said);
        const auto same =
            std::ranges::find_if(waivers, [&](const model::Waiver& old) { return model::areOfOnePlace(old, waiver); });
        if (same == waivers.end()) {
            waivers.push_back(waiver);
        } else if (waiver.distance < same->distance) {
            *same = waiver;
        }
    }
}

/// All steps that have --nets; with `acceptsAll` every location of two nets is a finding.
base::Result<std::vector<StepRules>> checkSteps(const ClearanceArguments& arguments, const Document& board,
                                                const model::RuleTable& table, const Waivers& waivers, bool acceptsAll,
                                                base::Progress& progress) {
    std::vector<StepRules> steps;
    ASSIGN_OR_RETURN(const std::vector<const Document*> wanted, stepsWith(arguments.nets, board));
    for (const Document* step : wanted) {
        ASSIGN_OR_RETURN(model::RuleScope scope, scopeFor(*step, arguments));
        if (acceptsAll) {
            scope.isAccepted = [](const model::RuleFinding&) { return true; };
        }
        ASSIGN_OR_RETURN(model::RuleReport report, model::checkRules(*step, table, waivers, progress, scope));
        steps.push_back({step, std::move(report)});
    }
    if (steps.empty()) {
        return base::Error{base::ErrorCode::BadUsage, "the board has no nets, so --nets names none of them"};
    }
    return steps;
}

Outcome writeWaivers(const ClearanceArguments& arguments, const Document& board, const model::RuleTable& table,
                     Waivers waivers, base::Progress& progress) {
    const std::size_t before = waivers.size();
    ASSIGN_OR_RETURN(const std::vector<StepRules> steps, checkSteps(arguments, board, table, waivers, true, progress));
    for (const StepRules& found : steps) {
        waiveAll(arguments, table, found, waivers);
    }
    RETURN_IF_ERROR(model::writeWholeFile(arguments.newWaivers, model::toJson(waivers)));
    std::fprintf(stderr, "copperscope: %zu waivers, %zu before, in %s\n", waivers.size(), before,
                 arguments.newWaivers.c_str());
    const std::size_t incomplete = outlookOf(table, steps).incomplete;
    if (incomplete > 0) {
        std::fprintf(stderr,
                     "copperscope: %s could not check everything, which no waiver accepts: checks with these waivers "
                     "need --allow-incomplete\n",
                     counted(incomplete, "rule").c_str());
    }
    return int{kDone};
}

Outcome runRules(const ClearanceArguments& arguments, const model::OpenedBoard& opened, base::Progress& progress) {
    const Document& board = *opened.document;
    ASSIGN_OR_RETURN(const model::RuleTable table, rulesFor(arguments, &board));
    ASSIGN_OR_RETURN(const Waivers waivers, waiversFor(arguments));
    if (!arguments.newWaivers.empty()) {
        return writeWaivers(arguments, board, table, waivers, progress);
    }
    ASSIGN_OR_RETURN(std::vector<StepRules> steps, checkSteps(arguments, board, table, waivers, false, progress));
    for (model::WaiverNote& note : model::waiversElsewhere(waivers, model::distinctSteps(board))) {
        steps.front().report.waiverNotes.push_back(std::move(note));
    }
    RETURN_IF_ERROR(listBelow(arguments.below, steps));
    const model::ReportContext context{fileOf(opened), COPPERSCOPE_VERSION};
    RETURN_IF_ERROR(deliver(arguments, model::ruleReport(table, steps, formatOf(arguments), arguments.worst, context)));
    return exitCodeOf(outlookOf(table, steps), arguments);
}

/// Options that fit together no command line parser can say.
base::Status checkUsage(const ClearanceArguments& arguments) {
    const auto wrong = [](const char* text) { return base::Error{base::ErrorCode::BadUsage, text}; };
    if (arguments.rules.empty() && model::isOfRulesAlone(formatOf(arguments))) {
        return wrong("junit, sarif and html are reports on rules: they need --rules");
    }
    if (arguments.allowsIncomplete && arguments.rules.empty() && arguments.below.empty()) {
        return wrong("--allow-incomplete needs --rules or --below, which end with a verdict");
    }
    if (!arguments.newWaivers.empty() && (arguments.reason.empty() || arguments.author.empty())) {
        return wrong("--write-waivers needs --reason and --author, which must not be empty");
    }
    return base::Done{};
}

/// Without --below there is no verdict. Steps without nets have nothing between two that are named.
int limitCode(const ClearanceArguments& arguments, const Document& board, int code) {
    if (arguments.below.empty()) {
        return kDone;
    }
    if (arguments.nets.empty() && !model::unmeasuredSteps(board).empty()) {
        code = incompleteCode(code, "not everything could be checked: steps with copper have no nets",
                              arguments.allowsIncomplete);
    }
    const Document* const jobs[] = {&board};
    return verdictCode(code, jobs, arguments.allowsIncomplete);
}

}  // namespace

Outcome runClearance(const ClearanceArguments& arguments) {
    if (arguments.printsRules) {
        ASSIGN_OR_RETURN(const model::RuleTable table, rulesFor(arguments, nullptr));
        const model::RulePreset* preset = arguments.tolerance.empty() ? model::findPreset(arguments.rules) : nullptr;
        RETURN_IF_ERROR(deliver(arguments, preset != nullptr ? preset->text : model::commentedJson(table)));
        return int{kDone};
    }
    RETURN_IF_ERROR(checkUsage(arguments));
    ConsoleProgress console;
    ASSIGN_OR_RETURN(const model::OpenedBoard opened, openWithSession(arguments.board, console.progress()));
    const Document& board = *opened.document;
    if (arguments.isThroughStackup) {
        ASSIGN_OR_RETURN(const ThroughStackup found, runThroughStackup(arguments, board, console.progress()));
        RETURN_IF_ERROR(deliver(arguments, found.report));
        return limitCode(arguments, board, found.code);
    }
    if (!arguments.map.file.empty()) {
        return runClearanceMap(arguments.map, board, arguments.layer, console.progress());
    }
    if (!arguments.rules.empty()) {
        return runRules(arguments, opened, console.progress());
    }
    ASSIGN_OR_RETURN(const auto found, measureSteps(board, arguments, console.progress()));
    RETURN_IF_ERROR(deliver(arguments, model::clearanceReport(found, formatOf(arguments))));
    const bool isAnyClose = std::ranges::any_of(found, [](const StepClearances& s) { return !s.clearances.empty(); });
    return limitCode(arguments, board, isAnyClose ? kTooClose : kDone);
}

}  // namespace app
