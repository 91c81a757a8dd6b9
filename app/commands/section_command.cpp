#include "app/commands/section_command.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <iterator>
#include <nlohmann/json.hpp>

#include "app/common/console_progress.h"
#include "model/export/section_export.h"
#include "model/solids/milling.h"
#include "model/text/json_text.h"
#include "render/scene/layer_style.h"

namespace app {

using base::ErrorCode;
using model::Document;
using model::Section;

namespace {

base::Result<model::SectionRequest> requestFor(const Document& board, const SectionArguments& arguments) {
    if (arguments.line.size() < 4 || arguments.line.size() % 2 != 0) {
        return base::Error{ErrorCode::BadUsage, "--line takes two corners or more: x0,y0,x1,y1 in millimetres"};
    }
    model::SectionRequest request;
    for (std::size_t i = 0; i + 1 < arguments.line.size(); i += 2) {
        request.line.push_back({arguments.line[i] * base::kNmPerMm, arguments.line[i + 1] * base::kNmPerMm});
    }
    for (const std::string& name : arguments.layers) {
        ASSIGN_OR_RETURN(const model::LayerId layer, findLayer(board, name));
        request.layers.resize(board.layers.size());
        request.layers[layer.row()] = true;
    }
    return request;
}

/// As the 3D view has them.
std::vector<std::uint32_t> coloursOf(const Document& board) {
    std::vector<std::uint32_t> colours;
    for (const render::LayerStyle& style : render::defaultStyles(board)) {
        const auto byte = [](float value) { return static_cast<std::uint32_t>(std::lround(value * 255.0F)); };
        colours.push_back(byte(style.colour.r) << 16U | byte(style.colour.g) << 8U | byte(style.colour.b));
    }
    return colours;
}

nlohmann::ordered_json piecesJson(const model::BoardIndex& index, const std::vector<model::SectionPiece>& pieces) {
    nlohmann::ordered_json list = nlohmann::ordered_json::array();
    for (const model::SectionPiece& piece : pieces) {
        const auto element = piece.at.element.isValid() ? nlohmann::ordered_json(piece.at.element.value) : nullptr;
        const model::StackupRow* row = model::stackupRowOf(*index.board, piece);
        list.push_back(
            {{"layer", index.board->layer(piece.layer).name},
             {"copy", piece.at.copy},
             {"element", element},
             {"net", model::netOf(index, piece)},
             {"from_nm", piece.from},
             {"to_nm", piece.to},
             {"bottom_nm", piece.bottom},
             {"top_nm", piece.top},
             {"upper_from_nm", piece.upperFrom()},
             {"upper_to_nm", piece.upperTo()},
             {"material", model::toString(piece.material)},
             {"dielectric", row != nullptr ? nlohmann::ordered_json(row->name) : nullptr},
             {"dielectric_thickness_nm", row != nullptr ? nlohmann::ordered_json(row->thickness) : nullptr}});
    }
    return list;
}

std::string sectionJson(const model::BoardIndex& index, const Section& section) {
    nlohmann::ordered_json line = nlohmann::ordered_json::array();
    for (const base::PointD corner : section.line) {
        line.push_back({base::toMm(corner.x), base::toMm(corner.y)});
    }
    const nlohmann::ordered_json all = {{"line_mm", line},
                                        {"stations_nm", section.stations},
                                        {"pieces", piecesJson(index, section.pieces)},
                                        {"bores", piecesJson(index, section.bores)},
                                        {"notes", section.notes},
                                        {"remarks", section.notes}};
    return model::jsonText(all);
}

std::vector<model::ElementId> elementsOf(const model::MilledBoard& milled) {
    std::vector<model::ElementId> elements;
    std::ranges::transform(milled.elements, std::back_inserter(elements), &model::MilledElement::element);
    return elements;
}

/// As the board is made, unless it is to be as designed.
base::Result<Section> sectionOf(const model::BoardIndex& index, model::SectionRequest request, bool isAsDesigned) {
    bool isOutlineDoubtful = false;
    for (const model::Document* step : isAsDesigned ? std::vector<const model::Document*>() : index.tree.steps) {
        const bool isBoard = step == index.board.get();
        const model::MilledBoard milled = isBoard ? model::findMilled(*step, {}, base::Progress())
                                                  : model::findInCutouts(*step, {}, base::Progress());
        isOutlineDoubtful = isOutlineDoubtful || milled.isOutlineDoubtful;
        request.milled.push_back(elementsOf(milled));
    }
    ASSIGN_OR_RETURN(Section section, model::makeSection(index, request));
    if (isOutlineDoubtful) {
        section.notes.emplace_back(
            "more copper lies beyond the board outline than within; the section shows all of it, as if the outline "
            "were not that of the board");
    }
    return section;
}

base::Result<std::string> sectionText(const SectionArguments& arguments) {
    ConsoleProgress console;
    ASSIGN_OR_RETURN(const auto board, openDocument(arguments.board, console.progress()));
    ASSIGN_OR_RETURN(const auto request, requestFor(*board, arguments));
    ASSIGN_OR_RETURN(const auto index, model::indexBoard(board, console.progress()));
    ASSIGN_OR_RETURN(const Section section, sectionOf(*index, request, arguments.isAsDesigned));
    for (const std::string& note : section.notes) {
        std::fprintf(stderr, "%s\n", note.c_str());
    }
    return arguments.format == "json" ? sectionJson(*index, section)
           : arguments.format == "csv"
               ? model::sectionCsv(*index, section)
               : model::sectionSvg(*board, section, {coloursOf(*board), arguments.heightTimes, arguments.scale});
}

}  // namespace

Outcome runSection(const SectionArguments& arguments) {
    if (arguments.format != "svg" && (arguments.scale != 0.0 || arguments.heightTimes != 0.0)) {
        return base::Error{ErrorCode::BadUsage, "--scale and --height-times are of drawings: they need --format svg"};
    }
    ASSIGN_OR_RETURN(const std::string text, sectionText(arguments));
    std::fwrite(text.data(), 1, text.size(), stdout);
    return int{kDone};
}

}  // namespace app
