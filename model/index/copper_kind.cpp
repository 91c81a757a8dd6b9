#include "model/index/copper_kind.h"

namespace model {

namespace {

std::string kindOfHole(const Document& document, ElementId hole) {
    const bool isRound = document.elements.kind[hole.row()] == ElementKind::Circle;
    switch (holeKind(document.elements.flags[hole.row()])) {
        case HoleKind::Via: return "via";
        case HoleKind::Component: return isRound ? "component hole" : "plated slot";
        case HoleKind::Plated: return isRound ? "plated hole" : "plated slot";
        case HoleKind::NonPlated: return isRound ? "NPTH" : "NPTH slot";
    }
    return {};
}

}  // namespace

std::string copperKind(const Document& document, ElementId element) {
    const std::uint8_t flags = document.elements.flags[element.row()];
    const ElementKind kind = document.elements.kind[element.row()];
    if ((flags & kHole) != 0) {
        return kindOfHole(document, element);
    }
    const SubnetId subnet = document.elements.subnet[element.row()];
    const bool isPad =
        (flags & kPad) != 0 || (subnet.isValid() && document.subnets[subnet.row()].kind == SubnetKind::PinPads);
    return isPad ? "pad" : kind == ElementKind::Area ? "area" : kind == ElementKind::Circle ? "dot" : "track";
}

}  // namespace model
