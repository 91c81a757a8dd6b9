#include "model/formats/gerber/drills/drill_functions.h"

#include <algorithm>

#include "model/formats/gerber/text/words.h"

namespace model::gerber {

namespace {

constexpr std::string_view kBackDrill = "BackDrill";

/// Empty if the feature has none.
std::string_view functionOf(const Image& image, const formats::DrawnFeature& feature) {
    if (feature.attributes < 0) {
        return {};
    }
    const formats::Words& words = image.attributes[static_cast<std::size_t>(feature.attributes)];
    const auto found = std::ranges::find(words, ".AperFunction", &formats::Words::value_type::first);
    return found == words.end() ? std::string_view() : std::string_view(found->second);
}

}  // namespace

Plating platingOfWords(std::string_view text) {
    const bool isNon =
        holds(text, "NON_PLATED") || holds(text, "NON-PLATED") || holds(text, "NONPLATED") || holds(text, "NPTH");
    return isNon                                         ? Plating::NonPlated
           : holds(text, "PLATED") || holds(text, "PTH") ? Plating::Plated
                                                         : Plating::NotSaid;
}

Plating platingOfFunction(std::string_view function) {
    return holds(function, "ViaDrill")   ? Plating::Via
           : holds(function, kBackDrill) ? Plating::NonPlated
                                         : platingOfWords(function);
}

void plateByFunction(Image& image) {
    for (formats::DrawnFeature& feature : image.features) {
        if (feature.plating == Plating::NotSaid) {
            feature.plating = platingOfFunction(functionOf(image, feature));
        }
    }
}

BackDrills backDrillsIn(const Image& image) {
    const auto count = static_cast<std::size_t>(std::ranges::count_if(
        image.features, [&](const auto& feature) { return holds(functionOf(image, feature), kBackDrill); }));
    return count == 0 ? BackDrills::None : count == image.features.size() ? BackDrills::All : BackDrills::Some;
}

}  // namespace model::gerber
