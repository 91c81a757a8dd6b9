#include "model/section/section_notes.h"

#include <algorithm>
#include <string>
#include <vector>

#include "model/board/board_face.h"
#include "model/board/holes.h"
#include "model/board/local_stack.h"
#include "model/section/landing_via.h"
#include "model/text/formatting.h"

namespace model {

namespace {

/// Names of the cut layers that have a property.
template <class Has>
std::string cutLayers(const Document& board, const std::vector<SectionPiece>& pieces, Has has) {
    std::vector<bool> hasSection(board.layers.size());
    for (const SectionPiece& piece : pieces) {
        hasSection[piece.layer.row()] = true;
    }
    std::vector<std::string> names;
    for (std::size_t row = 0; row < board.layers.size(); ++row) {
        if (hasSection[row] && has(board.layers[row])) {
            names.push_back(board.layers[row].name);
        }
    }
    return joined(names);
}

bool has(const Section& section, SectionMaterial material) {
    return std::ranges::find(section.pieces, material, &SectionPiece::material) != section.pieces.end();
}

}  // namespace

void addNotes(const Document& board, const CutFindings& findings, Section& section) {
    if (!findings.wallless.empty()) {
        section.notes.push_back("plated holes without a known plating thickness, drawn without it: " +
                                std::to_string(findings.wallless.size()));
    }
    if (!findings.milled.empty()) {
        section.notes.push_back("left out as milled away beyond the board outline or in cut-outs, parts of elements: " +
                                std::to_string(findings.milled.size()));
    }
    if (section.pieces.empty() && section.bores.empty()) {
        section.notes.push_back("the line meets nothing of the board");
    }
    // Holes and the substrate follow from other layers, bodies of components have heights of their own.
    const auto hasOwn = [](const Layer& l) {
        return !isHoles(l.type) && l.type != LayerType::Body && l.type != LayerType::ComponentBody;
    };
    const std::string flat =
        cutLayers(board, section.pieces, [&](const Layer& l) { return l.thickness == 0 && hasOwn(l); });
    if (!flat.empty()) {
        section.notes.push_back("without a thickness, drawn as a line: " + flat);
    }
    const std::string assumed = cutLayers(board, section.pieces, [&](const Layer& l) {
        return l.thickness > 0 && l.thicknessSource == Source::Assumed && hasOwn(l);
    });
    if (!assumed.empty()) {
        section.notes.push_back("thickness assumed: " + assumed);
    }
}

void addAssumptions(const Document& board, const CutFindings& findings, Section& section) {
    std::vector<std::string> made;
    const auto add = [&made](bool isMade, const std::string& what) {
        if (isMade) {
            made.push_back(what);
        }
    };
    add(has(section, SectionMaterial::SolderMask),
        formatted("solder mask is %.0f %% as thick on copper", 100 * kMaskOnCopper));
    const auto isFilm = [&](const SectionPiece& piece) { return isLaidOn(board.layer(drawnBy(board, piece.layer))); };
    add(std::ranges::any_of(section.pieces, isFilm),
        "coverlay and adhesive fill the space beside copper and are level outside");
    std::vector<std::string> undrawn;
    for (const LayerId layer : findings.undrawn) {
        undrawn.push_back(board.layer(layer).name);
    }
    add(!undrawn.empty(), "all over the zones that have them, as the job draws nothing of them: " + joined(undrawn));
    add(findings.landed > 0,
        formatted("laser vias narrow to %.0f %% at the target pad and are plated there", 100 * kViaTaper));
    const auto isResin = [&](const SectionPiece& piece) {
        const StackupRow* row = stackupRowOf(board, piece);
        return row != nullptr && piece.top - piece.bottom > row->thickness;
    };
    add(std::ranges::any_of(section.pieces, isResin), "dielectrics fill the space beside inner copper");
    add(has(section, SectionMaterial::Plating) && !board.stackup.rows.empty(),
        "copper thicknesses include surface plating");
    add(has(section, SectionMaterial::Part) || has(section, SectionMaterial::Terminal),
        "shapes of parts, standing on mask and silkscreen, and their solder");
    if (!made.empty()) {
        section.notes.push_back("assumed: " + joined(made, "; "));
    }
}

}  // namespace model
