#pragma once

#include <memory>

#include "model/nets/net_check.h"
#include "ui/common/table_model.h"

namespace ui {

/// What the netlist check found (model/nets/net_check.h), as a table: a row per short, one per island of an open net,
/// one per pin without a net that touches one, one per piece of floating copper and one per net tie, the weighty ones
/// first.
class NetlistCheckModel : public TableModel {
    Q_OBJECT

public:
    enum Column { Kind, Nets, What, Layer, X, Y, Step };
    enum class FindingKind : std::uint8_t {
        Short,     ///< copper of two nets touches
        Open,      ///< an island with pads or holes of a net that has several such
        NoNet,     ///< a pin without a net touches copper of one
        Floating,  ///< an island without any
        Tie        ///< a component joins two nets on purpose
    };
    struct Finding {
        FindingKind kind = FindingKind::Short;
        std::uint32_t step = 0;  ///< row of model::StepTree::steps
        std::uint32_t row = 0;   ///< of NetReport::shorts, ties or pinsOnNets, else of NetReport::islands
        model::NetId net;        ///< the lower one of a short or tie
    };

    explicit NetlistCheckModel(QObject* parent = nullptr);

    /// `checks` of all steps of `board`, which is held as long as they are. A null board empties the table.
    void setChecks(std::shared_ptr<const model::Document> board, std::vector<model::StepCheck> checks);

    [[nodiscard]] const Finding& finding(int row) const { return m_findings[static_cast<std::size_t>(row)]; }
    /// What is highlighted when it is shown: both sides of a short, a pin's pad and the copper that it touches, an
    /// element of an island or tie; rows of the finding's step.
    [[nodiscard]] std::vector<model::ElementId> elementsOf(const Finding& finding) const;
    [[nodiscard]] model::PointD locationOf(const Finding& finding) const;
    [[nodiscard]] model::LayerId layerOf(const Finding& finding) const;
    [[nodiscard]] bool isChecked() const { return m_board != nullptr; }
    /// "2 shorts, 1 open net, no floating copper", with pins without a net and net ties if there are any, or that no
    /// check was made yet.
    [[nodiscard]] QString summary() const;

private:
    [[nodiscard]] int rows() const override { return static_cast<int>(m_findings.size()); }
    [[nodiscard]] Cell cell(int row, int column) const override;
    void listStep(std::uint32_t step);
    [[nodiscard]] const model::StepCheck& stepCheck(const Finding& finding) const { return m_checks[finding.step]; }
    [[nodiscard]] const model::ShortedNets& shorted(const Finding& finding) const {
        return stepCheck(finding).report.shorts[finding.row];
    }
    [[nodiscard]] const model::NetTie& tie(const Finding& finding) const {
        return stepCheck(finding).report.ties[finding.row];
    }
    [[nodiscard]] const model::PinOnNet& pinOnNet(const Finding& finding) const {
        return stepCheck(finding).report.pinsOnNets[finding.row];
    }
    [[nodiscard]] const model::NetIsland& island(const Finding& finding) const {
        return stepCheck(finding).report.islands[finding.row];
    }
    [[nodiscard]] QString netsText(const Finding& finding) const;
    [[nodiscard]] QString whatText(const Finding& finding) const;
    [[nodiscard]] QString designator(const Finding& finding, model::ComponentId component) const;

    std::shared_ptr<const model::Document> m_board;
    std::vector<model::StepCheck> m_checks;
    std::vector<Finding> m_findings;
};

}  // namespace ui
