#pragma once

#include <QColor>
#include <cstddef>

#include "render/scene/element_state.h"

namespace ui {

/// Which of render::kHighlightColours what lies near the selection has (the clearance lens), beside so many highlighted
/// nets: cyan, or one that none of them has.
[[nodiscard]] constexpr std::size_t nearbyHighlight(std::size_t highlightedNets) {
    constexpr std::size_t kCyan = 2;
    return highlightedNets > kCyan && highlightedNets < render::kHighlightColours.size() ? highlightedNets : kCyan;
}

/// Its outline, as the painter draws it, and that of what is selected; both with a dark edge.
inline constexpr QColor kNearbyOutline{90, 235, 255};
inline constexpr QColor kSelectedOutline{255, 221, 87};

}  // namespace ui
