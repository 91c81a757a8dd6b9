#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "model/base/progress.h"
#include "model/clearance/rule_file.h"
#include "model/formats/registry.h"
#include "model/session/session.h"

/// From a path to a board that is ready: the one way for the command line and the window.
namespace model {

/// Which board to open, and how.
struct OpenRequest {
    std::filesystem::path path;
    std::string step{};                      ///< empty: the job's first step
    std::vector<std::string> thicknesses{};  ///< LAYER=LENGTH over what job and session say, saved nowhere
    bool noSession = false;                  ///< as if there were no session file; none is written either
    bool inferNets = false;                  ///< nets by following the copper, instead of the job's
    std::string format{};                    ///< BoardFormat::key; empty: the richest that is there
    std::string member{};                    ///< BoardForm::member
    bool onlyAsks = false;                   ///< reads nothing where there are several forms and none is named here
    std::filesystem::path layerMap{};        ///< what files of a Gerber job draw; empty: ReadOptions::layerMap
    formats::ArchiveLimits limits{};         ///< of archives that are unpacked
};

/// What thicknesses are set over those of the job: those of the session file, and over them those for this time only.
struct SetThicknesses {
    std::vector<ThicknessOverride> saved{};
    std::vector<ThicknessOverride> once{};

    /// Both, one entry per row of the stackup.
    [[nodiscard]] std::vector<ThicknessOverride> all() const;
    bool operator==(const SetThicknesses&) const = default;
};

struct OpenedBoard {
    OpenRequest request;                       ///< of several forms it names the one that was read
    std::shared_ptr<const Document> document;  ///< with the thicknesses in it; null if one of `forms` is to be chosen
    SetThicknesses thicknesses{};
    bool areThicknessesSaved = true;  ///< those of `thicknesses.saved` are in the session file
    session::Session session{};       ///< as the file holds it, of other steps too
    std::shared_ptr<const session::FileContent> sessionFile{};  ///< what was read; null where there is none
    std::optional<RuleFile> projectRules{};  ///< those of a KiCad board's project (kicadRulesFor), unless noSession
    std::string format{};                    ///< BoardFormat::key of what was read
    std::vector<BoardForm> forms{};          ///< where there are several: the one that was read or is proposed first
    std::vector<std::string> notes{};        ///< what of the session file is not used, a sentence each
};

/// Reads the board, infers its nets if that is requested, and stacks it as its session and the request say. Cancelled
/// by `progress`. Errors: those of readBoard; BadUsage for thicknesses.
[[nodiscard]] base::Result<OpenedBoard> openBoard(const OpenRequest& request, base::Progress& progress);

/// The request with the form that was chosen.
[[nodiscard]] OpenRequest requestOf(OpenRequest request, const BoardForm& form);
/// The request that opens the board again: with the thicknesses that were set for this time only.
[[nodiscard]] OpenRequest reloadRequest(const OpenedBoard& board);

}  // namespace model
