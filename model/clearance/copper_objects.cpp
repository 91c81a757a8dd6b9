#include "model/clearance/copper_objects.h"

namespace model {

namespace {

CopperObject objectOf(const Document& document, std::size_t row) {
    const std::uint8_t flags = document.elements.flags[row];
    if (isPlatedHole(flags)) {
        return (flags & kVia) != 0 ? CopperObject::Via : CopperObject::Pad;
    }
    if (!document.layer(document.elements.layer[row]).isCopper()) {
        return CopperObject::Any;
    }
    const SubnetId subnet = document.elements.subnet[row];
    const SubnetKind use = subnet.isValid() ? document.subnets[subnet.row()].kind : SubnetKind::Other;
    if ((flags & kPad) != 0 || use == SubnetKind::PinPads) {  // some pads are drawn as areas
        return use == SubnetKind::Via ? CopperObject::Via : CopperObject::Pad;
    }
    return document.elements.kind[row] == ElementKind::Area ? CopperObject::Plane : CopperObject::Track;
}

}  // namespace

std::vector<CopperObject> copperObjectsOf(const Document& document) {
    std::vector<CopperObject> objects(document.elements.size());
    for (std::size_t row = 0; row < objects.size(); ++row) {
        objects[row] = objectOf(document, row);
    }
    return objects;
}

}  // namespace model
