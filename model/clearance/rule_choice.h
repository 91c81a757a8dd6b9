#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "model/board/document.h"
#include "model/clearance/design_rules.h"

namespace model {

/// Which rule of a table holds for what, on one document: of those that are on and fit, the last one. Document and
/// table must outlive it.
class RuleChoice {
public:
    RuleChoice(const Document& document, const RuleTable& table);

    /// Of copper to copper of two nets; none if no rule fits.
    [[nodiscard]] std::optional<std::size_t> between(NetId a, NetId b) const;
    /// Of a kind that knows no net classes.
    [[nodiscard]] std::optional<std::size_t> of(RuleKind kind) const;
    /// The largest least value of a kind, nm; 0: there is no such rule.
    [[nodiscard]] double reachOf(RuleKind kind) const;
    /// Rows of the rules of a kind that are on.
    [[nodiscard]] std::vector<std::size_t> rowsOf(RuleKind kind) const;
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
