#include "model/export/files/export_file.h"

#include <algorithm>
#include <type_traits>

#include "model/base/ascii.h"
#include "model/export/drawings/dxf_drawing.h"
#include "model/export/drawings/pdf_drawing.h"
#include "model/export/drawings/svg_drawing.h"
#include "model/export/meshes/glb_export.h"
#include "model/export/meshes/obj_export.h"
#include "model/export/meshes/stl_export.h"

namespace model {

namespace fs = std::filesystem;
using base::ErrorCode;
using base::Progress;
using base::Result;

namespace {

NotExported describe(const SolidPlan& plan, const MissingSolid& missing) {
    const Document& step = *plan.steps[missing.step].document;
    const std::size_t row = missing.element.row();
    const Layer& layer = step.layer(step.elements.layer[row]);
    return {layer.name, layer.file, step.elements.line[row], std::string(missing.reason),
            missing.step == 0 ? missing.element : ElementId{}};
}

std::vector<NotExported> describe(const SolidPlan& plan, const std::vector<MissingSolid>& missing) {
    std::vector<NotExported> all;
    for (const MissingSolid& item : missing) {
        all.push_back(describe(plan, item));
    }
    return all;
}

/// Who asks for "F.Mask" may have meant the mask.
void nameMasks(const Document& board, const SolidChoice& choice, ExportSummary& summary) {
    for (const auto& [openings, mask] : chosenOpenings(board, choice)) {
        const Layer& layer = board.layer(openings);
        summary.missing.push_back({layer.name, layer.file, 0,
                                   "the solder mask itself: layer " + layer.name +
                                       " draws its openings, which are written as solids; the mask is the layer \"" +
                                       board.layer(mask).name + "\""});
    }
}

/// Of a STEP file that gzip leaves; 0.19 to 0.21 on boards of all kinds.
constexpr double kPackedShare = 0.2;
/// How much longer a packed file takes.
constexpr double kPackedTime = 1.8;

StepOptions stepOptionsOf(const Document& board, const ExportRequest& request) {
    StepOptions options;
    options.looks = request.looks;
    options.name = board.job.name;
    options.time = request.time;
    options.isWrittenOut = request.isWrittenOut;
    options.hasPolylines = request.hasPolylines;
    return options;
}

/// "1,321 solids"
std::string counted(std::uint64_t count, const char* one, const char* many) {
    std::string digits = std::to_string(count);
    for (std::size_t left = digits.size(); left > 3; left -= 3) {
        digits.insert(left - 3, ",");
    }
    return digits + " " + (count == 1 ? one : many);
}

/// Nothing where a form has all written out, or nothing lies on the board twice.
std::string copiesText(std::uint64_t copies) {
    return copies == 0 ? "" : ", " + counted(copies, "placed copy", "placed copies");
}

template <bool isPacked>
Result<ExportSummary> writeStep(const Document& board, const ExportRequest& request, const fs::path& path,
                                Progress& progress) {
    ASSIGN_OR_RETURN(const SolidPlan plan, planSolids(board, request.choice, progress));
    StepOptions options = stepOptionsOf(board, request);
    options.isPacked = isPacked;
    ASSIGN_OR_RETURN(const SolidReport report, exportStep(plan, options, path, progress));
    return ExportSummary{report.bytes, counted(report.solids, "solid", "solids") + copiesText(report.copies),
                         describe(plan, report.missing)};
}

/// Triangles by one of the functions of model/export/meshes.
template <class Options, auto Write>
Result<ExportSummary> writeMesh(const Document& board, const ExportRequest& request, const fs::path& path,
                                Progress& progress) {
    ASSIGN_OR_RETURN(const SolidPlan plan, planSolids(board, request.choice, progress));
    Options options;
    options.looks = request.looks;
    options.name = board.job.name;
    options.how = request.how;
    if constexpr (std::is_same_v<Options, GlbOptions>) {
        options.packing = request.isCompressed ? GlbPacking::Compressed : GlbPacking::Plain;
        options.isInstanced = request.isInstanced;
    }
    ASSIGN_OR_RETURN(const MeshReport report, Write(plan, options, path, progress));
    return ExportSummary{report.bytes, counted(report.triangles, "triangle", "triangles") + copiesText(report.copies),
                         describe(plan, report.missing)};
}

DrawingOptions drawingOptions(const Document& board, const ExportRequest& request) {
    DrawingOptions options;
    if (!request.choice.layers.empty()) {
        options.layers.resize(board.layers.size());
        for (const LayerId layer : request.choice.layers) {
            options.layers[layer.row()] = true;
        }
    }
    for (const SolidLook& look : request.looks) {
        options.colours.push_back(look.rgb);
    }
    return options;
}

/// The file takes its name last: what fails before leaves none.
Result<ExportSummary> finish(const DrawingReport& report, FileWriter& file) {
    ExportSummary summary{
        0, counted(report.layers.size(), "layer", "layers") + ", " + counted(report.regions, "region", "regions"), {}};
    for (const NotDrawn& item : report.notDrawn) {
        summary.missing.push_back(
            {item.layer, item.file, item.line, std::string(item.reason), item.step == 0 ? item.element : ElementId{}});
    }
    RETURN_IF_ERROR(file.commit());
    summary.bytes = file.size();
    return summary;
}

/// A drawing by one of the functions that leave the file to be committed.
template <auto Write, class... Rest>
Result<ExportSummary> draw(const Document& board, const ExportRequest& request, const fs::path& path,
                           Progress& progress, const Rest&... rest) {
    FileWriter file(path);
    ASSIGN_OR_RETURN(const DrawingReport report, Write(board, drawingOptions(board, request), rest..., file, progress));
    return finish(report, file);
}

Result<ExportSummary> drawPdf(const Document& board, const ExportRequest& request, const fs::path& path,
                              Progress& progress) {
    const PdfPages pages = request.isOnePage    ? PdfPages::AllOnOne
                           : request.isMirrored ? PdfPages::BottomMirrored
                                                : PdfPages::OnePerLayer;
    return draw<writePdf>(board, request, path, progress, pages);
}

constexpr ExportFormat kFormats[] = {
    {"STEP", ".step .stp", "exact solids for mechanical CAD", true, true, false, false, true, writeStep<false>},
    {"Compressed STEP", ".stpz", "the same with gzip, a fifth of the size", true, true, false, false, true,
     writeStep<true>},
    {"GLB", ".glb", "triangles with names and colours for viewers", true, false, false, true, true,
     writeMesh<GlbOptions, exportGlb>},
    {"STL", ".stl", "triangles for printers", true, false, false, false, false, writeMesh<MeshOptions, exportStl>},
    {"OBJ", ".obj", "triangles for renderers", true, false, false, false, false, writeMesh<MeshOptions, exportObj>},
    {"DXF", ".dxf", "outlines of layers for CAD", false, false, false, false, false, draw<writeDxf>},
    {"SVG", ".svg", "a drawing of layers, true to scale", false, false, false, false, false, draw<writeSvg>},
    {"PDF", ".pdf", "a drawing of layers, true to scale", false, false, true, false, false, drawPdf},
};

std::vector<std::string> endingsOf(const ExportFormat& format) {
    std::vector<std::string> endings;
    for (std::size_t at = 0; at < format.endings.size();) {
        const std::size_t end = std::min(format.endings.find(' ', at), format.endings.size());
        endings.emplace_back(format.endings.substr(at, end - at));
        at = end + 1;
    }
    return endings;
}

/// What is on in the request and no business of the format.
base::Status checkKnown(const ExportFormat& format, const ExportRequest& request) {
    const SolidChoice& choice = request.choice;
    const std::pair<const char*, bool> ofSolids[] = {
        {"--nets", !choice.nets.empty()},      {"--window", choice.window.has_value()},
        {"--min-hole", choice.minHole > 0},    {"--outer-only", choice.isOuterOnly},
        {"--merge", choice.isMerged},          {"--fit-arcs", choice.hasFittedArcs},
        {"--as-designed", choice.isAsDesigned}};
    for (const auto& [option, isOn] : ofSolids) {
        if (isOn && !format.isSolid) {
            return base::Error{ErrorCode::BadUsage,
                               std::string(format.name) + " does not know " + option +
                                   ", which is for solids and triangles: drawings show whole layers as designed, and "
                                   "--layers says which"};
        }
    }
    const struct {
        const char* name;  ///< on the command line; the window offers to a format what that knows
        bool isOn;
        bool isKnown;
        const char* knownTo;
    } options[] = {
        {"--written-out", request.isWrittenOut, format.isStep, "STEP"},
        {"--polylines", request.hasPolylines, format.isStep, "STEP"},
        {"--one-page", request.isOnePage, format.isPdf, "PDF"},
        {"--mirror-bottom", request.isMirrored, format.isPdf, "PDF"},
        {"--compress", request.isCompressed, format.isGlb, "GLB"},
        {"--instancing", request.isInstanced, format.isGlb, "GLB"},
        {"--one-part", choice.isOnePart, format.isTree, "STEP and GLB"},
    };
    if (request.isOnePage && request.isMirrored) {
        return base::Error{ErrorCode::BadUsage, "layers are mirrored on pages of their own, not all on one page"};
    }
    for (const auto& option : options) {
        if (option.isOn && !option.isKnown) {
            return base::Error{ErrorCode::BadUsage, std::string(format.name) + " does not know " + option.name +
                                                        ", which is for " + option.knownTo};
        }
    }
    return base::Done{};
}

}  // namespace

std::span<const ExportFormat> exportFormats() {
    return kFormats;
}

std::string exportEndings() {
    std::vector<std::string> all;
    for (const ExportFormat& format : kFormats) {
        std::ranges::move(endingsOf(format), std::back_inserter(all));
    }
    std::string text;
    for (std::size_t i = 0; i < all.size(); ++i) {
        text += (i == 0 ? "" : i + 1 < all.size() ? ", " : " or ") + all[i];
    }
    return text;
}

const ExportFormat* exportFormatOf(const fs::path& path) {
    const std::string ending = base::lowerCase(path.extension().string());
    const auto* const found = std::ranges::find_if(
        kFormats, [&](const ExportFormat& format) { return std::ranges::count(endingsOf(format), ending) > 0; });
    return found != std::end(kFormats) ? found : nullptr;
}

fs::path otherFileOf(const fs::path& path) {
    const ExportFormat* format = exportFormatOf(path);
    return format != nullptr && format->write == writeMesh<MeshOptions, exportObj> ? materialsBeside(path) : fs::path();
}

Result<std::optional<StepEstimate>> estimateExport(const Document& board, const ExportFormat& format,
                                                   const ExportRequest& request, const Progress& progress) {
    RETURN_IF_ERROR(checkKnown(format, request));
    if (!format.isStep) {
        return std::optional<StepEstimate>();
    }
    ASSIGN_OR_RETURN(const SolidPlan plan, planSolids(board, request.choice, progress));
    ASSIGN_OR_RETURN(StepEstimate estimate, estimateStep(plan, stepOptionsOf(board, request), progress));
    if (format.write == writeStep<true>) {
        estimate.bytes *= kPackedShare;
        estimate.seconds *= kPackedTime;
    }
    return std::optional(estimate);
}

Result<ExportSummary> exportBoard(const Document& board, const ExportFormat& format, const ExportRequest& request,
                                  const fs::path& path, Progress& progress) {
    RETURN_IF_ERROR(checkKnown(format, request));
    ASSIGN_OR_RETURN(ExportSummary summary, format.write(board, request, path, progress));
    summary.beside = otherFileOf(path);
    if (format.isSolid) {
        nameMasks(board, request.choice, summary);
    }
    return summary;
}

}  // namespace model
