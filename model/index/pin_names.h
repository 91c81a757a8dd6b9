#pragma once

#include <string>
#include <vector>

#include "model/board/document.h"

/// What people call pins, and which nets a component is on.
namespace model {

/// The pin within its component: "3". Some jobs write the designator before it ("U5-3"), which is left out.
[[nodiscard]] std::string pinName(const Document& document, PinId pin);
/// "U5.3"; the pin alone if it is of no component.
[[nodiscard]] std::string fullPinName(const Document& document, PinId pin);
/// Each once, rising; pins without a net are left out.
[[nodiscard]] std::vector<NetId> netsOf(const Document& document, const Component& component);

}  // namespace model
