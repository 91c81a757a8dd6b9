#include "ui/messages/message_model.h"

#include "ui/common/severity_colour.h"

namespace ui {

namespace {

QString locationText(const model::Diagnostic& entry) {
    const QString file = QString::fromStdString(entry.file);
    return entry.line > 0 ? QStringLiteral("%1:%2").arg(file).arg(entry.line) : file;
}

}  // namespace

MessageModel::MessageModel(QObject* parent)
    : TableModel({{tr("Severity"), tr("How much it matters")},
                  {tr("Message"), tr("What was skipped, repaired or assumed")},
                  {tr("Where"), tr("File inside the job and line of the first occurrence")},
                  {tr("Count"), tr("How often it happened"), kNumber}},
                 parent) {}

void MessageModel::setMessages(std::shared_ptr<const model::Document> document, model::Diagnostics modelling) {
    beginResetModel();
    m_document = std::move(document);
    m_modelling = std::move(modelling);
    endResetModel();
}

void MessageModel::setExported(model::Diagnostics exported) {
    beginResetModel();
    m_exported = std::move(exported);
    endResetModel();
}

std::size_t MessageModel::count(model::Severity severity) const {
    return (m_document ? m_document->diagnostics.count(severity) : 0) + m_modelling.count(severity) +
           m_exported.count(severity);
}

const model::Diagnostic& MessageModel::message(int row) const {
    auto position = static_cast<std::size_t>(row);
    if (position < readingCount()) {
        return m_document->diagnostics.entries()[position];
    }
    position -= readingCount();
    const std::size_t modelling = m_modelling.entries().size();
    return position < modelling ? m_modelling.entries()[position] : m_exported.entries()[position - modelling];
}

QString MessageModel::searchText(int row) const {
    return QString::fromStdString(message(row).text) + ' ' + locationText(message(row));
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
        case Location: return {locationText(entry)};
        default: return {entry.count};
    }
}

QString MessageModel::tip(int row, int) const {
    const model::Diagnostic& entry = message(row);
    const bool isOnBoard = entry.element.isValid() || entry.location.has_value();
    const QString text = QString::fromStdString(entry.text);
    return isOnBoard ? text + '\n' + tr("Click to see the location on the board") : text;
}

}  // namespace ui
