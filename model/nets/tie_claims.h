#pragma once

#include <vector>

#include "model/board/document.h"

namespace model {

/// What speaks for a component to join nets on purpose.
enum class TieClaim : std::uint8_t {
    None,      ///< nothing: copper that joins its nets is a short
    OnePin,    ///< some of its nets are of pads that are one pin
    Jumper,    ///< it is called a jumper, which may be one of copper
    NetTie,    ///< it is called a net tie
    Declared,  ///< the job declares which of its pads may be joined
};

/// Which nets of a component its copper may join.
struct TiedNets {
    TieClaim claim = TieClaim::None;
    std::vector<std::vector<NetId>> groups;  ///< each rising, of at least two nets
};

/// KiCad declares ties (netTieGroups), so nothing else counts on its boards. Formats that cannot are taken by what they
/// call the component: "net tie" in its reference, part, package or an attribute, a reference NT1; "jumper" there, JP1
/// or SJ1, but not one that is called open or a header, whose pads are to be apart. Pads of one name are one pin, as
/// KiCad takes them, whatever nets they have; so are those whose nets KiCad made for one pin that is not connected.
[[nodiscard]] TiedNets tiedNetsOf(const Document& document, ComponentId component);

}  // namespace model
