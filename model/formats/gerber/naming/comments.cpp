#include <algorithm>
#include <vector>

#include "model/formats/gerber/naming/file_role.h"
#include "model/formats/gerber/text/words.h"

namespace model::gerber {

namespace {

using Kind = FileRole::Kind;

/// Allegro lists the classes that a film shows: "Layer:  ETCH/TOP", "Layer:  PIN/SOLDERMASK_TOP".
struct AllegroClasses {
    int etch = 0;
    int masks = 0;
    int pastes = 0;
    int silks = 0;
    int assemblies = 0;
    int drawings = 0;
    int tables = 0;  ///< of holes and layers: what only fabrication drawings show
    int outlines = 0;
    std::string etchName;
    std::vector<std::string> keepouts;  ///< copper layers, as films with keepouts list them: from the bottom
    LayerSide side = LayerSide::None;
    bool isNegative = false;  ///< "Mode:      Negative": what is drawn is left out of a plane
};

LayerSide sideOf(std::string_view name) {
    return name.find("TOP") != std::string_view::npos || name.find("PRIMARY") != std::string_view::npos ? LayerSide::Top
           : name.find("BOTTOM") != std::string_view::npos || name.find("SECONDARY") != std::string_view::npos
               ? LayerSide::Bottom
               : LayerSide::None;
}

void readAllegro(std::string_view text, AllegroClasses& classes) {
    const std::size_t slash = text.find('/');
    const std::string layer = upperCase(trimmed(text.substr(slash + 1)));
    const std::string kind = upperCase(trimmed(text.substr(0, slash)));
    const auto has = [&](std::string_view word) { return layer.find(word) != std::string::npos; };
    if (kind == "ETCH" || kind == "CONDUCTOR") {
        ++classes.etch;
        classes.etchName = layer;
    }
    if (kind == "VIA KEEPOUT" && layer != "ALL") {
        classes.keepouts.push_back(layer);
    }
    classes.masks += has("SOLDERMASK") ? 1 : 0;
    classes.pastes += has("PASTEMASK") ? 1 : 0;
    classes.silks += has("SILKSCREEN") || has("AUTOSILK") ? 1 : 0;
    classes.assemblies += has("ASSEMBLY") ? 1 : 0;
    classes.drawings += kind == "DRAWING FORMAT" || (kind == "MANUFACTURING" && !has("AUTOSILK")) ? 1 : 0;
    classes.tables += has("NCLEGEND") || has("NCDRILL_LEGEND") || has("XSECTION_CHART") || has("STACKUP") ? 1 : 0;
    classes.outlines += has("DESIGN_OUTLINE") || layer == "OUTLINE" || has("CUTOUT") ? 1 : 0;
    const bool isSided = has("SOLDERMASK") || has("PASTEMASK") || has("SILK") || has("ASSEMBLY");
    if (isSided && classes.side == LayerSide::None) {
        classes.side = sideOf(layer);
    }
}

std::optional<FileRole> roleOf(const AllegroClasses& classes) {
    FileRole role;
    role.source = RoleSource::Comment;
    role.side = classes.side;
    const bool isAssembly = classes.assemblies > 0 && classes.assemblies >= classes.silks;
    // Any film may have a frame and a title; one that shows nothing else, or tables, is a drawing.
    const bool isOfBoard = classes.masks > 0 || classes.pastes > 0 || classes.silks > 0;
    const bool isDrawing = classes.etch == 0 && (classes.tables > 0 || (classes.drawings > 1 && !isOfBoard));
    if (isAssembly || isDrawing) {
        role.kind = Kind::Document;
    } else if (classes.etch == 1) {
        role.kind = Kind::Copper;
        role.isNegative = classes.isNegative;
        role.side = sideOf(classes.etchName);
        role.side = role.side == LayerSide::None ? LayerSide::Inner : role.side;
        const auto at = std::ranges::find(classes.keepouts, classes.etchName);
        const bool isListed =
            at != classes.keepouts.end() && classes.keepouts.front() == "BOTTOM" && classes.keepouts.back() == "TOP";
        if (isListed) {
            role.order = static_cast<int>(classes.keepouts.end() - at);
            role.isCountedFromTop = true;
        }
    } else if (classes.etch > 1) {
        return std::nullopt;
    } else if (classes.masks > 0) {
        role.kind = Kind::SolderMask;
    } else if (classes.pastes > 0) {
        role.kind = Kind::Paste;
    } else if (classes.silks > 0) {
        role.kind = Kind::Legend;
    } else if (classes.outlines > 0) {
        role.kind = Kind::Profile;
    } else {
        return std::nullopt;
    }
    return role;
}

}  // namespace

std::optional<FileRole> roleOfComments(const Image& image) {
    AllegroClasses classes;
    for (const std::string& comment : image.comments) {
        const std::string_view text = comment;
        if (text.starts_with("Layer_Physical_Order=")) {  // Altium
            FileRole role;
            role.source = RoleSource::Comment;
            role.kind = Kind::Copper;
            role.order = parseInteger(text.substr(21)).value_or(0);
            role.isCountedFromTop = true;
            role.side = role.order == 1 ? LayerSide::Top : LayerSide::None;
            return role;
        }
        if (text.starts_with("Layer:") && text.find('/') != std::string_view::npos) {
            readAllegro(text.substr(6), classes);
        }
        classes.isNegative = classes.isNegative || (text.starts_with("Mode:") && holds(text, "Negative"));
    }
    if (const std::optional<FileRole> role = roleOf(classes)) {
        return role;
    }
    // EasyEDA: "Layer: TopSolderMaskLayer"; Mentor: "Layer : EtchLayerTop.gdo"; Fusion: %INTop Copper*%.
    for (const std::string& comment : image.comments) {
        const std::string_view text = comment;
        const bool isLayer = text.starts_with("Layer") && text.find(':') != std::string_view::npos &&
                             text.find('/') == std::string_view::npos;
        if (isLayer) {
            std::optional<FileRole> role = roleOfName(std::string(trimmed(text.substr(text.find(':') + 1))) + ".x");
            if (role) {
                role->source = RoleSource::Comment;
                return role;
            }
        }
    }
    return std::nullopt;
}

}  // namespace model::gerber
