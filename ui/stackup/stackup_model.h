#pragma once

#include <memory>

#include "model/board/document.h"
#include "ui/common/table_model.h"

namespace ui {

/// The stackup of the board from the top as a table whose thicknesses can be edited: a number with um, mm, mil, inch
/// or, for copper, oz. An empty text takes a row back to what the job says. Values that are assumed are in italics,
/// those set by the user in bold, and where a value comes from is beside it. The document stays as it is; whoever
/// listens sets another one.
class StackupModel : public TableModel {
    Q_OBJECT

public:
    enum Column { Order, Name, Type, Thickness, From, Weight, MaterialName, Constant, Tangent };

    explicit StackupModel(QObject* parent = nullptr);

    /// A null document, or one of a format that states its heights, empties the table. Rows that stay are not reset, so
    /// that the selection stays too.
    void setDocument(std::shared_ptr<const model::Document> document);

    /// Takes rows back to what the job says.
    void reset(const std::vector<int>& rows);

    /// From the top.
    [[nodiscard]] const model::StackupRow& row(int index) const;

signals:
    /// The user wants these rows to be so thick; 0 takes one back to what the job says.
    void edited(const std::vector<model::ThicknessOverride>& changes);
    /// The text is no thickness; says why.
    void refused(const QString& reason);

private:
    [[nodiscard]] int rows() const override {
        return m_document ? static_cast<int>(m_document->stackup.rows.size()) : 0;
    }
    [[nodiscard]] Cell cell(int row, int column) const override;
    [[nodiscard]] QString tip(int row, int column) const override;
    bool edit(int row, int column, const QVariant& value) override;
    [[nodiscard]] QString sourceText(model::Source source) const;
    [[nodiscard]] static QString thicknessHint();

    std::shared_ptr<const model::Document> m_document;
};

}  // namespace ui
