#include "app/common/open_board.h"

#include <algorithm>
#include <cstdio>
#include <optional>
#include <utility>

#include "app/common/beside_program.h"
#include "app/common/console_progress.h"
#include "app/common/headless_device.h"
#include "model/base/ascii.h"
#include "model/board/diagnostic_facts.h"
#include "model/formats/board_forms.h"

namespace app {

using Board = std::shared_ptr<const model::Document>;

model::OpenRequest orSample(model::OpenRequest request) {
    if (request.path.empty()) {
        request.path = besideProgram(COPPERSCOPE_RESOURCES "/sample/ocp_tap_sa45_odb.tgz");
    }
    return request;
}

base::Status checkLayerMap(const model::OpenedBoard& board) {
    if (board.request.layerMap.empty() || board.format == "gerber") {
        return base::Done{};
    }
    return base::Error{base::ErrorCode::BadUsage,
                       board.request.path.string() +
                           ": --layer-map says what the files of a Gerber job draw, and this "
                           "was read as " +
                           board.format + ", where they say it themselves"};
}

namespace {

/// Errors that are named on stderr, one by one.
constexpr std::size_t kNamedErrors = 5;

/// Reading a board takes a while: what a window saved in that time is kept.
base::Status saveThicknesses(const model::OpenedBoard& board) {
    namespace session = model::session;
    session::KnownPart known{board.sessionFile, board.sessionFile};
    RETURN_IF_ERROR(session::saveThicknesses(board.request.path, *board.document, board.thicknesses.all(),
                                             board.request.noSession ? nullptr : &known));
    if (known.keepsOthers) {
        std::fprintf(stderr,
                     "copperscope: other thicknesses were saved while the board was read; they are kept in %s\n",
                     session::sessionPath(board.request.path).c_str());
    }
    if (known.replacesOthers) {
        std::fprintf(stderr,
                     "copperscope: thicknesses that --set-thickness names were saved while the board was read; "
                     "they are replaced\n");
    }
    return base::Done{};
}

}  // namespace

void sayErrors(const model::Document& document) {
    std::size_t errors = 0;
    for (const model::Diagnostic& entry : document.diagnostics.entries()) {
        if (entry.severity == model::Severity::Error && errors++ < kNamedErrors) {
            const std::string place = entry.file.empty() ? "copperscope" : model::placeOf(entry);
            std::fprintf(stderr, "%s: error: %s\n", place.c_str(), entry.text.c_str());
        }
    }
    if (errors > kNamedErrors) {
        std::fprintf(stderr, "... and %zu more errors, which copperscope info lists\n", errors - kNamedErrors);
    }
}

void sayChoice(const model::OpenedBoard& board, const model::OpenRequest& asked) {
    const auto isSame = [&](const model::BoardForm& form) { return form.format->key == board.format; };
    if (board.forms.empty() || (!asked.format.empty() && std::ranges::count_if(board.forms, isSame) == 1)) {
        return;
    }
    std::fprintf(stderr, "%s: %s\n", asked.path.c_str(), model::choiceText(board.forms, asked.path).c_str());
}

std::filesystem::path fileOf(const model::OpenedBoard& board) {
    const std::filesystem::path member = board.request.path / board.request.member;
    std::error_code error;
    return !board.request.member.empty() && std::filesystem::exists(member, error) ? member : board.request.path;
}

base::Result<model::OpenedBoard> openWithSession(const BoardArguments& arguments, base::Progress& progress) {
    if (arguments.saveSession && arguments.request.thicknesses.empty() && !arguments.request.noSession) {
        return base::Error{base::ErrorCode::BadUsage,
                           "--save-session saves what --set-thickness sets, and nothing is set"};
    }
    const model::OpenRequest asked = orSample(arguments.request);
    ASSIGN_OR_RETURN(model::OpenedBoard board, model::openBoard(asked, progress));
    RETURN_IF_ERROR(checkLayerMap(board));
    sayChoice(board, asked);
    for (const std::string& note : board.notes) {
        std::fprintf(stderr, "copperscope: %s\n", note.c_str());
    }
    sayErrors(*board.document);
    if (arguments.saveSession) {
        RETURN_IF_ERROR(saveThicknesses(board));
    }
    return board;
}

base::Result<Board> openDocument(const BoardArguments& arguments, base::Progress& progress) {
    ASSIGN_OR_RETURN(const model::OpenedBoard board, openWithSession(arguments, progress));
    return board.document;
}

model::Discretisation discretisationOf(const BoardArguments& arguments) {
    return {arguments.chordUm * base::kNmPerUm, arguments.paperSegments};
}

namespace {

/// What triangulates areas, and the device that it may need.
struct WantedTriangulator {
    std::optional<DeviceTriangulator> device;
    render::AreaTriangulator areas;
};

base::Result<WantedTriangulator> openTriangulator(const BoardArguments& arguments) {
    const tri::Triangulator wanted = tri::triangulatorNamed(arguments.triangulator).value_or(tri::Triangulator::Auto);
    WantedTriangulator result;
    if (wanted == tri::Triangulator::Gpu) {
        ASSIGN_OR_RETURN(result.device, DeviceTriangulator::open());
        result.areas.onDevice = [triangulator = result.device->triangulator.get()](
                                    std::span<const tri::Polygon> polygons, base::Progress& work) {
            return triangulator->triangulate(polygons, work);
        };
    } else {
        result.areas.triangulator = wanted;
    }
    return result;
}

}  // namespace

base::Result<render::BoardModel> modelBoard(const model::Document& document, const BoardArguments& arguments,
                                            base::Progress& progress) {
    ASSIGN_OR_RETURN(const WantedTriangulator triangulator, openTriangulator(arguments));
    return render::buildBoardModel(document, discretisationOf(arguments), progress, triangulator.areas);
}

base::Result<CountedBoard> countBoard(const BoardArguments& arguments) {
    ConsoleProgress console;
    ASSIGN_OR_RETURN(const model::OpenedBoard board, openWithSession(arguments, console.progress()));
    ASSIGN_OR_RETURN(const WantedTriangulator triangulator, openTriangulator(arguments));
    const model::Discretisation how = discretisationOf(arguments);
    ASSIGN_OR_RETURN(render::ModelCounts counts,
                     render::countBoardModel(*board.document, how, console.progress(), triangulator.areas));
    return CountedBoard{board.document, std::move(counts), how, board.format};
}

base::Status checkOnlyOne(const model::Document& document, model::LayerId layer, const std::string& name) {
    const bool isExact = document.layer(layer).name == name;
    const auto alike = std::ranges::count_if(document.layers, [&](const model::Layer& other) {
        return isExact ? other.name == name : base::equalsIgnoringCase(other.name, document.layer(layer).name);
    });
    if (alike > 1) {
        return base::Error{base::ErrorCode::BadUsage, std::to_string(alike) + " layers are called " + name +
                                                          ", so the name does not say which is meant"};
    }
    return base::Done{};
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
    RETURN_IF_ERROR(checkOnlyOne(document, layer, name));
    return layer;
}

render::LevelOfDetail levelsOf(const std::string& name) {
    return name == "paper"    ? render::LevelOfDetail::Paper
           : name == "coarse" ? render::LevelOfDetail::Coarse
                              : render::LevelOfDetail::Error;
}

}  // namespace app
