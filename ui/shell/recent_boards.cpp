#include "ui/shell/recent_boards.h"

#include <QDir>
#include <QFileInfo>
#include <QMenu>

namespace ui {

namespace {

/// "&1 board.tgz – /home/me/boards": numbered for the keyboard, an & in a name is no mnemonic.
QString menuText(int number, const QFileInfo& file) {
    const QString mnemonic = number <= 9 ? QStringLiteral("&%1 ").arg(number) : QString();
    const QString name = file.fileName() + QStringLiteral(" – ") + QDir::toNativeSeparators(file.path());
    return mnemonic + QString(name).replace('&', QStringLiteral("&&"));
}

}  // namespace

RecentBoards::RecentBoards(Settings& settings, QMenu& menu, QObject* parent)
    : QObject(parent), m_settings(settings), m_menu(menu) {
    connect(&menu, &QMenu::aboutToShow, this, &RecentBoards::fillMenu);
}

void RecentBoards::add(const QString& path) {
    const QString absolute = QFileInfo(path).absoluteFilePath();
    QStringList paths = m_settings.recentBoards();
    paths.removeAll(absolute);
    paths.prepend(absolute);
    m_settings.setRecentBoards(paths.mid(0, kMost));
}

void RecentBoards::fillMenu() {
    m_menu.clear();
    int number = 0;
    for (const QString& path : m_settings.recentBoards()) {
        const QFileInfo file(path);
        QAction* action = m_menu.addAction(menuText(++number, file), this, [this, path] { emit chosen(path); });
        action->setEnabled(file.exists());
        action->setStatusTip(file.exists() ? path : tr("%1 is not there now").arg(path));
    }
    m_menu.addSeparator();
    QAction* clearAction = m_menu.addAction(tr("&Clear list"), this, [this] { m_settings.setRecentBoards({}); });
    clearAction->setEnabled(number > 0);
}

}  // namespace ui
