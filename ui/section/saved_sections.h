#pragma once

#include <QObject>
#include <QStringListModel>
#include <QUndoStack>

#include "ui/workspace/session_part.h"

namespace ui {

/// Sections of a board that the user keeps by name: keeping, renaming and forgetting are undone like every other edit,
/// and kept in the session file beside the job.
class SavedSections : public QObject {
    Q_OBJECT

public:
    using List = std::vector<model::session::SavedSection>;

    explicit SavedSections(QUndoStack& history, QObject* parent = nullptr);

    /// Their names; they can be edited.
    [[nodiscard]] QStringListModel& names() { return m_names; }
    [[nodiscard]] const List& sections() const { return m_sections; }
    void setBoard(const LoadedBoard& board);
    /// Keeps a line of the step on the screen under a name of its own, "Section 1" and so on; that is the answer.
    QString keep(std::vector<base::PointD> line);
    void rename(int row, const QString& name);
    void remove(int row);
    /// Is it of the step on the screen?
    [[nodiscard]] bool isHere(const model::session::SavedSection& section) const;

signals:
    void notSaved(const QString& reason);

private:
    void change(const QString& what, List after);
    void apply(const List& sections);
    void show(List sections);

    QUndoStack& m_history;
    QStringListModel m_names;
    List m_sections;
    SessionPart m_session;
};

}  // namespace ui
