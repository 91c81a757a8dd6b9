#include "model/section/section_material.h"

#include <algorithm>
#include <array>
#include <string>

#include "model/base/ascii.h"

namespace model {

namespace {

struct MaterialFacts {
    const char* name;
    std::optional<std::uint32_t> rgb;
    int order;
};

/// As in SectionMaterial. Dielectrics are told apart by lightness too.
constexpr std::array<MaterialFacts, kSectionMaterialCount> kMaterials{{
    {"copper", {}, 3},
    {"plating", {}, 3},
    {"solder mask", {}, 3},
    {"paste as printed", {}, 3},
    {"silkscreen", {}, 3},
    {"core", 0x4f6b57, 0},
    {"prepreg", 0x9bb89c, 0},
    {"polyimide", 0xc98a3a, 0},
    {"adhesive", 0xe6dcb4, 0},
    {"dielectric, type not stated", 0x74857c, 0},
    {"coverlay", {}, 3},
    {"stiffener", {}, 3},
    {"solder", 0xa9b4be, 3},
    {"part", 0x34343a, 1},
    {"terminal", 0xdadde0, 2},
    {"other", {}, 3},
}};

bool holdsAny(const std::string& text, std::initializer_list<const char*> words) {
    return std::ranges::any_of(words, [&](const char* word) { return text.find(word) != std::string::npos; });
}

/// What fills the space beside copper is what flows when it is pressed; where that is not known, rather not a core.
int flowOf(SectionMaterial material) {
    return material == SectionMaterial::Prepreg || material == SectionMaterial::Adhesive ? 2
           : material == SectionMaterial::Dielectric                                     ? 1
                                                                                         : 0;
}

}  // namespace

const char* toString(SectionMaterial material) {
    return kMaterials[static_cast<std::size_t>(material)].name;
}

std::optional<std::uint32_t> colourOf(SectionMaterial material) {
    return kMaterials[static_cast<std::size_t>(material)].rgb;
}

int drawOrderOf(SectionMaterial material) {
    return kMaterials[static_cast<std::size_t>(material)].order;
}

SectionMaterial materialOf(const Layer& layer) {
    if (layer.use == LayerUse::Coverlay || layer.use == LayerUse::Stiffener || layer.use == LayerUse::Adhesive) {
        return layer.use == LayerUse::Coverlay    ? SectionMaterial::Coverlay
               : layer.use == LayerUse::Stiffener ? SectionMaterial::Stiffener
                                                  : SectionMaterial::Adhesive;
    }
    switch (layer.type) {
        case LayerType::Signal:
        case LayerType::PowerGround:
        case LayerType::Mixed: return SectionMaterial::Copper;
        case LayerType::Drill:
        case LayerType::Rout: return SectionMaterial::Plating;
        case LayerType::SolderMask: return SectionMaterial::SolderMask;
        case LayerType::SolderPaste:
        case LayerType::ConductivePaste: return SectionMaterial::Paste;
        case LayerType::SilkScreen: return SectionMaterial::Silkscreen;
        case LayerType::Dielectric:
        case LayerType::Body: return SectionMaterial::Dielectric;
        case LayerType::ComponentBody: return SectionMaterial::Part;
        default: return SectionMaterial::Other;
    }
}

SectionMaterial materialOf(const Document& document, const StackupRow& row) {
    const std::string words = base::lowerCase(row.material.type + ' ' + row.material.name + ' ' + row.material.form);
    const LayerUse use = row.layer.isValid() ? document.layer(row.layer).use : LayerUse::Plain;
    if (use == LayerUse::Adhesive || holdsAny(words, {"adhesive", "bondply", "bond ply"})) {
        return SectionMaterial::Adhesive;
    }
    if (use == LayerUse::Flex || holdsAny(words, {"polyimide", "kapton", "pyralux", "flex"})) {
        return SectionMaterial::Polyimide;
    }
    return holdsAny(words, {"prepreg"}) ? SectionMaterial::Prepreg
           : holdsAny(words, {"core"})  ? SectionMaterial::Core
                                        : SectionMaterial::Dielectric;
}

SectionMaterial materialOf(const Document& document, LayerId layer) {
    const Layer& own = document.layer(layer);
    const bool isCoverlay = own.openings.isValid() && document.layer(own.openings).use == LayerUse::Coverlay;
    return isCoverlay ? SectionMaterial::Coverlay : materialOf(own);
}

bool isDielectric(SectionMaterial material) {
    return material == SectionMaterial::Core || material == SectionMaterial::Prepreg ||
           material == SectionMaterial::Polyimide || material == SectionMaterial::Adhesive ||
           material == SectionMaterial::Dielectric;
}

std::vector<DielectricBand> dielectricBandsOf(const Document& document, const std::vector<bool>& has) {
    std::vector<DielectricBand> bands;
    bool isOpen = false;  // a dielectric is missing since the last one
    for (std::size_t i = 0; i < document.stackup.rows.size(); ++i) {
        const StackupRow& row = document.stackup.rows[i];
        if (row.type != LayerType::Dielectric || row.thickness <= 0) {
            continue;
        }
        if (!has[i]) {
            isOpen = true;
            continue;
        }
        DielectricBand band{row.z, row.z + row.thickness, materialOf(document, row), i};
        if (!bands.empty() && bands.back().bottom > band.top && !isOpen) {
            DielectricBand& above = bands.back();
            const bool isFromBelow = flowOf(band.material) > flowOf(above.material);
            isFromBelow ? band.top = above.bottom : above.bottom = band.top;
        }
        isOpen = false;
        bands.push_back(band);
    }
    return bands;
}

}  // namespace model
