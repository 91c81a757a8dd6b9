#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "model/nets/net_groups.h"

namespace ui {

/// The rows of a table of nets: nets in an order, under headings of their groups, which may lie within each other and
/// can be folded. A row is an id and nothing else: there may be a million nets. A heading means all nets under it, also
/// those that are folded away.
class NetRows {
public:
    using Groups = std::shared_ptr<const model::NetGroups>;

    NetRows() = default;
    /// `nets` are rows of Document::nets; with `groups` (null: no headings) those of a group follow each other, groups
    /// in their order, nets in none last.
    NetRows(const std::vector<std::uint32_t>& nets, Groups groups);

    /// Without what is folded away.
    [[nodiscard]] int count() const { return static_cast<int>(m_shown.size()); }
    [[nodiscard]] int nets() const { return m_nets; }
    [[nodiscard]] const Groups& groups() const { return m_groups; }
    [[nodiscard]] bool isHeading(int row) const { return (at(row) & kHeading) != 0; }
    /// None for headings.
    [[nodiscard]] model::NetId netAt(int row) const;
    /// The net of a row, or all under a heading.
    [[nodiscard]] std::vector<model::NetId> netsAt(int row) const;
    /// How many those are; known without looking at them.
    [[nodiscard]] std::size_t netCountAt(int row) const { return isHeading(row) ? m_netCounts[groupAt(row)] : 1; }
    /// Row of NetGroups::names, or their number for the heading of nets in none.
    [[nodiscard]] std::uint32_t groupAt(int heading) const { return at(heading) & ~kHeading; }
    /// How many headings a row stands under, not counting its own.
    [[nodiscard]] int depthOf(int row) const;
    /// None if it is not there or folded away.
    [[nodiscard]] std::optional<int> rowOf(model::NetId net) const;
    /// The nearest heading above a row that it stands under.
    [[nodiscard]] std::optional<int> headingOf(int row) const;

    [[nodiscard]] bool isFolded(int heading) const { return m_isFolded[groupAt(heading)]; }
    void fold(int heading, bool isFolded);
    /// By group, the rest last; those of other rows with the same groups.
    [[nodiscard]] const std::vector<bool>& folded() const { return m_isFolded; }
    void setFolded(std::vector<bool> isFolded);
    /// Unfolds what a net is folded away in. False if it is not there at all.
    bool reveal(model::NetId net);

private:
    static constexpr std::uint32_t kHeading = 1U << 31U;

    [[nodiscard]] std::uint32_t at(int row) const { return m_all[m_shown[static_cast<std::size_t>(row)]]; }
    [[nodiscard]] std::uint32_t depthOfHeading(std::uint32_t entry) const;
    [[nodiscard]] std::size_t endOfHeading(std::size_t place) const;
    void addHeadings(std::uint32_t group, std::optional<std::uint32_t> last);
    void countNets();
    void show();

    Groups m_groups;
    std::vector<std::uint32_t> m_all;    ///< nets, and headings with the row of their group
    std::vector<std::uint32_t> m_shown;  ///< rows of m_all
    std::vector<int> m_headings;         ///< shown rows that are, rising
    std::vector<bool> m_isFolded;
    std::vector<std::uint32_t> m_netCounts;  ///< by group, with those of the groups within it
    int m_nets = 0;
};

}  // namespace ui
