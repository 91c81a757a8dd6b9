#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "model/base/progress.h"
#include "model/base/result.h"
#include "model/formats/common/read_options.h"
#include "model/formats/gerber/layer_map.h"

namespace model::gerber {

/// What a file of a job is taken to draw, for people to look at and to change.
struct LayerProposal {
    std::string path;     ///< inside the job
    std::string content;  ///< what the file holds: "image", "drills", "netlist", "job file", "placements" or "other"
    /// Copper layers are numbered from the top, whatever told them; of what is no image only Ignored may be told.
    FileRole role;
    std::string draws;    ///< describe(role), for people: "top copper 1"; empty for what is no image
    std::string why;      ///< how that is known, for people: "its name, as of a known CAD system"
    std::string board;    ///< of a job with several boards: the one it belongs to; empty if it belongs to all
    bool isSure = false;  ///< nobody needs to look: it is told, or named as a known system names it, no other file
                          ///< claims the same, and of inner copper no number before it is left out

    [[nodiscard]] bool isImage() const { return content == "image" || content == "drills"; }
};

/// For all files of a Gerber job (a folder, an archive, a job file with what lies beside it, or one file), as it is
/// opened with these options, which may hold a layer map; images and drills come first, by board from the top. Errors:
/// those of readFilesAt() and assignFiles().
[[nodiscard]] base::Result<std::vector<LayerProposal>> proposeLayers(const std::filesystem::path& path,
                                                                     const formats::ReadOptions& options,
                                                                     base::Progress& progress);

/// The same as if there were no layer map, neither named nor beside the job.
[[nodiscard]] base::Result<std::vector<LayerProposal>> proposeWithoutMap(const std::filesystem::path& path,
                                                                         base::Progress& progress);

/// The map that says just what these proposals say, of images, drills and what is ignored: changed by somebody, it is
/// what opens the job as it should be.
[[nodiscard]] LayerMap mapOf(const std::vector<LayerProposal>& proposals);
/// The text of that map, with a comment over each row on how it is known.
[[nodiscard]] std::string explainedMapText(const std::vector<LayerProposal>& proposals);

}  // namespace model::gerber
