#include "model/clearance/side_names.h"

#include "model/board/holes.h"
#include "model/index/pin_names.h"

namespace model {

std::string textOf(const Side& side) {
    std::string text = side.net;
    for (const std::string& part : {side.pin, side.kind}) {
        text += part.empty() ? "" : ", " + part;
    }
    return side.element.isValid() ? text + ", element " + std::to_string(side.element.value) : text;
}

SideNames::SideNames(const Document& document)
    : m_document(document), m_pins(document), m_isMicrovia(microviasOf(document)) {}

Side SideNames::of(ElementId element) const {
    if (!element.isValid()) {
        return {sideOf(m_document, element), {}, {}, {}};
    }
    const PinId pin = pinOf(m_document, m_pins, element);
    return {sideOf(m_document, element), pin.isValid() ? fullPinName(m_document, pin) : "", kindOf(element), element};
}

std::pair<Side, Side> SideNames::of(const RuleFinding& finding) const {
    Side second = of(finding.b);
    second.net = secondSideOf(m_document, finding);
    return {of(finding.a), std::move(second)};
}

std::string SideNames::kindOf(ElementId element) const {
    const std::uint8_t flags = m_document.elements.flags[element.row()];
    const ElementKind kind = m_document.elements.kind[element.row()];
    if ((flags & kHole) != 0) {
        return kindOfHole(element);
    }
    const Layer& layer = m_document.layer(m_document.elements.layer[element.row()]);
    if (!layer.isCopper()) {
        return layer.type == LayerType::SilkScreen ? "silkscreen" : "opening";
    }
    const SubnetId subnet = m_document.elements.subnet[element.row()];
    const bool isPad =
        (flags & kPad) != 0 || (subnet.isValid() && m_document.subnets[subnet.row()].kind == SubnetKind::PinPads);
    return isPad ? "pad" : kind == ElementKind::Area ? "area" : kind == ElementKind::Circle ? "dot" : "track";
}

std::string SideNames::kindOfHole(ElementId hole) const {
    const bool isRound = m_document.elements.kind[hole.row()] == ElementKind::Circle;
    if (m_isMicrovia[hole.row()]) {
        return "microvia";
    }
    switch (holeKind(m_document.elements.flags[hole.row()])) {
        case HoleKind::Via: return "via";
        case HoleKind::Component: return isRound ? "component hole" : "plated slot";
        case HoleKind::Plated: return isRound ? "plated hole" : "plated slot";
        case HoleKind::NonPlated: return isRound ? "NPTH" : "NPTH slot";
    }
    return {};
}

}  // namespace model
