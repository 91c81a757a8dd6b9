#include "ui/nets/net_checker.h"

#include <utility>

namespace ui {

NetChecker::NetChecker(QObject* parent) : QObject(parent) {
    connect(&m_checks.background(), &Background::progressed, this, &NetChecker::progressed);
    connect(&m_checks.background(), &Background::finished, this, &NetChecker::deliver);
}

void NetChecker::start(std::shared_ptr<const model::Document> board) {
    m_board = std::move(board);
    m_checks.ask([board = m_board](base::Progress& progress) { return model::checkAllNets(*board, progress); },
                 "Checking nets", "There is not enough memory to check the nets");
}

void NetChecker::deliver() {
    if (const auto checks = m_checks.take()) {
        emit checked(m_board, *checks);
    } else {
        emit failed(QString::fromStdString(checks.error().text));
    }
}

}  // namespace ui
