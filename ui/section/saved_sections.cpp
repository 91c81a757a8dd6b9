#include "ui/section/saved_sections.h"

namespace ui {

SavedSections::SavedSections(Workspace& workspace, QObject* parent)
    : QObject(parent),
      m_workspace(workspace),
      m_part(
          workspace, tr("The sections"), [this](const List& sections) { show(sections); },
          model::session::saveSections) {
    connect(&m_names, &QStringListModel::dataChanged, this,
            [this](const QModelIndex& at) { rename(at.row(), at.data(Qt::EditRole).toString()); });
    connect(&workspace, &Workspace::boardOpened, this, [this](const LoadedBoard& board) {
        if (m_part.open()) {
            show(board.session.sections);
        }
    });
}

QString SavedSections::add(std::vector<base::PointD> line) {
    List after = m_sections;
    after.push_back({freeName(after, "Section "), m_workspace.board()->document->job.step, std::move(line)});
    m_part.edit(tr("saving a section"), m_sections, std::move(after));
    return QString::fromStdString(m_sections.back().name);
}

void SavedSections::rename(int row, const QString& name) {
    List after = m_sections;
    std::string& saved = after[static_cast<std::size_t>(row)].name;
    const std::string wanted = name.trimmed().toStdString();
    if (wanted.empty() || wanted == saved) {
        show(m_sections);  // the list shows what was typed
        return;
    }
    saved = wanted;
    m_part.edit(tr("the name of a section"), m_sections, std::move(after));
}

void SavedSections::remove(int row) {
    List after = m_sections;
    after.erase(after.begin() + row);
    m_part.edit(tr("deleting a section"), m_sections, std::move(after));
}

void SavedSections::show(List sections) {
    m_sections = std::move(sections);
    QStringList names;
    for (const model::session::SavedSection& section : m_sections) {
        names += QString::fromStdString(section.name);
    }
    m_names.setStringList(names);
}

}  // namespace ui
