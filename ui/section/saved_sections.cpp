#include "ui/section/saved_sections.h"

#include <algorithm>
#include <utility>

#include "ui/workspace/state_edit.h"

namespace ui {

namespace session = model::session;

SavedSections::SavedSections(QUndoStack& history, QObject* parent) : QObject(parent), m_history(history) {
    connect(&m_names, &QStringListModel::dataChanged, this,
            [this](const QModelIndex& at) { rename(at.row(), at.data(Qt::EditRole).toString()); });
}

void SavedSections::setBoard(const LoadedBoard& board) {
    if (m_session.open(board)) {
        show(board.sections);
    }
}

bool SavedSections::isHere(const session::SavedSection& section) const {
    return m_session.document() != nullptr && section.step == m_session.document()->job.step;
}

QString SavedSections::keep(std::vector<base::PointD> line) {
    const auto nameOf = [](std::size_t number) { return "Section " + std::to_string(number); };
    std::size_t number = m_sections.size() + 1;
    while (std::ranges::find(m_sections, nameOf(number), &session::SavedSection::name) != m_sections.end()) {
        ++number;
    }
    List after = m_sections;
    after.push_back({nameOf(number), m_session.document()->job.step, std::move(line)});
    change(QStringLiteral("keeping a section"), std::move(after));
    return QString::fromStdString(nameOf(number));
}

void SavedSections::rename(int row, const QString& name) {
    List after = m_sections;
    std::string& kept = after[static_cast<std::size_t>(row)].name;
    const std::string wanted = name.trimmed().toStdString();
    if (wanted.empty() || wanted == kept) {
        show(m_sections);  // the list shows what was typed
        return;
    }
    kept = wanted;
    change(QStringLiteral("the name of a section"), std::move(after));
}

void SavedSections::remove(int row) {
    List after = m_sections;
    after.erase(after.begin() + row);
    change(QStringLiteral("forgetting a section"), std::move(after));
}

void SavedSections::change(const QString& what, List after) {
    m_history.push(
        new StateEdit<List>(what, m_sections, std::move(after), [this](const List& sections) { apply(sections); }));
}

void SavedSections::show(List sections) {
    m_sections = std::move(sections);
    QStringList names;
    for (const session::SavedSection& section : m_sections) {
        names += QString::fromStdString(section.name);
    }
    m_names.setStringList(names);
}

void SavedSections::apply(const List& sections) {
    show(sections);
    const QString trouble = m_session.save(QStringLiteral("The sections"), [&](const auto& path, const auto& document) {
        return session::saveSections(path, document, sections);
    });
    if (!trouble.isEmpty()) {
        emit notSaved(trouble);
    }
}

}  // namespace ui
