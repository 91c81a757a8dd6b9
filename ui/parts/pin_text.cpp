#include "ui/parts/pin_text.h"

#include <QCoreApplication>
#include <algorithm>
#include <set>

#include "model/index/pin_names.h"
#include "ui/common/net_name.h"

namespace ui {

namespace {

struct PinText {
    Q_DECLARE_TR_FUNCTIONS(ui::PinText)
};

QString counted(std::size_t count, const QString& none, const QString& one, const QString& many) {
    return count == 0 ? none : count == 1 ? one : many.arg(count);
}

QString pinsText(std::size_t count) {
    return counted(count, PinText::tr("no pins"), PinText::tr("1 pin"), PinText::tr("%L1 pins"));
}

QString netsText(std::size_t count) {
    return counted(count, PinText::tr("no nets"), PinText::tr("1 net"), PinText::tr("%L1 nets"));
}

QString componentsText(std::size_t count) {
    return counted(count, PinText::tr("no components"), PinText::tr("1 component"), PinText::tr("%L1 components"));
}

QString netsOfElementsText(std::size_t nets, std::size_t elements) {
    return elements == 0 ? netsText(nets) : PinText::tr("%L1 elements of %2").arg(elements).arg(netsText(nets));
}

bool hasCopper(const model::Document& step, model::NetId net) {
    return std::ranges::any_of(step.elementsOf(net), [&](model::ElementId element) {
        return step.layer(step.elements.layer[element.row()]).isCopper();
    });
}

}  // namespace

QString pinsOfPartsText(const PartPicking& parts) {
    std::size_t pins = 0;
    std::set<model::BoardNet> nets;
    for (const BoardPart& part : parts.parts()) {
        const model::Document& step = parts.document(part.step);
        const model::Component& component = step.components[part.component.row()];
        pins += component.pinCount;
        for (const model::NetId net : model::netsOf(step, component)) {
            nets.insert({part.step, net});
        }
    }
    const BoardPart& first = parts.parts().front();
    const QString whose = parts.parts().size() == 1 ? parts.nameOf(first) : componentsText(parts.parts().size());
    return pins == 0 ? PinText::tr("%1: no pins").arg(whose)
                     : PinText::tr("%1: %2 on %3").arg(whose, pinsText(pins), netsText(nets.size()));
}

QString pinsOfNetsText(const PartPicking& parts, const std::vector<model::BoardNet>& nets,
                       const std::vector<BoardPin>& pins, std::size_t elements) {
    std::set<BoardPart> components;
    for (const BoardPin& pin : pins) {
        components.insert({pin.step, parts.document(pin.step).pins[pin.pin.row()].component});
    }
    const model::BoardNet& first = nets.front();
    const model::Document& step = parts.document(first.step);
    const QString whose = nets.size() == 1 ? netName(step, first.net) : netsOfElementsText(nets.size(), elements);
    const QString text =
        pins.empty() ? PinText::tr("%1: no pins").arg(whose)
                     : PinText::tr("%1: %2 of %3").arg(whose, pinsText(pins.size()), componentsText(components.size()));
    const bool isBare = nets.size() == 1 && !hasCopper(step, first.net);
    return isBare ? PinText::tr("%1; the net has no copper").arg(text) : text;
}

}  // namespace ui
