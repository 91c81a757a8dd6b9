#pragma once

#include <QObject>

#include "ui/workspace/workspace.h"

namespace ui {

/// What to do next, said in the status bar for as long as there is something to do: a tool's prompt, which goes with
/// the tool.
class Hint : public QObject {
public:
    explicit Hint(Workspace& workspace, QObject* parent = nullptr) : QObject(parent), m_workspace(workspace) {
        connect(&workspace, &Workspace::reported, this, [this](const QString& text) { m_isShown = text == m_text; });
    }

    void show(const QString& text) {
        m_text = text;
        m_workspace.prompt(text);
    }
    /// Whatever else was reported since stays.
    void end() {
        if (m_isShown) {
            show({});
            m_isShown = false;
        }
    }

private:
    Workspace& m_workspace;
    QString m_text;
    bool m_isShown = false;
};

}  // namespace ui
