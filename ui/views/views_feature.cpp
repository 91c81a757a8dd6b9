#include "ui/views/views_feature.h"

#include <QInputDialog>
#include <algorithm>

#include "ui/layers/current_layer.h"
#include "ui/parts/part_picking.h"
#include "ui/views/element_outlines.h"
#include "ui/views/element_styles.h"
#include "ui/views/frame_display.h"
#include "ui/views/layer_styles.h"
#include "ui/views/outline_veil.h"
#include "ui/views/picture_saver.h"
#include "ui/views/plan_painter.h"
#include "ui/views/probing.h"
#include "ui/views/view_cube.h"
#include "ui/views/view_history.h"
#include "ui/views/view_menu.h"

namespace ui {

namespace {

constexpr int kLargeWidth = 3840;  ///< proposed for pictures of any size

std::vector<LayerAppearance> defaultsOf(FeatureContext& context, const model::Document& document) {
    return defaultAppearances(document, context.settings.choice<render::Palette>(), context.layers.boardColours());
}

void takeDefaults(FeatureContext& context) {
    if (const model::Document* document = context.layers.document()) {
        context.layers.setDefaults(defaultsOf(context, *document));
    }
}

void connectBoard(FeatureContext& context) {
    Workspace& workspace = context.workspace;
    BoardViews& views = context.views;
    QObject::connect(&workspace, &Workspace::boardRead, &context.layers, [&context](const LoadedBoard& board) {
        context.layers.setDocument(board.document, defaultsOf(context, *board.document));
    });
    QObject::connect(&workspace, &Workspace::boardShown, &views, [&context](const LoadedBoard& board) {
        context.views.show(board, context.layers.effectiveStyles());
    });
    QObject::connect(&workspace, &Workspace::restacked, &views,
                     [&views](const LoadedBoard& board) { views.setHeights(board.document); });
    QObject::connect(&context.layers, &LayerModel::boardColoursChanged, &views, [&context] { takeDefaults(context); });
    QObject::connect(&context.layers, &LayerModel::stylesChanged, &views, [&context] {
        context.views.setBoardColours(context.layers.boardColours());
        context.views.setStyles(context.layers.effectiveStyles());
    });
    QObject::connect(&views, &BoardViews::troubled, &workspace, &Workspace::errorReported);
    QObject::connect(&views, &BoardViews::deviceGoes, &workspace, &Workspace::deviceGoes);
}

/// The layer that stands out is the one shown alone, or else the current one.
void connectContrast(FeatureContext& context) {
    Workspace& workspace = context.workspace;
    BoardViews& views = context.views;
    const auto setContrast = [&context] {
        const bool isOn = context.actions[ActionId::Contrast].isChecked();
        const model::LayerId solo = context.layers.soloLayer();
        const model::LayerId layer = solo.isValid() ? solo : context.workspace.currentLayer();
        context.views.setContrastLayer(isOn ? layer : model::LayerId{});
    };
    context.on(ActionId::Contrast, [&context, setContrast](bool isOn) {
        const bool hasLayer = isOn && takeCurrentLayer(context.workspace).isValid();
        setContrast();
        if (isOn && !hasLayer) {
            context.workspace.report(BoardViews::tr("All layers but the current one fade: choose one in Layers"));
        }
    });
    QObject::connect(&workspace, &Workspace::currentLayerChanged, &views, &BoardViews::setTopLayer);
    QObject::connect(&workspace, &Workspace::currentLayerChanged, &views, setContrast);
    QObject::connect(&context.layers, &LayerModel::stylesChanged, &views, setContrast);
    QObject::connect(&workspace, &Workspace::boardOpened, &views, setContrast);
}

/// Before what the commands do: hints on it are about a view that is seen. To switch something off needs no look at it.
void connectHiddenViews(FeatureContext& context) {
    BoardViews& views = context.views;
    QObject::connect(&views, &BoardViews::bothWanted, &context.actions[ActionId::ShowSideBySide], &QAction::trigger);
    for (const ActionSpec& spec : ActionSet::kSpecs) {
        if ((spec.flags & (kInFlat | kInSolid)) != 0) {
            const BoardView& view = (spec.flags & kInFlat) != 0 ? views.flat() : views.solid();
            context.on(spec.id, &views, [&views, &view, isSwitch = (spec.flags & kCheckable) != 0](bool isOn) {
                if (isOn || !isSwitch) {
                    views.reveal(view);
                }
            });
        }
    }
}

void connectCameras(FeatureContext& context) {
    BoardViews& views = context.views;
    const auto on = [&](ActionId id, auto slot) {
        context.on(id, &views, [&views, slot](bool isOn) { slot(views.active().controller(), isOn); });
    };
    using Camera = CameraController;
    on(ActionId::Fit, [](Camera& camera, bool) { camera.fit(); });
    on(ActionId::ZoomIn, [](Camera& camera, bool) { camera.zoomAtCentre(Camera::kZoomPerNotch); });
    on(ActionId::ZoomOut, [](Camera& camera, bool) { camera.zoomAtCentre(1.0F / Camera::kZoomPerNotch); });
    on(ActionId::Flip, [](Camera& camera, bool) { camera.flip(); });
    on(ActionId::ViewTop, [](Camera& camera, bool) { camera.lookAtSide(render::NamedView::Top); });
    on(ActionId::ViewBottom, [](Camera& camera, bool) { camera.lookAtSide(render::NamedView::Bottom); });
    Camera& solid = views.solid().controller();
    context.on(ActionId::ViewIso, &solid, [&solid] { solid.look(render::NamedView::Iso); });
    context.on(ActionId::Orthographic, &solid, [&solid](bool isOn) { solid.setOrthographic(isOn); });
    for (BoardView* view : views.both()) {
        auto* history = new ViewHistory(view->controller(), view);
        QObject::connect(&context.workspace, &Workspace::boardOpened, history, &ViewHistory::clear);
        const auto ifActive = [&views, view, history](void (ViewHistory::*go)()) {
            return [&views, view, history, go] {
                if (&views.active() == view) {
                    (history->*go)();
                }
            };
        };
        context.on(ActionId::ViewBack, history, ifActive(&ViewHistory::back));
        context.on(ActionId::ViewForward, history, ifActive(&ViewHistory::forward));
    }
}

void connectProbing(FeatureContext& context) {
    Probing& probing = context.probing;
    QObject::connect(&probing, &Probing::componentRequested, &context.parts, &PartPicking::selectComponentOf);
    context.on(ActionId::FollowInSolid, [&](bool isOn) { probing.setFollows(BoardView::Kind::Solid, isOn); });
    context.on(ActionId::FollowInFlat, [&](bool isOn) { probing.setFollows(BoardView::Kind::Flat, isOn); });
    context.on(ActionId::ShowSelection, [&probing, &workspace = context.workspace] {
        const std::vector<model::BoardElement> chosen = workspace.selection().selectionElements();
        if (chosen.empty()) {
            workspace.report(BoardViews::tr("Nothing is selected: click an element or highlight a net first"));
        }
        probing.showInBoth(chosen);
    });
}

void connectOverlays(FeatureContext& context) {
    PlanPainter& plan = context.plan;
    BoardViews& views = context.views;
    new ElementStyles(views, context.workspace.selection(), context.netStyles, context.actions[ActionId::DimOthers],
                      &context.window);
    new ElementOutlines(views, context.workspace, context.netStyles, &context.window);
    auto* veil = new OutlineVeil(views.flat(), context.workspace, &context.window);
    context.on(ActionId::ShowMilledAway, veil, [veil, &views](bool isOn) {
        veil->setOn(!isOn);
        views.solid().setFabricated(!isOn);
    });
    auto* cube = new ViewCube(views.solid(), &context.window);
    auto* frameDisplay = new FrameDisplay(views, context.workspace, &context.window);
    context.on(ActionId::ShowViewCube, cube, [cube](bool isOn) { cube->setOn(isOn); });
    context.on(ActionId::ShowFrameDisplay, frameDisplay, [frameDisplay](bool isOn) { frameDisplay->setOn(isOn); });
    context.on(ActionId::ShowGrid, &plan, [&plan](bool isOn) { plan.showGrid(isOn); });
    context.on(ActionId::ShowNames, &plan, [&plan](bool isOn) { plan.showNames(isOn); });
    context.on(ActionId::ShowPinNames, &plan, [&plan](bool isOn) { plan.showPinNames(isOn); });
    context.on(ActionId::ShowOutlines, &views, [&views](bool isOn) { views.flat().setOutlined(isOn); });
    for (const ActionId id :
         {ActionId::ShowViewCube, ActionId::ShowGrid, ActionId::ShowNames, ActionId::ShowPinNames}) {
        context.actions[id].setChecked(true);
    }
}

/// The arrangement that is there already, chosen again, makes both views alike.
void connectDivision(FeatureContext& context) {
    BoardViews& views = context.views;
    const auto keep = [&settings = context.settings](double share) { settings.setFlatShare(share); };
    QObject::connect(&views, &BoardViews::divided, &context.window, keep);
    for (const auto& [id, arrangement] : {std::pair(ActionId::ShowSideBySide, Arrangement::SideBySide),
                                          std::pair(ActionId::ShowStacked, Arrangement::Stacked)}) {
        context.on(id, [&views, keep, own = arrangement] {
            if (views.arrangement() == own) {
                keep(0.5);
                views.divide(0.5);
            }
        });
    }
    context.restorers.emplace_back([&context] { context.views.divide(context.settings.flatShare()); });
}

void connectAppearance(FeatureContext& context) {
    BoardViews& views = context.views;
    context.addChoice<Arrangement>({{ActionId::ShowFlat, Arrangement::Flat},
                                    {ActionId::ShowSolid, Arrangement::Solid},
                                    {ActionId::ShowSideBySide, Arrangement::SideBySide},
                                    {ActionId::ShowStacked, Arrangement::Stacked}},
                                   [&views](Arrangement arrangement) { views.setArrangement(arrangement); });
    context.addChoice<render::Backend>({{ActionId::BackendAuto, render::Backend::Auto},
                                        {ActionId::BackendMesh, render::Backend::Mesh},
                                        {ActionId::BackendPull, render::Backend::Pull},
                                        {ActionId::BackendImpostor, render::Backend::Impostor},
                                        {ActionId::BackendRaster, render::Backend::Raster}},
                                       [&views](render::Backend backend) { views.setBackend(backend); });
    context.actions[ActionId::BackendMesh].setEnabled(context.device.device().caps().hasMeshShader);
    context.actions[ActionId::BackendRaster].setEnabled(context.device.device().caps().hasAtomic64);
    const auto setPalette = [&context](render::Palette palette) {
        context.actions[ActionId::SafeColours].setChecked(palette == render::Palette::ColourBlindSafe);
        context.settings.choose(palette);
        context.views.setPalette(palette);
        takeDefaults(context);
    };
    context.on(ActionId::SafeColours, [setPalette](bool isOn) {
        setPalette(isOn ? render::Palette::ColourBlindSafe : render::Palette::Standard);
    });
    context.restorers.emplace_back([&context, setPalette] { setPalette(context.settings.choice<render::Palette>()); });
}

void requestPicture(FeatureContext& context, PictureSaver& pictures, int width) {
    context.nameFile(
        BoardViews::tr("Save picture"), BoardViews::tr("picture"), {BoardViews::tr("PNG pictures (*.png)")},
        [&context, &pictures, width](const QString& path) { pictures.save(context.views.active(), path, width); });
}

void requestWidth(FeatureContext& context, PictureSaver& pictures) {
    const int most = static_cast<int>(context.device.device().caps().maxImageSize);
    auto* dialog = new QInputDialog(&context.window);
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    dialog->setInputMode(QInputDialog::IntInput);
    dialog->setWindowTitle(BoardViews::tr("Save picture of any size"));
    dialog->setLabelText(BoardViews::tr("Width in pixels; the height follows from the view:"));
    dialog->setIntRange(16, most);
    dialog->setIntValue(std::min(kLargeWidth, most));
    QObject::connect(dialog, &QInputDialog::intValueSelected, &context.views,
                     [&context, &pictures](int width) { requestPicture(context, pictures, width); });
    dialog->open();
}

void connectPictures(FeatureContext& context) {
    auto* pictures = new PictureSaver(context);
    context.on(ActionId::SavePicture, [&context, pictures] { requestPicture(context, *pictures, 0); });
    context.on(ActionId::SaveLargePicture, [&context, pictures] { requestWidth(context, *pictures); });
    context.on(ActionId::CopyPicture, [&context, pictures] { pictures->copy(context.views.active()); });
}

}  // namespace

void addViews(FeatureContext& context) {
    connectBoard(context);
    connectHiddenViews(context);
    connectContrast(context);
    connectCameras(context);
    connectProbing(context);
    addViewMenu(context);
    connectOverlays(context);
    connectDivision(context);
    connectAppearance(context);
    connectPictures(context);
}

}  // namespace ui
