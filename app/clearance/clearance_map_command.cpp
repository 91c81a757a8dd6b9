#include "app/clearance/clearance_map_command.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <filesystem>

#include "app/clearance/clearance_map_image.h"
#include "app/common/open_board.h"
#include "app/common/window_option.h"
#include "model/base/ascii.h"
#include "model/base/thickness_units.h"
#include "model/clearance/board_distances.h"
#include "model/clearance/clearance.h"
#include "model/export/clearance_map_export.h"
#include "model/text/formatting.h"
#include "model/text/whole_file.h"
#include "render/frame/png.h"

namespace app {

using base::ErrorCode;
using base::PointD;
using model::MapFrame;

namespace {

constexpr double kPictureCells = 1600.0;  ///< along the longer side, unless --resolution says otherwise
constexpr double kTableCells = 400.0;
constexpr double kMostTableCells = 4'000'000.0;  ///< about 300 MB

base::Error refused(std::string text) {
    return {ErrorCode::BadUsage, std::move(text)};
}

enum class Form { Picture, Table };

base::Result<Form> formOf(const std::string& file) {
    const std::string ending = base::lowerCase(std::filesystem::path(file).extension().string());
    if (ending != ".png" && ending != ".csv") {
        return refused(file + ": a clearance map is written as .png or .csv");
    }
    return ending == ".png" ? Form::Picture : Form::Table;
}

base::Result<model::LayerId> layerOf(const model::Document& board, const std::string& name) {
    if (name.empty()) {
        return refused("--map shows one layer: --layer names it");
    }
    const model::LayerId layer = board.findLayer(name);
    if (!layer.isValid() || !board.layer(layer).isCopper()) {
        return refused("the board has no copper layer " + name);
    }
    RETURN_IF_ERROR(checkOnlyOne(board, layer, name));
    return layer;
}

base::Result<double> reachOf(const std::string& text) {
    ASSIGN_OR_RETURN(const base::Nm reach, model::parseLength(text));
    if (reach <= 0 || reach > model::kMostMapReach) {
        return refused("a clearance map reaches up to 10 mm, not " + text);
    }
    return static_cast<double>(reach);
}

/// Says how many cells there would be before anything is made of so many.
base::Result<MapFrame> frameFor(const base::Box& window, const std::string& resolution, Form form) {
    const double longest = static_cast<double>(std::max(window.width(), window.height()));
    double cell = std::ceil(longest / (form == Form::Picture ? kPictureCells : kTableCells));
    if (!resolution.empty()) {
        ASSIGN_OR_RETURN(const base::Nm wanted, model::parseLength(resolution));
        cell = static_cast<double>(wanted);
    }
    if (!(cell >= 1.0) || cell > model::kMostMapCell) {
        return refused("the cells of a clearance map have sides of 1 nm to 10 mm");
    }
    const double width = std::ceil(static_cast<double>(window.width()) / cell);
    const double height = std::ceil(static_cast<double>(window.height()) / cell);
    const double most = form == Form::Picture ? double{model::kMostMapCells} : kMostTableCells;
    if (width * height > most) {
        return refused(
            model::formatted("a clearance map of %.0f x %.0f cells is too large: a %s has %.0f at most; a "
                             "coarser --resolution or a smaller --window makes it smaller",
                             width, height, form == Form::Picture ? "picture" : "table", most));
    }
    return MapFrame{base::toDouble(window.min), cell, static_cast<std::uint32_t>(width),
                    static_cast<std::uint32_t>(height)};
}

base::Status write(const ClearanceMapArguments& arguments, Form form, const model::Document& board,
                   model::LayerId layer, const model::ClearanceMap& map, double reach) {
    if (form == Form::Table) {
        return model::writeWholeFile(arguments.file, model::clearanceMapCsv(board, layer, map));
    }
    const std::string title = board.layer(layer).name + ": spacing between nets";
    ASSIGN_OR_RETURN(const std::string png, render::encodePng(imageOf(map, reach, title)));
    return model::writeWholeFile(arguments.file, png);
}

}  // namespace

Outcome runClearanceMap(const ClearanceMapArguments& arguments, const model::Document& board, const std::string& layer,
                        base::Progress& progress) {
    ASSIGN_OR_RETURN(const Form form, formOf(arguments.file));
    ASSIGN_OR_RETURN(const model::LayerId onLayer, layerOf(board, layer));
    ASSIGN_OR_RETURN(const double reach, reachOf(arguments.reach));
    ASSIGN_OR_RETURN(const auto distances, model::BoardDistances::betweenNets(board, onLayer, progress));
    base::Box window = distances.extent();
    if (!arguments.window.empty()) {
        ASSIGN_OR_RETURN(window, boxOfWindow(arguments.window));
        RETURN_IF_ERROR(checkMeets(window, board.extent));
    }
    ASSIGN_OR_RETURN(const MapFrame frame, frameFor(window, arguments.resolution, form));
    const auto detail = form == Form::Table ? model::MapDetail::Nets : model::MapDetail::Distances;
    ASSIGN_OR_RETURN(const model::ClearanceMap map, distances.map(frame, reach, progress, detail));
    for (const std::string& note : model::unmeasuredSteps(board)) {
        std::fprintf(stderr, "copperscope: %s\n", note.c_str());
    }
    if (!distances.note().empty()) {
        std::fprintf(stderr, "copperscope: %s\n", distances.note().c_str());
    }
    RETURN_IF_ERROR(write(arguments, form, board, onLayer, map, reach));
    return int{kDone};
}

}  // namespace app
