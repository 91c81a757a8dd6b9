#pragma once

#include <QCoreApplication>
#include <algorithm>
#include <functional>
#include <string>
#include <utility>

#include "ui/workspace/undo_step.h"
#include "ui/workspace/workspace.h"

namespace ui {

/// One part of a board's session file as its editor sees it: edits are undone on the history, shown and saved.
template <class State>
class SessionPart {
public:
    using Show = std::function<void(const State&)>;
    using Save = std::function<base::Status(const std::filesystem::path&, const model::Document&, const State&)>;

    /// `name` as in "The views": what then counts in the window alone where it cannot be saved.
    SessionPart(Workspace& workspace, QString name, Show show, Save save)
        : m_workspace(workspace), m_name(std::move(name)), m_show(std::move(show)), m_save(std::move(save)) {}

    /// A board was opened. True if the part is to be taken from its session; false if what was edited is in no file:
    /// then it stays.
    [[nodiscard]] bool open() {
        const std::filesystem::path& path = m_workspace.board()->request.path;
        m_isSaved = m_isSaved || path != m_path;
        m_path = path;
        return m_isSaved;
    }
    void edit(const QString& what, State before, State after) {
        m_workspace.history().push(new UndoStep<State>(what, std::move(before), std::move(after),
                                                       [this](const State& state) { apply(state); }));
    }

private:
    void apply(const State& state) {
        m_show(state);
        const LoadedBoard& board = *m_workspace.board();
        m_isSaved = false;
        if (board.request.noSession) {
            return;
        }
        const base::Status saved = m_save(m_path, *board.document, state);
        m_isSaved = saved.ok();
        if (!saved) {
            m_workspace.reportError(
                QCoreApplication::translate("SessionPart", "%1. %2 count until another board is opened.")
                    .arg(QString::fromStdString(saved.error().text), m_name));
        }
    }

    Workspace& m_workspace;
    QString m_name;
    Show m_show;
    Save m_save;
    std::filesystem::path m_path;
    bool m_isSaved = true;
};

/// "View 3": a name that no entry of the list has, counted on from its length.
template <class List>
[[nodiscard]] std::string freeName(const List& list, const std::string& word) {
    for (std::size_t number = list.size() + 1;; ++number) {
        std::string name = word + std::to_string(number);
        if (std::ranges::find(list, name, [](const auto& entry) { return entry.name; }) == list.end()) {
            return name;
        }
    }
}

}  // namespace ui
