#pragma once

#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "model/index/board_index.h"
#include "ui/common/table_model.h"
#include "ui/parts/part_picking.h"
#include "ui/workspace/loader.h"

namespace ui {

/// Pins of components, in the order people count: U5.2 before U5.10. Which of the board's pins these are is decided by
/// whoever calls `setPins`.
class PinModel : public TableModel {
    Q_OBJECT

public:
    enum Column { Pin, Net, Layer, X, Y, Step };

    explicit PinModel(QObject* parent = nullptr);

    /// Without an index it is a board without pins. None are listed until `setPins` or `setAllPins`.
    void setBoard(const LoadedBoard& board);
    void setPins(std::vector<BoardPin> pins);
    /// Takes no time where they are listed.
    void setAllPins();

    [[nodiscard]] BoardPin pinAt(int row) const { return m_rows[static_cast<std::size_t>(row)].pin; }
    /// Of those that are listed, from above; in one pass, as there may be 100,000 of them.
    [[nodiscard]] std::vector<int> rowsOf(std::vector<BoardPin> pins) const;
    /// None if it is on none.
    [[nodiscard]] std::optional<model::BoardNet> netAt(int row) const;
    [[nodiscard]] bool hasSeveralSteps() const { return steps().size() > 1; }
    [[nodiscard]] std::span<const model::Document* const> steps() const;

private:
    struct Row {
        BoardPin pin;
        model::LayerId top;  ///< copper that its pads and hole are on; none if there is none
        model::LayerId bottom;
    };

    [[nodiscard]] int rows() const override { return static_cast<int>(m_rows.size()); }
    [[nodiscard]] Cell cell(int row, int column) const override;
    [[nodiscard]] QString tip(int row, int column) const override;
    [[nodiscard]] const model::Document& stepOf(const BoardPin& pin) const { return *m_board->tree.steps[pin.step]; }
    [[nodiscard]] const model::Pin& recordOf(int row) const;
    [[nodiscard]] std::size_t netRank(const BoardPin& pin) const;
    [[nodiscard]] Row rowFor(const BoardPin& pin) const;
    [[nodiscard]] std::vector<Row> rowsFor(std::vector<BoardPin> pins) const;
    void setRows(std::vector<Row> rows, bool areAll);
    [[nodiscard]] Cell layerCell(const Row& row) const;

    std::shared_ptr<const model::BoardIndex> m_board;
    std::vector<std::vector<std::uint32_t>> m_pinRanks;               ///< LoadedBoard::pinRanks
    std::vector<std::shared_ptr<const model::NetStatistics>> m_nets;  ///< LoadedBoard::nets
    std::vector<Row> m_rows;
    std::optional<std::vector<Row>> m_all;  ///< once they were listed
    bool m_areAllListed = false;
};

}  // namespace ui
