#pragma once

#include <QAbstractTableModel>
#include <memory>
#include <vector>

#include "model/nets/net_check.h"
#include "ui/common/lengths.h"

namespace ui {

/// What the check of the nets against the copper found (model/nets/net_check.h), as a table: a row per short,
/// one per island of an open net, and one per piece of loose copper, the weighty ones first.
class NetCheckModel : public QAbstractTableModel {
    Q_OBJECT

public:
    enum Column { Kind, Nets, What, Layer, X, Y, Step, ColumnCount };
    enum class FindingKind : std::uint8_t {
        Short,  ///< copper of two nets touches
        Open,   ///< an island with pads or holes of a net that has several such
        Loose   ///< an island without any
    };
    struct Finding {
        FindingKind kind = FindingKind::Short;
        std::uint32_t step = 0;  ///< row of model::StepTree::steps
        std::uint32_t row = 0;   ///< of NetReport::shorts, else of NetReport::islands
        model::NetId net;        ///< the lower one of a short
    };

    using QAbstractTableModel::QAbstractTableModel;

    /// `checks` of all steps of `board`, which is kept as long as they are. A null board empties the table.
    void setChecks(std::shared_ptr<const model::Document> board, std::vector<model::StepCheck> checks);
    void setUnit(LengthUnit unit);

    [[nodiscard]] const Finding& finding(int row) const { return m_findings[static_cast<std::size_t>(row)]; }
    /// What stands out when it is shown: both sides of a short, an element of an island; rows of the finding's step.
    [[nodiscard]] std::vector<model::ElementId> elementsOf(const Finding& finding) const;
    [[nodiscard]] model::PointD locationOf(const Finding& finding) const;
    [[nodiscard]] model::LayerId layerOf(const Finding& finding) const;
    [[nodiscard]] bool isChecked() const { return m_board != nullptr; }
    /// "2 shorts, 1 open net, no loose copper", or that nothing was checked yet.
    [[nodiscard]] QString summary() const;

    [[nodiscard]] int rowCount(const QModelIndex& parent = {}) const override;
    [[nodiscard]] int columnCount(const QModelIndex& parent = {}) const override;
    [[nodiscard]] QVariant data(const QModelIndex& index, int role) const override;
    [[nodiscard]] QVariant headerData(int section, Qt::Orientation orientation, int role) const override;

private:
    void listStep(std::uint32_t step);
    [[nodiscard]] const model::StepCheck& check(const Finding& finding) const { return m_checks[finding.step]; }
    [[nodiscard]] const model::ShortedNets& shorted(const Finding& finding) const;
    [[nodiscard]] const model::NetIsland& island(const Finding& finding) const;
    [[nodiscard]] QString netsText(const Finding& finding) const;
    [[nodiscard]] QString whatText(const Finding& finding) const;

    std::shared_ptr<const model::Document> m_board;
    std::vector<model::StepCheck> m_checks;
    std::vector<Finding> m_findings;
    LengthUnit m_unit = LengthUnit::Millimetre;
};

}  // namespace ui
