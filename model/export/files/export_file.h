#pragma once

#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "model/base/progress.h"
#include "model/export/solids/step_export.h"

/// Everything that a board can be exported as: the one table that the command line and the window read.
namespace model {

/// What is exported, for all formats; each uses what it knows (ExportFormat).
struct ExportRequest {
    SolidChoice choice;            ///< drawings use its layers only
    std::vector<SolidLook> looks;  ///< by row of the board's layers
    std::string time;              ///< ISO 8601, for headers; empty where the format has no place for it
    bool isWrittenOut = false;     ///< StepOptions::isWrittenOut
    bool hasPolylines = false;     ///< StepOptions::hasPolylines
    bool isOnePage = false;        ///< PDF: all layers on one page
    bool isMirrored = false;       ///< PDF with a page per layer: those of the bottom as they are seen from below
    bool isCompressed = false;     ///< GLB: GlbPacking::Compressed
    bool isInstanced = false;      ///< GLB: GlbOptions::isInstanced
    Discretisation how;            ///< of curves in meshes
};

/// Something that is not in the file.
struct NotExported {
    std::string layer;
    std::string file;        ///< of the job
    std::uint32_t line = 0;  ///< of that file, from 1
    std::string reason;
    ElementId element{};  ///< none where it is one of a placed step
};

/// What became of an export.
struct ExportSummary {
    std::uint64_t bytes = 0;
    std::string content;  ///< "1,321 solids, 531 placed copies"
    std::vector<NotExported> missing;
    std::filesystem::path beside{};  ///< the second file, as otherFileOf; empty where there is none
};

/// A kind of file.
struct ExportFormat {
    std::string_view name;     ///< "STEP"
    std::string_view endings;  ///< in lower case, separated by spaces: ".step .stp"
    std::string_view purpose;  ///< "exact solids for mechanical CAD"
    bool isSolid = false;      ///< it knows all of SolidChoice but isOnePart; otherwise layers only
    bool isStep = false;       ///< it knows ExportRequest::time, isWrittenOut and hasPolylines
    bool isPdf = false;        ///< it knows ExportRequest::isOnePage and isMirrored
    bool isGlb = false;        ///< it knows ExportRequest::isCompressed and isInstanced
    bool isTree = false;       ///< it knows SolidChoice::isOnePart
    base::Result<ExportSummary> (*write)(const Document& board, const ExportRequest& request,
                                         const std::filesystem::path& path, base::Progress& progress) = nullptr;
};

[[nodiscard]] std::span<const ExportFormat> exportFormats();
/// ".step, .stp, .dxf, .svg or .pdf"
[[nodiscard]] std::string exportEndings();
/// By what the name ends with; nullptr if it is none of them.
[[nodiscard]] const ExportFormat* exportFormatOf(const std::filesystem::path& path);

/// What is written beside the file of that name, as the materials of .obj; empty where that is all.
[[nodiscard]] std::filesystem::path otherFileOf(const std::filesystem::path& path);

/// About how large the file will be and how long it takes; no value for formats that cannot be told before. Errors:
/// BadUsage for choices that the format does not know; as planSolids.
[[nodiscard]] base::Result<std::optional<StepEstimate>> estimateExport(const Document& board,
                                                                       const ExportFormat& format,
                                                                       const ExportRequest& request,
                                                                       const base::Progress& progress);
/// Writes the file, all of it or nothing. Errors: BadUsage for choices that the format does not know, names that are
/// not there and when nothing is left to write; OutputFailed; Cancelled.
[[nodiscard]] base::Result<ExportSummary> exportBoard(const Document& board, const ExportFormat& format,
                                                      const ExportRequest& request, const std::filesystem::path& path,
                                                      base::Progress& progress);

}  // namespace model
