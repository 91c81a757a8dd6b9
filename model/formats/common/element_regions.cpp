#include "model/formats/common/element_regions.h"

#include "model/figures/element_polygons.h"
#include "model/geometry/region.h"
#include "model/solids/shells/drawn_outlines.h"

namespace model::formats {

RegionBoolean regionsOf(const Document& document, ElementId element) {
    ElementOutlines outlines = drawnOutlinesOf(document, element);
    if (!outlines.regions.empty()) {
        return {std::move(outlines.regions), true};
    }
    std::vector<EdgeLoops> chords = model::regionsOf(discretise(document, element, kBooleanChords));
    const bool isNothing = chords.empty();
    return {std::move(chords), isNothing};
}

}  // namespace model::formats
