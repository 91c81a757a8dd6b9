#include "ui/workspace/part_writer.h"

#include <utility>

#include "ui/workspace/session_news.h"
#include "ui/workspace/workspace.h"

namespace ui {

using model::session::KnownPart;

PartWriter::PartWriter(Workspace& workspace, QString name) : m_workspace(workspace), m_name(std::move(name)) {
    SessionNews::of(workspace);  // hears of the board before anything is saved
}

void PartWriter::begin() {
    const LoadedBoard& board = *m_workspace.board();
    m_known = std::make_shared<KnownPart>(KnownPart{board.sessionFile, board.sessionFile});
}

void PartWriter::write(Save save, Ended ended) {
    const auto after = std::make_shared<KnownPart>();  // what is reported here: m_known may be written to by then
    const auto work = [save = std::move(save), path = m_workspace.board()->request.path,
                       document = m_workspace.board()->document, known = m_known, after]() -> base::Status {
        RETURN_IF_ERROR(save(path, *document, known.get()));
        *after = *known;
        return base::Done{};
    };
    const auto report = [this, known = m_known, after, count = ++m_count,
                         ended = std::move(ended)](const base::Status& saved) {
        const QString news =
            saved && known == m_known ? SessionNews::of(m_workspace).afterSave(*after, m_name) : QString();
        ended(saved, count == m_count && known == m_known);
        if (!news.isEmpty()) {
            m_workspace.reportError(news);
        }
    };
    m_workspace.files().add(m_known.get(), work, report);
}

}  // namespace ui
