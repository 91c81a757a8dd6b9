#pragma once

#include <QCoreApplication>
#include <algorithm>
#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "ui/workspace/session_news.h"
#include "ui/workspace/undo_step.h"
#include "ui/workspace/workspace.h"

namespace ui {

/// One part of a board's session file as its editor sees it: edits are undone on the history, saved and shown. What
/// another window saved of this part or another one stays in the file, is reported (SessionNews), and is not shown
/// before the board is read again: the history here knows nothing of it.
template <class State>
class SessionPart {
public:
    using Show = std::function<void(const State&)>;
    using Save = std::function<base::Status(const std::filesystem::path&, const model::Document&, const State&,
                                            model::session::KnownPart*)>;

    /// `name` as in "The views": what then counts in the window alone where it cannot be saved.
    SessionPart(Workspace& workspace, QString name, Show show, Save save)
        : m_workspace(workspace), m_name(std::move(name)), m_show(std::move(show)), m_save(std::move(save)) {
        SessionNews::of(workspace);  // hears of the board before anything is saved
        QObject::connect(&workspace, &Workspace::openingBegan, &workspace, [this] { m_isRead = true; });
    }

    /// A board was opened. True if the part is to be taken from its session; false if it is the same one, and what was
    /// edited is in no file, or the file was read before: then it stays.
    [[nodiscard]] bool open() {
        const LoadedBoard& board = *m_workspace.board();
        const std::filesystem::path& path = board.request.path;
        const bool isLater = path == m_path && (!m_isSaved || !m_isRead);
        m_isSaved = m_isSaved || path != m_path;
        m_path = path;
        if (!isLater) {
            m_known = {board.sessionFile, board.sessionFile};
        }
        return !isLater;
    }
    /// What is shown is in the file.
    [[nodiscard]] bool isSaved() const { return m_isSaved; }
    void edit(const QString& what, State before, State after) {
        m_workspace.history().push(new UndoStep<State>(what, std::move(before), std::move(after),
                                                       [this](const State& state) { apply(state); }));
    }
    /// Shows and saves what follows from something else that was edited, whose step of the history takes it back, too.
    void follow(const State& state) { apply(state); }

private:
    void apply(const State& state) {
        m_isSaved = m_isRead = false;
        const QString trouble = m_workspace.board()->request.noSession ? QString() : save(state);
        m_show(state);
        if (!trouble.isEmpty()) {
            m_workspace.reportError(trouble);
        }
    }
    /// What there is to say of it; empty for nothing.
    QString save(const State& state) {
        const base::Status saved = m_save(m_path, *m_workspace.board()->document, state, &m_known);
        m_isSaved = saved.ok();
        return saved ? SessionNews::of(m_workspace).afterSave(m_known, m_name)
                     : QCoreApplication::translate("SessionPart", "%1. %2 count until another board is opened.")
                           .arg(QString::fromStdString(saved.error().text), m_name);
    }

    Workspace& m_workspace;
    QString m_name;
    Show m_show;
    Save m_save;
    std::filesystem::path m_path;
    model::session::KnownPart m_known;
    bool m_isSaved = true;
    bool m_isRead = true;  ///< whoever reads the file now finds the last edit in it
};

/// "View 3": a name that no entry has, counted on from their number.
template <class Entry>
[[nodiscard]] std::string freeName(const std::vector<Entry>& entries, const std::string& word) {
    std::size_t number = entries.size();
    std::string name;
    do {
        name = word + std::to_string(++number);
    } while (std::ranges::find(entries, name, &Entry::name) != entries.end());
    return name;
}

/// A list in a board's session whose entries have a name and the step they are of: views, measurements, sections.
template <class Entry>
class SavedList {
public:
    using List = std::vector<Entry>;

    /// `part` is the list in a session; `show` takes the list whenever it is another.
    SavedList(Workspace& workspace, QString name, List model::session::Session::*part,
              typename SessionPart<List>::Save save, std::function<void(const List&)> show)
        : m_workspace(workspace),
          m_show(std::move(show)),
          m_part(
              workspace, std::move(name), [this](const List& entries) { set(entries); }, std::move(save)) {
        QObject::connect(&workspace, &Workspace::boardOpened, &workspace, [this, part](const LoadedBoard& board) {
            if (m_part.open()) {
                set(board.session.*part);
            }
        });
    }

    [[nodiscard]] const List& entries() const { return m_entries; }
    /// Adds an entry of the step on the screen, with a free name that begins with `word`.
    void add(const QString& what, Entry entry, const std::string& word) {
        entry.step = m_workspace.board()->document->job.step;
        entry.name = freeName(m_entries, word);
        List after = m_entries;
        after.push_back(std::move(entry));
        m_part.edit(what, m_entries, std::move(after));
    }
    /// Says where the entry is that was added last: "Saved as View 3", or that it is in no file.
    void reportAdded() const {
        const QString text =
            m_part.isSaved()
                ? QCoreApplication::translate("SavedList", "Saved as %1")
                : QCoreApplication::translate("SavedList", "%1 is not saved: it counts until another board is opened");
        m_workspace.report(text.arg(QString::fromStdString(m_entries.back().name)));
    }
    template <class Edit>
    void change(const QString& what, int row, const Edit& edit) {
        List after = m_entries;
        edit(after[static_cast<std::size_t>(row)]);
        m_part.edit(what, m_entries, std::move(after));
    }
    /// Of every entry what follows from something else that was edited: no step of the history.
    template <class Follow>
    void follow(const Follow& follow) {
        List after = m_entries;
        std::ranges::for_each(after, follow);
        if (after != m_entries) {
            m_part.follow(after);
        }
    }
    void rename(const QString& what, int row, const QString& name) {
        change(what, row, [&name](Entry& entry) { entry.name = name.toStdString(); });
    }
    void remove(const QString& what, std::vector<int> rows) {
        List after = m_entries;
        std::ranges::sort(rows, std::greater());
        for (const int row : rows) {
            after.erase(after.begin() + row);
        }
        m_part.edit(what, m_entries, std::move(after));
    }

private:
    void set(const List& entries) {
        m_entries = entries;
        m_show(m_entries);
    }

    Workspace& m_workspace;
    List m_entries;
    std::function<void(const List&)> m_show;
    SessionPart<List> m_part;
};

}  // namespace ui
