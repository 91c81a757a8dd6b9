#include "ui/search/search_feature.h"

#include "ui/parts/part_picking.h"
#include "ui/search/location_mark.h"
#include "ui/search/search_box.h"

namespace ui {

namespace {

void showPart(const Found& found, PartPicking& parts) {
    if (found.kind == FoundKind::Pin) {
        parts.selectPinNamedAs({found.step, model::PinId{std::size_t{found.row}}});
    } else {
        parts.select(std::vector{BoardPart{found.step, model::ComponentId{std::size_t{found.row}}}});
    }
    parts.showSelected();
}

/// All that have it, in the first copy of their step.
void showAttribute(const Found& found, const BoardSearch& search, Workspace& workspace, PartPicking& parts) {
    const model::AttributeValue& attribute = search.attribute(found);
    const model::Document& step = parts.document(found.step);
    if (attribute.owner == model::AttributeValue::Owner::Components) {
        std::vector<BoardPart> chosen;
        for (const model::ComponentId component : model::componentsWith(step, attribute)) {
            chosen.push_back({found.step, component});
        }
        parts.select(std::move(chosen));
        parts.showSelected();
        return;
    }
    std::vector<model::BoardElement> elements;
    for (const model::ElementId element : model::elementsWith(step, attribute)) {
        elements.push_back({workspace.selection().firstCopyOf(found.step), element});
    }
    workspace.selection().selectAs(search.titleOf(found), elements);
    workspace.showElements(elements);
}

void show(const Found& found, const BoardSearch& search, Workspace& workspace, PartPicking& parts) {
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
        case FoundKind::Attribute: showAttribute(found, search, workspace, parts); break;
        case FoundKind::Component:
        case FoundKind::Pin: showPart(found, parts); break;
    }
}

}  // namespace

void addSearch(FeatureContext& context) {
    Workspace& workspace = context.workspace;
    auto* box = new SearchBox(context.actions, context.window);
    auto* mark = new LocationMark(context.views, workspace, &context.window);
    context.escapes.emplace_back([mark] { return mark->clear(); });
    context.on(ActionId::Find, box, [box] { box->open({}); });
    context.on(ActionId::Commands, box, [box] { box->open(QStringLiteral(">")); });
    QObject::connect(box, &SearchBox::chosen, &workspace, [&context, box, mark](const Found& found) {
        mark->clear();
        if (found.kind == FoundKind::Location) {
            mark->set(found.location);
        }
        show(found, box->search(), context.workspace, context.parts);
        context.views.active().takeKeyboard();  // not the line it was before, which would take the next key for text
    });
    QObject::connect(&workspace, &Workspace::boardRead, box,
                     [box](const LoadedBoard& board) { box->setBoard(board.document); });
    QObject::connect(&workspace, &Workspace::unitChanged, box, &SearchBox::setUnit);
}

}  // namespace ui
