// What the commands for cross-sections do.

#include <QStatusBar>

#include "ui/shell/dialogs.h"
#include "ui/shell/main_window.h"
#include "ui/shell/message_bar.h"

namespace ui {

void MainWindow::connectSections() {
    connect(&m_actions[ActionId::DrawSection], &QAction::triggered, this, [this](bool isOn) {
        raise(m_sections->panel());
        m_sections->draw(isOn);
    });
    connect(&m_actions[ActionId::OpenAlongSection], &QAction::triggered, this, [this] {
        if (const auto line = m_sections->straightLine()) {
            m_sectionPlane->cutAlong(line->first, line->second);
            m_actions[ActionId::SectionPlane].setChecked(true);
        } else {
            statusBar()->showMessage(QStringLiteral("Draw a section with a straight line first"));
        }
    });
    connect(&m_actions[ActionId::ExportSection], &QAction::triggered, this, [this] {
        requestSectionPath(*this, m_settings.lastFolder(), [this](const QString& path) {
            if (const base::Status saved = m_sections->save(path); !saved) {
                m_messageBar->showError(QString::fromStdString(saved.error().text));
            } else {
                statusBar()->showMessage(QStringLiteral("Saved %1").arg(path));
            }
        });
    });
    connect(&m_actions[ActionId::SectionAlongNet], &QAction::triggered, this, [this] {
        raise(m_sections->panel());
        m_sections->followNet();
    });
    connect(&m_actions[ActionId::SaveSection], &QAction::triggered, m_sections, &Sections::keep);
    connect(m_sections, &Sections::reported, this, [this](const QString& what) { statusBar()->showMessage(what); });
    connect(&m_sections->keeping(), &SavedSections::notSaved, m_messageBar, &MessageBar::showError);
    connect(m_sections, &Sections::placed, this, [this] {
        m_actions[ActionId::DrawSection].setChecked(false);
        if (const auto line = m_sections->straightLine(); line && m_sectionPlane->isAlongLine()) {
            m_sectionPlane->cutAlong(line->first, line->second);
        }
    });
}

}  // namespace ui
