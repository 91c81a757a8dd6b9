#include "ui/element/element_feature.h"

#include "ui/element/element_panel.h"
#include "ui/element/element_picture.h"
#include "ui/parts/part_picking.h"

namespace ui {

namespace {

/// Goes on from the element selected last to what it belongs to.
void follow(FactLink link, Workspace& workspace, PartPicking& parts) {
    SelectionModel& selection = workspace.selection();
    const model::BoardElement at = *selection.current();
    switch (link) {
        case FactLink::Net: selection.setNets({*selection.netOf(at)}); break;
        case FactLink::Pin: parts.selectPinOf(at); break;
        case FactLink::Component: parts.selectComponentOf(at); break;
        case FactLink::Layer: workspace.setCurrentLayer(selection.layerOf(at)); break;
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
    QObject::connect(panel, &ElementPanel::followed, &workspace,
                     [&context](FactLink link) { follow(link, context.workspace, context.parts); });
}

}  // namespace ui
