#include "ui/stackup/stackup_feature.h"

#include "model/export/stackup_export.h"
#include "ui/common/paths.h"
#include "ui/layers/layer_model.h"
#include "ui/stackup/stackup_panel.h"
#include "ui/stackup/stackup_view.h"
#include "ui/workspace/session_part.h"

namespace ui {

namespace session = model::session;

namespace {

void apply(Workspace& workspace, const model::SetThicknesses& state) {
    const LoadedBoard& board = *workspace.board();
    auto document = session::applyThicknesses(board.document, state.all());
    base::Status saved = base::Done{};
    if (!board.request.noSession) {
        saved = session::saveThicknesses(board.request.path, *document, state.saved);
    }
    if (!saved) {
        workspace.reportError(StackupPanel::tr("%1. The thicknesses count until another board is opened.")
                                  .arg(QString::fromStdString(saved.error().text)));
    }
    workspace.restack(std::move(document), state, saved.ok());
}

/// One step of the history, however many rows. A thickness of 0 takes a row back to what the job says.
void edit(Workspace& workspace, const std::vector<model::ThicknessOverride>& changes) {
    const model::SetThicknesses& before = workspace.board()->thicknesses;
    model::SetThicknesses after = before;
    for (const model::ThicknessOverride& change : changes) {
        session::setThickness(after.saved, change);
        session::setThickness(after.once, {change.layer, 0});  // the later word counts
    }
    if (after != before) {
        const QString what = changes.size() == 1
                                 ? StackupPanel::tr("thickness of %1").arg(QString::fromStdString(changes[0].layer))
                                 : StackupPanel::tr("thicknesses");
        workspace.history().push(new UndoStep<model::SetThicknesses>(
            what, before, after, [&workspace](const model::SetThicknesses& state) { apply(workspace, state); }));
    }
}

void connectView(FeatureContext& context, StackupView& view) {
    Workspace& workspace = context.workspace;
    const auto setColours = [&view, &layers = context.layers] { view.setStyles(layers.colours(), layers.soloLayer()); };
    const auto setBoard = [&view, setColours](const LoadedBoard& board) {
        view.setStackup(board.document);
        setColours();
    };
    QObject::connect(&context.layers, &LayerModel::stylesChanged, &view, setColours);
    QObject::connect(&workspace, &Workspace::boardOpened, &view, setBoard);
    QObject::connect(&workspace, &Workspace::restacked, &view, setBoard);
    QObject::connect(&view, &StackupView::isolateRequested, &workspace, [&](model::LayerId layer) {
        context.workspace.setCurrentLayer(layer);
        context.layers.toggleSolo(layer);
    });
    context.actions[ActionId::ExaggerateCopper].setChecked(view.isExaggerated());
    context.on(ActionId::ExaggerateCopper, &view, [&view](bool isOn) { view.setExaggerated(isOn); });
}

}  // namespace

void addStackup(FeatureContext& context) {
    Workspace& workspace = context.workspace;
    auto* stackup = new StackupModel(&context.window);
    auto* panel = new StackupPanel(*stackup, context.actions);
    context.addPanel(
        {ActionId::ShowStackupDock, "stack", StackupPanel::tr("Stackup"), Qt::LeftDockWidgetArea, "layers", 0}, *panel);
    const auto setBoard = [stackup](const LoadedBoard& board) { stackup->setDocument(board.document); };
    QObject::connect(&workspace, &Workspace::boardRead, stackup, setBoard);
    QObject::connect(&workspace, &Workspace::restacked, stackup, setBoard);
    QObject::connect(stackup, &StackupModel::edited, &workspace,
                     [&workspace](const auto& changes) { edit(workspace, changes); });
    QObject::connect(stackup, &StackupModel::refused, &workspace, &Workspace::errorReported);
    connectView(context, panel->view());
    context.on(ActionId::ExportStackup, panel, [&context, panel] {
        context.saveFile(StackupPanel::tr("Export stackup"),
                         {StackupPanel::tr("Drawings (*.svg)"), StackupPanel::tr("Tables (*.csv)")},
                         [&context, panel](const QString& path) {
                             return model::writeStackup(*context.workspace.board()->document, toPath(path),
                                                        panel->view().isExaggerated());
                         });
    });
}

}  // namespace ui
