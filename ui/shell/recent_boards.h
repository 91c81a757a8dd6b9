#pragma once

#include <QObject>

#include "ui/workspace/settings.h"

class QMenu;

namespace ui {

/// The menu of boards opened lately, newest first. Missing ones are greyed, not dropped: a drive may come back.
class RecentBoards : public QObject {
    Q_OBJECT

public:
    static constexpr int kMost = 12;

    /// Fills `menu` each time it opens.
    RecentBoards(Settings& settings, QMenu& menu, QObject* parent = nullptr);

    /// Puts the board first.
    void add(const QString& path);

signals:
    void chosen(const QString& path);

private:
    void fillMenu();

    Settings& m_settings;
    QMenu& m_menu;
};

}  // namespace ui
