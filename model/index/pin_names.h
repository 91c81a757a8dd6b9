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
/// The pads of the pin that people mean by the name of this one: a connector has a pin MP with a pad at each end, which
/// are pins of the document that have one name in one component. Rising, itself among them; alone without a name.
[[nodiscard]] std::vector<PinId> pinsNamedAs(const Document& document, PinId pin);
/// All components with the designator of this one, which should be alone. Rising; alone without a designator.
[[nodiscard]] std::vector<ComponentId> componentsNamedAs(const Document& document, ComponentId component);
/// Each once, rising; pins without a net are left out.
[[nodiscard]] std::vector<NetId> netsOf(const Document& document, const Component& component);

}  // namespace model
