#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "model/board/document.h"
#include "model/clearance/design_rules.h"

namespace model {

/// The class of every element that is a hole, by element; Any for what is none.
[[nodiscard]] std::vector<HoleClass> holeClassesOf(const Document& document);

/// Which rule of a table holds for what, on one document: of those that are on and fit, the last one. Document and
/// table must outlive it.
class RuleChoice {
public:
    RuleChoice(const Document& document, const RuleTable& table);

    /// Of copper to copper of two nets; none if no rule fits.
    [[nodiscard]] std::optional<std::size_t> between(NetId a, NetId b) const;
    /// Of a kind that knows no net classes, for holes of one class.
    [[nodiscard]] std::optional<std::size_t> of(RuleKind kind, HoleClass hole = HoleClass::Any) const;
    /// Of holes to holes; none if no rule fits.
    [[nodiscard]] std::optional<std::size_t> between(HoleClass a, HoleClass b) const;
    /// The largest least value of a kind, nm; 0: there is no such rule.
    [[nodiscard]] double reachOf(RuleKind kind) const;
    /// Rows of the rules of a kind that are on.
    [[nodiscard]] std::vector<std::size_t> rowsOf(RuleKind kind) const;
    /// Why no item of the document can meet a rule that is on: there are no such holes, or a later rule holds for all
    /// it is for. Empty if some can.
    [[nodiscard]] std::string whyUnused(std::size_t rule, const std::vector<HoleClass>& holes) const;
    /// Rows of net classes that a rule between nets names and that no net of the document fits.
    [[nodiscard]] std::vector<std::size_t> emptyClassesOf(std::size_t rule) const;

private:
    struct Fit {
        std::size_t row;
        std::uint64_t first;
        std::uint64_t second;
    };

    [[nodiscard]] std::size_t classRow(const std::string& name) const;
    [[nodiscard]] std::uint64_t maskOf(const std::string& name) const;
    [[nodiscard]] std::uint64_t classesOf(NetId net) const;

    const RuleTable& m_table;
    std::vector<std::uint64_t> m_classes;  ///< by net
    std::vector<Fit> m_rules;
};

}  // namespace model
