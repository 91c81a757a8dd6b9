#include "model/solids/shells/merged_shells.h"

#include <algorithm>
#include <iterator>

#include "model/base/disjoint_sets.h"
#include "model/geometry/box_index.h"
#include "model/geometry/loops/edge_union.h"
#include "model/solids/shells/element_shells.h"

namespace model {

namespace {

using Regions = std::vector<EdgeLoops>;

/// The regions whose boxes touch each other, directly or by others. Empties `regions`.
std::vector<Regions> groupsOf(Regions& regions) {
    std::vector<Box> boxes;
    boxes.reserve(regions.size());
    for (const EdgeLoops& region : regions) {
        boxes.push_back(boxOf(region));
    }
    const BoxIndex index(boxes);
    DisjointSets groups(regions.size());
    for (std::uint32_t row = 0; row < regions.size(); ++row) {
        index.visit(boxes[row], [&](std::uint32_t other) { groups.join(row, other); });
    }
    std::vector<std::uint32_t> place(regions.size(), static_cast<std::uint32_t>(regions.size()));
    std::vector<Regions> found;
    for (std::uint32_t row = 0; row < regions.size(); ++row) {
        std::uint32_t& at = place[groups.find(row)];
        if (at == regions.size()) {
            at = static_cast<std::uint32_t>(found.size());
            found.emplace_back();
        }
        found[at].push_back(std::move(regions[row]));
    }
    return found;
}

class Merger {
public:
    explicit Merger(ZRange z) : m_z(z) {}

    /// Halves of what cannot be united are united on their own.
    void merge(Regions group) {
        std::optional<Regions> united = unite(group);
        if (united) {
            return take(std::move(*united));
        }
        if (group.size() < 2) {
            return take(std::move(group));
        }
        const std::size_t before = m_result.shells.size();
        const std::size_t apartBefore = m_result.apart;
        const auto middle = group.begin() + static_cast<std::ptrdiff_t>(group.size() / 2);
        std::ranges::nth_element(group, middle, {}, [](const EdgeLoops& region) {
            return std::pair(region.edges.front().a.x, region.edges.front().a.y);
        });
        merge(Regions(std::move_iterator(group.begin()), std::move_iterator(middle)));
        merge(Regions(std::move_iterator(middle), std::move_iterator(group.end())));
        m_result.apart = apartBefore + m_result.shells.size() - before;
    }
    void countProblem() { ++m_result.problems; }
    [[nodiscard]] MergedShells result() && { return std::move(m_result); }

private:
    void take(Regions regions) {
        for (EdgeLoops& region : regions) {
            m_result.shells.push_back({std::move(region), m_z});
        }
    }

    ZRange m_z;
    MergedShells m_result;
};

}  // namespace

MergedShells mergedShells(const Document& document, std::span<const ElementId> elements) {
    if (elements.empty()) {
        return {};
    }
    Merger merger(solidHeightsOf(document, elements.front()));
    Regions regions;
    for (const ElementId element : elements) {
        ElementOutlines outlines = outlinesOf(document, element);
        if (!outlines.problem.empty()) {
            merger.countProblem();
        }
        std::ranges::move(outlines.regions, std::back_inserter(regions));
    }
    for (Regions& group : groupsOf(regions)) {
        merger.merge(std::move(group));
    }
    return std::move(merger).result();
}

}  // namespace model
