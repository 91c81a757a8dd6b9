#pragma once

#include <QSortFilterProxyModel>

#include "model/board/diagnostics.h"

namespace ui {

/// The messages that are at least so severe and contain all the words typed, in text or place, in any order and case.
class MessageFilter : public QSortFilterProxyModel {
    Q_OBJECT

public:
    explicit MessageFilter(QObject* parent = nullptr);

    void setLeastSeverity(model::Severity severity);
    void setWords(const QString& words);

protected:
    [[nodiscard]] bool filterAcceptsRow(int row, const QModelIndex& parent) const override;
    [[nodiscard]] bool lessThan(const QModelIndex& left, const QModelIndex& right) const override;

private:
    model::Severity m_leastSeverity = model::Severity::Info;
    QStringList m_words;
};

}  // namespace ui
