#include "render/culling/hidden_layers.h"

#include <algorithm>
#include <cmath>

namespace render {
namespace {

using shader::LayerState;
using Role = LayerInSubstrate::Role;

/// Heights closer than this, mm, are one: a thousandth of the thinnest foil.
constexpr float kSameHeight = 1e-5F;
/// By so much of a pixel barrels reach below the surface, for the chords of their hole.
constexpr float kOverlapPx = 0.25F;

bool isVisible(const LayerState& state) {
    return (state.flags & shader::kLayerVisible) != 0;
}

bool isOpaque(const LayerState& state) {
    return isVisible(state) && (state.flags & shader::kLayerTranslucent) == 0;
}

/// From one height to another, seen from above: `top` is nearer to the viewer.
struct Block {
    float top = 0.0F;
    float bottom = 0.0F;
};

/// A layer's heights as one sees them from above; from below the world is flipped.
Block blockOf(const LayerState& state, bool isFromAbove) {
    return isFromAbove ? Block{state.z1, state.z0} : Block{-state.z0, -state.z1};
}

/// The opaque substrate, parts that lie on each other as one; from the top.
std::vector<Block> substrateOf(std::span<const LayerInSubstrate> layers, std::span<const LayerState> states,
                               bool isFromAbove) {
    std::vector<Block> parts;
    for (std::size_t i = 0; i < states.size(); ++i) {
        if (layers[i].role == Role::Substrate && isOpaque(states[i])) {
            parts.push_back(blockOf(states[i], isFromAbove));
        }
    }
    std::ranges::sort(parts, std::greater{}, &Block::top);
    std::vector<Block> blocks;
    for (const Block& part : parts) {
        if (!blocks.empty() && part.top >= blocks.back().bottom - kSameHeight) {
            blocks.back().bottom = std::min(blocks.back().bottom, part.bottom);
        } else {
            blocks.push_back(part);
        }
    }
    return blocks;
}

/// Does the substrate hide what lies under its surface, down to `bottom`? What is below its lower face could be seen
/// past its edge, unless it keeps far enough inside or is thinner than a pixel shows.
bool hides(const Block& substrate, float bottom, float marginMm, const Sight& sight) {
    const float below = std::max(0.0F, substrate.bottom - bottom);
    return marginMm >= 0.0F &&
           (below == 0.0F || below * sight.flatness <= marginMm || below * sight.pixelsPerMm < kThinPx);
}

void hide(bool isMilled, LayerState& state) {
    state.flags = isMilled ? state.flags | shader::kLayerMilledOnly : state.flags & ~shader::kLayerVisible;
}

void cutAt(const Block& substrate, const Sight& sight, LayerState& state) {
    const float overlap = std::min(kOverlapPx / sight.pixelsPerMm, substrate.top - substrate.bottom);
    if (sight.isFromAbove) {
        state.z0 = std::max(state.z0, substrate.top - overlap);
    } else {
        state.z1 = std::min(state.z1, -substrate.top + overlap);
    }
}

}  // namespace

Sight sightOf(const EyePoint& eye, float low, float high) {
    const glm::dmat4 back = glm::inverse(eye.clipFromCentred);
    const auto at = [&](double x, double y, double z) {
        const glm::dvec4 p = back * glm::dvec4(x, y, z, 1.0);
        return glm::dvec3(p) / p.w + eye.centre;
    };
    Sight sight;
    double flatness = 0.0;
    double nearest = std::numeric_limits<double>::infinity();
    for (const auto& [x, y] :
         {std::pair(-1.0, -1.0), std::pair(1.0, -1.0), std::pair(-1.0, 1.0), std::pair(1.0, 1.0)}) {
        // Reversed depth: 1 is the near plane.
        const glm::dvec3 from = at(x, y, 1.0);
        const glm::dvec3 direction = at(x, y, 0.5) - from;
        sight.isFromAbove = direction.z < 0.0;
        const double face = sight.isFromAbove ? high : low;
        const double steps = (face - from.z) / direction.z;
        const bool isOutside = sight.isFromAbove ? from.z > face : from.z < face;
        if (direction.z == 0.0 || !isOutside || !std::isfinite(steps)) {
            return {};
        }
        const glm::dvec3 hit = from + steps * direction - eye.centre;
        flatness = std::max(flatness, glm::length(glm::dvec2(direction)) / std::abs(direction.z));
        nearest = std::min(nearest, (eye.clipFromCentred * glm::dvec4(hit, 1.0)).w);
    }
    sight.isOutside = true;
    sight.flatness = static_cast<float>(flatness);
    sight.pixelsPerMm = nearest > 0.0 ? eye.pixelsPerMm / static_cast<float>(nearest) : sight.pixelsPerMm;
    return sight;
}

void hideBuried(std::span<const LayerInSubstrate> layers, const Sight& sight, std::vector<LayerState>& states) {
    for (std::size_t i = 0; i < states.size(); ++i) {
        if (layers[i].role == Role::Plug && !isOpaque(states[i])) {
            return;
        }
    }
    if (!sight.isOutside) {
        return;
    }
    for (const Block& substrate : substrateOf(layers, states, sight.isFromAbove)) {
        for (std::size_t i = 0; i < states.size(); ++i) {
            const Block block = blockOf(states[i], sight.isFromAbove);
            // Areas stand on a face of such a layer: it has to stay where it is.
            const bool isUneven = (states[i].flags & (shader::kLayerGrowsUp | shader::kLayerGrowsDown)) != 0;
            if (!isVisible(states[i]) || layers[i].role == Role::Substrate ||
                !hides(substrate, block.bottom, layers[i].marginMm, sight)) {
                continue;
            }
            if (block.top < substrate.top - kSameHeight) {
                hide(layers[i].isMilled, states[i]);
            } else if (block.bottom < substrate.top && !isUneven && !layers[i].isMilled) {
                cutAt(substrate, sight, states[i]);
            }
        }
    }
}

}  // namespace render
