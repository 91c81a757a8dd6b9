#pragma once

#include <QCoreApplication>
#include <algorithm>
#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "ui/workspace/part_writer.h"
#include "ui/workspace/undo_step.h"
#include "ui/workspace/workspace.h"

namespace ui {

/// One part of a board's session file as its editor sees it: edits are undone on the history, shown and saved. What
/// another window saved of this part or another one stays in the file, is reported (SessionNews), and is not shown
/// before the board is read again: the history here knows nothing of it. `Saved` is what model::session saves of a
/// State.
template <class State, class Saved = State>
class SessionPart {
public:
    using Show = std::function<void(const State&)>;
    /// Runs on the thread for files.
    using Save = base::Status (*)(const std::filesystem::path& board, const model::Document&, const Saved&,
                                  model::session::KnownPart*);
    using Extract = std::function<Saved(const State&)>;
    using Ended = std::function<void(bool isSaved)>;

    /// `name` as in "The views": what then counts in the window alone where it cannot be saved.
    SessionPart(Workspace& workspace, const QString& name, Show show, Save save, Extract extract = std::identity())
        : m_workspace(workspace),
          m_show(std::move(show)),
          m_save(save),
          m_extract(std::move(extract)),
          m_writer(workspace, name) {
        QObject::connect(&workspace, &Workspace::openingBegan, &workspace, [this] { m_isRead = true; });
    }

    /// Hears of the last edit whether it is in the file.
    void onSaved(Ended ended) { m_ended = std::move(ended); }
    /// A board was opened. True if the part is to be taken from its session; false if it is the same one, and what was
    /// edited is in no file, or the file was read before: then it stays.
    [[nodiscard]] bool open() {
        const std::filesystem::path& path = m_workspace.board()->request.path;
        const bool isLater = path == m_path && (!m_isSaved || !m_isRead);
        m_isSaved = m_isSaved || path != m_path;
        m_path = path;
        if (!isLater) {
            m_writer.begin();
        }
        return !isLater;
    }
    void edit(const QString& what, State before, State after) {
        m_workspace.history().push(new UndoStep<State>(what, std::move(before), std::move(after),
                                                       [this](const State& state) { apply(state); }));
    }
    /// Shows and saves what follows from something else that was edited, whose step of the history takes it back, too.
    void follow(const State& state) { apply(state); }

private:
    void apply(const State& state) {
        m_isRead = false;
        m_isSaved = !m_workspace.board()->request.noSession;
        m_show(state);
        if (m_isSaved) {
            write(m_extract(state));
        } else {
            m_ended(false);
        }
    }
    void write(Saved saved) {
        m_writer.write(
            [save = m_save, saved = std::move(saved)](const auto& path, const auto& board, auto* known) {
                return save(path, board, saved, known);
            },
            [this](const base::Status& written, bool isLast) { onWritten(written, isLast); });
    }
    void onWritten(const base::Status& written, bool isLast) {
        if (!written) {
            m_workspace.reportError(
                QCoreApplication::translate("SessionPart", "%1. %2 count until another board is opened.")
                    .arg(QString::fromStdString(written.error().text), m_writer.name()));
        }
        if (isLast) {
            m_isSaved = written.ok();
            m_ended(m_isSaved);
        }
    }

    Workspace& m_workspace;
    Show m_show;
    Save m_save;
    Extract m_extract;
    Ended m_ended = [](bool) {};
    PartWriter m_writer;
    std::filesystem::path m_path;
    bool m_isSaved = true;  ///< what is shown is in the file, or on its way there: whoever reads the file waits for it
    bool m_isRead = true;   ///< whoever reads the file now finds the last edit in it
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
    SavedList(Workspace& workspace, const QString& name, List model::session::Session::*part,
              typename SessionPart<List>::Save save, std::function<void(const List&)> show)
        : m_workspace(workspace),
          m_show(std::move(show)),
          m_part(
              workspace, name, [this](const List& entries) { set(entries); }, save) {
        m_part.onSaved([this](bool isSaved) { reportAdded(isSaved); });
        QObject::connect(&workspace, &Workspace::boardOpened, &workspace, [this, part](const LoadedBoard& board) {
            m_added.clear();
            if (m_part.open()) {
                set(board.session.*part);
            }
        });
    }

    [[nodiscard]] const List& entries() const { return m_entries; }
    /// Adds an entry of the step on the screen, with a free name that begins with `word`.
    void add(const QString& what, Entry entry, const std::string& word) { append(what, named(std::move(entry), word)); }
    /// The same, and reports where the entry is: "Saved as View 3", or that it is in no file.
    void addAndReport(const QString& what, Entry entry, const std::string& word) {
        entry = named(std::move(entry), word);
        m_added = QString::fromStdString(entry.name);
        append(what, std::move(entry));
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
    [[nodiscard]] Entry named(Entry entry, const std::string& word) const {
        entry.step = m_workspace.board()->document->job.step;
        entry.name = freeName(m_entries, word);
        return entry;
    }
    void append(const QString& what, Entry entry) {
        List after = m_entries;
        after.push_back(std::move(entry));
        m_part.edit(what, m_entries, std::move(after));
    }
    void reportAdded(bool isSaved) {
        const QString text = isSaved ? QCoreApplication::translate("SavedList", "Saved as %1")
                                     : QCoreApplication::translate(
                                           "SavedList", "%1 is not saved: it counts until another board is opened");
        if (!m_added.isEmpty()) {
            m_workspace.report(text.arg(std::exchange(m_added, {})));
        }
    }
    void set(const List& entries) {
        m_entries = entries;
        m_show(m_entries);
    }

    Workspace& m_workspace;
    List m_entries;
    std::function<void(const List&)> m_show;
    QString m_added;  ///< the name of the entry that is to be reported
    SessionPart<List> m_part;
};

}  // namespace ui
