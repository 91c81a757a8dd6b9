#include "ui/messages/message_model.h"

#include "model/board/diagnostic_facts.h"
#include "ui/common/severity_colour.h"

namespace ui {

MessageModel::MessageModel(QObject* parent)
    : TableModel({{tr("Severity"), tr("How much it matters")},
                  {tr("Message"), tr("What was skipped, repaired or assumed")},
                  {tr("Where"), tr("File inside the job and line of the first occurrence"), kPath},
                  {tr("Count"), tr("How often it happened"), kNumber}},
                 parent) {}

void MessageModel::setMessages(std::shared_ptr<const model::Document> document, model::Diagnostics modelling) {
    beginResetModel();
    m_document = std::move(document);
    m_modelling = std::move(modelling);
    endResetModel();
}

void MessageModel::setExported(model::Diagnostics exported) {
    setList(m_exported, std::move(exported));
}

void MessageModel::setRules(model::Diagnostics rules) {
    setList(m_rules, std::move(rules));
}

void MessageModel::setList(model::Diagnostics& list, model::Diagnostics messages) {
    beginResetModel();
    list = std::move(messages);
    endResetModel();
}

std::vector<const model::Diagnostics*> MessageModel::lists() const {
    std::vector<const model::Diagnostics*> lists{&m_modelling, &m_rules, &m_exported};
    if (m_document) {
        lists.insert(lists.begin(), &m_document->diagnostics);
    }
    return lists;
}

int MessageModel::rows() const {
    std::size_t count = 0;
    for (const model::Diagnostics* list : lists()) {
        count += list->entries().size();
    }
    return static_cast<int>(count);
}

std::size_t MessageModel::count(model::Severity severity) const {
    std::size_t count = 0;
    for (const model::Diagnostics* list : lists()) {
        count += list->count(severity);
    }
    return count;
}

const model::Diagnostic& MessageModel::message(int row) const {
    auto position = static_cast<std::size_t>(row);
    const std::vector<const model::Diagnostics*> all = lists();
    auto list = all.begin();
    while (position >= (*list)->entries().size()) {
        position -= (*list)->entries().size();
        ++list;
    }
    return (*list)->entries()[position];
}

QString MessageModel::searchText(int row) const {
    return QString::fromStdString(message(row).text) + ' ' + QString::fromStdString(model::placeOf(message(row)));
}

Cell MessageModel::cell(int row, int column) const {
    const model::Diagnostic& entry = message(row);
    const QString severities[] = {tr("Note"), tr("Warning"), tr("Error")};
    switch (column) {
        case Severity:
            return {.text = severities[rankOf(row)],
                    .order = rankOf(row),  // by weight, not by spelling
                    .decoration = severityColour(entry.severity)};
        case Text: return text(entry.text);
        case Location: return {QString::fromStdString(model::placeOf(entry))};
        default: return {entry.count};
    }
}

QString MessageModel::tip(int row, int column) const {
    const model::Diagnostic& entry = message(row);
    if (column == Location) {
        return QString::fromStdString(model::placeOf(entry));
    }
    const bool isOnBoard = entry.element.isValid() || entry.location.has_value();
    const QString text = QString::fromStdString(entry.text);
    return isOnBoard ? text + '\n' + tr("Click to see the location on the board") : text;
}

}  // namespace ui
