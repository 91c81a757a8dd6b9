#include "app/commands/export_command.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <string>

#include "app/common/console_progress.h"
#include "app/common/interrupt.h"
#include "app/common/time_of_writing.h"
#include "app/common/window_option.h"
#include "model/base/thickness_units.h"
#include "model/export/files/export_file.h"
#include "render/scene/layer_style.h"

namespace app {

using base::ErrorCode;
using base::Result;
using model::Document;

namespace {

/// Missing elements that are named on stderr, one by one.
constexpr std::size_t kNamed = 20;

Result<model::SolidChoice> choiceOf(const Document& board, const ExportArguments& arguments) {
    model::SolidChoice choice;
    for (const std::string& name : arguments.layers) {
        ASSIGN_OR_RETURN(const model::LayerId layer, findLayer(board, name));
        choice.layers.push_back(layer);
    }
    choice.nets = arguments.nets;
    if (!arguments.window.empty()) {
        ASSIGN_OR_RETURN(choice.window, boxOfWindow(arguments.window));
    }
    if (!arguments.minHole.empty()) {
        ASSIGN_OR_RETURN(choice.minHole, model::parseLength(arguments.minHole));
    }
    choice.hasFittedArcs = arguments.hasFittedArcs;
    choice.isOuterOnly = arguments.isOuterOnly;
    choice.isMerged = arguments.isMerged;
    choice.isOnePart = arguments.isOnePart;
    choice.isAsDesigned = arguments.isAsDesigned;
    return choice;
}

/// Solids as the 3D view has them, drawings as the 2D view: outer copper under a finish would be of one colour there.
std::vector<model::SolidLook> looksOf(const Document& board, const model::ExportFormat& format) {
    const auto appearance = format.isSolid ? render::Appearance::Solid : render::Appearance::Flat;
    std::vector<model::SolidLook> looks;
    for (const render::LayerStyle& style : render::defaultStyles(board, appearance)) {
        const auto byte = [](float value) { return static_cast<std::uint32_t>(std::lround(value * 255.0F)); };
        looks.push_back({byte(style.colour.r) << 16U | byte(style.colour.g) << 8U | byte(style.colour.b),
                         static_cast<double>(style.opacity)});
    }
    return looks;
}

void reportMissing(const std::vector<model::NotExported>& missing) {
    for (std::size_t i = 0; i < std::min(missing.size(), kNamed); ++i) {
        const std::string line = missing[i].line > 0 ? ":" + std::to_string(missing[i].line) : "";
        std::fprintf(stderr, "%s%s: not exported: %s\n", missing[i].file.c_str(), line.c_str(),
                     missing[i].reason.c_str());
    }
    if (missing.size() > kNamed) {
        std::fprintf(stderr, "... and %zu more\n", missing.size() - kNamed);
    }
}

Result<model::ExportRequest> requestFor(const Document& board, const model::ExportFormat& format,
                                        const ExportArguments& arguments) {
    model::ExportRequest request;
    ASSIGN_OR_RETURN(request.choice, choiceOf(board, arguments));
    request.looks = looksOf(board, format);
    if (format.isStep) {
        ASSIGN_OR_RETURN(request.time, timeOfWriting());
    }
    request.isWrittenOut = arguments.isWrittenOut;
    request.hasPolylines = arguments.hasPolylines;
    request.isOnePage = arguments.isOnePage;
    request.isMirrored = arguments.isMirrored;
    request.isCompressed = arguments.isCompressed;
    request.isInstanced = arguments.isInstanced;
    request.how = discretisationOf(arguments.board);
    return request;
}

base::Status sayEstimate(const Document& board, const model::ExportFormat& format, const model::ExportRequest& request,
                         const base::Progress& progress) {
    ASSIGN_OR_RETURN(const auto estimate, model::estimateExport(board, format, request, progress));
    if (estimate) {
        std::fprintf(stderr, "about %.1f MB, %.0f s\n", estimate->bytes / 1e6, std::ceil(estimate->seconds));
    }
    return base::Done{};
}

/// Curves are exact where there are no triangles.
base::Status checkChords(const model::ExportFormat& format, const ExportArguments& arguments) {
    const bool isOfTriangles = format.isSolid && !format.isStep;
    const bool isGiven = arguments.board.paperSegments || arguments.board.chordUm != BoardArguments{}.chordUm;
    if (isGiven && !isOfTriangles) {
        return base::Error{ErrorCode::BadUsage, std::string(format.name) +
                                                    " has the exact curves: --chord and --paper-segments are for files "
                                                    "of triangles (.glb, .stl, .obj)"};
    }
    return base::Done{};
}

/// Who saves them may set them with any file.
base::Status checkThicknesses(const model::ExportFormat& format, const ExportArguments& arguments) {
    const bool isSet = !arguments.board.request.thicknesses.empty() && !arguments.board.saveSession;
    if (isSet && !format.isSolid) {
        return base::Error{ErrorCode::BadUsage, std::string(format.name) +
                                                    " is flat: --set-thickness is for solids and triangles, or with "
                                                    "--save-session"};
    }
    return base::Done{};
}

}  // namespace

Outcome runExport(const ExportArguments& arguments) {
    const model::ExportFormat* format = model::exportFormatOf(arguments.output);
    if (format == nullptr) {
        return base::Error{
            ErrorCode::BadUsage,
            arguments.output + ": what the name ends with is the format; it is one of " + model::exportEndings()};
    }
    RETURN_IF_ERROR(checkChords(*format, arguments));
    RETURN_IF_ERROR(checkThicknesses(*format, arguments));
    ConsoleProgress console;
    const Interrupt interrupt(console.progress());
    ASSIGN_OR_RETURN(const auto board, openDocument(arguments.board, console.progress()));
    ASSIGN_OR_RETURN(const model::ExportRequest request, requestFor(*board, *format, arguments));
    RETURN_IF_ERROR(sayEstimate(*board, *format, request, console.progress()));
    ASSIGN_OR_RETURN(const model::ExportSummary summary,
                     model::exportBoard(*board, *format, request, arguments.output, console.progress()));
    reportMissing(summary.missing);
    const std::string beside = summary.beside.empty() ? "" : " and " + summary.beside.string();
    std::fprintf(stderr, "%s%s: %s, %.1f MB\n", arguments.output.c_str(), beside.c_str(), summary.content.c_str(),
                 static_cast<double>(summary.bytes) / 1e6);
    return int{kDone};
}

}  // namespace app
