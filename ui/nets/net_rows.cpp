#include "ui/nets/net_rows.h"

#include <algorithm>

namespace ui {

NetRows::NetRows(const std::vector<std::uint32_t>& nets, Groups groups)
    : m_groups(std::move(groups)), m_nets(static_cast<int>(nets.size())) {
    if (!m_groups) {
        m_all = nets;
        show();
        return;
    }
    const auto rest = static_cast<std::uint32_t>(m_groups->names.size());
    std::optional<std::uint32_t> last;
    for (const std::uint32_t net : nets) {
        const std::uint32_t group = std::min(m_groups->groupOf[net], rest);
        if (group != last) {
            addHeadings(group, last);
            last = group;
        }
        m_all.push_back(net);
    }
    m_isFolded.assign(rest + 1, false);
    countNets();
    show();
}

/// Those of the group, and of the groups it lies within that `last` does not lie within.
void NetRows::addHeadings(std::uint32_t group, std::optional<std::uint32_t> last) {
    std::vector<std::uint32_t> headings{group};
    for (std::uint32_t row = group; row > 0 && group < m_groups->names.size() && m_groups->depths[row] > 0;) {
        const std::uint32_t depth = m_groups->depths[row];
        while (m_groups->depths[row] >= depth) {
            --row;  // up to the one around it
        }
        if (last && row <= *last) {
            break;  // it has its heading
        }
        headings.push_back(row);
    }
    for (auto heading = headings.rbegin(); heading != headings.rend(); ++heading) {
        m_all.push_back(kHeading | *heading);
    }
}

void NetRows::countNets() {
    m_netCounts.assign(m_isFolded.size(), 0);
    std::vector<std::uint32_t> open;  // headings the next net stands under
    for (const std::uint32_t entry : m_all) {
        if ((entry & kHeading) == 0) {
            for (const std::uint32_t heading : open) {
                ++m_netCounts[heading & ~kHeading];
            }
            continue;
        }
        while (!open.empty() && depthOfHeading(open.back()) >= depthOfHeading(entry)) {
            open.pop_back();
        }
        open.push_back(entry);
    }
}

std::uint32_t NetRows::depthOfHeading(std::uint32_t entry) const {
    const std::uint32_t group = entry & ~kHeading;
    return group < m_groups->depths.size() ? m_groups->depths[group] : 0;
}

std::size_t NetRows::endOfHeading(std::size_t place) const {
    const std::uint32_t depth = depthOfHeading(m_all[place]);
    const auto ends = [&](std::uint32_t entry) { return (entry & kHeading) != 0 && depthOfHeading(entry) <= depth; };
    const auto next = m_all.begin() + static_cast<std::ptrdiff_t>(place) + 1;
    return static_cast<std::size_t>(std::find_if(next, m_all.end(), ends) - m_all.begin());
}

void NetRows::show() {
    m_shown.clear();
    m_headings.clear();
    for (std::size_t place = 0; place < m_all.size();) {
        const bool isHeading = (m_all[place] & kHeading) != 0;
        if (isHeading) {
            m_headings.push_back(count());
        }
        m_shown.push_back(static_cast<std::uint32_t>(place));
        place = isHeading && m_isFolded[m_all[place] & ~kHeading] ? endOfHeading(place) : place + 1;
    }
}

void NetRows::fold(int heading, bool isFolded) {
    m_isFolded[groupAt(heading)] = isFolded;
    show();
}

void NetRows::setFolded(std::vector<bool> isFolded) {
    isFolded.resize(m_isFolded.size());
    m_isFolded = std::move(isFolded);
    show();
}

bool NetRows::reveal(model::NetId net) {
    const auto found = static_cast<std::size_t>(std::ranges::find(m_all, net.value) - m_all.begin());
    if (found == m_all.size()) {
        return false;
    }
    for (std::size_t place = 0; place < found; ++place) {
        if ((m_all[place] & kHeading) != 0 && endOfHeading(place) > found) {
            m_isFolded[m_all[place] & ~kHeading] = false;
        }
    }
    show();
    return true;
}

model::NetId NetRows::netAt(int row) const {
    return isHeading(row) ? model::NetId{} : model::NetId{at(row)};
}

std::vector<model::NetId> NetRows::netsAt(int row) const {
    const std::size_t first = m_shown[static_cast<std::size_t>(row)];
    const std::size_t end = isHeading(row) ? endOfHeading(first) : first + 1;
    std::vector<model::NetId> nets;
    for (std::size_t place = first; place < end; ++place) {
        if ((m_all[place] & kHeading) == 0) {
            nets.emplace_back(m_all[place]);
        }
    }
    return nets;
}

int NetRows::depthOf(int row) const {
    if (isHeading(row)) {
        return static_cast<int>(depthOfHeading(at(row)));
    }
    const std::optional<int> heading = headingOf(row);
    return heading ? depthOf(*heading) + 1 : 0;
}

std::optional<int> NetRows::headingOf(int row) const {
    auto above = std::ranges::lower_bound(m_headings, row);
    while (above != m_headings.begin()) {
        --above;
        if (!isHeading(row) || depthOfHeading(at(*above)) < depthOfHeading(at(row))) {
            return *above;
        }
    }
    return std::nullopt;
}

std::optional<int> NetRows::rowOf(model::NetId net) const {
    const auto found = std::ranges::find(m_shown, net.value, [&](std::uint32_t place) { return m_all[place]; });
    return found == m_shown.end() ? std::nullopt : std::optional(static_cast<int>(found - m_shown.begin()));
}

}  // namespace ui
