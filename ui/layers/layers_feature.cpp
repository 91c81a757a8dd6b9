#include "ui/layers/layers_feature.h"

#include "ui/layers/board_colour_menu.h"
#include "ui/layers/layer_sets.h"
#include "ui/layers/layer_step.h"
#include "ui/layers/layers_panel.h"

namespace ui {

void addLayers(FeatureContext& context) {
    Workspace& workspace = context.workspace;
    LayerModel& layers = context.layers;
    auto* panel = new LayersPanel(layers, context.actions);
    context.addPanel({ActionId::ShowLayersDock, "layers", LayersPanel::tr("Layers"), Qt::LeftDockWidgetArea}, *panel);
    panel->setSets(*new LayerSets(layers, workspace, context.actions, context.window));
    panel->setBoardColours(*new BoardColourMenu(layers, workspace, panel));
    context.on(ActionId::RestoreLayers, [&layers] { layers.restoreDefaults(); });
    context.on(ActionId::SoloLayer, [&] { layers.toggleSolo(workspace.currentLayer()); });
    context.on(ActionId::NextLayer, panel, [panel] { panel->step(1); });
    context.on(ActionId::PreviousLayer, panel, [panel] { panel->step(-1); });
    context.on(ActionId::TopCopper, panel, [panel] { panel->goToOuterCopper(true); });
    context.on(ActionId::BottomCopper, panel, [panel] { panel->goToOuterCopper(false); });
    QObject::connect(&layers, &LayerModel::edited, &workspace, [&layers, &workspace](const LayerEdit& edit) {
        workspace.history().push(new LayerStep(layers, edit));
    });
    const auto report = [panel, &workspace] { workspace.setCurrentLayer(panel->currentLayer()); };
    QObject::connect(panel, &LayersPanel::currentChanged, &workspace, report);
    QObject::connect(&workspace, &Workspace::currentLayerChanged, panel, [panel](model::LayerId layer) {
        if (layer.isValid() && layer != panel->currentLayer()) {
            panel->select(layer);
        }
    });
    QObject::connect(&workspace, &Workspace::layerWanted, &layers, &LayerModel::show);
    QObject::connect(&workspace, &Workspace::restacked, &layers,
                     [&layers](const LoadedBoard& board) { layers.setHeights(board.document); });
}

}  // namespace ui
