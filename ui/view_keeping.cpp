#include "ui/view_keeping.h"

#include <QUndoCommand>
#include <algorithm>
#include <glm/trigonometric.hpp>
#include <utility>

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

/// Holds both lists whole: they are short.
class ViewKeeping::Edit : public QUndoCommand {
public:
    Edit(ViewKeeping& owner, const QString& what, List after)
        : QUndoCommand(what), m_owner(owner), m_before(owner.m_list.views()), m_after(std::move(after)) {}

    void undo() override { m_owner.apply(m_before); }
    void redo() override { m_owner.apply(m_after); }

private:
    ViewKeeping& m_owner;
    List m_before;
    List m_after;
};

ViewKeeping::ViewKeeping(BoardViews& views, models::LayerModel& layers, QUndoStack& history, QObject* parent)
    : QObject(parent), m_views(views), m_layers(layers), m_history(history) {
    connect(&m_list, &models::ViewListModel::renamed, this, &ViewKeeping::rename);
}

void ViewKeeping::setBoard(const LoadedBoard& board) {
    m_request = board.request;
    m_document = board.document;
    m_list.setViews(board.views);
}

void ViewKeeping::keep() {
    if (m_document == nullptr) {
        return;
    }
    List after = m_list.views();
    after.push_back({freeName(), m_document->job.step, poseOf(m_views.flat().controller()),
                     poseOf(m_views.solid().controller()), m_layers.visibleNames()});
    change(QStringLiteral("keeping a view"), std::move(after));
}

void ViewKeeping::rename(int row, const QString& name) {
    List after = m_list.views();
    after[static_cast<std::size_t>(row)].name = name.toStdString();
    change(QStringLiteral("the name of a view"), std::move(after));
}

void ViewKeeping::forget(int row) {
    List after = m_list.views();
    after.erase(after.begin() + row);
    change(QStringLiteral("forgetting a view"), std::move(after));
}

void ViewKeeping::goTo(int row) {
    const session::KeptView& view = m_list.views()[static_cast<std::size_t>(row)];
    const QString name = QString::fromStdString(view.name);
    if (view.step != m_document->job.step) {
        emit otherStep(name, QString::fromStdString(view.step));
        return;
    }
    m_layers.showOnly(view.layers);
    m_views.flat().controller().setPose(cameraPose(view.flat));
    m_views.solid().controller().setPose(cameraPose(view.solid));
    emit shown(name);
}

void ViewKeeping::change(const QString& what, List after) {
    m_history.push(new Edit(*this, what, std::move(after)));
}

void ViewKeeping::apply(const List& views) {
    m_list.setViews(views);
    if (m_request.noSession) {
        return;
    }
    if (const base::Status saved = session::saveViews(m_request.path, *m_document, views); !saved) {
        emit notSaved(QStringLiteral("%1. The views count until another board is opened.")
                          .arg(QString::fromStdString(saved.error().text)));
    }
}

std::string ViewKeeping::freeName() const {
    for (std::size_t number = m_list.views().size() + 1;; ++number) {
        const std::string name = "View " + std::to_string(number);
        if (std::ranges::find(m_list.views(), name, &session::KeptView::name) == m_list.views().end()) {
            return name;
        }
    }
}

}  // namespace ui
