#include "app/open_board.h"

#include "app/console_progress.h"
#include "app/resources.h"

namespace app {

base::Result<std::shared_ptr<const model::Document>> openDocument(const BoardArguments& arguments,
                                                                  base::Progress& progress) {
    const std::filesystem::path path = arguments.path.empty() ? sampleBoard() : std::filesystem::path(arguments.path);
    return model::readBoard(path, {arguments.step}, progress);
}

model::Discretisation discretisationOf(const BoardArguments& arguments) {
    return {arguments.chordUm * base::kNmPerUm, arguments.paperSegments};
}

base::Result<OpenBoard> openBoard(const BoardArguments& arguments) {
    ConsoleProgress console;
    base::Result<std::shared_ptr<const model::Document>> document = openDocument(arguments, console.progress());
    if (!document) {
        return document.error();
    }
    base::Result<render::BoardModel> model =
        render::buildBoardModel(**document, discretisationOf(arguments), console.progress());
    if (!model) {
        return model.error();
    }
    return OpenBoard{std::move(*document), std::move(*model)};
}

}  // namespace app
