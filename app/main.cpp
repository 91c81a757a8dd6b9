#include <spdlog/sinks/stdout_color_sinks.h>
#include <spdlog/spdlog.h>

#include "app/commands/command_line.h"
#include "app/commands/workbench_command.h"

namespace {

struct Run {
    int argc;
    char** argv;

    int operator()(const app::WorkbenchArguments& arguments) const { return app::runWorkbench(argc, argv, arguments); }
    int operator()(const app::InfoArguments& arguments) const { return app::runInfo(arguments); }
    int operator()(const app::RenderArguments& arguments) const { return app::runRender(arguments); }
    int operator()(const app::GenerateArguments& arguments) const { return app::runGenerate(arguments); }
    int operator()(const app::BenchArguments& arguments) const { return app::runBench(arguments); }
    int operator()(const app::TriangulationBenchArguments& arguments) const {
        return app::runTriangulationBench(arguments);
    }
    int operator()(const app::ClearanceArguments& arguments) const { return app::runClearance(arguments); }
    int operator()(const app::SectionArguments& arguments) const { return app::runSection(arguments); }
    int operator()(const app::MeasureArguments& arguments) const { return app::runMeasure(arguments); }
    int operator()(const app::Quit& quit) const { return quit.code; }
};

}  // namespace

int main(int argc, char** argv) {
    spdlog::set_default_logger(spdlog::stderr_color_mt("copperscope"));  // data goes to stdout, talk to stderr
    return std::visit(Run{argc, argv}, app::parseCommandLine(argc, argv));
}
