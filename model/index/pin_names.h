#pragma once

#include <string>
#include <vector>

#include "model/index/pin_finder.h"

/// What people call pins, and which nets a component is on.
namespace model {

/// The pin within its component: "3". Some jobs write the designator before it ("U5-3"), which is left out.
[[nodiscard]] std::string pinName(const Document& document, PinId pin);
/// "U5.3"; the pin alone if it is of no component.
[[nodiscard]] std::string fullPinName(const Document& document, PinId pin);
/// The pin of a pad or plated hole: the one that its subnet names, also for pads that are drawn as areas, else the
/// first that the finder knows. None if it belongs to none.
[[nodiscard]] PinId pinOf(const Document& document, const PinFinder& pins, ElementId element);
/// Each once, rising; pins without a net are left out.
[[nodiscard]] std::vector<NetId> netsOf(const Document& document, const Component& component);

}  // namespace model
