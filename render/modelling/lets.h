#pragma once

#include <cstdint>
#include <functional>
#include <glm/glm.hpp>
#include <span>
#include <vector>

#include "model/board/document.h"
#include "render/modelling/board_frame.h"
#include "render/modelling/round_holes.h"
#include "shaders/shared/board.h"

namespace render {

/// The lets of one layer as its elements have them, and the order in which they are drawn.
struct LayerLets {
    std::vector<shader::Let> lets;
    std::vector<std::uint32_t> order;      ///< rows of `lets` along a Morton curve, those of milled elements last
    std::size_t wholeCount = 0;            ///< so many of `order` are of elements that are not milled
    std::uint32_t zeroWidthTracks = 0;     ///< tracks without a width: nothing to draw
    std::uint32_t firstZeroWidthLine = 0;  ///< line of the first one in the layer's file
};

[[nodiscard]] Box2 boxOf(const shader::Let& let);

/// The round holes of a shape that lets fill in.
using HolesOfShape = std::function<std::span<const RoundHole>(model::ShapeId)>;

/// Which elements a fabricator mills, in part or altogether (model/solids/milling.h).
using IsMilled = std::function<bool(model::ElementId)>;

/// Lets for all lines, arcs, circles and trails of a layer (paper: "Procedural"), and for round holes of its areas. A
/// trail gives one let per edge with its element's id; an arc is split so that `kArcFineChords` chords stay within
/// `chordToleranceNm`. Positions are mm from `origin`.
[[nodiscard]] LayerLets makeLets(const model::Document& document, model::LayerId layer, model::Point origin,
                                 double chordToleranceNm, const HolesOfShape& holesOf = {},
                                 const IsMilled& isMilled = {});

/// How many clusters a layer's lets are cut into.
[[nodiscard]] std::size_t clusterCount(const LayerLets& made);

/// Writes a layer's lets in their order, and its clusters, to as many rows as they take. `firstLet` is the row that the
/// first of `lets` has on the board.
void placeLets(const LayerLets& made, model::LayerId layer, std::uint32_t firstLet, std::span<shader::Let> lets,
               std::span<shader::Cluster> clusters);

}  // namespace render
