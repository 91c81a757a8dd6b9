#pragma once

#include <map>
#include <memory>
#include <optional>
#include <vector>

#include "ui/common/table_model.h"
#include "ui/parts/part_picking.h"

namespace ui {

/// The components of the board and of the steps it places, each step's once, in the order people count: U2 before U10.
/// Of their attributes (part number, value, tolerance …) one column shows all but the height in one line, or the one
/// that is chosen, by whose name it is called then; a filter looks through all of them either way. The side of a
/// component that stands on an inner layer of a rigid-flex board is the name of that layer.
class PartModel : public TableModel {
    Q_OBJECT

public:
    enum Column { Designator, Part, Attributes, Package, Side, X, Y, Rotation, Height, Pins, Fitted, Step };

    explicit PartModel(QObject* parent = nullptr);

    void setBoard(std::shared_ptr<const model::Document> board);
    /// Names of attributes that any component has a value of, in the order people count.
    [[nodiscard]] const QStringList& attributeNames() const { return m_attributeNames; }
    /// Which the column shows; empty or of no component: all of them.
    void setAttribute(const QString& name);
    /// Empty while the column shows all of them.
    [[nodiscard]] QString attribute() const { return QString::fromStdString(m_attribute); }
    /// Of these rows: "no heights", "3 without a package outline"; empty if nothing is missing. Or that the job has no
    /// components.
    [[nodiscard]] QStringList missing(const std::vector<int>& shown) const;
    [[nodiscard]] bool hasHeights() const;

    [[nodiscard]] BoardPart partAt(int row) const { return m_rows[static_cast<std::size_t>(row)]; }
    [[nodiscard]] std::optional<int> rowOf(const BoardPart& part) const;
    [[nodiscard]] bool hasSeveralSteps() const;
    /// By row.
    [[nodiscard]] QStringList designators() const;
    [[nodiscard]] const model::Component& componentAt(int row) const;
    /// Empty if it has none.
    [[nodiscard]] std::string packageOf(int row) const;
    [[nodiscard]] QString stepNameOf(int row) const;
    /// Name and value of each attribute that says something.
    [[nodiscard]] std::vector<std::pair<QString, QString>> attributesOf(int row) const;
    /// The attribute called "value" in whatever case; empty if there is none.
    [[nodiscard]] QString valueOf(int row) const;
    /// What the column shows: the value of the chosen attribute, or "name: value" of all but the height.
    [[nodiscard]] QStringList attributeTextsOf(int row) const;
    [[nodiscard]] bool isOneAttribute() const { return !m_attribute.empty(); }
    [[nodiscard]] QString searchText(int row) const override;

private:
    [[nodiscard]] int rows() const override { return static_cast<int>(m_rows.size()); }
    [[nodiscard]] Cell cell(int row, int column) const override;
    [[nodiscard]] QVariant order(int row, int column) const override;
    [[nodiscard]] QString tip(int row, int column) const override;
    [[nodiscard]] const model::Document& stepOf(const BoardPart& part) const { return *m_steps[part.step]; }
    void sortRows();
    void findMounted();
    [[nodiscard]] QString sideOf(int row) const;
    [[nodiscard]] QString rankedText(int row, int column) const;
    [[nodiscard]] const std::vector<std::uint32_t>& ranks(int column) const;
    void listAttributeNames();

    std::shared_ptr<const model::Document> m_board;
    std::vector<const model::Document*> m_steps;    ///< as model::StepTree::steps
    std::vector<BoardPart> m_rows;                  ///< by designator
    std::map<BoardPart, model::LayerId> m_mounted;  ///< of those that stand on an inner layer: that layer
    /// Per column of names: places of the rows' texts. Made when the table is first sorted by that column.
    mutable std::array<std::vector<std::uint32_t>, Step + 1> m_ranks;
    QStringList m_attributeNames;
    std::string m_attribute;  ///< the chosen one; empty: all
};

}  // namespace ui
