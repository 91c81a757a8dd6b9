#include "ui/net_checker.h"

#include <new>
#include <utility>

namespace ui {

NetChecker::NetChecker(QObject* parent) : QObject(parent) {
    connect(&m_background, &Background::progressed, this, &NetChecker::progressed);
    connect(&m_background, &Background::finished, this, &NetChecker::deliver);
}

void NetChecker::start(std::shared_ptr<const model::Document> board) {
    m_board = std::move(board);
    m_answer = std::make_shared<Answer>();
    m_background.start(
        [board = m_board, answer = m_answer](base::Progress& progress) {
            try {
                *answer = model::checkAllNets(*board, progress);
            } catch (const std::bad_alloc&) {
                *answer = base::Error{base::ErrorCode::BadInput, "There is not enough memory to check the nets"};
            }
        },
        "Checking nets");
}

void NetChecker::deliver() {
    const std::shared_ptr<Answer> answer = std::move(m_answer);
    if (**answer) {
        emit checked(m_board, ***answer);
    } else {
        emit failed(QString::fromStdString((*answer)->error().text));
    }
}

}  // namespace ui
