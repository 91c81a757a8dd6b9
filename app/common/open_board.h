#pragma once

#include <memory>
#include <string>

#include "model/opening/open_board.h"
#include "render/modelling/board_model.h"
#include "render/scene/view_settings.h"

namespace app {

/// What `info` and `render` share: which board to open and how to model it.
struct BoardArguments {
    model::OpenRequest request;  ///< as orSample
    bool saveSession = false;    ///< saves the thicknesses of the request in the session file
    double chordUm = 5.0;
    bool paperSegments = false;
    std::string triangulator = "auto";  ///< of areas; as tri::triangulatorNamed
};

/// The request, or without a path that of the board that comes with Copperscope: at its place beside the program
/// (../share/copperscope), which in a build tree leads to the sources.
[[nodiscard]] model::OpenRequest orSample(model::OpenRequest request);

/// Errors: BadUsage if a layer map is named and the board is none of Gerber, which alone has a use for it.
[[nodiscard]] base::Status checkLayerMap(const model::OpenedBoard& board);

/// Says on stderr what of the job could not be read, with file and line, and so is not on the board, or not as it
/// should be. What else was noticed is for `info`.
void sayErrors(const model::Document& document);

/// Says on stderr which of several boards, or forms of one, was read where `asked` leads, and what else is there; no
/// word where the format that was asked for leaves only one.
void sayChoice(const model::OpenedBoard& board, const model::OpenRequest& asked);

/// The file or folder that was read, for reports: of several in a folder the one that was taken, of several in an
/// archive the archive.
[[nodiscard]] std::filesystem::path fileOf(const model::OpenedBoard& board);

/// model::openBoard; which of several was read (sayChoice), what of the job could not be read (sayErrors) and what of
/// the session is not used is said on stderr. Errors: also those of checkLayerMap; BadUsage if there is nothing to save
/// in the session; OutputFailed when that cannot be saved.
[[nodiscard]] base::Result<std::shared_ptr<const model::Document>> openDocument(const BoardArguments& arguments,
                                                                                base::Progress& progress);
/// The same with all that is known of it.
[[nodiscard]] base::Result<model::OpenedBoard> openWithSession(const BoardArguments& arguments,
                                                               base::Progress& progress);

[[nodiscard]] model::Discretisation discretisationOf(const BoardArguments& arguments);

/// Lets and triangles, with the triangulator that was requested. Errors as render::buildBoardModel; DeviceFailed if a
/// device is to triangulate and there is none.
[[nodiscard]] base::Result<render::BoardModel> modelBoard(const model::Document& document,
                                                          const BoardArguments& arguments, base::Progress& progress);

/// A board read, and what its model holds.
struct CountedBoard {
    std::shared_ptr<const model::Document> document;
    render::ModelCounts model;
    model::Discretisation how;  ///< what it was modelled with
    std::string format;         ///< model::BoardFormat::key of what was read
};

/// Reads and counts, with progress on stderr. Errors as openDocument and modelBoard.
[[nodiscard]] base::Result<CountedBoard> countBoard(const BoardArguments& arguments);

/// The layer of that name; the names that solder masks had in older versions work too, with a note on stderr. Errors:
/// BadUsage, also where several layers have it.
[[nodiscard]] base::Result<model::LayerId> findLayer(const model::Document& document, const std::string& name);

/// Is the layer that was found the only one that the name may mean? What is written alike to the letter goes before
/// what differs in case. Errors: BadUsage.
[[nodiscard]] base::Status checkOnlyOne(const model::Document& document, model::LayerId layer, const std::string& name);

/// What `--lod` says: "error" or "paper".
[[nodiscard]] render::LevelOfDetail levelsOf(const std::string& name);

}  // namespace app
