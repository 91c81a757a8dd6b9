#include "model/clearance/side_names.h"

#include "model/board/holes.h"
#include "model/index/copper_kind.h"
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
    if (m_isMicrovia[element.row()]) {
        return "microvia";
    }
    const Layer& layer = m_document.layer(m_document.elements.layer[element.row()]);
    if ((m_document.elements.flags[element.row()] & kHole) != 0 || layer.isCopper()) {
        return copperKind(m_document, element);
    }
    return layer.type == LayerType::SilkScreen ? "silkscreen" : "opening";
}

}  // namespace model
