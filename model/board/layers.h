#pragma once

#include <cstdint>
#include <vector>

#include "model/board/document.h"

/// What the layers of a job are to a person: which kind each is listed under, and which of them belong to a task.
namespace model {

/// In the order they are listed.
enum class LayerGroup : std::uint8_t {
    Copper,
    SolderMask,
    Paste,
    Silkscreen,
    Drill,       ///< and routing
    Components,  ///< their bodies, and where they are placed
    Mechanical,  ///< outline, substrate, stiffeners, and drawings of them
    Dielectric,
    Other
};
inline constexpr std::size_t kLayerGroupCount = static_cast<std::size_t>(LayerGroup::Other) + 1;

/// By type. Where the job's type says too little (documents) or too much (drawings that are exported as silkscreen), by
/// the name, of which there are habits of KiCad, Altium and Allegro.
[[nodiscard]] LayerGroup groupOf(const Layer& layer);

/// Is the layer a drawing that the job calls silkscreen: a DXF overlay, an assembly drawing? It is not printed.
[[nodiscard]] bool isDrawingAsSilkscreen(const Layer& layer);

/// Of several silkscreens on one side the one next to the board is the print; the others are assembly drawings and
/// placement outlines that would cover the board. One entry per layer: is it a print? Layers are in physical order.
[[nodiscard]] std::vector<bool> silkscreenPrints(const Document& document);

/// On which face of the board an outer layer lies, from the job's word or the order of layers: the first copper layer
/// and what is above it at the top, the last one and what is below at the bottom. Inner for copper in between, None for
/// boards without copper.
[[nodiscard]] LayerSide faceOf(const Document& document, LayerId layer);
/// The first copper layer, or the last one; none on boards without copper. On a board with one it is both.
[[nodiscard]] LayerId outerCopper(const Document& document, LayerSide face);

/// The inner copper or dielectric that a body stands on, in a zone of a rigid-flex board that lacks what lies outside
/// of it; none: it stands on the outermost layer of its side.
[[nodiscard]] LayerId mountingLayerOf(const Document& document, const Body& body);

/// Layers that belong together.
enum class LayerPreset : std::uint8_t {
    All,
    None,
    Copper,
    Top,     ///< outer copper with what is seen on it, holes and the board
    Bottom,  ///< likewise
    Inner,   ///< inner copper and holes
    Assembly,
    Fabrication
};

/// One entry per layer: does it belong to the preset?
[[nodiscard]] std::vector<bool> layersOf(const Document& document, LayerPreset preset);

}  // namespace model
