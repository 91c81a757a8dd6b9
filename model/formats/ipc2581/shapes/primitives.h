#pragma once

#include <string>
#include <string_view>

#include "model/formats/common/pad_shape.h"
#include "model/formats/ipc2581/xml/xml_cursor.h"

/// The standard primitives of IPC-2581 that are told by sizes: all but Contour.
namespace model::ipc2581 {

[[nodiscard]] bool isPrimitive(std::string_view element);

/// What the primitive whose start tag was read last draws when it is filled, around its own origin. `nm` is the unit of
/// its sizes. A shape that cannot be drawn draws nothing and says why (PadShape::problem).
[[nodiscard]] formats::PadShape primitiveShape(const XmlCursor& at, double nm);

/// Its kind and sizes in millimetres: "RectRound 1.2 0.65 0.065 true true true true". Equal names are equal shapes.
[[nodiscard]] std::string primitiveName(const XmlCursor& at, double nm);

}  // namespace model::ipc2581
