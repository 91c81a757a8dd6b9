#pragma once

#include <memory>
#include <optional>

#include "model/agreement/agreement.h"
#include "ui/common/table_model.h"

namespace ui {

/// The board on the screen, A, beside another one, B.
struct ComparedBoards {
    std::shared_ptr<const model::Document> a;
    std::shared_ptr<const model::Document> b;
    model::Agreement agreement;
    QString nameOfB;
};

/// How two boards differ (model/agreement), as a table: a row per difference, after them what was not compared, and
/// what agrees.
class ComparisonModel : public TableModel {
    Q_OBJECT

public:
    enum Column { Aspect, Layer, What, X, Y };
    /// So many differences of a layer, or of another aspect, are listed at most; a row says how many are left.
    static constexpr std::size_t kMost = 2'000;

    explicit ComparisonModel(QObject* parent = nullptr);

    /// None empties the table.
    void setBoards(std::optional<ComparedBoards> boards);
    [[nodiscard]] const std::optional<ComparedBoards>& boards() const { return m_boards; }
    [[nodiscard]] const model::Comparison& comparison(int row) const {
        return m_boards->agreement.comparisons[m_rows[static_cast<std::size_t>(row)].comparison];
    }
    /// Null where the row is about the whole comparison.
    [[nodiscard]] const model::Difference* difference(int row) const;
    /// "12 differences: copper 3, holes 9. A is this board, B is rev-b.tgz", or that nothing was compared yet.
    [[nodiscard]] QString summary() const;

private:
    struct Row {
        std::size_t comparison = 0;
        std::size_t difference = 0;  ///< none: as many as there are
    };

    [[nodiscard]] int rows() const override { return static_cast<int>(m_rows.size()); }
    [[nodiscard]] Cell cell(int row, int column) const override;
    void listComparison(std::size_t comparison);
    [[nodiscard]] QString whatText(int row) const;
    [[nodiscard]] Cell coordinate(int row, model::Nm model::Point::*axis) const;

    std::optional<ComparedBoards> m_boards;
    std::vector<Row> m_rows;
};

}  // namespace ui
