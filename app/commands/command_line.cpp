#include "app/commands/command_line.h"

#include <CLI/CLI.hpp>
#include <charconv>

#include "app/common/commit.h"
#include "app/common/exit_code.h"

namespace app {

namespace {

void addStackupOptions(CLI::App& command, std::vector<std::string>& thicknesses, bool& noSession) {
    command
        .add_option(
            "--set-thickness", thicknesses,
            "LAYER=LENGTH over what the job says, with um, mm, mil, inch, or oz for copper; may be given several "
            "times")
        ->take_all()
        ->expected(1);
    command.add_flag("--no-session", noSession, "ignore the session file beside the board");
}

void addNetOptions(CLI::App& command, bool& inferNets) {
    command.add_flag("--infer-nets", inferNets, "find the nets by following the copper, instead of the job's");
}

void addModellingOptions(CLI::App& command, BoardArguments& board) {
    command.add_option("--step", board.step, "the step to open; default: the first one with features of its own");
    command.add_option("--chord", board.chordUm, "largest distance between a curve and its chords, in micrometres")
        ->check(CLI::Range(0.5, 50.0))
        ->capture_default_str();
    addNetOptions(command, board.inferNets);
    command.add_flag("--paper-segments", board.paperSegments,
                     "50 segments per circle and 20 per arc, as the paper does");
}

void addBoardOptions(CLI::App& command, BoardArguments& board) {
    addStackupOptions(command, board.thicknesses, board.noSession);
    command.add_flag("--save-session", board.saveSession,
                     "keep the set thicknesses in the session file beside the board");
    command.add_option("BOARD", board.path,
                       "ODB++ job (folder, .tgz, .tar.gz, .tar, .zip) or a model of the paper; default: the sample");
    addModellingOptions(command, board);
    command
        .add_option("--triangulator", board.triangulator,
                    "who triangulates areas: auto, cpu, parallel, cgal or gpu; the triangles are the same")
        ->check(CLI::IsMember({"auto", "cpu", "parallel", "cgal", "gpu"}))
        ->capture_default_str();
}

void addInfo(CLI::App& parent, InfoArguments& arguments) {
    CLI::App* command =
        parent.add_subcommand("info", "Say what is in a board: layers, stack, nets, elements, messages");
    addBoardOptions(*command, arguments.board);
    command->add_flag("--json", arguments.asJson, "as JSON");
    command->add_flag("--check-nets", arguments.checkNets, "compare the nets with the copper: opens and shorts");
}

void parseSize(const std::string& text, RenderArguments& arguments) {
    const std::size_t cross = text.find('x');
    const char* end = text.data() + text.size();
    const auto width = std::from_chars(text.data(), end, arguments.width);
    const bool isPair = cross != std::string::npos && width.ptr == text.data() + cross;
    const auto height = isPair ? std::from_chars(width.ptr + 1, end, arguments.height) : width;
    if (!isPair || height.ptr != end || arguments.width == 0 || arguments.height == 0) {
        throw CLI::ValidationError("--size", "takes WIDTHxHEIGHT in pixels, for example 1600x1000");
    }
}

void addLevels(CLI::App& command, std::string& levels) {
    command
        .add_option(
            "--lod", levels,
            "level of detail by error in pixels, the paper's three levels by size, or coarse as while a view moves")
        ->check(CLI::IsMember({"error", "paper", "coarse"}))
        ->capture_default_str();
}

void addRender(CLI::App& parent, RenderArguments& arguments) {
    CLI::App* command = parent.add_subcommand("render", "Draw a board to a picture");
    addBoardOptions(*command, arguments.board);
    command->add_option("-o,--output", arguments.output, "the picture to write (.png)")->required();
    command->add_option("--view", arguments.view, "top, bottom or iso")->check(CLI::IsMember({"top", "bottom", "iso"}));
    command->add_option_function<std::string>(
        "--size", [&arguments](const std::string& text) { parseSize(text, arguments); },
        "WIDTHxHEIGHT in pixels [1600x1000]");
    command->add_option("--mode", arguments.mode, "2d or 3d")
        ->check(CLI::IsMember({"2d", "3d"}))
        ->capture_default_str();
    command->add_option("--backend", arguments.backend, "auto, mesh, pull, impostor or raster (unsmoothed)")
        ->check(CLI::IsMember({"auto", "mesh", "pull", "impostor", "raster"}))
        ->capture_default_str();
    command
        ->add_option("--pipeline", arguments.pipeline,
                     "hybrid, or standard: every element as stored triangles, to compare with")
        ->check(CLI::IsMember({"hybrid", "standard"}))
        ->capture_default_str();
    command->add_option("--layers", arguments.layers, "only these layers, separated by commas")->delimiter(',');
    command->add_option("--net", arguments.nets, "light up this net; may be given several times")
        ->take_all()
        ->expected(1);
    command
        ->add_option("--explode", arguments.explode, "spread the stack: 0 is real, 1 is about half the board's width")
        ->check(CLI::Range(0.0, 10.0));
    command
        ->add_option("--window", arguments.window, "X0,Y0,X1,Y1 in millimetres of the job's coordinates; draws in 2D")
        ->delimiter(',')
        ->expected(4);
    command
        ->add_option("--z-scale", arguments.zScale,
                     "COPPER,OTHER: draw copper and everything else so many times as thick")
        ->delimiter(',')
        ->expected(2)
        ->check(CLI::Range(0.01, 1000.0));
    command
        ->add_option("--clip", arguments.cut,
                     "X0,Y0,X1,Y1 in millimetres: cut the board open along this line; what is to its left is left out "
                     "(3D)")
        ->delimiter(',')
        ->expected(4);
    addLevels(*command, arguments.levels);
    command->add_flag("--outlines", arguments.isOutlined, "in 2D, outlines and nothing in them");
    command->add_flag("--mono", arguments.isMono, "shapes white on black, neither shaded nor smoothed");
}

void addGenerate(CLI::App& parent, GenerateArguments& arguments) {
    CLI::App* command = parent.add_subcommand("generate", "Make up a board to measure with, as an ODB++ job");
    command->add_option("--like", arguments.like, "element counts of this model of the paper's Table 3: t1 to t9")
        ->required()
        ->check(CLI::IsMember({"t1", "t2", "t3", "t4", "t5", "t6", "t7", "t8", "t9"}));
    command->add_option("--scale", arguments.scale, "times as many elements")
        ->check(CLI::Range(0.01, 100.0))
        ->capture_default_str();
    command->add_option("--seed", arguments.seed, "another number, another board of the same kind")
        ->capture_default_str();
    command->add_option("-o,--output", arguments.output, "the job to write (.tgz)")->required();
}

void addBench(CLI::App& parent, BenchArguments& arguments) {
    CLI::App* command =
        parent.add_subcommand("bench", "Measure modelling, memory and frame times (the paper's Tables 2, 4 and 5)");
    command->add_option("BOARD", arguments.boards, "boards, as for info");
    addModellingOptions(*command, arguments.modelling);
    command->add_option("--pipeline", arguments.pipeline, "both, hybrid or standard")
        ->check(CLI::IsMember({"both", "hybrid", "standard"}))
        ->capture_default_str();
    addLevels(*command, arguments.levels);
    command->add_flag("--only-culled", arguments.onlyCulled, "no frames without culling and level of detail");
    command->add_option("--frames", arguments.frames, "frames of which the median is given")
        ->check(CLI::Range(1, 1000))
        ->capture_default_str();
    command->add_flag("--json", arguments.asJson, "as JSON");
}

void addClearance(CLI::App& parser, ClearanceArguments& arguments) {
    CLI::App* command = parser.add_subcommand("clearance", "List the narrowest places between nets");
    command->add_option("BOARD", arguments.board.path, "the board; default: the sample");
    command->add_option("--step", arguments.board.step,
                        "the step to open; default: the first one with features of its own");
    addNetOptions(*command, arguments.board.inferNets);
    command->add_option("--worst", arguments.worst, "how many of the narrowest")
        ->check(CLI::Range(1, 1'000'000))
        ->capture_default_str();
    command->add_option("--rules", arguments.rules,
                        "check the rules of this JSON file, or \"default\"; exit code 4 if one is broken");
    command->add_option("--below", arguments.below,
                        "only what is closer than this, with um, mm, mil or inch; exit code 4 if anything is");
    command->add_option("--layer", arguments.layer, "only on this copper layer");
    command->add_option("--nets", arguments.nets, "only between these two, separated by a comma")
        ->delimiter(',')
        ->expected(2);
    command->add_option("--format", arguments.format, "text, json or csv")
        ->check(CLI::IsMember({"text", "json", "csv"}))
        ->capture_default_str();
}

void addSection(CLI::App& parser, SectionArguments& arguments) {
    CLI::App* command = parser.add_subcommand("section", "Cut a board open along a line");
    addBoardOptions(*command, arguments.board);
    command->add_option("--line", arguments.line, "X0,Y0,X1,Y1[,X2,Y2...] in millimetres of the job's coordinates")
        ->delimiter(',')
        ->required();
    command->add_option("--layers", arguments.layers, "only these layers, separated by commas")->delimiter(',');
    command->add_option("--format", arguments.format, "svg, json or csv")
        ->check(CLI::IsMember({"svg", "json", "csv"}))
        ->capture_default_str();
    command
        ->add_option("--height-times", arguments.heightTimes,
                     "draw heights so many times larger than lengths; default: as reads well")
        ->check(CLI::Range(0.01, 10'000.0));
}

void addMeasure(CLI::App& parser, MeasureArguments& arguments) {
    CLI::App* command = parser.add_subcommand("measure", "Measure how far two things of a board are apart");
    addBoardOptions(*command, arguments.board);
    const char* forms = "net:NAME, part:NAME, pin:PART.PIN, element:NUMBER, at:X,Y[,LAYER] with units, or edge";
    command->add_option("--from", arguments.from, forms)->required();
    command->add_option("--to", arguments.to, "the same")->required();
    CLI::Option* path = command->add_option("--path", arguments.path, "the way along the copper of this net instead");
    command
        ->add_option("--below", arguments.below, "exit code 4 if they are closer than this, with um, mm, mil or inch")
        ->excludes(path);
    command->add_option("--format", arguments.format, "text, json or csv")
        ->check(CLI::IsMember({"text", "json", "csv"}))
        ->capture_default_str();
}

/// The other thing that `bench` measures, with options of its own.
void addTriangulationBench(CLI::App* command, bool& isWanted, TriangulationBenchArguments& arguments) {
    CLI::Option* wanted =
        command->add_flag("--triangulation", isWanted,
                          "all triangulators instead, over areas of boards and generated ones (the paper's Table 6)");
    for (const char* drawing : {"--pipeline", "--frames"}) {
        wanted->excludes(command->get_option(drawing));
    }
    command
        ->add_option(
            "--triangulators", arguments.triangulators,
            "only these of cgal, cpu, parallel and gpu, separated by commas; default: all, gpu only if it is hardware")
        ->delimiter(',')
        ->check(CLI::IsMember({"cgal", "cpu", "parallel", "gpu"}))
        ->needs(wanted);
    command->add_option("--threads", arguments.threads, "numbers of threads, separated by commas; 0 = all cores")
        ->delimiter(',')
        ->check(CLI::Range(0, 1024))
        ->needs(wanted)
        ->capture_default_str();
    command->add_option("--repeats", arguments.repeats, "the best of so many runs")
        ->check(CLI::Range(1, 1000))
        ->needs(wanted)
        ->capture_default_str();
    command->add_option("--sets", arguments.sets, "only these generated sets, separated by commas; none: no set")
        ->delimiter(',')
        ->needs(wanted);
    command->add_flag("--huge", arguments.withHuge, "with the generated sets of a million vertices and more")
        ->needs(wanted);
}

std::string versionText() {
    const std::string commit = kCommit;
    return "Copperscope " COPPERSCOPE_VERSION + (commit.empty() ? "" : ", commit " + commit);
}

}  // namespace

Command parseCommandLine(int argc, char** argv) {
    CLI::App parser{"Copperscope looks into printed circuit boards", "copperscope"};
    parser.set_version_flag("--version", versionText());
    parser.require_subcommand(0, 1);
    WorkbenchArguments workbench;
    InfoArguments info;
    RenderArguments render;
    GenerateArguments generate;
    BenchArguments bench;
    ClearanceArguments clearance;
    SectionArguments section;
    MeasureArguments measure;
    parser.add_option("BOARD", workbench.path, "the board to open in the workbench; default: the sample");
    parser.add_option("--step", workbench.step, "the step to open");
    addStackupOptions(parser, workbench.thicknesses, workbench.noSession);
    addNetOptions(parser, workbench.inferNets);
    addInfo(parser, info);
    addRender(parser, render);
    addGenerate(parser, generate);
    addBench(parser, bench);
    addClearance(parser, clearance);
    addSection(parser, section);
    addMeasure(parser, measure);
    bool isTriangulationBench = false;
    TriangulationBenchArguments triangulationBench;
    addTriangulationBench(parser.get_subcommand("bench"), isTriangulationBench, triangulationBench);
    try {
        parser.parse(argc, argv);
        if (parser.got_subcommand("bench") && bench.boards.empty() && !isTriangulationBench) {
            throw CLI::RequiredError("BOARD");
        }
    } catch (const CLI::ParseError& error) {
        return Quit{parser.exit(error) == 0 ? kDone : kWrongUsage};
    }
    if (parser.got_subcommand("info")) {
        return info;
    }
    if (parser.got_subcommand("render")) {
        return render;
    }
    if (parser.got_subcommand("generate")) {
        return generate;
    }
    if (parser.got_subcommand("clearance")) {
        return clearance;
    }
    if (parser.got_subcommand("measure")) {
        return measure;
    }
    if (parser.got_subcommand("section")) {
        return section;
    }
    if (parser.got_subcommand("bench")) {
        triangulationBench.boards = bench.boards;
        triangulationBench.asJson = bench.asJson;
        return isTriangulationBench ? Command(triangulationBench) : Command(bench);
    }
    return workbench;
}

}  // namespace app
