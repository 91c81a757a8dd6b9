#pragma once

#include <QAbstractTableModel>
#include <memory>

#include "model/board/document.h"

namespace ui {

/// What was skipped, repaired or assumed while opening a board: the document's diagnostics, then those of the
/// modelling.
class MessageModel : public QAbstractTableModel {
    Q_OBJECT

public:
    enum Column { Severity, Text, Location, Count, ColumnCount };
    /// Of any cell: int(model::Severity), for filtering and sorting.
    static constexpr int kSeverityRole = Qt::UserRole;

    using QAbstractTableModel::QAbstractTableModel;

    [[nodiscard]] const model::Diagnostic& message(int row) const;
    void setMessages(std::shared_ptr<const model::Document> document, model::Diagnostics modelling);
    /// How many entries have this severity.
    [[nodiscard]] std::size_t count(model::Severity severity) const;

    [[nodiscard]] int rowCount(const QModelIndex& parent = {}) const override;
    [[nodiscard]] int columnCount(const QModelIndex& parent = {}) const override;
    [[nodiscard]] QVariant data(const QModelIndex& index, int role) const override;
    [[nodiscard]] QVariant headerData(int section, Qt::Orientation orientation, int role) const override;

private:
    [[nodiscard]] std::size_t readingCount() const { return m_document ? m_document->diagnostics.entries().size() : 0; }

    std::shared_ptr<const model::Document> m_document;
    model::Diagnostics m_modelling;
};

}  // namespace ui
