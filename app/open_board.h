#pragma once

#include <memory>
#include <string>

#include "model/reader.h"
#include "render/board_model.h"

namespace app {

/// What `info` and `render` share: which board to open and how to model it.
struct BoardArguments {
    std::string path;  ///< empty: the bundled sample
    std::string step;
    double chordUm = 5.0;
    bool paperSegments = false;
};

/// Errors as model::readBoard.
[[nodiscard]] base::Result<std::shared_ptr<const model::Document>> openDocument(const BoardArguments& arguments,
                                                                                base::Progress& progress);

[[nodiscard]] model::Discretisation discretisationOf(const BoardArguments& arguments);

/// A board read and modelled.
struct OpenBoard {
    std::shared_ptr<const model::Document> document;
    render::BoardModel model;
};

/// Reads and models, with progress on stderr. Errors as model::readBoard.
[[nodiscard]] base::Result<OpenBoard> openBoard(const BoardArguments& arguments);

}  // namespace app
