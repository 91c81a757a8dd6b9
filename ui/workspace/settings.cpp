#include "ui/workspace/settings.h"

#include <QDir>

namespace ui {

namespace {

constexpr auto kGeometry = "window/geometry";
constexpr auto kState = "window/state";
constexpr auto kRecent = "files/recent";
constexpr auto kFolder = "files/folder";

}  // namespace

Settings::Settings() : m_store(QStringLiteral("Copperscope"), QStringLiteral("Copperscope")) {}

Settings::Settings(const QString& iniFile) : m_store(iniFile, QSettings::IniFormat) {}

QByteArray Settings::windowGeometry() const {
    return m_store.value(kGeometry).toByteArray();
}

QByteArray Settings::windowState() const {
    return m_store.value(kState).toByteArray();
}

void Settings::setWindow(const QByteArray& geometry, const QByteArray& state) {
    m_store.setValue(kGeometry, geometry);
    m_store.setValue(kState, state);
}

QStringList Settings::recentBoards() const {
    return m_store.value(kRecent).toStringList();
}

void Settings::setRecentBoards(const QStringList& paths) {
    m_store.setValue(kRecent, paths);
}

QString Settings::lastFolder() const {
    return m_store.value(kFolder, QDir::homePath()).toString();
}

void Settings::setLastFolder(const QString& folder) {
    m_store.setValue(kFolder, folder);
}

void Settings::reset() {
    m_store.clear();
}

}  // namespace ui
