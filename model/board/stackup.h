#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "model/board/document.h"

/// Heights of the layers, from what a job says and defaults for what it does not.
namespace model {

/// Defaults where a job is silent; each use is reported in the diagnostics.
inline constexpr Nm kDefaultBoard = 1'600'000;
inline constexpr Nm kDefaultCopper = 35'000;
inline constexpr Nm kDefaultMask = 25'000;
inline constexpr Nm kDefaultPaste = 100'000;
inline constexpr Nm kDefaultSilk = 15'000;
inline constexpr Nm kDefaultCoverlay = 50'000;
inline constexpr Nm kDefaultAdhesive = 50'000;
inline constexpr Nm kDefaultStiffener = 200'000;
/// Thickness of a dielectric when the board's thickness leaves no room for it.
inline constexpr Nm kLeastDielectric = 50'000;
/// Beyond these a thickness is taken for a mistake of the job: 10 oz copper is 350 µm, backplanes are 10 mm thick.
inline constexpr double kMostCopper = 500'000;
inline constexpr double kMostDielectric = 10'000'000;
inline constexpr double kLeastThickness = 1'000;
/// By how much programs differ about what an ounce of copper is: 34 to 35.8 µm (odb-notes, Stack).
inline constexpr double kOunceTolerance = 0.035;

/// Gives every layer its z, thickness, side and source, and returns the stackup's rows from the top. `layers` come in
/// document order: the physical ones (copper, dielectric, mask, paste, silk) from the top first; `facts.layers` has one
/// entry per layer. z = 0 is the lower face of the lowest copper; surface layers lie outside of the outer copper;
/// drills and routs must have their spans set and reach from the lower face of the lowest to the upper face of the
/// highest copper they pass; everything else, layers without material (LayerFacts::hasMaterial) too, is a plane above
/// or below the board. A board of one copper layer has its substrate below z = 0, or above the copper where that is the
/// bottom layer, by its side, its name or where the job's dielectrics lie; holes pass both. Coverlays, adhesives and
/// stiffeners lie one on the other, from the board outwards; between copper layers they lie on the flexible copper next
/// to them.
///
/// What the user set counts most, then the job's own number; what is left of the job's board thickness is shared by
/// those dielectrics (or, where all of them are known, copper layers) that have no number; defaults come last. Shares
/// of copper follow from what the job says of dielectrics, not from what the user sets. What replaces an absurd number
/// of the job, and shares of a board's thickness that is absurd, are Source::Assumed. What is implausible in the result
/// is checked apart (model/board/stackup_checks.h).
[[nodiscard]] Stackup buildStackup(std::vector<Layer>& layers, StackupFacts facts, Diagnostics& diagnostics);

[[nodiscard]] bool isCopper(const StackupRow& row);
/// From the lowest to the highest face of copper and what lies between; the substrate of a single copper layer for
/// itself.
[[nodiscard]] Nm thicknessOf(const Stackup& stackup);

/// The dielectrics that the one copper layer at `copper` lies on: those below it, or else those above it.
struct SubstrateRows {
    std::size_t first = 0;
    std::size_t end = 0;  ///< first: there are none
    [[nodiscard]] bool has(std::size_t row) const { return row >= first && row < end; }
};
[[nodiscard]] SubstrateRows substrateOf(const std::vector<StackupRow>& rows, std::size_t copper);

/// The row of this name, in any case; nullptr if there is none.
[[nodiscard]] const StackupRow* findRow(const Stackup& stackup, std::string_view name);

/// Copper weight of a row in ounces per square foot with its source: as the job states it, unless the user set the
/// thickness; else from the thickness (Derived, or Assumed as the thickness is). Nothing for other rows.
struct CopperWeight {
    double oz = 0.0;
    Source source = Source::Job;
};
[[nodiscard]] std::optional<CopperWeight> copperWeightOf(const StackupRow& row);

}  // namespace model
