#include "ui/search/search_feature.h"

#include "ui/parts/part_picking.h"
#include "ui/search/search_box.h"

namespace ui {

namespace {

void showPart(const Found& found, PartPicking& parts) {
    if (found.kind == FoundKind::Pin) {
        parts.select(std::vector{BoardPin{found.step, model::PinId{std::size_t{found.row}}}});
    } else {
        parts.select(std::vector{BoardPart{found.step, model::ComponentId{std::size_t{found.row}}}});
    }
    parts.showSelected();
}

void show(const Found& found, Workspace& workspace, PartPicking& parts) {
    switch (found.kind) {
        case FoundKind::Location: workspace.showLocation(found.location, {}); break;
        case FoundKind::Layer:
            workspace.showLayer(model::LayerId{std::size_t{found.row}});
            workspace.setCurrentLayer(model::LayerId{std::size_t{found.row}});
            break;
        case FoundKind::Net:
            workspace.selection().setNets({{found.step, model::NetId{std::size_t{found.row}}}});
            workspace.showNets(workspace.selection().nets());
            break;
        case FoundKind::Component:
        case FoundKind::Pin: showPart(found, parts); break;
    }
}

}  // namespace

void addSearch(FeatureContext& context) {
    Workspace& workspace = context.workspace;
    auto* box = new SearchBox(context.actions, context.window);
    context.on(ActionId::Find, box, [box] { box->open({}); });
    context.on(ActionId::Commands, box, [box] { box->open(QStringLiteral(">")); });
    QObject::connect(box, &SearchBox::chosen, &workspace, [&context](const Found& found) { show(found, context.workspace, context.parts); });
    QObject::connect(&workspace, &Workspace::boardRead, box,
                     [box](const LoadedBoard& board) { box->search().setBoard(board.document); });
    QObject::connect(&workspace, &Workspace::unitChanged, box, &SearchBox::setUnit);
}

}  // namespace ui
