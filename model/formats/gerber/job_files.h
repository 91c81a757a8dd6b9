#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "model/base/progress.h"
#include "model/base/result.h"
#include "model/formats/common/archive.h"
#include "model/formats/gerber/drills/drill_file.h"
#include "model/formats/gerber/image/image.h"
#include "model/formats/gerber/job_file.h"
#include "model/formats/gerber/naming/file_role.h"
#include "model/formats/gerber/naming/layer_pairs.h"
#include "model/formats/gerber/netlist/d356.h"
#include "model/formats/gerber/placements.h"

namespace model::gerber {

/// One file of a job, read as what its content is.
struct ReadFile {
    enum class Kind : std::uint8_t { Gerber, Drills, Netlist, Job, Placements, LayerPairs, Other };

    std::string path;  ///< inside the job
    Kind kind = Kind::Other;
    formats::Bytes bytes;
    Image image;  ///< Gerber, Drills
    FileRole role;
    DrillHead head;           ///< Drills
    CoordinateFormat format;  ///< Drills: as the image was read with
    D356 netlist;
    JobFileFacts job;
    PlacementFile placements;
    std::vector<LayerPair> layerPairs;
    Diagnostics diagnostics;  ///< of everything but images, which have their own

    /// Without folders.
    [[nodiscard]] std::string_view name() const { return std::string_view(path).substr(path.find_last_of('/') + 1); }
    [[nodiscard]] std::string_view folder() const {
        const std::size_t slash = path.find_last_of('/');
        return slash == std::string::npos ? std::string_view() : std::string_view(path).substr(0, slash);
    }
    [[nodiscard]] bool isIgnored() const { return role.kind == FileRole::Kind::Ignored; }
    /// Something to draw?
    [[nodiscard]] bool isImage() const { return (kind == Kind::Gerber || kind == Kind::Drills) && !isIgnored(); }
};

/// Reads the images and drills of a job anew that lies farther out than coordinates reach (1.07 m), as boards in large
/// drawings of Allegro do: moved near the origin, which is reported.
void moveFarJob(std::vector<ReadFile>& files);

/// What the text of a file is, by its content.
[[nodiscard]] ReadFile::Kind kindOf(std::string_view text, std::string_view name);
/// Is it a picture, a drawing or another program's file by its name, which is never read?
[[nodiscard]] bool isForeign(std::string_view name);
/// Is the file named like one of a Gerber job?
[[nodiscard]] bool isNamedLikeGerber(std::string_view name);

/// All files of a job, images parsed, those of a size first. Errors: Cancelled.
[[nodiscard]] base::Result<std::vector<ReadFile>> readFiles(const formats::Archive& archive, base::Progress& progress);
/// The same of what lies at a path: a folder, an archive, a job file with what is beside it, or one file. Errors:
/// BadInput when it cannot be read; Cancelled.
[[nodiscard]] base::Result<std::vector<ReadFile>> readFilesAt(const std::filesystem::path& path,
                                                              base::Progress& progress);
/// One file whose bytes are at hand.
[[nodiscard]] ReadFile readFile(std::string path, formats::Bytes bytes);

/// Finds out what each image draws: told by attributes, the job file, comments, names or, at last, by content.
void assignRoles(std::vector<ReadFile>& files, const JobFileFacts& job);

}  // namespace model::gerber
