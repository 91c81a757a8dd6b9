#include "app/bench/bench_command.h"

#include <cstdio>

#include "app/bench/bench_tables.h"
#include "app/common/headless_device.h"
#include "model/text/json_text.h"

namespace app {

namespace {

base::Result<BenchReport> measure(const BenchArguments& arguments) {
    ASSIGN_OR_RETURN(HeadlessDevice opened, HeadlessDevice::open());
    render::gpu::Device& device = *opened.device;
    BenchReport report;
    report.device = device.caps().name + ", " + device.caps().driver;
    for (const std::string& path : arguments.boards) {
        ASSIGN_OR_RETURN(BoardResult board, benchBoard(device, path, arguments));
        report.boards.push_back(std::move(board));
    }
    return report;
}

}  // namespace

Outcome runBench(const BenchArguments& arguments) {
    if (arguments.pipeline == "standard" && arguments.levels != "error") {
        return base::Error{base::ErrorCode::BadUsage, "--lod is of the hybrid pipeline"};
    }
    ASSIGN_OR_RETURN(const BenchReport report, measure(arguments));
    const std::string text = arguments.asJson ? model::jsonText(benchJson(report)) : benchTable(report);
    std::fputs(text.c_str(), stdout);
    return int{kDone};
}

}  // namespace app
