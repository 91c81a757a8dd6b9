#include "ui/workspace/session_part.h"

namespace ui {

bool SessionPart::open(const LoadedBoard& board) {
    const bool isSameBoard = board.request.path == m_request.path;
    const bool isTaken = m_isSaved || !isSameBoard;
    m_isSaved = isTaken;
    m_request = board.request;
    m_document = board.document;
    return isTaken;
}

QString SessionPart::save(const QString& what, const Save& save) {
    m_isSaved = false;
    if (m_request.noSession) {
        return {};
    }
    const base::Status saved = save(m_request.path, *m_document);
    m_isSaved = saved.ok();
    return saved ? QString()
                 : QStringLiteral("%1. %2 count until another board is opened.")
                       .arg(QString::fromStdString(saved.error().text), what);
}

}  // namespace ui
