#include "ui/stackup/thickness_editing.h"

#include <algorithm>
#include <utility>

#include "model/board/stackup.h"

namespace ui {

namespace session = model::session;

namespace {

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

}  // namespace

ThicknessEditing::ThicknessEditing(Workspace& workspace, QObject* parent)
    : QObject(parent),
      m_workspace(workspace),
      m_part(
          workspace, tr("The thicknesses"), [this](const model::SetThicknesses& state) { show(state); },
          session::saveThicknesses, [](const model::SetThicknesses& state) { return state.saved; }) {
    m_part.onSaved([this](bool isSaved) {
        const LoadedBoard& board = *m_workspace.board();
        if (!isSaved && !board.request.noSession) {
            m_workspace.restack(board.document, board.thicknesses, false);
        }
    });
    // Which thicknesses the board has, the workspace says.
    connect(&workspace, &Workspace::boardOpened, this, [this] { static_cast<void>(m_part.open()); });
}

void ThicknessEditing::edit(const std::vector<model::ThicknessOverride>& changes) {
    const std::shared_ptr<const model::Document> document = m_workspace.board()->document;
    const model::SetThicknesses& before = m_workspace.board()->thicknesses;
    model::SetThicknesses after = before;
    for (const model::ThicknessOverride& change : changes) {
        session::setThickness(after.saved, change);
        session::setThickness(after.once, {change.layer, 0});  // the later word counts
    }
    if (after != before) {
        const QString what = changes.size() == 1 ? tr("thickness of %1").arg(QString::fromStdString(changes[0].layer))
                                                 : tr("thicknesses");
        m_part.edit(what, before, std::move(after));
        const QString others = madeUpBy(document->stackup, m_workspace.board()->document->stackup, changes);
        if (!others.isEmpty()) {
            m_workspace.report(
                tr("Of assumed thickness and changed too, so that the board stays as thick as it is taken "
                   "to be: %1")
                    .arg(others));
        }
    }
}

void ThicknessEditing::show(const model::SetThicknesses& state) {
    const LoadedBoard& board = *m_workspace.board();
    m_workspace.restack(session::applyThicknesses(board.document, state.all()), state, true);
}

}  // namespace ui
