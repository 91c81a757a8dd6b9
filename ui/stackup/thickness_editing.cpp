#include "ui/stackup/thickness_editing.h"

#include <utility>

#include "model/session/length_text.h"
#include "ui/workspace/state_edit.h"

namespace ui {

namespace session = model::session;

void ThicknessEditing::setBoard(const LoadedBoard& board) {
    m_history.clear();
    m_request = board.request;
    m_document = board.document;
    m_state = board.thicknesses;
    m_isSaved = true;
}

void ThicknessEditing::set(const std::vector<model::ThicknessOverride>& changes) {
    SetThicknesses after = m_state;
    for (const model::ThicknessOverride& change : changes) {
        session::setThickness(after.kept, change);
        session::setThickness(after.once, {change.layer, 0});  // the later word counts
    }
    if (after != m_state) {
        const QString what = changes.size() == 1
                                 ? QStringLiteral("thickness of %1").arg(QString::fromStdString(changes.front().layer))
                                 : QStringLiteral("thicknesses");
        m_history.push(new StateEdit<SetThicknesses>(what, m_state, std::move(after),
                                                     [this](const SetThicknesses& state) { apply(state); }));
    }
}

void ThicknessEditing::apply(const SetThicknesses& state) {
    m_state = state;
    m_document = session::applyThicknesses(m_document, state.all());
    save();
    emit restacked(m_document);
}

void ThicknessEditing::save() {
    if (m_request.noSession) {
        return;
    }
    const base::Status saved = session::saveThicknesses(m_request.path, *m_document, m_state.kept);
    m_isSaved = saved.ok();
    if (!saved) {
        emit notSaved(QStringLiteral("%1. The thicknesses count until another board is opened.")
                          .arg(QString::fromStdString(saved.error().text)));
    }
}

LoadRequest ThicknessEditing::request() const {
    LoadRequest request = m_request;
    const bool isInFile = m_isSaved && !request.noSession;
    request.noSession = !isInFile;
    request.thicknesses.clear();
    for (const model::ThicknessOverride& set : isInFile ? m_state.once : m_state.all()) {
        request.thicknesses.push_back(set.layer + "=" + session::thicknessText(set.thickness));
    }
    return request;
}

}  // namespace ui
