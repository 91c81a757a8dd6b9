#include "app/open_board.h"

#include "app/console_progress.h"
#include "app/resources.h"

namespace app {

base::Result<OpenBoard> openBoard(const BoardArguments& arguments) {
    ConsoleProgress console;
    const std::filesystem::path path = arguments.path.empty() ? sampleBoard() : std::filesystem::path(arguments.path);
    base::Result<std::shared_ptr<const model::Document>> document =
        model::readBoard(path, {arguments.step}, console.progress());
    if (!document) {
        return document.error();
    }
    const model::Discretisation how{arguments.chordUm * base::kNmPerUm, arguments.paperSegments};
    base::Result<render::BoardModel> model = render::buildBoardModel(**document, how, console.progress());
    if (!model) {
        return model.error();
    }
    return OpenBoard{std::move(*document), std::move(*model)};
}

}  // namespace app
