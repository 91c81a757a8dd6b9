#include "ui/shell/drop_target.h"

#include <QDropEvent>
#include <QMimeData>
#include <QUrl>
#include <algorithm>

#include "model/formats/registry.h"
#include "ui/common/paths.h"

namespace ui {

namespace {

QStringList localPaths(const QMimeData& data) {
    QStringList paths;
    for (const QUrl& url : data.urls()) {
        if (url.isLocalFile()) {
            paths += url.toLocalFile();
        }
    }
    // A board beside its drawings and reports comes first.
    std::ranges::stable_partition(paths, [](const QString& path) { return model::isNamedLikeBoard(toPath(path)); });
    return paths;
}

}  // namespace

bool DropTarget::eventFilter(QObject* watched, QEvent* event) {
    const bool isDrop = event->type() == QEvent::Drop;
    if (!isDrop && event->type() != QEvent::DragEnter && event->type() != QEvent::DragMove) {
        return QObject::eventFilter(watched, event);
    }
    auto& drop = static_cast<QDropEvent&>(*event);  // enter and move events are drop events too
    const QStringList paths = localPaths(*drop.mimeData());
    if (paths.isEmpty()) {
        return false;
    }
    drop.acceptProposedAction();
    if (isDrop) {
        emit dropped(paths);
    }
    return true;
}

}  // namespace ui
