#include "app/commands/info_command.h"

#include <algorithm>
#include <cstdio>
#include <iostream>
#include <map>
#include <optional>

#include "app/common/console_progress.h"
#include "app/common/incomplete_job.h"
#include "app/reports/info_json.h"
#include "app/reports/stackup_report.h"
#include "model/board/diagnostic_facts.h"
#include "model/board/layers.h"
#include "model/clearance/clearance.h"
#include "model/formats/common/read_options.h"
#include "model/formats/gerber/layer_proposals.h"
#include "model/text/json_text.h"
#include "render/standard/standard_triangles.h"

namespace app {

using model::Document;
using model::Layer;
using model::StepCheck;

namespace {

/// Components inside a rigid-flex board, by the layer that they stand on.
void printMounted(const Document& document) {
    std::map<model::LayerId, std::size_t> counts;
    for (const model::Body& body : document.bodies) {
        ++counts[model::mountingLayerOf(document, body)];
    }
    counts.erase(model::LayerId{});
    std::string text;
    for (const auto& [layer, count] : counts) {
        text += (text.empty() ? "" : ", ") + std::to_string(count) + " on " + document.layer(layer).name;
    }
    if (!text.empty()) {
        std::printf("inside      %s\n", text.c_str());
    }
}

void printJob(const Document& document, const std::string& format) {
    const model::JobInfo& job = document.job;
    std::printf("job         %s\n", job.name.c_str());
    std::printf("written by  %s\n", job.generator.empty() ? "(not stated)" : job.generator.c_str());
    std::printf("format      %s, version %s, %s\n", format.c_str(),
                job.version.empty() ? "(not stated)" : job.version.c_str(), job.units.c_str());
    std::printf("step        %s", job.step.c_str());
    for (const std::string& step : job.steps) {
        std::printf("%s", step == job.step ? "" : (" (also: " + step + ")").c_str());
    }
    std::printf("\nboard       %.3f x %.3f mm, %.3f mm thick\n",
                base::toMm(static_cast<double>(document.board.width())),
                base::toMm(static_cast<double>(document.board.height())), base::toMm(document.boardThickness));
    std::printf("nets        %zu\ncomponents  %zu\n", document.nets.size(), document.components.size());
    printMounted(document);
    for (const PlacedStep& placed : placedSteps(document)) {
        std::printf("copies      %llu x %s with %zu nets and %zu components\n",
                    static_cast<unsigned long long>(placed.copies), placed.step->job.step.c_str(),
                    placed.step->nets.size(), placed.step->components.size());
    }
}

template <class Count>
void printCounts(const std::array<Count, model::kElementKindCount>& counts) {
    for (const std::uint64_t count : counts) {
        std::printf(" %7llu", static_cast<unsigned long long>(count));
    }
}

void printPackages(const Document& document) {
    std::vector<std::uint32_t> counts(document.packages.size());
    for (const model::Component& component : document.components) {
        if (component.package.isValid()) {
            ++counts[component.package.row()];
        }
    }
    if (!counts.empty()) {
        std::printf("\n%-40s %10s %6s\n", "package", "components", "pins");
    }
    for (std::size_t row = 0; row < counts.size(); ++row) {
        const model::Package& package = document.packages[row];
        std::printf("%-40s %10u %6u\n", package.name.c_str(), counts[row], package.pins.count);
    }
}

void printLayers(const Document& document) {
    std::printf("\n%-28s %-16s %-8s %9s %9s %-8s %8s %7s %7s %7s %7s %7s\n", "layer", "type", "side", "z mm",
                "height mm", "from", "features", "lines", "arcs", "circles", "trails", "areas");
    for (const Layer& layer : document.layers) {
        if (layer.isSynthetic) {
            continue;
        }
        std::printf("%-28s %-16s %-8s %9.4f %9.4f %-8s %8u", layer.name.c_str(), model::toString(layer.type),
                    model::toString(layer.side), base::toMm(layer.z), base::toMm(layer.thickness),
                    model::toString(layer.thicknessSource), layer.featureCount);
        printCounts(layer.counts);
        std::printf("%s\n", layer.isNegative ? "  negative" : "");
    }
    std::printf("%-92s", "all layers");
    printCounts(document.elementCounts());
    std::printf("\n");
    if (!document.instances.empty()) {
        std::printf("%-92s", "with the copies of other steps");
        printCounts(document.elementCountsWithCopies());
        std::printf("\n");
    }
}

void printDiagnostics(const model::Diagnostics& diagnostics) {
    for (const model::Diagnostic& entry : diagnostics.entries()) {
        const std::string location = entry.file.empty() ? "" : model::placeOf(entry) + ": ";
        const std::string times = entry.count > 1 ? " (" + std::to_string(entry.count) + " times)" : "";
        std::printf("  %-8s %s%s%s\n", model::toString(entry.severity), location.c_str(), entry.text.c_str(),
                    times.c_str());
    }
}

void printModel(const CountedBoard& board) {
    const model::ReadTimes& read = board.document->times;
    const render::ModelTimes& modelled = board.model.times;
    std::printf(
        "\nmodel       %zu lets, %zu shapes of areas at %zu locations, %llu triangles stored (standard pipeline: "
        "%llu)\n",
        board.model.lets, board.model.shapes, board.model.instances,
        static_cast<unsigned long long>(board.model.triangles),
        static_cast<unsigned long long>(render::countStandardTriangles(*board.document, board.how)));
    std::printf("times       parse %.1f ms, create %.1f ms, discretise %.1f ms, triangulate %.1f ms\n", read.parseMs,
                read.createMs + modelled.createMs, modelled.discretiseMs, modelled.triangulateMs);
}

void printText(const CountedBoard& board, const std::vector<StepCheck>* checks) {
    printJob(*board.document, board.format);
    printLayers(*board.document);
    printStackup(*board.document);
    printDrills(*board.document);
    printPackages(*board.document);
    if (checks != nullptr) {
        printConnectivity(*checks);
    }
    printModel(board);
    if (!board.document->diagnostics.entries().empty() || !board.model.diagnostics.entries().empty()) {
        std::printf("\nmessages\n");
        printDiagnostics(board.document->diagnostics);
        printDiagnostics(board.model.diagnostics);
    }
}

/// Errors: why no Gerber job can be read there.
base::Status checkIsGerber(const std::filesystem::path& path, model::formats::ReadOptions options,
                           base::Progress& progress) {
    ASSIGN_OR_RETURN(const model::BoardFormat* format, model::formatAt(path, options, progress));
    options.format = "gerber";
    if (format->key == options.format || model::formatAt(path, options, progress)) {
        return base::Done{};
    }
    return base::Error{base::ErrorCode::BadUsage, path.string() + ": this is no Gerber job; it is read as " +
                                                      std::string(format->name) +
                                                      ", which says itself what its layers are"};
}

Outcome printLayerMap(const model::OpenRequest& request) {
    ConsoleProgress console;
    model::formats::ReadOptions options;
    options.layerMap = request.layerMap;
    options.limits = request.limits;
    const std::filesystem::path path = orSample(request).path;
    if (!request.format.empty() && request.format != "gerber") {
        return base::Error{base::ErrorCode::BadUsage, "--print-layer-map is of Gerber jobs, not of " + request.format};
    }
    RETURN_IF_ERROR(checkIsGerber(path, options, console.progress()));
    ASSIGN_OR_RETURN(const std::vector<model::gerber::LayerProposal> proposals,
                     model::gerber::proposeLayers(path, options, console.progress()));
    std::fputs(model::gerber::explainedMapText(proposals).c_str(), stdout);
    return int{kDone};
}

/// Of the netlist check: shorts and opens are faults. Floating copper, ties and pins without a net may be meant.
int codeOf(const std::vector<StepCheck>& checks) {
    const bool isFaulty = std::ranges::any_of(checks, [](const StepCheck& check) {
        return !check.report.shorts.empty() || std::ranges::any_of(check.report.opens, [&](const model::OpenNet& open) {
            return model::hasSeveralPadIslands(check.report, open);
        });
    });
    return isFaulty ? kTooClose : kDone;
}

/// Is there copper, and no step whose nets could be compared with it?
bool isNothingCompared(const std::vector<StepCheck>& checks) {
    const auto isLacking = [](const StepCheck& check) { return model::isCopperWithoutNets(*check.step); };
    const auto hasNets = [](const StepCheck& check) { return !check.step->nets.empty(); };
    return std::ranges::any_of(checks, isLacking) && std::ranges::none_of(checks, hasNets);
}

int verdictOf(const Document& board, const std::vector<StepCheck>& checks, bool allowsIncomplete) {
    const Document* const jobs[] = {&board};
    const int code =
        isNothingCompared(checks)
            ? incompleteCode(codeOf(checks), "nothing was compared: the board has copper but no nets", allowsIncomplete)
            : codeOf(checks);
    return verdictCode(code, jobs, allowsIncomplete);
}

}  // namespace

Outcome runInfo(const InfoArguments& arguments) {
    if (arguments.printsLayerMap) {
        return printLayerMap(arguments.board.request);
    }
    ASSIGN_OR_RETURN(const CountedBoard board, countBoard(arguments.board));
    std::optional<std::vector<StepCheck>> checks;
    if (arguments.checkNets) {
        ConsoleProgress console;
        ASSIGN_OR_RETURN(checks, model::checkAllNets(*board.document, console.progress()));
    }
    const std::vector<StepCheck>* checked = checks ? &*checks : nullptr;
    if (arguments.asJson) {
        // Names in jobs may hold bytes that are no UTF-8; readers decode them, and what slips through must not end the
        // report.
        std::cout << model::jsonText(infoJson(board, checked));
    } else {
        printText(board, checked);
    }
    return checks ? verdictOf(*board.document, *checks, arguments.allowsIncomplete) : int{kDone};
}

}  // namespace app
