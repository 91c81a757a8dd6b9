#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "model/board/document.h"

/// What the pieces of a section are made of, as far as the job says.
namespace model {

enum class SectionMaterial : std::uint8_t {
    Copper,
    Plating,  ///< of holes
    SolderMask,
    Paste,
    Silkscreen,
    Core,
    Prepreg,
    Polyimide,
    Adhesive,
    Dielectric,  ///< the job does not say which
    Coverlay,
    Stiffener,
    Solder,    ///< between a pad and what stands on it
    Part,      ///< the body of a component
    Terminal,  ///< its leads, terminals and pins
    Other
};
inline constexpr std::size_t kSectionMaterialCount = static_cast<std::size_t>(SectionMaterial::Other) + 1;

[[nodiscard]] const char* toString(
    SectionMaterial material);  ///< "copper", "solder mask", "dielectric, type not stated"
/// 0xRRGGBB of materials that look the same on all layers; none: they have the colour of their layer.
[[nodiscard]] std::optional<std::uint32_t> colourOf(SectionMaterial material);
[[nodiscard]] bool isDielectric(SectionMaterial material);
/// What is drawn first lies beneath: dielectrics, then parts and their terminals, then all else.
[[nodiscard]] int drawOrderOf(SectionMaterial material);

/// Of what is drawn on a layer.
[[nodiscard]] SectionMaterial materialOf(const Layer& layer);
/// The same, coverlay told apart from solder mask where we added the layer.
[[nodiscard]] SectionMaterial materialOf(const Document& document, LayerId layer);
/// Of a row of the stackup: what the job calls its type, form and material.
[[nodiscard]] SectionMaterial materialOf(const Document& document, const StackupRow& row);

/// A dielectric over the height that it fills.
struct DielectricBand {
    Nm bottom = 0;
    Nm top = 0;
    SectionMaterial material = SectionMaterial::Dielectric;
    std::size_t row = 0;  ///< of Stackup::rows; at its own thickness it fills no space beside copper
};

/// The substrate of a board from the top, where these rows of Stackup::rows are. Beside copper between two dielectrics
/// that are neighbours lies the resin of the prepreg or adhesive among them, or else of the upper one; beside copper
/// that a dielectric is missing next to, as in the flexible part of a rigid-flex board, is none. Empty for boards
/// without a stackup.
[[nodiscard]] std::vector<DielectricBand> dielectricBandsOf(const Document& document, const std::vector<bool>& has);

}  // namespace model
