#pragma once

#include <QMainWindow>
#include <optional>

#include "ui/workspace/settings.h"

class QDockWidget;

namespace ui {

/// Which panels are shown and where, for each use of the window. A use begins with the panels that it needs, in a
/// column at the left that leaves the views two thirds of a window of 1280 by 800; what the user makes of them is kept
/// with it, here and in the settings. Panels that a use does not show open where the others of their area are.
class PanelArrangements {
public:
    /// Once the window has all its panels and tool bars.
    PanelArrangements(QMainWindow& window, Settings& settings);

    /// Keeps how the panels of the use so far are, and shows those of another.
    void show(Use use);
    /// The panels of the use shown as they were at first.
    void restoreDefault();
    /// Keeps how panels are now for the next run.
    void save() const;
    /// What is shown is not kept: the settings were reset.
    void discard() { m_use.reset(); }

private:
    void layOut(Use use);
    void addGroup(const QList<QDockWidget*>& group, Qt::DockWidgetArea area);

    QMainWindow& m_window;
    Settings& m_settings;
    QList<std::pair<QDockWidget*, Qt::DockWidgetArea>> m_docks;  ///< in the order they were made, with their areas
    std::optional<Use> m_use;
};

}  // namespace ui
