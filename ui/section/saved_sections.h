#pragma once

#include <QObject>
#include <QStringListModel>

#include "ui/workspace/session_part.h"

namespace ui {

/// Sections of a board that the user saves by name: saving, renaming and deleting are undone like every other edit, and
/// saved in the session file beside the job.
class SavedSections : public QObject {
    Q_OBJECT

public:
    using List = std::vector<model::session::SavedSection>;

    explicit SavedSections(Workspace& workspace, QObject* parent = nullptr);

    /// Their names; they can be edited.
    [[nodiscard]] QStringListModel& names() { return m_names; }
    [[nodiscard]] const List& sections() const { return m_sections; }
    /// Saves a line of the step on the screen under a name of its own, "Section 1" and so on, which is returned.
    QString add(std::vector<base::PointD> line);
    void rename(int row, const QString& name);
    void remove(int row);

private:
    void show(List sections);

    Workspace& m_workspace;
    QStringListModel m_names;
    List m_sections;
    SessionPart<List> m_part;
};

}  // namespace ui
