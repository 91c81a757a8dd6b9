#include "app/commands/interaction_command.h"

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "app/commands/workbench_command.h"
#include "app/common/commit.h"
#include "model/text/formatting.h"
#include "model/text/json_text.h"

namespace app {

namespace {

using nlohmann::ordered_json;

constexpr double kSmooth = 0.95;  // of frames: what is rarer is a stutter, which the longest stall tells

std::string fixed(double value) {
    return model::fixedText(value, 1);
}

ordered_json jsonOf(const ui::InteractionRun& run) {
    return {{"view", run.view},
            {"name", run.name},
            {"frames", run.frameMs.size()},
            {"median_ms", run.percentile(0.5)},
            {"p95_ms", run.percentile(kSmooth)},
            {"longest_ms", run.percentile(1.0)},
            {"longest_stall_ms", run.longestStallMs},
            {"processor_ms", run.processorMs()},
            {"frames_per_second", run.framesPerSecond()}};
}

ordered_json jsonOf(const std::string& board, const ui::InteractionReport& report) {
    ordered_json runs = ordered_json::array();
    std::ranges::transform(report.runs, std::back_inserter(runs),
                           [](const ui::InteractionRun& run) { return jsonOf(run); });
    return {{"name", board},
            {"first_frame_ms", report.firstFrameMs},
            {"first_whole_ms", report.firstWholeMs},
            {"runs", std::move(runs)}};
}

std::string tableOf(const std::string& board, const ui::InteractionReport& report) {
    std::string text = board + ", " + report.device + "\nfirst picture " + fixed(report.firstFrameMs) +
                       " ms, of all of the board " + fixed(report.firstWholeMs) +
                       " ms after the model\n\n| view | what | median ms | p95 ms | longest ms | longest stall ms | "
                       "processor ms | frames/s |\n|---|---|---|---|---|---|---|---|\n";
    for (const ui::InteractionRun& run : report.runs) {
        text += "| " + run.view + " | " + run.name + " | " + fixed(run.percentile(0.5)) + " | " +
                fixed(run.percentile(kSmooth)) + " | " + fixed(run.percentile(1.0)) + " | " +
                fixed(run.longestStallMs) + " | " + fixed(run.processorMs()) + " | " + fixed(run.framesPerSecond()) +
                " |\n";
    }
    return text;
}

}  // namespace

Outcome runInteractionBench(const InteractionArguments& arguments) {
    ordered_json boards = ordered_json::array();
    std::string device;
    for (const std::string& path : arguments.boards) {
        ui::InteractionRequest request = arguments.request;
        request.board.path = path;
        request.board.noSession = true;
        ASSIGN_OR_RETURN(const ui::InteractionReport report, measureInWindow(request));
        const std::string name = std::filesystem::path(path).filename().string();
        device = report.device;
        boards.push_back(jsonOf(name, report));
        if (!arguments.asJson) {
            std::fputs((tableOf(name, report) + "\n").c_str(), stdout);
        }
    }
    if (arguments.asJson) {
        const ordered_json all{{"commit", kCommit},
                               {"device", device},
                               {"width", arguments.request.width},
                               {"height", arguments.request.height},
                               {"boards", std::move(boards)}};
        std::fputs(model::jsonText(all).c_str(), stdout);
    }
    return int{kDone};
}

}  // namespace app
