#include "ui/messages/message_filter.h"

#include <algorithm>

#include "ui/messages/message_model.h"

namespace ui {

MessageFilter::MessageFilter(QObject* parent) : QSortFilterProxyModel(parent) {
    setSortCaseSensitivity(Qt::CaseInsensitive);
}

void MessageFilter::setLeastSeverity(model::Severity severity) {
    m_leastSeverity = severity;
    invalidateFilter();
}

void MessageFilter::setWords(const QString& words) {
    m_words = words.split(' ', Qt::SkipEmptyParts);
    invalidateFilter();
}

bool MessageFilter::filterAcceptsRow(int row, const QModelIndex& parent) const {
    const QAbstractItemModel& source = *sourceModel();
    const QModelIndex text = source.index(row, MessageModel::Text, parent);
    if (text.data(MessageModel::kSeverityRole).toInt() < static_cast<int>(m_leastSeverity)) {
        return false;
    }
    const QString haystack =
        text.data().toString() + ' ' + source.index(row, MessageModel::Location, parent).data().toString();
    return std::all_of(m_words.begin(), m_words.end(),
                       [&](const QString& word) { return haystack.contains(word, Qt::CaseInsensitive); });
}

bool MessageFilter::lessThan(const QModelIndex& left, const QModelIndex& right) const {
    if (left.column() == MessageModel::Severity) {  // by weight, not by spelling
        return left.data(MessageModel::kSeverityRole).toInt() < right.data(MessageModel::kSeverityRole).toInt();
    }
    return QSortFilterProxyModel::lessThan(left, right);
}

}  // namespace ui
