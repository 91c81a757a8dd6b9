#include "ui/stackup/stackup_feature.h"

#include <algorithm>

#include "model/export/stackup_export.h"
#include "ui/common/paths.h"
#include "ui/common/thickness_text.h"
#include "ui/layers/layer_model.h"
#include "ui/stackup/stackup_panel.h"
#include "ui/stackup/stackup_pdf.h"
#include "ui/stackup/stackup_view.h"
#include "ui/stackup/thickness_editing.h"
#include "ui/workspace/read_anew.h"

namespace ui {

namespace {

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
    QObject::connect(&workspace, &Workspace::unitChanged, &view, &StackupView::setUnit);
    context.actions[ActionId::ExaggerateCopper].setChecked(view.isExaggerated());
    context.on(ActionId::ExaggerateCopper, &view, [&view](bool isOn) { view.setExaggerated(isOn); });
}

/// With the layer of another row alone in the views, they show that of this one instead.
void follow(FeatureContext& context, model::LayerId layer) {
    if (!layer.isValid()) {
        return;  // a dielectric that the job has no layer for
    }
    context.workspace.setCurrentLayer(layer);
    const model::LayerId alone = context.layers.soloLayer();
    if (alone.isValid() && alone != layer && !drawsNothing(context.workspace.board()->document->layer(layer))) {
        context.layers.toggleSolo(layer);
    }
}

void isolate(FeatureContext& context, model::LayerId layer) {
    const model::Layer& row = context.workspace.board()->document->layer(layer);
    if (drawsNothing(row)) {
        context.workspace.report(
            StackupPanel::tr("%1 draws nothing that could be shown alone").arg(QString::fromStdString(row.name)));
    } else {
        context.layers.toggleSolo(layer);
    }
}

void connectRows(FeatureContext& context, StackupPanel& panel, const StackupModel& stackup) {
    QObject::connect(&panel, &StackupPanel::rowSelected, &context.workspace,
                     [&context, &stackup](int row) { follow(context, stackup.row(row).layer); });
    QObject::connect(&panel.view(), &StackupView::holesChosen, &context.workspace,
                     [&context](model::LayerId layer) { follow(context, layer); });
    QObject::connect(&context.workspace, &Workspace::currentLayerChanged, &panel, &StackupPanel::selectLayer);
    QObject::connect(&panel.view(), &StackupView::isolateRequested, &context.workspace,
                     [&context](model::LayerId layer) { isolate(context, layer); });
    context.escapes.emplace(EscapeRank::Alone, [&layers = context.layers] {
        const bool isAlone = layers.soloLayer().isValid();
        if (isAlone) {
            layers.toggleSolo(layers.soloLayer());
        }
        return isAlone;
    });
}

base::Result<std::string> fileOf(const FeatureContext& context, const QString& path, bool isExaggerated) {
    const model::Document& document = *context.workspace.board()->document;
    const model::LengthWriter write = lengthWriter(context.workspace.unit());
    return path.endsWith(QStringLiteral(".pdf"), Qt::CaseInsensitive)
               ? stackupPdf(document, isExaggerated, write)
               : model::stackupFile(document, toPath(path), isExaggerated, write);
}

}  // namespace

void addStackup(FeatureContext& context) {
    Workspace& workspace = context.workspace;
    auto* stackup = new StackupModel(&context.window);
    auto* panel = new StackupPanel(*stackup, context.actions);
    context.addPanel({ActionId::ShowStackupDock, "stackup", StackupPanel::tr("Stackup"), Qt::LeftDockWidgetArea},
                     *panel);
    const auto setBoard = [stackup](const LoadedBoard& board) { stackup->setDocument(board.document); };
    QObject::connect(&workspace, &Workspace::boardRead, stackup, setBoard);
    QObject::connect(&workspace, &Workspace::boardRead, panel, &StackupPanel::clearSelection);
    QObject::connect(&workspace, &Workspace::boardLeaves, panel, [&workspace, panel](const LoadedBoard& next) {
        if (!isReadAnew(workspace, next)) {
            panel->scrollToTop();
        }
    });
    QObject::connect(&workspace, &Workspace::restacked, stackup, setBoard);
    QObject::connect(&workspace, &Workspace::unitChanged, stackup, &StackupModel::setUnit);
    auto* editing = new ThicknessEditing(workspace, &context.window);
    QObject::connect(stackup, &StackupModel::edited, editing, &ThicknessEditing::edit);
    QObject::connect(stackup, &StackupModel::refused, &workspace, &Workspace::errorReported);
    connectView(context, panel->view());
    connectRows(context, *panel, *stackup);
    context.on(ActionId::ExportStackup, panel, [&context, panel] {
        if (context.workspace.board()->document->stackup.rows.empty()) {
            context.workspace.report(
                StackupPanel::tr("There is no stackup to export: this board states its heights itself"));
            return;
        }
        context.saveFile(
            StackupPanel::tr("Export stackup"), StackupPanel::tr("stackup"),
            {StackupPanel::tr("Drawings (*.svg)"), StackupPanel::tr("Documents (*.pdf)"),
             StackupPanel::tr("Tables (*.csv)")},
            [&context, panel](const QString& path) { return fileOf(context, path, panel->view().isExaggerated()); });
    });
}

}  // namespace ui
