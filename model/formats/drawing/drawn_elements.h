#pragma once

#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

#include "model/formats/common/hole_rules.h"
#include "model/formats/drawing/drawn_nets.h"

namespace model::formats {

/// What a step draws on one layer, to become elements.
struct DrawnSource {
    const DrawnStep* step = nullptr;
    std::span<const DrawnFeature> features;
    std::string_view path;  ///< for diagnostics
    LayerId layer;          ///< of the document
};

/// Turns features into elements of the builder's current layer (ElementMaker): lines and arcs are tracks, regions
/// areas. With hole rules every element is a hole. Features that name a symbol or region that is not there are reported
/// and draw nothing, what names a net, pin or attributes that are not there is reported and has none. Returns one entry
/// per element: 1 when it takes away what was painted before it.
std::vector<std::uint8_t> addDrawn(DocumentBuilder& builder, DrawnNets& nets, Diagnostics& diagnostics,
                                   const DrawnSource& source, const HoleRules* holes);

}  // namespace model::formats
