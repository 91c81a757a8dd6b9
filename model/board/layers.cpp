#include "model/board/layers.h"

#include <algorithm>
#include <array>
#include <span>
#include <string>
#include <string_view>

#include "model/base/ascii.h"

namespace model {

namespace {

bool holdsAny(std::string_view name, std::span<const std::string_view> parts) {
    return std::ranges::any_of(parts,
                               [name](std::string_view part) { return name.find(part) != std::string_view::npos; });
}

/// KiCad calls assembly drawings F.Fab and B.Fab; Allegro's are AST and ASB.
bool isAssemblyDrawing(std::string_view name) {
    constexpr std::string_view kParts[] = {"assembl", "assy",  "asstop", "assbot",
                                           "ass_",    "f.fab", "b.fab",  "placement"};
    return holdsAny(name, kParts) || name.starts_with("ast") || name.starts_with("asb");
}

bool isFabricationDrawing(std::string_view name) {
    constexpr std::string_view kParts[] = {"fab", "drill_drawing", "drill_guide", "dimension"};
    return holdsAny(name, kParts) && !isAssemblyDrawing(name);
}

bool isMechanicalDrawing(std::string_view name) {
    constexpr std::string_view kParts[] = {"mech",      "outline", "edge",  "margin",   "keep",
                                           "courtyard", "3d",      "shape", "stiffener"};
    return holdsAny(name, kParts);
}

LayerGroup groupOfType(LayerType type) {
    switch (type) {
        case LayerType::Signal:
        case LayerType::PowerGround:
        case LayerType::Mixed: return LayerGroup::Copper;
        case LayerType::SolderMask: return LayerGroup::SolderMask;
        case LayerType::SolderPaste: return LayerGroup::Paste;
        case LayerType::SilkScreen: return LayerGroup::Silkscreen;
        case LayerType::Drill:
        case LayerType::Rout: return LayerGroup::Drill;
        case LayerType::Component:
        case LayerType::ComponentBody: return LayerGroup::Components;
        case LayerType::Mask:
        case LayerType::Profile:
        case LayerType::Body: return LayerGroup::Mechanical;
        case LayerType::Dielectric: return LayerGroup::Dielectric;
        case LayerType::ConductivePaste:
        case LayerType::Document:
        case LayerType::Other: return LayerGroup::Other;
    }
    return LayerGroup::Other;
}

bool isOutline(const Layer& layer) {
    return layer.type == LayerType::Profile;
}

/// What is seen of one side: its copper, the mask on it, its print, and what goes through the board.
bool isSeenFrom(LayerSide side, const Layer& layer, bool isPrint) {
    const LayerGroup group = groupOf(layer);
    const bool isMask = group == LayerGroup::SolderMask && layer.isSynthetic;
    const bool isOfSide = layer.side == side && (layer.isCopper() || isMask || isPrint);
    return isOfSide || group == LayerGroup::Drill || layer.type == LayerType::Body || isOutline(layer);
}

bool isForAssembly(const Layer& layer, bool isPrint) {
    return isPrint || groupOf(layer) == LayerGroup::Components || isOutline(layer) ||
           isAssemblyDrawing(base::lowerCase(layer.name));
}

/// What a fabricator makes, in the layers the job draws it with.
bool isForFabrication(const Layer& layer, bool isPrint) {
    const LayerGroup group = groupOf(layer);
    const bool isMade = layer.isCopper() || group == LayerGroup::SolderMask || group == LayerGroup::Drill;
    const bool isDrawing = group == LayerGroup::Other || group == LayerGroup::Mechanical;
    return ((isMade || isPrint) && !layer.isSynthetic) || isOutline(layer) ||
           (isDrawing && isFabricationDrawing(base::lowerCase(layer.name)));
}

bool belongsTo(LayerPreset preset, const Layer& layer, bool isPrint) {
    switch (preset) {
        case LayerPreset::All: return true;
        case LayerPreset::None: return false;
        case LayerPreset::Copper: return layer.isCopper();
        case LayerPreset::Top: return isSeenFrom(LayerSide::Top, layer, isPrint);
        case LayerPreset::Bottom: return isSeenFrom(LayerSide::Bottom, layer, isPrint);
        case LayerPreset::Inner:
            return (layer.isCopper() && layer.side == LayerSide::Inner) || groupOf(layer) == LayerGroup::Drill ||
                   isOutline(layer);
        case LayerPreset::Assembly: return isForAssembly(layer, isPrint);
        case LayerPreset::Fabrication: return isForFabrication(layer, isPrint);
    }
    return false;
}

}  // namespace

bool isDrawingAsSilkscreen(const Layer& layer) {
    constexpr std::string_view kParts[] = {"dxf", "dwg", "courtyard"};
    const std::string name = base::lowerCase(layer.name);
    return layer.type == LayerType::SilkScreen && (holdsAny(name, kParts) || isAssemblyDrawing(name));
}

LayerGroup groupOf(const Layer& layer) {
    const LayerGroup group = isDrawingAsSilkscreen(layer) ? LayerGroup::Other : groupOfType(layer.type);
    const bool isMechanical = group == LayerGroup::Other && isMechanicalDrawing(base::lowerCase(layer.name));
    return isMechanical ? LayerGroup::Mechanical : group;
}

std::vector<bool> silkscreenPrints(const Document& document) {
    std::vector<bool> prints(document.layers.size());
    std::size_t top = prints.size();
    bool hasBottom = false;
    for (std::size_t row = 0; row < prints.size(); ++row) {
        const Layer& layer = document.layers[row];
        if (groupOf(layer) != LayerGroup::Silkscreen || layer.context != LayerContext::Board) {
            continue;
        }
        if (layer.side != LayerSide::Bottom) {
            top = row;  // the last one before the copper
        } else if (!hasBottom) {
            hasBottom = true;
            prints[row] = true;
        }
    }
    if (top < prints.size()) {
        prints[top] = true;
    }
    return prints;
}

LayerId mountingLayerOf(const Document& document, const Body& body) {
    return document.layer(document.elements.layer[body.element.row()]).spanTop;
}

std::vector<bool> layersOf(const Document& document, LayerPreset preset) {
    const std::vector<bool> prints = silkscreenPrints(document);
    std::vector<bool> layers;
    for (std::size_t row = 0; row < prints.size(); ++row) {
        layers.push_back(belongsTo(preset, document.layers[row], prints[row]));
    }
    return layers;
}

LayerSide faceOf(const Document& document, LayerId layer) {
    const LayerId top = outerCopper(document, LayerSide::Top);
    const LayerId bottom = outerCopper(document, LayerSide::Bottom);
    if (!top.isValid()) {
        return LayerSide::None;
    }
    const LayerSide said = document.layer(layer).side;
    const bool isSaid = said == LayerSide::Top || said == LayerSide::Bottom;
    if (isSaid && !(document.layer(layer).isCopper() && top != bottom)) {
        return said;
    }
    return layer <= top ? LayerSide::Top : layer >= bottom ? LayerSide::Bottom : LayerSide::Inner;
}

LayerId outerCopper(const Document& document, LayerSide face) {
    LayerId found;
    for (std::size_t row = 0; row < document.layers.size(); ++row) {
        if (document.layers[row].isCopper() && (face == LayerSide::Bottom || !found.isValid())) {
            found = LayerId{row};
        }
    }
    return found;
}

}  // namespace model
