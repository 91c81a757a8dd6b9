#include "app/commands/agree_command.h"

#include <algorithm>
#include <array>
#include <cstdio>
#include <nlohmann/json.hpp>

#include "app/common/console_progress.h"
#include "app/common/incomplete_job.h"
#include "model/agreement/agreement.h"
#include "model/base/thickness_units.h"
#include "model/text/formatting.h"
#include "model/text/json_text.h"

namespace app {

using model::Accord;
using model::Agreement;
using model::Comparison;
using nlohmann::ordered_json;

namespace {

/// What two jobs that agree may still differ in.
constexpr std::array kNeverCompared = {"materials, and thicknesses of solder mask, paste and silkscreen",
                                       "values of parts, and which are not placed", "nets of copper that no pin is on"};

/// What only comparisons use that --aspects leaves out would do nothing.
base::Status checkEffects(const AgreeArguments& arguments, const model::AgreementRequest& request) {
    using enum model::Aspect;
    const auto wants = [&request](model::Aspect aspect) { return request.wants(aspect); };
    const std::array layers = {Copper, SolderMask, SolderPaste, Silkscreen, Outline};
    const bool wantsLayers = std::ranges::any_of(layers, wants);
    const auto wrong = [](const std::string& text) {
        return base::Error{base::ErrorCode::BadUsage, text + ", which --aspects leaves out"};
    };
    if (!arguments.tolerance.empty() && !wantsLayers && !wants(Holes)) {
        return wrong("--tolerance is for layers, outline and holes");
    }
    if (arguments.allowedPercent && !wantsLayers) {
        return wrong("--allow is for layers and outline");
    }
    if (arguments.board.request.inferNets && !wants(Nets) && !wants(NetNames)) {
        return wrong("--infer-nets is for nets and their names");
    }
    return base::Done{};
}

base::Result<model::AgreementRequest> requestFrom(const AgreeArguments& arguments) {
    model::AgreementRequest request;
    if (!arguments.tolerance.empty()) {
        ASSIGN_OR_RETURN(request.tolerance, model::parseLength(arguments.tolerance));
    }
    if (request.tolerance < 1'000 || request.tolerance > 1'000'000) {
        return base::Error{base::ErrorCode::BadUsage, "--tolerance is 1 um to 1 mm, not " + arguments.tolerance};
    }
    request.allowed = arguments.allowedPercent.value_or(0.0) / 100.0;
    request.most = arguments.most;
    for (const std::string& name : arguments.aspects) {
        request.aspects.push_back(*model::aspectNamed(name));  // the command line knows the names
    }
    RETURN_IF_ERROR(checkEffects(arguments, request));
    return request;
}

base::Result<model::OpenedBoard> open(const AgreeArguments& arguments, const std::string& path,
                                      const std::string& format, base::Progress& progress) {
    model::OpenRequest request = arguments.board.request;
    request.path = path;
    request.noSession = true;
    request.format = format.empty() ? request.format : format;
    ASSIGN_OR_RETURN(model::OpenedBoard board, model::openBoard(request, progress));
    sayChoice(board, request);
    sayErrors(*board.document);
    return board;
}

/// One of them is enough: a Gerber job is often compared with a board of another format.
base::Status checkLayerMaps(const model::OpenedBoard& a, const model::OpenedBoard& b) {
    const base::Status ofA = checkLayerMap(a);
    return ofA ? ofA : checkLayerMap(b);
}

// ---- JSON ----

ordered_json pointJson(const std::optional<base::Point>& point) {
    return point ? ordered_json({point->x, point->y}) : ordered_json(nullptr);
}

ordered_json boxJson(const base::Box& box) {
    return box.isEmpty() ? ordered_json(nullptr) : ordered_json({box.min.x, box.min.y, box.max.x, box.max.y});
}

void addRegion(ordered_json& json, const model::RegionDifference& region) {
    json["area_nm2"] = {region.areas[0], region.areas[1]};
    json["only_nm2"] = {region.only[0], region.only[1]};
    json["share"] = region.share();
    json["box_nm"] = boxJson(region.box);
}

ordered_json comparisonJson(const Comparison& comparison) {
    const bool hasLayers = !comparison.layers[0].empty() || !comparison.layers[1].empty();
    const bool hasCounts = comparison.counts[0] + comparison.counts[1] > 0;
    ordered_json json = {{"aspect", toString(comparison.aspect)}, {"verdict", toString(comparison.accord)}};
    json["layers"] = hasLayers ? ordered_json(comparison.layers) : ordered_json(nullptr);
    json["counts"] = hasCounts ? ordered_json(comparison.counts) : ordered_json(nullptr);
    json["note"] = comparison.note;
    if (comparison.region) {
        addRegion(json, *comparison.region);
    }
    if (comparison.farthest) {
        json["farthest_nm"] = *comparison.farthest;
    }
    json["differing"] = comparison.differing;
    json["differences"] = ordered_json::array();
    for (const model::Difference& difference : comparison.differences) {
        json["differences"].push_back({{"text", difference.text},
                                       {"at_nm", pointJson(difference.location)},
                                       {"box_nm", boxJson(difference.box)}});
    }
    return json;
}

void printJson(const AgreeArguments& arguments, const Agreement& agreement, bool isComplete) {
    ordered_json json = {{"a", arguments.a},
                         {"b", arguments.b},
                         {"agree", agreement.isAgreed()},
                         {"compared", agreement.isCompared()},
                         {"complete", isComplete},
                         {"shift_nm", {agreement.shift.x, agreement.shift.y}},
                         {"comparisons", ordered_json::array()},
                         {"never_compared", kNeverCompared}};
    for (const Comparison& comparison : agreement.comparisons) {
        json["comparisons"].push_back(comparisonJson(comparison));
    }
    std::fputs(model::jsonText(json).c_str(), stdout);
}

// ---- text ----

const char* accordWord(Accord verdict) {
    constexpr const char* kWords[] = {"agree", "DIFFER", "not compared"};
    return kWords[static_cast<std::size_t>(verdict)];
}

std::string bothNames(const Comparison& comparison) {
    const auto& [a, b] = comparison.layers;
    return a == b ? a : a.empty() ? b : b.empty() ? a : a + ", " + b;
}

std::string sizesOf(const Comparison& comparison) {
    if (comparison.region) {
        const model::RegionDifference& region = *comparison.region;
        return model::formatted("%.3f and %.3f mm²", region.areas[0] / 1e12, region.areas[1] / 1e12);
    }
    const auto& [a, b] = comparison.counts;
    const std::string counts = a + b == 0 ? ""
                               : a == b   ? std::to_string(a)
                                          : std::to_string(a) + " and " + std::to_string(b);
    return comparison.farthest ? counts + model::formatted(", at most %.3f µm apart", *comparison.farthest / 1e3)
                               : counts;
}

void printComparison(const Comparison& comparison) {
    std::printf("%-13s %-13s", accordWord(comparison.accord), toString(comparison.aspect));
    for (const std::string& text : {bothNames(comparison), sizesOf(comparison), comparison.note}) {
        std::printf("%s%s", text.empty() ? "" : "  ", text.c_str());
    }
    std::printf("\n");
    for (const model::Difference& difference : comparison.differences) {
        std::printf("  %s", difference.text.c_str());
        if (difference.location) {
            std::printf(", at %.4f, %.4f mm", base::toMm(difference.location->x), base::toMm(difference.location->y));
        }
        std::printf("\n");
    }
    if (comparison.differing > comparison.differences.size()) {
        std::printf("  and %zu more\n", comparison.differing - comparison.differences.size());
    }
}

/// The last line of the report.
const char* verdictOf(const Agreement& agreement, bool isComplete) {
    return !agreement.isCompared() ? "Nothing was compared."
           : !agreement.isAgreed() ? "The jobs differ."
           : isComplete            ? "The jobs agree."
                                   : "What could be read of the jobs agrees; not all could be read.";
}

void printText(const AgreeArguments& arguments, const Agreement& agreement, bool isComplete) {
    std::printf("A  %s\nB  %s\n", arguments.a.c_str(), arguments.b.c_str());
    if (agreement.shift != base::Point{}) {
        std::printf("B counts from another origin: %.4f, %.4f mm were added\n", base::toMm(agreement.shift.x),
                    base::toMm(agreement.shift.y));
    }
    std::printf("\n");
    for (const Comparison& comparison : agreement.comparisons) {
        printComparison(comparison);
    }
    std::printf("\nNever compared: ");
    for (const char* what : kNeverCompared) {
        std::printf("%s%s", what == kNeverCompared.front() ? "" : "; ", what);
    }
    std::printf(".\n%s\n", verdictOf(agreement, isComplete));
}

}  // namespace

Outcome runAgree(const AgreeArguments& arguments) {
    ConsoleProgress console;
    ASSIGN_OR_RETURN(const model::AgreementRequest request, requestFrom(arguments));
    ASSIGN_OR_RETURN(const auto a, open(arguments, arguments.a, arguments.formatA, console.progress()));
    ASSIGN_OR_RETURN(const auto b, open(arguments, arguments.b, arguments.formatB, console.progress()));
    RETURN_IF_ERROR(checkLayerMaps(a, b));
    ASSIGN_OR_RETURN(const Agreement agreement,
                     model::compareBoards(*a.document, *b.document, request, console.progress()));
    const model::Document* const jobs[] = {a.document.get(), b.document.get()};
    const bool isComplete = areComplete(jobs);
    arguments.asJson ? printJson(arguments, agreement, isComplete) : printText(arguments, agreement, isComplete);
    return verdictCode(agreement.isAgreed() ? kDone : kTooClose, jobs, arguments.allowsIncomplete);
}

}  // namespace app
