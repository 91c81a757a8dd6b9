#include "ui/views/view_menu.h"

#include <QActionGroup>
#include <QMenu>
#include <algorithm>

#include "ui/element/element_facts.h"
#include "ui/views/probing.h"
#include "ui/workspace/feature.h"

namespace ui {

namespace {

constexpr std::size_t kMostListed = 12;  // more is a column that nobody reads; Tab goes through all

constexpr ActionId kNetActions[] = {ActionId::HighlightNet,    ActionId::AddNet,  ActionId::ColourNet,
                                    ActionId::ChooseNetColour, ActionId::HideNet, ActionId::IsolateNet,
                                    ActionId::SectionAlongNet};
constexpr ActionId kPartActions[] = {ActionId::SelectComponent, ActionId::SelectPin};
constexpr ActionId kSelectionActions[] = {ActionId::ShowSelection, ActionId::SaveSelection, ActionId::ClearSelection};
constexpr ActionId kActionsOfAll[] = {ActionId::Fit,           ActionId::ShowAllLayers, ActionId::NoCurrentLayer,
                                      ActionId::RestoreLayers, ActionId::ShowAllNets,   ActionId::ClearNetColours};

void add(QMenu& menu, const ActionSet& actions, std::span<const ActionId> ids) {
    menu.addSeparator();
    for (const ActionId id : ids) {
        menu.addAction(&actions[id]);
    }
}

/// Names of nets may hold what a menu takes for a mnemonic.
QString plain(QString text) {
    return text.replace('&', QStringLiteral("&&"));
}

/// Everything under the pointer, what is selected checked: one of them, as is seen, unless several are.
void addElements(QMenu& menu, Workspace& workspace, const std::vector<model::Hit>& hits) {
    SelectionModel& selection = workspace.selection();
    auto* choices = new QActionGroup(&menu);
    choices->setExclusive(selection.selected().size() <= 1);
    for (std::size_t i = 0; i < std::min(hits.size(), kMostListed); ++i) {
        const model::BoardElement at = hits[i].at;
        QAction* entry = menu.addAction(plain(summaryOf(*workspace.board()->index, at, workspace.unit())), &selection,
                                        [&selection, at] { selection.select({at}); });
        entry->setCheckable(true);
        choices->addAction(entry);
        entry->setChecked(std::ranges::binary_search(selection.selected(), at));
    }
    if (hits.size() > kMostListed) {
        menu.addAction(Probing::tr("%1 more: Tab selects what lies beneath").arg(hits.size() - kMostListed))
            ->setEnabled(false);
    }
}

/// Unlike the command, which ends it where the layer is alone already.
void showAlone(FeatureContext& context, model::LayerId layer) {
    context.workspace.setCurrentLayer(layer);
    if (context.layers.soloLayer() != layer) {
        context.layers.toggleSolo(layer);
    }
}

void addLayer(QMenu& menu, FeatureContext& context, const model::BoardElement& at) {
    const model::LayerId layer = context.workspace.selection().layerOf(at);
    const QString name = plain(QString::fromStdString(context.workspace.board()->document->layer(layer).name));
    menu.addSeparator();
    menu.addAction(Probing::tr("Only layer %1").arg(name), &context.workspace,
                   [&context, layer] { showAlone(context, layer); });
    menu.addAction(Probing::tr("Hide layer %1").arg(name), &context.layers, [&context, layer] {
        const QModelIndex box = context.layers.index(static_cast<int>(layer.row()), LayerModel::Visible);
        context.layers.setData(box, Qt::Unchecked, Qt::CheckStateRole);
    });
}

void open(FeatureContext& context, BoardView& view, QPointF position) {
    Probing& probing = context.probing;
    if (!probing.isSelecting() || context.workspace.board() == nullptr) {
        return;
    }
    auto* menu = new QMenu(&context.window);
    menu->setAttribute(Qt::WA_DeleteOnClose);
    if (probing.chooseAt(view, position)) {
        const std::vector<model::Hit> hits = probing.hitsAt(view, position);
        const SelectionModel& selection = context.workspace.selection();
        addElements(*menu, context.workspace, hits);
        if (!selection.selectionNets().empty()) {
            add(*menu, context.actions, kNetActions);
        }
        add(*menu, context.actions, kPartActions);
        addLayer(*menu, context, selection.current().value_or(hits.front().at));
        add(*menu, context.actions, kSelectionActions);
    } else {
        add(*menu, context.actions, kActionsOfAll);
    }
    menu->popup(view.mapToGlobal(position.toPoint()));
}

}  // namespace

void addViewMenu(FeatureContext& context) {
    for (BoardView* view : context.views.both()) {
        QObject::connect(&view->controller(), &CameraController::menuRequested, view,
                         [&context, view](QPointF position) { open(context, *view, position); });
    }
}

}  // namespace ui
