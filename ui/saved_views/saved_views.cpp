#include "ui/saved_views/saved_views.h"

#include <algorithm>
#include <glm/trigonometric.hpp>
#include <utility>

#include "ui/workspace/state_edit.h"

namespace ui {

namespace session = model::session;

namespace {

session::Pose poseOf(const CameraController& controller) {
    const render::CameraPose& pose = controller.camera().pose();
    return {{pose.target.x, pose.target.y, pose.target.z},
            pose.distance,
            glm::degrees(pose.yaw),
            glm::degrees(pose.pitch),
            pose.isOrthographic};
}

render::CameraPose cameraPose(const session::Pose& pose) {
    return {{pose.target[0], pose.target[1], pose.target[2]},
            static_cast<float>(pose.distance),
            glm::radians(static_cast<float>(pose.yawDeg)),
            glm::radians(static_cast<float>(pose.pitchDeg)),
            pose.isParallel};
}

}  // namespace

SavedViews::SavedViews(BoardViews& views, LayerModel& layers, SelectionModel& selection, QUndoStack& history,
                       QObject* parent)
    : QObject(parent), m_views(views), m_layers(layers), m_selection(selection), m_history(history) {
    connect(&m_list, &ViewListModel::renamed, this, &SavedViews::rename);
}

void SavedViews::setBoard(const LoadedBoard& board) {
    if (m_session.open(board)) {
        m_list.setViews(board.views);
    }
}

void SavedViews::keep() {
    if (m_session.document() == nullptr) {
        return;
    }
    List after = m_list.views();
    after.push_back({freeName("View"), m_session.document()->job.step, poseOf(m_views.flat().controller()),
                     poseOf(m_views.solid().controller()), m_layers.visibleNames(), std::nullopt});
    change(QStringLiteral("keeping a view"), std::move(after));
}

void SavedViews::saveSelection() {
    if (m_selection.selected().empty() && m_selection.nets().empty()) {
        emit notKept(QStringLiteral("Select elements or highlight nets to keep them"));
        return;
    }
    if (m_selection.selected().size() > session::kMostSavedElements) {
        emit notKept(QStringLiteral("%L1 elements are too many to keep, %L2 is the most; highlight nets instead")
                         .arg(m_selection.selected().size())
                         .arg(session::kMostSavedElements));
        return;
    }
    session::SavedView kept{freeName("Selection"), m_session.document()->job.step, {}, {}, {}, std::nullopt};
    kept.selection = session::saveSelection(m_selection.tree(), m_selection.selected(), m_selection.nets());
    List after = m_list.views();
    after.push_back(std::move(kept));
    change(QStringLiteral("keeping a selection"), std::move(after));
}

void SavedViews::rename(int row, const QString& name) {
    List after = m_list.views();
    after[static_cast<std::size_t>(row)].name = name.toStdString();
    change(QStringLiteral("the name of a view"), std::move(after));
}

void SavedViews::remove(int row) {
    List after = m_list.views();
    after.erase(after.begin() + row);
    change(QStringLiteral("forgetting a view"), std::move(after));
}

void SavedViews::goTo(int row) {
    const session::SavedView& view = m_list.views()[static_cast<std::size_t>(row)];
    const QString name = QString::fromStdString(view.name);
    if (view.step != m_session.document()->job.step) {
        emit otherStep(name, QString::fromStdString(view.step));
        return;
    }
    if (view.selection) {
        select(view);
        return;
    }
    m_layers.showOnly(view.layers);
    m_views.flat().controller().setPose(cameraPose(view.flat));
    m_views.solid().controller().setPose(cameraPose(view.solid));
    emit shown(name);
}

void SavedViews::select(const session::SavedView& kept) {
    session::FoundSelection found = session::findSelection(m_selection.tree(), *kept.selection);
    m_selection.setNets(std::move(found.nets));
    m_selection.select(found.elements);
    QStringList missing;
    for (const std::string& net : found.missingNets) {
        missing += QStringLiteral("net %1").arg(QString::fromStdString(net));
    }
    if (found.missingElements > 0) {
        missing +=
            QStringLiteral("%L1 of %L2 elements").arg(found.missingElements).arg(kept.selection->elements.size());
    }
    if (!missing.isEmpty()) {
        emit missed(QStringLiteral("%1: not on this board: %2")
                        .arg(QString::fromStdString(kept.name), missing.join(QStringLiteral(", "))));
    }
    emit shown(QString::fromStdString(kept.name));
}

void SavedViews::saveDesk(LengthUnit unit) {
    if (m_session.isWithoutSession()) {
        emit notSaved(QStringLiteral("This board was opened without its session, so nothing is saved."));
        return;
    }
    const session::Desk desk{m_session.document()->job.step, poseOf(m_views.flat().controller()),
                             poseOf(m_views.solid().controller()), unitName(unit), m_layers.states()};
    if (const base::Status saved = session::saveDesk(m_session.board(), *m_session.document(), desk); !saved) {
        emit notSaved(QString::fromStdString(saved.error().text));
    } else {
        emit deskSaved(QString::fromStdString(session::sessionPath(m_session.board()).string()));
    }
}

std::optional<LengthUnit> SavedViews::restoreDesk(const LoadedBoard& board) {
    if (!board.desk || board.desk->step != board.document->job.step) {
        return std::nullopt;
    }
    m_layers.setStates(board.desk->layers);
    m_views.flat().controller().setPose(cameraPose(board.desk->flat));
    m_views.solid().controller().setPose(cameraPose(board.desk->solid));
    emit shown({});
    return unitNamed(board.desk->unit);
}

void SavedViews::change(const QString& what, List after) {
    m_history.push(
        new StateEdit<List>(what, m_list.views(), std::move(after), [this](const List& views) { apply(views); }));
}

void SavedViews::apply(const List& views) {
    m_list.setViews(views);
    const QString trouble = m_session.save(QStringLiteral("The views"), [&](const auto& path, const auto& document) {
        return session::saveViews(path, document, views);
    });
    if (!trouble.isEmpty()) {
        emit notSaved(trouble);
    }
}

std::string SavedViews::freeName(const std::string& word) const {
    for (std::size_t number = m_list.views().size() + 1;; ++number) {
        const std::string name = word + " " + std::to_string(number);
        if (std::ranges::find(m_list.views(), name, &session::SavedView::name) == m_list.views().end()) {
            return name;
        }
    }
}

}  // namespace ui
