#include "model/odb/holes.h"

#include <cstdlib>

namespace model::odb {

namespace {

/// Tool and symbol sizes are rounded apart, for example 7.988 mil and 202.9 µm.
constexpr Nm kSizeTolerance = 1'000;

enum class Plating { Unknown, Plated, Bare, Mixed };

Plating platingOf(const Tool& tool) {
    if (tool.type == "NON_PLATED") {
        return Plating::Bare;
    }
    return tool.type == "PLATED" || tool.type == "VIA" ? Plating::Plated : Plating::Unknown;
}

Plating join(Plating a, Plating b) {
    if (a == Plating::Unknown || a == b) {
        return b;
    }
    return b == Plating::Unknown ? a : Plating::Mixed;
}

}  // namespace

bool HoleRules::isPlated(const Feature& feature, Nm size, bool& isAssumed) const {
    if (feature.drill >= 0) {
        return feature.drill != 1;
    }
    Plating sameSize = Plating::Unknown;
    Plating all = Plating::Unknown;
    for (const Tool& tool : m_tools) {
        const Nm toolSize = tool.finishedSize > 0 ? tool.finishedSize : tool.drillSize;
        all = join(all, platingOf(tool));
        sameSize = std::abs(toolSize - size) <= kSizeTolerance ? join(sameSize, platingOf(tool)) : sameSize;
    }
    const bool isSizeClear = sameSize == Plating::Plated || sameSize == Plating::Bare;
    const Plating found = isSizeClear ? sameSize : all;
    if (found == Plating::Plated || found == Plating::Bare) {
        return found == Plating::Plated;
    }
    isAssumed = true;
    return m_type == LayerType::Drill;
}

Nm HoleRules::openSize(Nm size, bool isPlated) {
    if (!isPlated) {
        return size;
    }
    return size > 4 * kPlating ? size - 2 * kPlating : size / 2;
}

}  // namespace model::odb
