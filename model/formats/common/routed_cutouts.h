#pragma once

#include <memory>
#include <span>
#include <string>

#include "model/board/document_builder.h"

namespace model::formats {

/// A layer of routed slots that is built when the outline is known, as the cutter may run beside its paths.
struct RoutedLayer {
    LayerId layer;
    std::unique_ptr<DocumentBuilder> routed;  ///< its elements, on a layer of their own
    std::string file;                         ///< for messages
};

/// A cutter that goes all around a piece of the board cuts it loose. Takes such pieces out of the outline: what closed
/// non-plated paths on layers of routed slots enclose, if they pass all copper, and if no copper and no other step lies
/// there. A path around half of the board or more leaves that half, and cuts nothing out. Each is reported.
///
/// To be called when the profile and all positive layers but `waiting` are there, before what depends on the outline.
void takeOutRouted(DocumentBuilder& builder, std::span<const RoutedLayer> waiting = {});

/// Adds the elements of the layer. A path along the outline is the edge of what stays, with compensation (attribute
/// `.comp`) or without: only what its pen covers beyond the outline is cut, and it is no hole. Nor is one without a
/// width that passes around the board. Each is reported.
void addRouted(DocumentBuilder& builder, const RoutedLayer& layer);

}  // namespace model::formats
