#include "ui/stackup/stackup_feature.h"

#include <algorithm>

#include "model/board/stackup.h"
#include "model/export/stackup_export.h"
#include "ui/common/paths.h"
#include "ui/common/thickness_text.h"
#include "ui/layers/layer_model.h"
#include "ui/stackup/stackup_panel.h"
#include "ui/stackup/stackup_pdf.h"
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

/// What else became thicker or thinner, as the board stays as thick as it is known to be: "DIELECTRIC_2, DIELECTRIC_3".
QString madeUpBy(const model::Stackup& before, const model::Stackup& after,
                 const std::vector<model::ThicknessOverride>& changes) {
    QStringList names;
    for (const model::StackupRow& row : after.rows) {
        const model::StackupRow* old = model::findRow(before, row.name);
        const bool isEdited = std::ranges::count(changes, row.name, &model::ThicknessOverride::layer) > 0;
        if (!isEdited && old != nullptr && old->thickness != row.thickness) {
            names += QString::fromStdString(row.name);
        }
    }
    return names.join(QStringLiteral(", "));
}

/// One step of the history, however many rows. A thickness of 0 takes a row back to what the job says.
void edit(Workspace& workspace, const std::vector<model::ThicknessOverride>& changes) {
    const model::SetThicknesses& before = workspace.board()->thicknesses;
    model::SetThicknesses after = before;
    for (const model::ThicknessOverride& change : changes) {
        session::setThickness(after.saved, change);
        session::setThickness(after.once, {change.layer, 0});  // the later word counts
    }
    const std::shared_ptr<const model::Document> document = workspace.board()->document;
    if (after != before) {
        const QString what = changes.size() == 1
                                 ? StackupPanel::tr("thickness of %1").arg(QString::fromStdString(changes[0].layer))
                                 : StackupPanel::tr("thicknesses");
        workspace.history().push(new UndoStep<model::SetThicknesses>(
            what, before, after, [&workspace](const model::SetThicknesses& state) { apply(workspace, state); }));
        const QString others = madeUpBy(document->stackup, workspace.board()->document->stackup, changes);
        if (!others.isEmpty()) {
            workspace.report(StackupPanel::tr("Of assumed thickness and changed too, so that the board stays as thick "
                                              "as it is taken to be: %1")
                                 .arg(others));
        }
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
    QObject::connect(&workspace, &Workspace::unitChanged, &view, &StackupView::setUnit);
    context.actions[ActionId::ExaggerateCopper].setChecked(view.isExaggerated());
    context.on(ActionId::ExaggerateCopper, &view, [&view](bool isOn) { view.setExaggerated(isOn); });
}

/// Is there anything of it to be seen in the views?
bool isDrawn(const model::Document& document, model::LayerId id) {
    const model::Layer& layer = document.layer(id);
    return layer.elements.count > 0 || std::ranges::any_of(layer.countsWithCopies, [](auto n) { return n > 0; });
}

/// With the layer of another row alone in the views, they show that of this one instead.
void follow(FeatureContext& context, model::LayerId layer) {
    if (!layer.isValid()) {
        return;  // a dielectric that the job has no layer for
    }
    context.workspace.setCurrentLayer(layer);
    const model::LayerId alone = context.layers.soloLayer();
    if (alone.isValid() && alone != layer && isDrawn(*context.workspace.board()->document, layer)) {
        context.layers.toggleSolo(layer);
    }
}

void isolate(FeatureContext& context, model::LayerId layer) {
    const model::Document& document = *context.workspace.board()->document;
    if (isDrawn(document, layer)) {
        context.layers.toggleSolo(layer);
    } else {
        context.workspace.report(StackupPanel::tr("%1 draws nothing that could be shown alone")
                                     .arg(QString::fromStdString(document.layer(layer).name)));
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
    context.escapes.emplace_back([&layers = context.layers] {
        const bool isAlone = layers.soloLayer().isValid();
        if (isAlone) {
            layers.toggleSolo(layers.soloLayer());
        }
        return isAlone;
    });
}

base::Status save(const FeatureContext& context, const QString& path, bool isExaggerated) {
    const model::Document& document = *context.workspace.board()->document;
    const model::LengthWriter write = lengthWriter(context.workspace.unit());
    return path.endsWith(QStringLiteral(".pdf"), Qt::CaseInsensitive)
               ? writeStackupPdf(document, path, isExaggerated, write)
               : model::writeStackup(document, toPath(path), isExaggerated, write);
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
    QObject::connect(&workspace, &Workspace::restacked, stackup, setBoard);
    QObject::connect(&workspace, &Workspace::unitChanged, stackup, &StackupModel::setUnit);
    QObject::connect(stackup, &StackupModel::edited, &workspace,
                     [&workspace](const auto& changes) { edit(workspace, changes); });
    QObject::connect(stackup, &StackupModel::refused, &workspace, &Workspace::errorReported);
    connectView(context, panel->view());
    connectRows(context, *panel, *stackup);
    context.on(ActionId::ExportStackup, panel, [&context, panel] {
        context.saveFile(
            StackupPanel::tr("Export stackup"), StackupPanel::tr("stackup"),
            {StackupPanel::tr("Drawings (*.svg)"), StackupPanel::tr("Documents (*.pdf)"),
             StackupPanel::tr("Tables (*.csv)")},
            [&context, panel](const QString& path) { return save(context, path, panel->view().isExaggerated()); });
    });
}

}  // namespace ui
