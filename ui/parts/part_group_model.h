#pragma once

#include "ui/parts/part_model.h"

namespace ui {

/// The bill of materials: equal components of a PartModel as one row, with their quantity and designators. Equal are
/// those of one step whose part, value (the attribute of that name) and package the job says alike, and which are all
/// fitted or all not. Components that the job excludes from the bill of materials are left out; the tip of the heading
/// of quantities says how many. Rows are in the order of their first designators. Empty until it is switched on: on a
/// large board that takes a while.
class PartGroupModel : public TableModel {
    Q_OBJECT

public:
    enum Column { Quantity, Part, Value, Package, Attributes, Fitted, Step, Designators };

    /// Follows `parts`, which must live as long.
    explicit PartGroupModel(const PartModel& parts, QObject* parent = nullptr);

    void setOn(bool isOn);
    [[nodiscard]] bool isOn() const { return m_isOn; }
    /// Rows of the PartModel, rising.
    [[nodiscard]] const std::vector<int>& partsOf(int row) const { return m_groups[static_cast<std::size_t>(row)]; }
    /// None while it is switched off, and of a component that is left out.
    [[nodiscard]] std::optional<int> groupOf(int part) const;
    /// "3 components excluded from the bill of materials"; empty if none are left out.
    [[nodiscard]] QString leftOutText() const;
    [[nodiscard]] bool hasValues() const;
    /// Part, value, package, designators and all attributes.
    [[nodiscard]] QString searchText(int row) const override;

private:
    [[nodiscard]] int rows() const override { return static_cast<int>(m_groups.size()); }
    [[nodiscard]] Cell cell(int row, int column) const override;
    [[nodiscard]] QString tip(int row, int column) const override;
    void group();
    void setHeadings();
    [[nodiscard]] bool isLeftOut(int part) const;
    /// Part, value or package, alike in all of a group.
    [[nodiscard]] QString textOf(int part, int column) const;
    void rank(Column column);
    [[nodiscard]] QStringList designators(int row) const;
    [[nodiscard]] QString attributes(int row) const;

    const PartModel& m_parts;
    bool m_isOn = false;
    std::vector<std::vector<int>> m_groups;
    std::vector<std::optional<int>> m_groupOf;                    ///< by row of the PartModel
    std::array<std::vector<std::uint32_t>, Package + 1> m_ranks;  ///< per column of names: places of the rows' texts
};

}  // namespace ui
