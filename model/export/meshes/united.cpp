#include "model/export/meshes/united.h"

#include <algorithm>
#include <span>
#include <utility>

#include "model/base/disjoint_sets.h"
#include "model/geometry/box_index.h"

namespace model {

namespace {

std::vector<Box> boxesOf(const PolygonSet& set) {
    std::vector<Box> boxes(set.polygons.size());
    for (std::size_t i = 0; i < boxes.size(); ++i) {
        for (const Point& corner : set.loop(set.polygons[i].firstLoop)) {
            boxes[i].include(corner);
        }
    }
    return boxes;
}

/// Polygons that hang together by their boxes.
DisjointSets groupsOf(const std::vector<Box>& boxes) {
    DisjointSets groups(boxes.size());
    const BoxIndex index(boxes);
    for (std::uint32_t i = 0; i < boxes.size(); ++i) {
        index.visit(boxes[i], [&](std::uint32_t other) { groups.join(i, other); });
    }
    return groups;
}

void append(const PolygonSet& set, std::size_t row, LoopSet& to) {
    const PolygonSet::Polygon& polygon = set.polygons[row];
    for (std::uint32_t i = 0; i < polygon.loopCount; ++i) {
        const std::span<const Point> loop = set.loop(polygon.firstLoop + i);
        to.points.insert(to.points.end(), loop.begin(), loop.end());
        to.loopStart.push_back(static_cast<std::uint32_t>(to.points.size()));
    }
}

}  // namespace

LoopSet loopsOf(const PolygonSet& set, std::size_t row) {
    LoopSet loops;
    append(set, row, loops);
    return loops;
}

std::vector<LoopSet> uniteNear(const PolygonSet& set, std::size_t atOnce) {
    DisjointSets groups = groupsOf(boxesOf(set));
    std::vector<std::pair<std::uint32_t, std::uint32_t>> members;  // of a root, rising
    for (std::uint32_t i = 0; i < set.polygons.size(); ++i) {
        members.emplace_back(groups.find(i), i);
    }
    std::ranges::sort(members);
    std::vector<LoopSet> united;
    for (std::size_t first = 0; first < members.size();) {
        LoopSet group;
        std::size_t end = first;
        while (end < members.size() && members[end].first == members[first].first &&
               (atOnce == 0 || end - first < atOnce)) {
            append(set, members[end++].second, group);
        }
        united.push_back(end - first > 1 ? unitedLoops(group) : std::move(group));
        first = end;
    }
    return united;
}

}  // namespace model
