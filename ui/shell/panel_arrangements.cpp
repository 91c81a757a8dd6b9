#include "ui/shell/panel_arrangements.h"

#include <QDockWidget>
#include <QToolBar>
#include <algorithm>

namespace ui {

namespace {

/// In heights of a line of text.
constexpr int kColumnLines = 24;
constexpr int kBottomLines = 14;
/// The column takes no larger part of the window.
constexpr int kMostOfWindow = 4;
/// Upper and lower panels of the column share its height so.
constexpr int kUpperShare = 3;
constexpr int kLowerShare = 2;

/// Names of docks, the one in front first. Those of a group lie behind each other.
struct Plan {
    QStringList upper;
    QStringList lower{};
};

Plan planOf(Use use) {
    switch (use) {
        case Use::Stackup: return {{"stackup", "layers"}};
        case Use::Nets: return {{"nets", "layers"}, {"element", "pins"}};
        case Use::Clearance: return {{"clearances", "measurements", "layers"}};
        default: return {{"layers", "stackup", "nets"}, {"element", "pins", "views"}};
    }
}

}  // namespace

PanelArrangements::PanelArrangements(QMainWindow& window, Settings& settings) : m_window(window), m_settings(settings) {
    for (QDockWidget* dock : window.findChildren<QDockWidget*>()) {
        m_docks.emplaceBack(dock, window.dockWidgetArea(dock));
    }
    window.setCorner(Qt::BottomLeftCorner, Qt::LeftDockWidgetArea);
}

void PanelArrangements::show(Use use) {
    if (m_use == use) {
        return;
    }
    const bool isSwitched = m_use.has_value();
    save();
    auto* toolBar = m_window.findChild<QToolBar*>(QStringLiteral("toolbar"));
    const bool hasToolBar = toolBar->isVisibleTo(&m_window);
    m_use = use;
    layOut(use);
    m_window.restoreState(m_settings.windowState(use));
    if (isSwitched) {
        toolBar->setVisible(hasToolBar);  // no matter of panels
    }
}

void PanelArrangements::restoreDefault() {
    layOut(*m_use);
}

void PanelArrangements::save() const {
    if (m_use) {
        m_settings.setWindowState(*m_use, m_window.saveState());
    }
}

void PanelArrangements::layOut(Use use) {
    const Plan plan = planOf(use);
    const auto named = [this](const QStringList& names) {
        QList<QDockWidget*> docks;
        std::ranges::for_each(names, [&](const QString& name) { docks += m_window.findChild<QDockWidget*>(name); });
        return docks;
    };
    const QList<QDockWidget*> lower = named(plan.lower);
    QList<QDockWidget*> upper = named(plan.upper);
    const QList<QDockWidget*> shown = upper + lower;
    QList<QDockWidget*> bottom;
    for (const auto& [dock, area] : m_docks) {
        m_window.removeDockWidget(dock);  // out of the groups of the use before
        if (!shown.contains(dock)) {
            (area == Qt::BottomDockWidgetArea ? bottom : upper) += dock;
        }
    }
    addGroup(upper, Qt::LeftDockWidgetArea);
    addGroup(lower, Qt::LeftDockWidgetArea);
    addGroup(bottom, Qt::BottomDockWidgetArea);
    const int line = m_window.fontMetrics().height();
    const int width = std::min(line * kColumnLines, m_window.width() / kMostOfWindow);
    m_window.resizeDocks({upper.first()}, {width}, Qt::Horizontal);
    m_window.resizeDocks({bottom.first()}, {line * kBottomLines}, Qt::Vertical);
    std::ranges::for_each(shown, &QWidget::show);
    upper.first()->raise();
    if (!lower.isEmpty()) {
        lower.first()->raise();
        const int height = m_window.height();
        m_window.resizeDocks({upper.first(), lower.first()}, {height * kUpperShare, height * kLowerShare},
                             Qt::Vertical);
    }
}

/// Hidden, behind each other.
void PanelArrangements::addGroup(const QList<QDockWidget*>& group, Qt::DockWidgetArea area) {
    for (QDockWidget* dock : group) {
        if (dock == group.first()) {
            m_window.addDockWidget(area, dock);
        } else {
            m_window.tabifyDockWidget(group.first(), dock);
        }
        dock->hide();
    }
}

}  // namespace ui
