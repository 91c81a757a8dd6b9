#include "ui/messages/message_model.h"

#include <QColor>
namespace ui {

namespace {

constexpr const char* kHeadings[MessageModel::ColumnCount] = {"Severity", "Message", "Where", "Count"};
constexpr const char* kTips[MessageModel::ColumnCount] = {
    "How much it matters",
    "What was skipped, repaired or assumed",
    "File inside the job and line of the first occurrence",
    "How often it happened",
};

QString severityText(model::Severity severity) {
    switch (severity) {
        case model::Severity::Info: return QStringLiteral("Note");
        case model::Severity::Warning: return QStringLiteral("Warning");
        case model::Severity::Error: return QStringLiteral("Error");
    }
    return {};
}

/// Mid tones, readable on a light and on a dark ground; the word beside it says the same.
QColor severityColour(model::Severity severity) {
    switch (severity) {
        case model::Severity::Info: return {0x56, 0x8c, 0xc8};
        case model::Severity::Warning: return {0xe0, 0x9a, 0x1f};
        case model::Severity::Error: return {0xd9, 0x4a, 0x3d};
    }
    return {};
}

QString positionText(const model::Diagnostic& entry) {
    const QString file = QString::fromStdString(entry.file);
    return entry.line > 0 ? QStringLiteral("%1:%2").arg(file).arg(entry.line) : file;
}

QVariant cell(const model::Diagnostic& entry, int column) {
    switch (column) {
        case MessageModel::Severity: return severityText(entry.severity);
        case MessageModel::Text: return QString::fromStdString(entry.text);
        case MessageModel::Location: return positionText(entry);
        case MessageModel::Count: return entry.count;
        default: return {};
    }
}

QString tip(const model::Diagnostic& entry) {
    const bool isOnBoard = entry.element.isValid() || entry.location.has_value();
    const QString text = QString::fromStdString(entry.text);
    return isOnBoard ? text + QStringLiteral("\nClick to see the place on the board") : text;
}

/// Numbers to the right, under headings to the right.
QVariant alignment(int column) {
    return QVariant::fromValue(
        Qt::Alignment(Qt::AlignVCenter | (column == MessageModel::Count ? Qt::AlignRight : Qt::AlignLeft)));
}

}  // namespace

void MessageModel::setMessages(std::shared_ptr<const model::Document> document, model::Diagnostics modelling) {
    beginResetModel();
    m_document = std::move(document);
    m_modelling = std::move(modelling);
    endResetModel();
}

std::size_t MessageModel::count(model::Severity severity) const {
    return (m_document ? m_document->diagnostics.count(severity) : 0) + m_modelling.count(severity);
}

const model::Diagnostic& MessageModel::message(int row) const {
    const auto position = static_cast<std::size_t>(row);
    return position < readingCount() ? m_document->diagnostics.entries()[position]
                                     : m_modelling.entries()[position - readingCount()];
}

int MessageModel::rowCount(const QModelIndex& parent) const {
    return parent.isValid() ? 0 : static_cast<int>(readingCount() + m_modelling.entries().size());
}

int MessageModel::columnCount(const QModelIndex& parent) const {
    return parent.isValid() ? 0 : ColumnCount;
}

QVariant MessageModel::data(const QModelIndex& index, int role) const {
    if (!checkIndex(index, CheckIndexOption::IndexIsValid | CheckIndexOption::ParentIsInvalid)) {
        return {};
    }
    const model::Diagnostic& diagnostic = message(index.row());
    switch (role) {
        case Qt::DisplayRole:
        case Qt::EditRole: return cell(diagnostic, index.column());
        case Qt::ToolTipRole: return tip(diagnostic);
        case Qt::DecorationRole:
            return index.column() == Severity ? QVariant(severityColour(diagnostic.severity)) : QVariant();
        case Qt::TextAlignmentRole: return alignment(index.column());
        case kSeverityRole: return static_cast<int>(diagnostic.severity);
        default: return {};
    }
}

QVariant MessageModel::headerData(int section, Qt::Orientation orientation, int role) const {
    if (orientation != Qt::Horizontal || section < 0 || section >= ColumnCount) {
        return {};
    }
    switch (role) {
        case Qt::DisplayRole: return kHeadings[section];
        case Qt::ToolTipRole: return kTips[section];
        case Qt::TextAlignmentRole: return alignment(section);
        default: return {};
    }
}

}  // namespace ui
