#include "ui/saved_views/saved_views_feature.h"

#include <QHeaderView>
#include <glm/trigonometric.hpp>
#include <map>
#include <string>
#include <utility>

#include "ui/common/panel_parts.h"
#include "ui/common/table_view.h"
#include "ui/layers/layer_model.h"
#include "ui/views/board_views.h"
#include "ui/workspace/read_anew.h"

namespace ui {

namespace session = model::session;

namespace {

session::Pose poseOf(const CameraController& controller, base::Point origin) {
    const render::CameraPose& pose = controller.camera().pose();
    return {{pose.target.x, pose.target.y, pose.target.z},
            pose.distance,
            glm::degrees(pose.yaw),
            glm::degrees(pose.pitch),
            pose.isOrthographic,
            origin,
            controller.aspect()};
}

/// On a board with this middle.
render::CameraPose cameraPose(const session::Pose& pose, base::Point origin) {
    const base::Point before = pose.origin.value_or(origin);
    return {{pose.target[0] + base::toMm(double{1} * before.x - origin.x),
             pose.target[1] + base::toMm(double{1} * before.y - origin.y), pose.target[2]},
            static_cast<float>(pose.distance),
            glm::radians(static_cast<float>(pose.yawDeg)),
            glm::radians(static_cast<float>(pose.pitchDeg)),
            pose.isParallel};
}

/// The only layer of each file that all of a layer comes from.
std::map<std::string, std::string> layersByFile(const model::Document& board) {
    std::map<std::string, std::string> names;
    for (const model::Layer& layer : board.layers) {
        const auto [row, isNew] = names.try_emplace(layer.file, layer.name);
        row->second = isNew && !layer.file.empty() ? layer.name : std::string();
    }
    std::erase_if(names, [](const auto& row) { return row.second.empty(); });
    return names;
}

/// New names by old ones of layers that come from the same file: a layer that is told what it draws has another name.
std::map<std::string, std::string> renamedLayers(const model::Document& before, const model::Document& after) {
    const std::map<std::string, std::string> now = layersByFile(after);
    std::map<std::string, std::string> names;
    for (const auto& [file, name] : layersByFile(before)) {
        const auto found = now.find(file);
        if (found != now.end() && found->second != name) {
            names.emplace(name, found->second);
        }
    }
    return names;
}

}  // namespace

SavedViewsFeature::SavedViewsFeature(FeatureContext& context)
    : QObject(&context.window),
      m_workspace(context.workspace),
      m_settings(context.settings),
      m_views(context.views),
      m_layers(context.layers),
      m_orthographic(context.actions[ActionId::Orthographic]),
      m_savedDesk(m_workspace, tr("Cameras and layers")),
      m_saved(m_workspace, tr("The views"), &session::Session::views, session::saveViews,
              [this](const auto& views) { take(views); }) {
    m_list.setParent(this);
    addPanel(context);
    context.on(ActionId::SaveView, this, [this] { saveView(); });
    context.on(ActionId::SaveSelection, this, [this] { saveSelection(); });
    context.on(ActionId::SaveSession, this, [this] { saveDesk(); });
    connect(&m_list, &ViewListModel::renamed, this,
            [this](int row, const QString& name) { m_saved.rename(tr("the name of a view"), row, name); });
    connect(&m_workspace, &Workspace::boardLeaves, this, &SavedViewsFeature::keep);
    connect(&m_workspace, &Workspace::sessionRestored, this, &SavedViewsFeature::restoreDesk);
}

void SavedViewsFeature::addPanel(FeatureContext& context) {
    auto* table = new TableView(m_list);
    table->setSelectionMode(QAbstractItemView::SingleSelection);
    table->horizontalHeader()->setStretchLastSection(true);
    // A double click is a click that was meant well: it goes there, and the next key does not overwrite the name.
    table->setEditTriggers(QAbstractItemView::EditKeyPressed);
    addRowCommands(*table);
    QAction& remove = table->addDelete(tr("Delete the selected view or selection (Del)"));
    connect(table, &TableView::deleteRequested, this,
            [this](const auto& rows) { m_saved.remove(tr("deleting a view"), rows); });
    connect(table, &TableView::rowChosen, this, &SavedViewsFeature::goTo);
    const ActionSet& actions = context.actions;
    context.addPanel(
        {ActionId::ShowSavedViewsDock, "views", tr("Saved views"), Qt::LeftDockWidgetArea},
        *panelOf(buttonRow({&actions[ActionId::SaveView], &actions[ActionId::SaveSelection], &remove}), table));
}

void SavedViewsFeature::addRowCommands(TableView& table) {
    const auto add = [&table](const char* name, const QString& text, auto run) {
        QAction* action = table.addAction(text, &table, [&table, run] {
            if (table.currentIndex().isValid()) {
                run(table.currentIndex());
            }
        });
        action->setObjectName(QLatin1String(name));
    };
    add("show", tr("Show"), [&table](const QModelIndex& at) { table.choose(at); });
    add("update", tr("Update"), [this](const QModelIndex& at) { update(at.row()); });
    add("rename", tr("Rename\tF2"),
        [&table](const QModelIndex& at) { table.edit(at.siblingAtColumn(ViewListModel::Name)); });
}

void SavedViewsFeature::take(const std::vector<session::SavedView>& views) {
    m_list.setViews(views);
    std::vector<session::LayerSet> sets;
    for (const session::SavedView& view : views) {
        if (!view.selection) {
            sets.push_back({view.name, view.layers});
        }
    }
    m_layers.offerSets(std::move(sets));
}

session::SavedSelection SavedViewsFeature::marked() const {
    const SelectionModel& selection = m_workspace.selection();
    const bool isFew = selection.selected().size() <= session::kMostSavedElements;
    return session::saveSelection(selection.tree(), isFew ? selection.selected() : std::vector<model::BoardElement>{},
                                  selection.nets());
}

session::SavedView SavedViewsFeature::shownView() const {
    session::SavedSelection selection = marked();
    return {{},
            {},
            poseOf(m_views.flat().controller(), origin()),
            poseOf(m_views.solid().controller(), origin()),
            m_layers.visibleNames(),
            std::nullopt,
            std::move(selection.nets),
            nameOf(m_workspace.currentLayer()),
            std::move(selection.elements)};
}

void SavedViewsFeature::saveView() {
    m_saved.addAndReport(tr("saving a view"), shownView(), "View ");
}

std::optional<session::SavedView> SavedViewsFeature::shownSelection() const {
    const SelectionModel& selection = m_workspace.selection();
    if (selection.selected().empty() && selection.nets().empty()) {
        m_workspace.report(tr("Select elements or highlight nets to save them"));
        return std::nullopt;
    }
    if (selection.selected().size() > session::kMostSavedElements) {
        m_workspace.report(tr("%L1 elements are too many to save, %L2 is the most; highlight nets instead")
                               .arg(selection.selected().size())
                               .arg(session::kMostSavedElements));
        return std::nullopt;
    }
    session::SavedView saved;
    saved.selection = session::saveSelection(selection.tree(), selection.selected(), selection.nets());
    return saved;
}

void SavedViewsFeature::saveSelection() {
    if (std::optional<session::SavedView> saved = shownSelection()) {
        m_saved.add(tr("saving a selection"), std::move(*saved), "Selection ");
    }
}

void SavedViewsFeature::update(int row) {
    const session::SavedView& before = m_saved.entries()[static_cast<std::size_t>(row)];
    const QString name = QString::fromStdString(before.name);
    if (!m_workspace.isOpen(before.step)) {
        reportOtherStep(before);
        return;
    }
    std::optional<session::SavedView> now = before.selection ? shownSelection() : std::optional(shownView());
    if (now) {
        now->name = before.name;
        now->step = before.step;
        m_saved.change(tr("updating a view"), row, [&now](session::SavedView& view) { view = *now; });
        m_workspace.report(tr("%1 is updated").arg(name));
    }
}

void SavedViewsFeature::reportOtherStep(const session::SavedView& view) const {
    m_workspace.report(tr("%1 shows step %2, which is not open")
                           .arg(QString::fromStdString(view.name), QString::fromStdString(view.step)));
}

void SavedViewsFeature::goTo(int row) {
    const session::SavedView& view = m_saved.entries()[static_cast<std::size_t>(row)];
    const QString name = QString::fromStdString(view.name);
    if (!m_workspace.isOpen(view.step)) {
        reportOtherStep(view);
        return;
    }
    if (view.selection) {
        select(name, *view.selection);
    } else {
        m_layers.showOnly(view.layers);
        if (view.current) {
            m_workspace.setCurrentLayer(m_workspace.board()->document->findLayer(*view.current));
        }
        setCameras(view.flat, view.solid);
        if (!view.nets.empty() || !view.elements.empty()) {
            select(name, {view.nets, view.elements});
        }
    }
    m_workspace.report(name);
}

void SavedViewsFeature::setCameras(const session::Pose& flat, const session::Pose& solid) {
    const auto put = [this](CameraController& controller, const session::Pose& pose) {
        const auto aspect = static_cast<float>(pose.aspect.value_or(0.0));  // none is narrower
        controller.restore(cameraPose(pose, origin()), aspect);
    };
    put(m_views.flat().controller(), flat);
    put(m_views.solid().controller(), solid);
    m_orthographic.setChecked(m_views.solid().controller().camera().isOrthographic());
}

void SavedViewsFeature::select(const QString& name, const session::SavedSelection& saved) {
    SelectionModel& selection = m_workspace.selection();
    session::FoundSelection found = session::findSelection(selection.tree(), saved);
    selection.setNets(std::move(found.nets));
    selection.select(found.elements);
    QStringList missing;
    for (const std::string& net : found.missingNets) {
        missing += tr("net %1").arg(QString::fromStdString(net));
    }
    if (found.missingElements > 0) {
        missing += tr("%L1 of %L2 elements").arg(found.missingElements).arg(saved.elements.size());
    }
    if (!missing.isEmpty()) {
        m_workspace.reportError(tr("%1: not on this board: %2").arg(name, missing.join(QStringLiteral(", "))));
    }
}

void SavedViewsFeature::saveDesk() {
    const LoadedBoard& board = *m_workspace.board();
    if (board.request.noSession) {
        m_workspace.reportError(tr("This board was opened without its session, so nothing is saved."));
        return;
    }
    const QString file = QString::fromStdString(session::sessionPath(board.request.path).string());
    m_savedDesk.write([desk = desk()](const auto& path, const auto& document,
                                      auto* known) { return session::saveDesk(path, document, desk, known); },
                      [this, file](const base::Status& saved, bool) { m_workspace.reportSaved(saved, file); });
}

base::Point SavedViewsFeature::origin() const {
    return m_workspace.board()->model->origin;
}

std::string SavedViewsFeature::nameOf(model::LayerId layer) const {
    return layer.isValid() ? m_workspace.board()->document->layer(layer).name : std::string();
}

session::Desk SavedViewsFeature::desk() const {
    return {m_workspace.board()->document->job.step,
            poseOf(m_views.flat().controller(), origin()),
            poseOf(m_views.solid().controller(), origin()),
            unitName(m_workspace.unit()),
            m_layers.states(),
            nameOf(m_layers.soloLayer())};
}

void SavedViewsFeature::keep(const LoadedBoard& next) {
    const LoadedBoard& board = *m_workspace.board();
    m_kept.reset();
    m_stepBefore = isOtherStep(m_workspace, next) ? std::optional(desk()) : std::nullopt;
    if (!isReadAnew(m_workspace, next)) {
        return;
    }
    m_kept = Kept{desk(), marked(), m_workspace.selection().title(), nameOf(m_workspace.currentLayer())};
    const auto rename = [names = renamedLayers(*board.document, *next.document)](std::string& name) {
        const auto found = names.find(name);
        name = found != names.end() ? found->second : name;
    };
    for (session::LayerState& layer : m_kept->desk.layers) {
        rename(layer.layer);
    }
    for (session::SavedElement& element : m_kept->selection.elements) {
        rename(element.layer);
    }
    rename(m_kept->currentLayer);
    rename(m_kept->desk.solo);
}

void SavedViewsFeature::restoreLayers(const model::Document& board, const session::Desk& desk) {
    m_layers.setStates(desk.layers);
    LayerSettings settings = m_layers.settings();
    settings.solo = board.findLayer(desk.solo);
    m_layers.setSettings(settings);
}

void SavedViewsFeature::restoreKept(const LoadedBoard& board) {
    const Kept kept = *std::exchange(m_kept, std::nullopt);
    restoreLayers(*board.document, kept.desk);
    m_workspace.setCurrentLayer(board.document->findLayer(kept.currentLayer));
    setCameras(kept.desk.flat, kept.desk.solid);
    SelectionModel& selection = m_workspace.selection();
    session::FoundSelection found = session::findSelection(selection.tree(), kept.selection);
    selection.setNets(std::move(found.nets));
    if (!kept.title.isEmpty() && !found.elements.empty()) {
        selection.selectAs(kept.title, found.elements);
    } else {
        selection.select(found.elements);
    }
}

void SavedViewsFeature::restoreDesk(const LoadedBoard& board) {
    if (m_kept) {
        restoreKept(board);
        return;
    }
    m_savedDesk.begin();
    const std::optional<session::Desk>& desk = board.session.desk;
    if (desk && m_workspace.isOpen(desk->step)) {
        restoreLayers(*board.document, *desk);
        m_workspace.setCurrentLayer(m_layers.soloLayer());
        setCameras(desk->flat, desk->solid);
        showUnit(unitNamed(desk->unit));
    } else if (m_stepBefore) {
        restoreLayers(*board.document, *m_stepBefore);
        m_workspace.setCurrentLayer(m_layers.soloLayer());
    } else {
        showUnit(m_settings.choice<LengthUnit>());
    }
}

/// The session of a board does not change what the user likes for others.
void SavedViewsFeature::showUnit(LengthUnit unit) {
    if (unit != m_workspace.unit()) {
        m_workspace.setUnit(unit);
    }
}

}  // namespace ui
