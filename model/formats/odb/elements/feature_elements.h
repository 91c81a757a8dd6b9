#pragma once

#include <span>
#include <string_view>
#include <vector>

#include "model/formats/common/hole_rules.h"
#include "model/formats/odb/elements/net_links.h"
#include "model/formats/odb/elements/symbol_library.h"

namespace model::odb {

/// The features of one file, to become elements.
struct FeatureSource {
    const FeatureFile* file = nullptr;
    std::string_view path;                           ///< for diagnostics
    std::span<const NetLink> links;                  ///< by feature; empty when the file has no nets
    const AttributeTypes* attributeTypes = nullptr;  ///< none: attributes are not kept
};

/// Turns features into elements of the builder's current layer (formats::ElementMaker): L and A are tracks, P pads, S
/// areas, T the strokes of its characters, B an area of its bars and the strokes of its text. With hole rules every
/// element is a hole. Returns one entry per element: 1 when it takes away what was painted before it.
std::vector<std::uint8_t> addFeatures(DocumentBuilder& builder, SymbolLibrary& symbols, Diagnostics& diagnostics,
                                      const FeatureSource& source, const formats::HoleRules* holes);

}  // namespace model::odb
