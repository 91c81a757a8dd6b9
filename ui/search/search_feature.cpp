#include "ui/search/search_feature.h"

#include <QAction>
#include <algorithm>

#include "ui/layers/layer_model.h"
#include "ui/nets/net_styles.h"
#include "ui/parts/part_picking.h"
#include "ui/search/location_mark.h"
#include "ui/search/search_box.h"
#include "ui/workspace/hint.h"

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
    workspace.selection().selectAs(search.titleOf(found, workspace.unit()), elements);
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

/// Of the selected elements, or of those of the highlighted nets, but for the nets that `isLeftOut`; each once.
template <class IsLeftOut>
std::vector<model::LayerId> layersOf(const SelectionModel& selection, const IsLeftOut& isLeftOut) {
    std::vector<model::LayerId> layers;
    for (const model::BoardElement& at : selection.selected()) {
        if (const auto net = selection.netOf(at); !net || !isLeftOut(*net)) {
            layers.push_back(selection.layerOf(at));
        }
    }
    std::vector<model::BoardNet> nets =
        selection.selected().empty() ? selection.nets() : std::vector<model::BoardNet>();
    std::erase_if(nets, isLeftOut);
    const std::vector<model::StepCopy>& copies = selection.tree().copies;
    for (const model::BoardNet& net : nets) {
        for (const bool isFlipped : {false, true}) {
            const auto copy = std::ranges::find_if(copies, [&](const model::StepCopy& each) {
                return each.step == net.step && each.isFlipped == isFlipped;
            });
            for (const model::ElementId element : selection.tree().steps[net.step]->elementsOf(net.net)) {
                if (copy != copies.end()) {
                    layers.push_back(selection.layerOf({static_cast<std::uint32_t>(copy - copies.begin()), element}));
                }
            }
        }
    }
    std::ranges::sort(layers);
    layers.erase(std::ranges::unique(layers).begin(), layers.end());
    return layers;
}

QString hiddenLayersText(const QString& title, const model::Document& board, std::vector<model::LayerId> layers) {
    // Bodies are named only of what has nothing else.
    const auto bodies = std::ranges::partition(layers, [&](auto layer) { return !board.layer(layer).isSynthetic; });
    if (bodies.size() < layers.size()) {
        layers.erase(bodies.begin(), bodies.end());
    }
    QStringList names;
    for (const model::LayerId layer : layers) {
        names += QString::fromStdString(board.layer(layer).name);
    }
    return SearchBox::tr("%1 is on layers that are hidden: %2").arg(title, names.join(QStringLiteral(", ")));
}

/// With the command that ends it, as its menu calls it.
QString hiddenNetText(const QString& title, const QAction& showAll) {
    return SearchBox::tr("%1 is hidden: %2 (%3)")
        .arg(title, showAll.text().remove('&'), showAll.shortcut().toString(QKeySequence::NativeText));
}

/// What is found is outlined where it is drawn: a view that moves there and shows nothing needs a word.
void sayIfHidden(const QString& title, const FeatureContext& context, Hint& hint) {
    const SelectionModel& selection = context.workspace.selection();
    const std::vector<LayerAppearance> styles = context.layers.effectiveStyles();
    const auto isAnySeen = [&](const std::vector<model::LayerId>& layers) {
        return std::ranges::any_of(layers, [&](model::LayerId layer) { return styles[layer.row()].isVisible; });
    };
    const auto layers = layersOf(selection, [](const model::BoardNet&) { return false; });
    const auto isHidden = [&](const model::BoardNet& net) { return context.netStyles.isHidden(net); };
    if (!layers.empty() && !isAnySeen(layers)) {
        hint.show(hiddenLayersText(title, *context.workspace.board()->document, layers));
    } else if (!layers.empty() && !isAnySeen(layersOf(selection, isHidden))) {
        hint.show(hiddenNetText(title, context.actions[ActionId::ShowAllNets]));
    }
}

}  // namespace

void addSearch(FeatureContext& context) {
    Workspace& workspace = context.workspace;
    auto* box = new SearchBox(context.actions, context.window);
    auto* mark = new LocationMark(context.views, workspace, &context.window);
    auto* hint = new Hint(workspace, box);
    QObject::connect(&workspace.selection(), &SelectionModel::selectionChanged, hint, &Hint::end);
    QObject::connect(&workspace.selection(), &SelectionModel::netsChanged, hint, &Hint::end);
    context.escapes.emplace(EscapeRank::Mark, [mark] { return mark->clear(); });
    context.on(ActionId::Find, box, [box] { box->open({}); });
    context.on(ActionId::Commands, box, [box] { box->open(QStringLiteral(">")); });
    QObject::connect(box, &SearchBox::chosen, &workspace, [&context, box, mark, hint](const Found& found) {
        mark->clear();
        if (found.kind == FoundKind::Location) {
            mark->set(found.location);
        }
        show(found, box->search(), context.workspace, context.parts);
        if (found.kind != FoundKind::Location && found.kind != FoundKind::Layer) {
            sayIfHidden(box->search().titleOf(found, context.workspace.unit()), context, *hint);
        }
        context.views.active().takeKeyboard();  // not the line it was before, which would take the next key for text
    });
    QObject::connect(&workspace, &Workspace::boardRead, box,
                     [box](const LoadedBoard& board) { box->setBoard(board.document); });
    QObject::connect(&workspace, &Workspace::unitChanged, box, &SearchBox::setUnit);
}

}  // namespace ui
