#include "ui/element/element_feature.h"

#include "model/index/pin_names.h"
#include "ui/element/element_panel.h"
#include "ui/element/element_picture.h"
#include "ui/parts/part_picking.h"

namespace ui {

namespace {

/// Shows it, too: it may lie anywhere on the board.
void selectPinOfNet(const QString& name, const SelectionModel& selection, PartPicking& parts) {
    for (const model::BoardNet& net : selection.nets()) {
        const model::Document& step = parts.document(net.step);
        for (const model::PinId pin : parts.finderOf(net.step).pinsOf(net.net)) {
            const bool isOfComponent = step.pins[pin.row()].component.isValid();
            if (isOfComponent && QString::fromStdString(model::fullPinName(step, pin)) == name) {
                parts.selectPinNamedAs({net.step, pin});
                parts.showSelected();
                return;
            }
        }
    }
}

/// Goes on from the element selected last to what it belongs to, or from the net to its pin.
void follow(FactLink link, const QString& value, Workspace& workspace, PartPicking& parts) {
    SelectionModel& selection = workspace.selection();
    if (link == FactLink::PinOfNet) {
        selectPinOfNet(value, selection, parts);
        return;
    }
    const model::BoardElement at = *selection.current();
    switch (link) {
        case FactLink::Net: selection.setNets({*selection.netOf(at)}); break;
        case FactLink::Pin: parts.selectPinOf(at); break;
        case FactLink::Component: parts.selectComponentOf(at); break;
        case FactLink::Layer: workspace.setCurrentLayer(selection.layerOf(at)); break;
        case FactLink::PinOfNet: break;
    }
}

}  // namespace

void addElement(FeatureContext& context) {
    Workspace& workspace = context.workspace;
    auto* picture = new ElementPicture(context.device, workspace.selection(), context.layers);
    auto* panel = new ElementPanel(context.parts, workspace.selection(), picture);
    context.addPanel({ActionId::ShowElementDock, "element", ElementPanel::tr("Element"), Qt::LeftDockWidgetArea},
                     *panel);
    QObject::connect(&workspace, &Workspace::deviceGoes, picture, &ElementPicture::releaseDevice);
    QObject::connect(&workspace, &Workspace::unitChanged, panel, &ElementPanel::setUnit);
    QObject::connect(panel, &ElementPanel::followed, &workspace, [&context](FactLink link, const QString& value) {
        follow(link, value, context.workspace, context.parts);
    });
}

}  // namespace ui
