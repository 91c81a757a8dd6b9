#include "ui/layers/layers_feature.h"

#include <algorithm>

#include "ui/layers/board_colour_menu.h"
#include "ui/layers/current_layer.h"
#include "ui/layers/layer_sets.h"
#include "ui/layers/layer_step.h"
#include "ui/layers/layers_panel.h"
#include "ui/workspace/hint.h"

namespace ui {

namespace {

/// The bodies of the components that a board has, on either side.
std::vector<model::LayerId> bodyLayers(const LayerModel& layers) {
    std::vector<model::LayerId> found;
    const std::size_t count = layers.document() != nullptr ? layers.document()->layers.size() : 0;
    for (std::size_t row = 0; row < count; ++row) {
        if (layers.document()->layers[row].type == model::LayerType::ComponentBody) {
            found.emplace_back(row);
        }
    }
    return found;
}

/// The switch says what is drawn: on as soon as the bodies of one side are.
void addComponentSwitch(FeatureContext& context) {
    LayerModel& layers = context.layers;
    QAction& action = context.actions[ActionId::ShowComponents];
    const auto follow = [&layers, &action] {
        const std::vector<LayerAppearance> styles = layers.effectiveStyles();
        action.setChecked(
            std::ranges::any_of(bodyLayers(layers), [&](model::LayerId id) { return styles[id.row()].isVisible; }));
    };
    context.on(ActionId::ShowComponents, [&layers, &workspace = context.workspace, follow](bool isOn) {
        const std::vector<model::LayerId> bodies = bodyLayers(layers);
        if (bodies.empty()) {
            workspace.report(LayersPanel::tr("The board has no components with a body"));
        }
        layers.setVisible(bodies, isOn);
        follow();
    });
    QObject::connect(&layers, &LayerModel::stylesChanged, &action, follow);
}

/// "Only TOP is shown. H again shows all.", said after the command for as long as that is so: the current layer may be
/// one that nobody chose, like the bodies of a component that was selected.
class AloneHint : public Hint {
public:
    AloneHint(FeatureContext& context, QObject* parent)
        : Hint(context.workspace, parent), m_layers(context.layers), m_actions(context.actions) {
        connect(&m_layers, &LayerModel::stylesChanged, this, [this] {
            if (m_layers.soloLayer() != m_said) {
                end();
            }
        });
    }

    void say() {
        m_said = m_layers.soloLayer();
        if (m_said.isValid()) {
            const QString name = QString::fromStdString(m_layers.document()->layer(m_said).name);
            const QString key = m_actions[ActionId::SoloLayer].shortcut().toString(QKeySequence::NativeText);
            show(LayersPanel::tr("Only %1 is shown. %2 again shows all.").arg(name, key));
        }
    }

private:
    LayerModel& m_layers;
    const ActionSet& m_actions;
    model::LayerId m_said;
};

void addSoloCommand(FeatureContext& context, QObject* parent) {
    auto* hint = new AloneHint(context, parent);
    context.on(ActionId::SoloLayer, [&layers = context.layers, &workspace = context.workspace, hint] {
        const bool isSolo = layers.soloLayer().isValid();
        const model::LayerId layer = isSolo ? workspace.currentLayer() : takeCurrentLayer(workspace);
        if (!isSolo && !layer.isValid()) {
            workspace.report(LayersPanel::tr("Choose in Layers which one to show alone"));
        }
        layers.toggleSolo(layer);
        hint->say();
    });
}

}  // namespace

void addLayers(FeatureContext& context) {
    Workspace& workspace = context.workspace;
    LayerModel& layers = context.layers;
    auto* panel = new LayersPanel(layers, context.actions);
    context.addPanel({ActionId::ShowLayersDock, "layers", LayersPanel::tr("Layers"), Qt::LeftDockWidgetArea}, *panel);
    panel->setSets(*new LayerSets(layers, workspace, context.actions, context.window));
    panel->setBoardColours(*new BoardColourMenu(layers, workspace, panel));
    addComponentSwitch(context);
    for (const ActionId id : {ActionId::NoCurrentLayer, ActionId::ShowDefaultLayers}) {
        context.on(id, panel, [panel] { panel->deselect(); });
    }
    context.on(ActionId::RestoreLayers, [&layers] { layers.restoreDefaults(); });
    addSoloCommand(context, panel);
    context.on(ActionId::NextLayer, panel, [panel] { panel->step(1); });
    context.on(ActionId::PreviousLayer, panel, [panel] { panel->step(-1); });
    context.on(ActionId::TopCopper, panel, [panel] { panel->goToOuterCopper(true); });
    context.on(ActionId::BottomCopper, panel, [panel] { panel->goToOuterCopper(false); });
    QObject::connect(&layers, &LayerModel::edited, &workspace, [&layers, &workspace](const LayerEdit& edit) {
        workspace.history().push(new LayerStep(layers, edit));
        if (layers.soloLayer().isValid()) {
            workspace.setCurrentLayer(layers.soloLayer());
        }
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
    QObject::connect(&workspace, &Workspace::unitChanged, &layers, &LayerModel::setUnit);
}

}  // namespace ui
