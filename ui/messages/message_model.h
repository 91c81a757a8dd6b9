#pragma once

#include <memory>
#include <vector>

#include "model/board/document.h"
#include "ui/common/table_model.h"

namespace ui {

/// What was skipped, repaired or assumed while opening a board: the document's diagnostics, then those of the
/// modelling; then what is left out of the rules and of the file that was exported last. The rank of a row is its
/// severity.
class MessageModel : public TableModel {
    Q_OBJECT

public:
    enum Column { Severity, Text, Location, Count };

    explicit MessageModel(QObject* parent = nullptr);

    [[nodiscard]] const model::Diagnostic& message(int row) const;
    void setMessages(std::shared_ptr<const model::Document> document, model::Diagnostics modelling);
    /// What the last export left out.
    void setExported(model::Diagnostics exported);
    /// What is left out of the rules.
    void setRules(model::Diagnostics rules);
    /// How many entries have this severity.
    [[nodiscard]] std::size_t count(model::Severity severity) const;

    [[nodiscard]] int rankOf(int row) const override { return static_cast<int>(message(row).severity); }
    [[nodiscard]] QString searchText(int row) const override;

private:
    [[nodiscard]] int rows() const override;
    [[nodiscard]] Cell cell(int row, int column) const override;
    [[nodiscard]] QString tip(int row, int column) const override;
    /// All lists, one behind the other.
    [[nodiscard]] std::vector<const model::Diagnostics*> lists() const;
    void setList(model::Diagnostics& list, model::Diagnostics messages);

    std::shared_ptr<const model::Document> m_document;
    model::Diagnostics m_modelling;
    model::Diagnostics m_rules;
    model::Diagnostics m_exported;
};

}  // namespace ui
