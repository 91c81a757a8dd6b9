#include "ui/shell/docks.h"

#include <QDockWidget>
#include <QMainWindow>

namespace ui {

namespace {

struct DockSpec {
    ActionId toggle;
    const char* name;  ///< QMainWindow::saveState finds it by this
    const char* title;
    Qt::DockWidgetArea area;
    const char* behind;  ///< shares the place of this one, which stays in front; null: a place of its own
    int lines;  ///< width at the sides, height at the bottom, in heights of a line of text; 0: of the one in front
};

constexpr DockSpec kDocks[] = {
    {ActionId::ShowLayersDock, "layers", "Layers", Qt::LeftDockWidgetArea, nullptr, 27},
    {ActionId::ShowStackupDock, "stack", "Stack", Qt::LeftDockWidgetArea, "layers", 0},
    {ActionId::ShowNetsDock, "nets", "Nets", Qt::RightDockWidgetArea, nullptr, 22},
    {ActionId::ShowElementDock, "element", "Element", Qt::RightDockWidgetArea, nullptr, 22},
    {ActionId::ShowSavedViewsDock, "views", "Views", Qt::RightDockWidgetArea, "element", 0},
    {ActionId::ShowMessagesDock, "messages", "Messages", Qt::BottomDockWidgetArea, nullptr, 13},
    {ActionId::ShowNetCheckDock, "netCheck", "Opens and shorts", Qt::BottomDockWidgetArea, "messages", 0},
    {ActionId::ShowClearanceDock, "clearances", "Clearances", Qt::BottomDockWidgetArea, "messages", 0},
    {ActionId::ShowMeasurementsDock, "measurements", "Measurements", Qt::BottomDockWidgetArea, "messages", 0},
    {ActionId::ShowSectionDock, "section", "Cross-section", Qt::BottomDockWidgetArea, "messages", 0},
    {ActionId::ShowStatisticsDock, "statistics", "Statistics", Qt::BottomDockWidgetArea, "messages", 0},
};

struct Sizes {
    QList<QDockWidget*> docks;
    QList<int> sizes;
};

void place(QMainWindow& window, QDockWidget& dock, const DockSpec& spec) {
    window.addDockWidget(spec.area, &dock);
    if (spec.behind != nullptr) {
        auto* front = window.findChild<QDockWidget*>(QLatin1String(spec.behind));
        window.tabifyDockWidget(front, &dock);
        front->raise();
    }
}

/// The command of a panel brings it to the front, also from behind another one; and hides it when it is there.
void connectToggle(QAction& toggle, QDockWidget& dock) {
    QObject::connect(&toggle, &QAction::triggered, &dock, [&dock](bool isOn) {
        dock.setVisible(isOn);
        if (isOn) {
            dock.raise();
        }
    });
    QObject::connect(&dock, &QDockWidget::visibilityChanged, &toggle, &QAction::setChecked);
}

}  // namespace

void addDocks(QMainWindow& window, ActionSet& actions, const std::function<QWidget*(ActionId)>& panelOf) {
    Sizes atSides;
    Sizes below;
    for (const DockSpec& spec : kDocks) {
        auto* dock = new QDockWidget(QLatin1String(spec.title), &window);
        dock->setObjectName(QLatin1String(spec.name));
        dock->setWidget(panelOf(spec.toggle));
        connectToggle(actions[spec.toggle], *dock);
        place(window, *dock, spec);
        if (spec.lines > 0) {
            Sizes& sizes = spec.area == Qt::BottomDockWidgetArea ? below : atSides;
            sizes.docks += dock;
            sizes.sizes += window.fontMetrics().height() * spec.lines;
        }
    }
    window.setCorner(Qt::BottomLeftCorner, Qt::LeftDockWidgetArea);
    // All at once, or one takes from another what it was given.
    window.resizeDocks(atSides.docks, atSides.sizes, Qt::Horizontal);
    window.resizeDocks(below.docks, below.sizes, Qt::Vertical);
}

}  // namespace ui
