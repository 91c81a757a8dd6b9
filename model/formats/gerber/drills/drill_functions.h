#pragma once

#include <string_view>

#include "model/formats/gerber/image/image.h"

/// What holes are by the attribute .AperFunction of their tools or apertures, in Excellon and in Gerber alike.
namespace model::gerber {

/// By the words PLATED, NON_PLATED, PTH and NPTH of a text, in any case.
[[nodiscard]] Plating platingOfWords(std::string_view text);

/// "ViaDrill", or as drill files write it "Plated,PTH,ViaDrill". A back-drill takes plating away and has none. What
/// says nothing of plating, as ComponentDrill, leaves it to the function of the file.
[[nodiscard]] Plating platingOfFunction(std::string_view function);

/// Gives features of a layer of holes that do not say it the plating of their function.
void plateByFunction(Image& image);

/// Which of the holes are back-drills.
enum class BackDrills : std::uint8_t { None, Some, All };
[[nodiscard]] BackDrills backDrillsIn(const Image& image);

}  // namespace model::gerber
