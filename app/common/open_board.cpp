#include "app/common/open_board.h"

#include <cstdio>
#include <optional>
#include <utility>

#include "app/common/console_progress.h"
#include "app/common/headless_device.h"
#include "app/common/resources.h"
#include "model/session/length_text.h"
#include "model/session/session.h"

namespace app {

namespace session = model::session;
using Board = std::shared_ptr<const model::Document>;

namespace {

base::Status addThicknesses(const std::vector<std::string>& texts, const model::Stackup& stackup,
                            std::vector<model::ThicknessOverride>& into) {
    for (const std::string& text : texts) {
        const base::Result<model::ThicknessOverride> change = session::parseOverride(text, stackup);
        if (!change) {
            return base::Error{change.error().code, "--set-thickness: " + change.error().text};
        }
        session::setThickness(into, *change);
    }
    return base::Done{};
}

/// The board as its session and the arguments want it.
base::Result<Board> stacked(const Board& read, const std::filesystem::path& path, const BoardArguments& arguments) {
    session::LoadedSession found;
    if (!arguments.noSession) {
        found = session::loadSession(path, *read);
    }
    for (const std::string& text : found.ignored) {
        std::fprintf(stderr, "copperscope: %s\n", text.c_str());
    }
    std::vector<model::ThicknessOverride>& wanted = found.session.thicknesses;
    RETURN_IF_ERROR(addThicknesses(arguments.thicknesses, read->stackup, wanted));
    if (arguments.saveSession) {
        RETURN_IF_ERROR(session::saveThicknesses(path, *read, wanted));
    }
    return session::applyThicknesses(read, wanted);
}

}  // namespace

base::Result<Board> openDocument(const BoardArguments& arguments, base::Progress& progress) {
    const std::filesystem::path path = arguments.path.empty() ? sampleBoard() : std::filesystem::path(arguments.path);
    ASSIGN_OR_RETURN(const Board read, model::readBoard(path, {arguments.step, arguments.inferNets}, progress));
    return stacked(read, path, arguments);
}

model::Discretisation discretisationOf(const BoardArguments& arguments) {
    return {arguments.chordUm * base::kNmPerUm, arguments.paperSegments};
}

base::Result<render::BoardModel> modelBoard(const model::Document& document, const BoardArguments& arguments,
                                            base::Progress& progress) {
    const tri::Triangulator wanted = tri::triangulatorNamed(arguments.triangulator).value_or(tri::Triangulator::Auto);
    render::AreaTriangulator areas;
    std::optional<DeviceTriangulator> device;
    if (wanted == tri::Triangulator::Gpu) {
        ASSIGN_OR_RETURN(DeviceTriangulator opened, DeviceTriangulator::open());
        device.emplace(std::move(opened));
        areas.onDevice = [&device](std::span<const tri::Polygon> polygons, base::Progress& work) {
            return device->triangulator->triangulate(polygons, work);
        };
    } else {
        areas.triangulator = wanted;
    }
    return render::buildBoardModel(document, discretisationOf(arguments), progress, areas);
}

base::Result<OpenBoard> openBoard(const BoardArguments& arguments) {
    ConsoleProgress console;
    ASSIGN_OR_RETURN(const Board document, openDocument(arguments, console.progress()));
    ASSIGN_OR_RETURN(render::BoardModel model, modelBoard(*document, arguments, console.progress()));
    return OpenBoard{document, std::move(model), discretisationOf(arguments)};
}

base::Result<model::LayerId> findLayer(const model::Document& document, const std::string& name) {
    constexpr std::string_view kOld = " coat";
    model::LayerId layer = document.findLayer(name);
    if (!layer.isValid() && name.ends_with(kOld)) {
        const std::string now = name.substr(0, name.size() - kOld.size()) + " solder mask";
        layer = document.findLayer(now);
        std::fprintf(stderr, "copperscope: layer \"%s\" is now named \"%s\"\n", name.c_str(), now.c_str());
    }
    if (!layer.isValid()) {
        return base::Error{base::ErrorCode::BadUsage, "there is no layer " + name + " (see copperscope info)"};
    }
    return layer;
}

render::LevelOfDetail levelsOf(const std::string& name) {
    return name == "paper"    ? render::LevelOfDetail::Paper
           : name == "coarse" ? render::LevelOfDetail::Coarse
                              : render::LevelOfDetail::Error;
}

}  // namespace app
