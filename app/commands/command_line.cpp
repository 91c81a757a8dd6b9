#include "app/commands/command_line.h"

#include <CLI/CLI.hpp>
#include <charconv>

#include "app/bench/bench_command.h"
#include "app/bench/calibration_bench.h"
#include "app/bench/triangulation_bench.h"
#include "app/clearance/clearance_command.h"
#include "app/commands/agree_command.h"
#include "app/commands/export_command.h"
#include "app/commands/generate_command.h"
#include "app/commands/info_command.h"
#include "app/commands/interaction_command.h"
#include "app/commands/measure_command.h"
#include "app/commands/misspelt_command.h"
#include "app/commands/option_checks.h"
#include "app/commands/option_values.h"
#include "app/commands/render_command.h"
#include "app/commands/section_command.h"
#include "app/commands/verify_command.h"
#include "app/commands/workbench_command.h"
#include "app/common/commit.h"
#include "app/common/exit_code.h"
#include "app/common/memory_limit.h"
#include "model/agreement/agreement.h"
#include "model/board/board_colours.h"
#include "model/clearance/rule_presets.h"
#include "model/export/files/export_file.h"
#include "model/formats/registry.h"

namespace app {

namespace {

int codeOf(const Outcome& outcome) {
    return outcome ? *outcome : fail(outcome.error());
}

/// Arguments for the options of a command, which `chosen` runs with them when the command is given.
template <class Arguments>
Arguments& argumentsOf(CLI::App& command, Command& chosen, Outcome (*run)(const Arguments&)) {
    const auto arguments = std::make_shared<Arguments>();
    command.callback([&chosen, arguments, run] { chosen = [arguments, run] { return codeOf(run(*arguments)); }; });
    return *arguments;
}

/// "a, b or c"
std::string enumeration(const std::vector<std::string>& names) {
    std::string text;
    for (std::size_t i = 0; i < names.size(); ++i) {
        text += (i == 0 ? "" : i + 1 < names.size() ? ", " : " or ") + names[i];
    }
    return text;
}

/// An option that takes one of these values; an empty default is not shown.
void addChoice(CLI::App& command, const char* name, std::string& value, const std::vector<std::string>& choices,
               const char* help = "") {
    CLI::Option* option = command.add_option(name, value, enumeration(choices) + help)->check(CLI::IsMember(choices));
    if (!value.empty()) {
        option->capture_default_str();
    }
}

/// An option that names a file, read or written.
template <class Path>
CLI::Option* addFile(CLI::App& command, const char* name, Path& value, const std::string& help) {
    return command.add_option(name, value, help)->type_name("FILE");
}

template <class Number>
CLI::Option* addNumber(CLI::App& command, const char* name, Number& value, Number low, Number high, const char* help) {
    return command.add_option(name, value, help)->check(CLI::Range(low, high))->capture_default_str();
}

void addStackupOptions(CLI::App& command, model::OpenRequest& request) {
    addRepeated(command, "--set-thickness", request.thicknesses,
                "LAYER=LENGTH over what the job says, with um, mm, mil, inch, or oz for copper");
    command.add_flag("--no-session", request.noSession, "ignore the session file beside the board");
}

void addStep(CLI::App& command, model::OpenRequest& request) {
    command.add_option("--step", request.step, "the step to open; default: the first one with features of its own");
}

void addNetOptions(CLI::App& command, model::OpenRequest& request) {
    command.add_flag("--infer-nets", request.inferNets, "infer the nets from the copper instead of the job's netlist");
}

/// To be called when all other options of the command are there: `--format` may be that of its report.
void addInputOptions(CLI::App& command, model::OpenRequest& request) {
    const bool isFree = command.get_option_no_throw("--format") == nullptr;
    addChoice(command, isFree ? "--input-format,--format" : "--input-format", request.format, model::formatKeys(),
              ": what to read of a job that is there in several formats; default: the richest");
    addFile(command, "--layer-map", request.layerMap,
            "what each file of a Gerber job draws (see docs/command-line.md)");
    addSize(command, "--max-unpacked", "how much an archive may unpack to, as 8G; default: 4G, and 250 times its size",
            [&request](std::uint64_t bytes) { request.limits = model::formats::limitsOfUnpacking(bytes); });
    addSize(command, "--max-memory", "how much memory may be taken, as 2G; default: what the machine has", limitMemory);
}

void addChords(CLI::App& command, BoardArguments& board) {
    addNumber(command, "--chord", board.chordUm, 0.5, 50.0,
              "largest distance between a curve and its chords, in micrometres");
    command.add_flag("--paper-segments", board.paperSegments,
                     "50 segments per circle and 20 per arc, as the paper does");
}

void addBoard(CLI::App& command, model::OpenRequest& request, const std::string& help) {
    command.add_option("BOARD", request.path, help + "; default: the sample");
}

void addBoardOptions(CLI::App& command, BoardArguments& board) {
    addStackupOptions(command, board.request);
    command.add_flag("--save-session", board.saveSession,
                     "save the set thicknesses in the session file beside the board");
    addBoard(command, board.request, model::describeFormats());
    addStep(command, board.request);
    addNetOptions(command, board.request);
}

/// Of commands that make triangles of a board.
void addModellingOptions(CLI::App& command, BoardArguments& board) {
    addChords(command, board);
    addChoice(command, "--triangulator", board.triangulator, {"auto", "cpu", "parallel", "cgal", "gpu"},
              ": what triangulates areas; the triangles are the same");
}

void addInfo(CLI::App& parent, Command& chosen) {
    CLI::App& command =
        *parent.add_subcommand("info", "Report what a board holds: layers, stackup, nets, elements, messages");
    InfoArguments& arguments = argumentsOf(command, chosen, runInfo);
    addBoardOptions(command, arguments.board);
    addModellingOptions(command, arguments.board);
    command.add_flag("--json", arguments.asJson, "as JSON");
    command.add_flag("--check-nets", arguments.checkNets,
                     "compare the nets with the copper; exit code 4 if there are opens or shorts, or no nets");
    command.add_flag("--allow-incomplete", arguments.allowsIncomplete,
                     "with --check-nets: exit code 0 also where not everything could be checked");
    command.add_flag("--print-layer-map", arguments.printsLayerMap,
                     "only what the files of a Gerber job are taken to draw, and why, as a file for --layer-map");
    addInputOptions(command, arguments.board.request);
}

/// Of anything with a width and a height.
template <class Sized>
void parseSize(const std::string& text, Sized& sized) {
    const std::size_t cross = text.find('x');
    const char* end = text.data() + text.size();
    const auto width = std::from_chars(text.data(), end, sized.width);
    const bool isPair = cross != std::string::npos && width.ptr == text.data() + cross;
    const auto height = isPair ? std::from_chars(width.ptr + 1, end, sized.height) : width;
    const bool areNumbers = width.ec == std::errc() && height.ec == std::errc();
    if (!isPair || !areNumbers || height.ptr != end || sized.width < 1 || sized.height < 1) {
        throw CLI::ValidationError("--size", "takes WIDTHxHEIGHT in pixels, for example 1600x1000");
    }
}

void addLevels(CLI::App& command, std::string& levels) {
    addChoice(command, "--lod", levels, {"error", "paper", "coarse"},
              ": level of detail by error in pixels, the paper's three levels by size, or as while a view moves");
}

void addPictureOptions(CLI::App& command, RenderArguments& arguments) {
    addFile(command, "-o,--output", arguments.output, "the picture to write (.png)")->required();
    addChoice(command, "--view", arguments.view, {"top", "bottom", "iso"});
    command.add_option_function<std::string>(
        "--size", [&arguments](const std::string& text) { parseSize(text, arguments); },
        "WIDTHxHEIGHT in pixels [1600x1000]");
    addChoice(command, "--mode", arguments.mode, {"2d", "3d"}, "; default: 3d, with --window 2d");
    addChoice(command, "--backend", arguments.backend, {"auto", "mesh", "pull", "impostor", "raster"},
              "; raster does not smooth");
    addChoice(command, "--pipeline", arguments.pipeline, {"hybrid", "standard"},
              "; standard stores every element as triangles, for comparison");
    addLevels(command, arguments.levels);
}

void addBoardColours(CLI::App& command, RenderArguments& arguments) {
    addChoice(command, "--mask-colour", arguments.maskColour, model::boardColourNames(), ": of the solder mask, in 3D");
    addChoice(command, "--silkscreen-colour", arguments.silkscreenColour, model::boardColourNames(), ", in 3D");
    addChoice(command, "--finish", arguments.finish, model::surfaceFinishNames(), ": of exposed copper, in 3D");
}

void addRender(CLI::App& parent, Command& chosen) {
    CLI::App& command = *parent.add_subcommand("render", "Draw a board to a picture");
    RenderArguments& arguments = argumentsOf(command, chosen, runRender);
    addBoardOptions(command, arguments.board);
    addModellingOptions(command, arguments.board);
    addPictureOptions(command, arguments);
    addNames(command, "--layers", arguments.layers, "only these layers, separated by commas");
    addBoardColours(command, arguments);
    addRepeated(command, "--net", arguments.nets, "highlight this net");
    command
        .add_option("--explode", arguments.explode,
                    "exploded view: 0 shows the real stackup, 1 spreads it over about half the board's width")
        ->check(CLI::Range(0.0, 10.0));
    addNumbers(command, "--window", arguments.window,
               "X0,Y0,X1,Y1 in millimetres of the job's coordinates; draws in 2D", {4});
    addNumbers(command, "--z-scale", arguments.zScale,
               "COPPER,OTHER: vertical scale of copper and of everything else, for example 10,5", {2, 0.01, 1000.0});
    addNumbers(command, "--clip", arguments.clip,
               "X0,Y0,X1,Y1 in millimetres: a section plane along this line; what is to its left is left out (3D)",
               {4});
    command.add_flag("--components", arguments.hasComponents, "with the bodies of the components");
    command.add_flag("--as-designed", arguments.isAsDesigned,
                     "in 3D, draw also what is milled away beyond the board outline, and print over holes");
    command.add_flag("--outlines", arguments.isOutlined, "in 2D, outlines without fill");
    command.add_flag("--transparent", arguments.isTransparent, "without background");
    command.add_flag("--mono", arguments.isMono, "shapes white on black, neither shaded nor smoothed");
    addInputOptions(command, arguments.board.request);
}

void addGenerate(CLI::App& parent, Command& chosen) {
    CLI::App& command = *parent.add_subcommand("generate", "Generate a board for measurements");
    GenerateArguments& arguments = argumentsOf(command, chosen, runGenerate);
    command.add_option("--like", arguments.like, "element counts of this model of the paper's Table 3: t1 to t9")
        ->required()
        ->check(CLI::IsMember({"t1", "t2", "t3", "t4", "t5", "t6", "t7", "t8", "t9"}));
    addNumber(command, "--scale", arguments.scale, 0.01, 100.0, "factor of the element counts");
    command.add_option("--seed", arguments.seed, "another number, another board of the same kind")
        ->capture_default_str();
    command.add_flag("--nurbs", arguments.isNurbs, "as a text model of the paper whose areas have NURBS edges");
    addFile(command, "-o,--output", arguments.output, "the ODB++ job to write (.tgz), with --nurbs the model (.txt)")
        ->required();
}

std::string presetNames() {
    std::vector<std::string> names{"default"};
    for (const model::RulePreset& preset : model::rulePresets()) {
        names.emplace_back(preset.name);
    }
    return enumeration(names);
}

void addReportFormat(CLI::App& command, std::string& format) {
    addChoice(command, "--format", format, {"text", "json", "csv"});
}

void addWaivers(CLI::App& command, CLI::Option& rules, ClearanceArguments& arguments) {
    addFile(command, "--waivers", arguments.waivers,
            "with --rules: locations that this JSON file waives are counted apart and are no failure")
        ->needs(&rules);
    CLI::Option* write =
        addFile(command, "--write-waivers", arguments.newWaivers,
                "with --rules: waive all locations that are left in this file, with those of --waivers")
            ->needs(&rules);
    command.add_option("--reason", arguments.reason, "why they are waived")->needs(write);
    command.add_option("--author", arguments.author, "who waives them")->needs(write);
}

void addMapOptions(CLI::App& command, ClearanceMapArguments& map) {
    CLI::Option* file = addFile(command, "--map", map.file,
                                "writes the spacings between nets of a --layer as a picture (.png) or table (.csv)");
    file->needs(command.get_option("--layer"));
    command.add_option("--reach", map.reach, "of the map: the largest spacing shown, up to 10mm")
        ->capture_default_str()
        ->needs(file);
    command
        .add_option("--resolution", map.resolution,
                    "of the map: the side of a pixel or cell; default: 1600 (.csv: 400) along the longer side")
        ->needs(file);
    addNumbers(command, "--window", map.window, "of the map: X0,Y0,X1,Y1 in millimetres of the job's coordinates", {4})
        ->needs(file);
}

void addClearance(CLI::App& parent, Command& chosen) {
    CLI::App& command = *parent.add_subcommand("clearance", "List the smallest clearances between nets");
    ClearanceArguments& arguments = argumentsOf(command, chosen, runClearance);
    model::OpenRequest& request = arguments.board.request;
    addBoard(command, request, "the board");
    addStep(command, request);
    addNetOptions(command, request);
    addNumber<std::size_t>(command, "--worst", arguments.worst, 1, 1'000'000, "how many of the smallest");
    command.add_flag("--through", arguments.isThroughStackup,
                     "distances in space, also through dielectric and on panels across copies");
    CLI::Option* rules =
        addFile(command, "--rules", arguments.rules,
                "check the rules of this JSON, .kicad_dru, .kicad_pro or .kicad_pcb file, or of a preset (" +
                    presetNames() + "); exit code 4 if one is broken or incomplete");
    command.add_flag("--print", arguments.printsRules, "prints the rules as a file with comments, and checks nothing")
        ->needs(rules);
    command.add_option("--tolerance", arguments.tolerance,
                       "with --rules: how far a distance may be below its limit; default 0.5um, or as the file says");
    command.add_flag("--allow-incomplete", arguments.allowsIncomplete,
                     "with --rules or --below: exit code 0 also where not everything could be checked");
    command.add_option(
        "--below", arguments.below,
        "only clearances less than this, with um, mm, mil or inch; exit code 4 if there is one; with --rules only "
        "these locations are listed");
    command.add_option("--layer", arguments.layer, "only on this copper layer, with --rules also solder mask");
    addNames(command, "--nets", arguments.nets, "only between these two, separated by a comma", {{}, 2});
    addChoice(command, "--format", arguments.format, {"text", "json", "csv", "junit", "sarif", "html"});
    addFile(command, "-o,--output", arguments.output, "write the report to this file; default: stdout");
    addWaivers(command, *rules, arguments);
    addMapOptions(command, arguments.map);
    addInputOptions(command, request);
}

void addSection(CLI::App& parent, Command& chosen) {
    CLI::App& command = *parent.add_subcommand("section", "Draw a cross section of a board along a line");
    SectionArguments& arguments = argumentsOf(command, chosen, runSection);
    addBoardOptions(command, arguments.board);
    addNumbers(command, "--line", arguments.line, "X0,Y0,X1,Y1[,X2,Y2...] in millimetres of the job's coordinates")
        ->required();
    addNames(command, "--layers", arguments.layers, "only these layers, separated by commas");
    command.add_flag("--as-designed", arguments.isAsDesigned, "also what is milled away beyond the board outline");
    addChoice(command, "--format", arguments.format, {"svg", "json", "csv"});
    command
        .add_option("--scale", arguments.scale, "mm of paper for a mm of the line (SVG); default: as fits on a sheet")
        ->check(CLI::Range(0.001, 1000.0));
    command.add_option("--height-times", arguments.heightTimes, "vertical scale; default: as large as is easy to read")
        ->check(CLI::Range(0.01, 10'000.0));
    addInputOptions(command, arguments.board.request);
}

constexpr const char* kPolylines =
    "STEP: chords around a bend as one edge and one wall, for programs that take walls with bends";

void addExport(CLI::App& parent, Command& chosen) {
    CLI::App& command = *parent.add_subcommand("export", "Write a board as solids or drawings for other programs");
    ExportArguments& arguments = argumentsOf(command, chosen, runExport);
    addBoardOptions(command, arguments.board);
    addChords(command, arguments.board);
    addFile(command, "-o,--output", arguments.output,
            "the file to write (" + model::exportEndings() + "); .obj writes its .mtl beside it")
        ->required();
    addNames(command, "--layers", arguments.layers, "only these layers, separated by commas");
    addNames(command, "--nets", arguments.nets, "only copper of these nets, separated by commas");
    addNumbers(command, "--window", arguments.window,
               "X0,Y0,X1,Y1 in millimetres of the job's coordinates: only what reaches into it", {4});
    command.add_option("--min-hole", arguments.minHole,
                       "leave out round holes narrower than this, with um, mm, mil or inch");
    command.add_flag("--fit-arcs", arguments.hasFittedArcs, "runs of chords as arcs, where those are within 5 um");
    command.add_flag("--outer-only", arguments.isOuterOnly,
                     "only the substrate and the bodies of components; of outer copper in --layers the solder pads");
    command.add_flag("--merge", arguments.isMerged, "touching copper of one net and layer as one solid");
    command.add_flag("--one-part", arguments.isOnePart, "STEP, GLB: one part instead of a tree of layers and nets");
    command.add_flag("--as-designed", arguments.isAsDesigned,
                     "also what is milled away beyond the board outline, and print over holes");
    command.add_flag("--instancing", arguments.isInstanced,
                     "GLB: equal pads of a net as one node (EXT_mesh_gpu_instancing), which not all viewers show");
    command.add_flag("--compress", arguments.isCompressed,
                     "GLB: compressed meshes (EXT_meshopt_compression), which not all viewers read");
    command.add_flag("--one-page", arguments.isOnePage, "PDF: all layers on one page instead of a page each");
    command.add_flag("--mirror-bottom", arguments.isMirrored, "PDF: layers of the bottom as they are seen from below");
    command.add_flag("--written-out", arguments.isWrittenOut,
                     "equal tracks, pads and barrels one by one, for programs that do not know placed shapes");
    command.add_flag("--polylines", arguments.hasPolylines, kPolylines);
    addInputOptions(command, arguments.board.request);
}

void addVerify(CLI::App& parent, Command& chosen) {
    CLI::App& command =
        *parent.add_subcommand("verify", "Prove exported solids and pictures against the board (needs OpenCASCADE)");
    VerifyArguments& arguments = argumentsOf(command, chosen, runVerify);
    addStackupOptions(command, arguments.board.request);
    addBoard(command, arguments.board.request, model::describeFormats());
    addNetOptions(command, arguments.board.request);
    addFile(command, "--step", arguments.step,
            "this file, exported with the same --layers and --as-designed; default: one is written");
    addNames(command, "--layers", arguments.layers, "only these layers, separated by commas");
    command.add_option("--sample", arguments.sample, "about so many elements, spread over all shapes and layers")
        ->excludes(command.get_option("--step"));
    addNumber<std::uint64_t>(command, "--points", arguments.points, 0, 100'000'000, "random points to compare");
    command.add_flag("--polylines", arguments.hasPolylines, kPolylines)->excludes(command.get_option("--step"));
    command.add_flag("--strict", arguments.isStrict, "read without the repairs that the reader makes on its own");
    command.add_flag("--no-pictures", arguments.noPictures, "without pictures of both pipelines");
    command.add_flag("--json", arguments.asJson, "as JSON");
    addInputOptions(command, arguments.board.request);
}

void addMeasure(CLI::App& parent, Command& chosen) {
    CLI::App& command = *parent.add_subcommand("measure", "Measure the distance between two items of a board");
    MeasureArguments& arguments = argumentsOf(command, chosen, runMeasure);
    addBoardOptions(command, arguments.board);
    const char* forms = "net:NAME, part:NAME, pin:PART.PIN, element:NUMBER, at:X,Y[,LAYER] with units, or edge";
    command.add_option("--from", arguments.from, forms)->required();
    command.add_option("--to", arguments.to, "the same")->required();
    CLI::Option* path = command.add_option("--path", arguments.path, "the path length along this net instead");
    command
        .add_option("--below", arguments.below,
                    "exit code 4 if the distance is less than this, with um, mm, mil or inch")
        ->excludes(path);
    command.add_flag("--allow-incomplete", arguments.allowsIncomplete,
                     "with --below: exit code 0 also where not all of the job could be read");
    addReportFormat(command, arguments.format);
    addInputOptions(command, arguments.board.request);
}

std::vector<std::string> aspectNames() {
    std::vector<std::string> names;
    for (std::size_t aspect = 0; aspect < model::kAspectCount; ++aspect) {
        names.emplace_back(model::toString(static_cast<model::Aspect>(aspect)));
    }
    return names;
}

void addAgree(CLI::App& parent, Command& chosen) {
    CLI::App& command =
        *parent.add_subcommand("agree", "Say whether two jobs describe the same board; exit code 4 if they do not");
    AgreeArguments& arguments = argumentsOf(command, chosen, runAgree);
    command.add_option("A", arguments.a, model::describeFormats())->required();
    command.add_option("B", arguments.b, "the same, in this or another format")->required();
    addStep(command, arguments.board.request);
    addNetOptions(command, arguments.board.request);
    command
        .add_option("--tolerance", arguments.tolerance,
                    "length of a pixel: what layers differ in counts where it is wider than about three of them")
        ->default_str("10um");
    command
        .add_option("--allow", arguments.allowedPercent, "percent of a layer's area that may differ and still agree")
        ->type_name("FLOAT")
        ->check(CLI::Range(0.0, 100.0))
        ->default_str("0");
    addNumber<std::size_t>(command, "--worst", arguments.most, 0, 1'000'000, "how many differences of each are listed");
    addNames(command, "--aspects", arguments.aspects, "only these, separated by commas", {aspectNames()});
    command.add_flag("--allow-incomplete", arguments.allowsIncomplete,
                     "exit code 0 also where not all of a job could be read");
    command.add_flag("--json", arguments.asJson, "as JSON");
    addInputOptions(command, arguments.board.request);
    addChoice(command, "--format-a", arguments.formatA, model::formatKeys(), ": of A alone");
    addChoice(command, "--format-b", arguments.formatB, model::formatKeys(), ": of B alone");
}

/// What `bench` measures with --triangulation, with options of its own.
void addTriangulationBench(CLI::App& command, bool& isWanted, TriangulationBenchArguments& arguments) {
    CLI::Option* wanted =
        command.add_flag("--triangulation", isWanted,
                         "all triangulators instead, over areas of boards and generated ones (the paper's Table 6)");
    addNames(command, "--triangulators", arguments.triangulators,
             "only these of cgal, cpu, parallel and gpu, separated by commas; default: all, gpu only if it is hardware",
             {{"cgal", "cpu", "parallel", "gpu"}})
        ->needs(wanted);
    addNumbers(command, "--threads", arguments.threads, "numbers of threads, separated by commas; 0 = all cores",
               {0, 0, 1024})
        ->needs(wanted)
        ->default_str("1,0");
    addNumber(command, "--repeats", arguments.repeats, 1, 1000, "the best of so many runs")->needs(wanted);
    addNames(command, "--sets", arguments.sets, "only these generated sets, separated by commas; none: no set")
        ->needs(wanted);
    command.add_flag("--huge", arguments.withHuge, "with the generated sets of a million vertices and more")
        ->needs(wanted);
}

/// What it measures with --interactive.
void addInteractionBench(CLI::App& command, bool& isWanted, InteractionArguments& arguments) {
    CLI::Option* wanted = command.add_flag(
        "--interactive", isWanted,
        "the window instead: how long pan, zoom, orbit, hover, highlight and layers take until they are seen");
    command
        .add_option_function<std::string>(
            "--size", [&arguments](const std::string& text) { parseSize(text, arguments.request); },
            "WIDTHxHEIGHT of the canvas in pixels [1920x1080]")
        ->needs(wanted);
    command
        .add_option("--pictures", arguments.request.pictures,
                    "a folder that gets a PNG of every frame, and of views at rest also what the device draws")
        ->needs(wanted);
}

/// What it measures, and saves, with --calibrate.
void addCalibrationBench(CLI::App& command, bool& isWanted) {
    command.add_flag("--calibrate", isWanted,
                     "the device instead: which back end auto takes for tilted views from now on; the answer is saved");
}

void addBench(CLI::App& parent, Command& chosen) {
    struct All {
        BenchArguments frames;
        CalibrationBenchArguments calibration;
        TriangulationBenchArguments triangulation;
        InteractionArguments interaction;
        bool isTriangulation = false;
        bool isInteraction = false;
        bool isCalibration = false;
    };
    const auto all = std::make_shared<All>();
    BenchArguments& arguments = all->frames;
    CLI::App& command =
        *parent.add_subcommand("bench", "Measure modelling, memory and frame times (the paper's Tables 2, 4 and 5)");
    command.add_option("BOARD", arguments.boards, "boards, as for info");
    addStep(command, arguments.modelling.request);
    addNetOptions(command, arguments.modelling.request);
    addChords(command, arguments.modelling);
    addChoice(command, "--pipeline", arguments.pipeline, {"both", "hybrid", "standard"});
    addLevels(command, arguments.levels);
    command.add_flag("--only-culled", arguments.onlyCulled, "no frames without culling and level of detail");
    command.add_flag("--components", arguments.hasComponents, "with the bodies of the components");
    command.add_flag("--stages", arguments.hasStages,
                     "also how long the device takes for each stage of a frame, or kernel of a triangulation");
    addNumber(command, "--frames", arguments.frames, 1, 1000, "frames per median");
    command.add_flag("--json", arguments.asJson, "as JSON");
    addInputOptions(command, arguments.modelling.request);
    addTriangulationBench(command, all->isTriangulation, all->triangulation);
    addInteractionBench(command, all->isInteraction, all->interaction);
    addCalibrationBench(command, all->isCalibration);
    command.callback([&chosen, &command, all] {
        if (all->frames.boards.empty() && !all->isTriangulation && !all->isCalibration) {
            throw CLI::RequiredError("BOARD");
        }
        all->triangulation.boards = all->interaction.boards = all->frames.boards;
        all->triangulation.reading.limits = all->frames.modelling.request.limits;
        all->triangulation.hasStages = all->frames.hasStages;
        all->triangulation.asJson = all->interaction.asJson = all->calibration.asJson = all->frames.asJson;
        all->interaction.request.board = all->frames.modelling.request;
        if (command.get_option("--frames")->count() > 0) {
            all->interaction.request.frames = all->frames.frames;
        }
        chosen = [all] {
            return codeOf(all->isTriangulation ? runTriangulationBench(all->triangulation)
                          : all->isInteraction ? runInteractionBench(all->interaction)
                          : all->isCalibration ? runCalibrationBench(all->calibration)
                                               : runBench(all->frames));
        };
    });
}

std::string versionText() {
    const std::string commit = kCommit;
    return "Copperscope " COPPERSCOPE_VERSION + (commit.empty() ? "" : ", commit " + commit);
}

/// As in docs/command-line.md, for --help and the man pages.
constexpr const char* kExitCodes =
    "Exit codes: 0 done; 1 wrong usage; 2 the input cannot be read; 3 no usable device or module, not enough memory, "
    "or the output cannot be written; 4 a limit set by an option is broken, nets "
    "and copper differ (info --check-nets), two jobs differ (agree), what was exported is wrong (verify), or not "
    "everything could be checked.";

constexpr void (*kCommands[])(CLI::App&, Command&) = {addInfo,    addRender,  addGenerate, addBench,  addClearance,
                                                      addSection, addMeasure, addExport,   addVerify, addAgree};

/// Says why, and nothing else.
Command refusal(const std::string& why) {
    return [why] { return fail({base::ErrorCode::BadUsage, why}); };
}

}  // namespace

std::shared_ptr<CLI::App> makeCommandLine(int argc, char** argv, Command& chosen) {
    auto parser = std::make_shared<CLI::App>("Copperscope, a viewer for printed circuit boards", "copperscope");
    parser->set_version_flag("--version", versionText());
    parser->require_subcommand(0, 1);
    const auto workbench = std::make_shared<model::OpenRequest>();
    addBoard(*parser, *workbench, "the board to open in the workbench");
    addStep(*parser, *workbench);
    addStackupOptions(*parser, *workbench);
    addNetOptions(*parser, *workbench);
    addInputOptions(*parser, *workbench);
    chosen = [argc, argv, workbench] { return runWorkbench(argc, argv, *workbench); };
    for (const auto addCommand : kCommands) {
        addCommand(*parser, chosen);
    }
    limitCombinations(*parser);
    checkValues(*parser);
    parser->footer(kExitCodes);
    return parser;
}

Command parseCommandLine(int argc, char** argv) {
    if (const std::string error = emptyAssignment(argc, argv); !error.empty()) {
        return refusal(error);
    }
    Command chosen;
    const auto parser = makeCommandLine(argc, argv, chosen);
    try {
        parser->parse(argc, argv);
    } catch (const CLI::ParseError& error) {
        if (const auto misspelt = misspeltCommand(*parser); misspelt && error.get_exit_code() != 0) {
            return refusal(*misspelt);
        }
        const int code = parser->exit(error) == 0 ? kDone : kWrongUsage;
        return [code] { return code; };
    }
    if (const auto misspelt = misspeltCommand(*parser)) {
        return refusal(*misspelt);
    }
    const auto unusable = unusableOption(*parser);
    return unusable ? refusal(*unusable) : chosen;
}

}  // namespace app
