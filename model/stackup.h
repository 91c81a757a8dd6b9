#pragma once

#include <optional>
#include <span>
#include <vector>

#include "model/document.h"

namespace model {

/// What a job says about the thickness of one layer; everything may be missing. Values of other layers of the job must
/// not be put here.
struct ThicknessHint {
    std::optional<double> copperNm;      ///< copper layers: own thickness
    std::optional<double> dielectricNm;  ///< dielectric rows: own thickness
    std::optional<double>
        dielectricBelowNm;  ///< copper layers: the dielectric under it, where the job has no row for that
};

/// Defaults where a job is silent; each use is told in the diagnostics.
inline constexpr Nm kDefaultBoard = 1'600'000;
inline constexpr Nm kDefaultCopper = 35'000;
inline constexpr Nm kDefaultMask = 25'000;
inline constexpr Nm kDefaultPaste = 100'000;
inline constexpr Nm kDefaultSilk = 15'000;
/// Thickness of a dielectric when the board's thickness leaves no room for it.
inline constexpr Nm kLeastDielectric = 50'000;
/// Beyond these a thickness is taken for a mistake of the job: 10 oz copper is 350 µm, backplanes are 10 mm thick.
inline constexpr double kMostCopper = 500'000;
inline constexpr double kMostDielectric = 10'000'000;
inline constexpr double kLeastThickness = 1'000;

/// Gives every layer its z, thickness, side and source. `layers` come in document order: the physical ones (copper,
/// dielectric, mask, paste, silk) from the top first; `hints` has one entry per layer. z = 0 is the lower face of the
/// lowest copper; surface layers lie outside of the outer copper; drills and routs must have their spans set and reach
/// from the lower face of the lowest to the upper face of the highest copper they pass; everything else is a plane
/// above or below the board. Returns the thickness from the lowest to the highest copper face; a board of one copper
/// layer has its laminate below z = 0, and the laminate's thickness is returned.
Nm buildStackup(std::vector<Layer>& layers, std::span<const ThicknessHint> hints, std::optional<double> boardNm,
                Diagnostics& diagnostics);

}  // namespace model
