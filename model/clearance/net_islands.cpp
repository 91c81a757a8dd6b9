#include "model/clearance/net_islands.h"

#include <algorithm>

#include "model/base/parallel.h"
#include "model/figures/distance.h"
#include "model/nets/disjoint_sets.h"

namespace model {

namespace {

constexpr std::size_t kFiguresPerTask = 64;

/// A figure without a net and what it touches.
struct Touch {
    std::uint32_t unassigned = 0;
    std::uint32_t other = 0;
};

std::vector<Touch> touchesOf(const LayerGeometry& plane, std::span<const std::uint32_t> unassigned) {
    std::vector<Touch> touches;
    for (const std::uint32_t row : unassigned) {
        plane.visitNear(plane.figures().box(row), kTouchNm, [&](std::uint32_t other) {
            if (other != row && spacingBetween(plane.figures(), row, plane.figures(), other, kTouchNm)) {
                touches.push_back({row, other});
            }
        });
    }
    return touches;
}

std::vector<Touch> allTouches(const LayerGeometry& plane, std::span<const std::uint32_t> unassigned,
                              base::Progress& progress) {
    std::vector<std::vector<Touch>> parts((unassigned.size() + kFiguresPerTask - 1) / kFiguresPerTask);
    base::parallelFor(parts.size(), [&](std::size_t task) {
        if (!progress.isCancelled()) {
            const std::size_t first = task * kFiguresPerTask;
            parts[task] =
                touchesOf(plane, unassigned.subspan(first, std::min(kFiguresPerTask, unassigned.size() - first)));
        }
    });
    std::vector<Touch> touches;
    for (const std::vector<Touch>& part : parts) {
        touches.insert(touches.end(), part.begin(), part.end());
    }
    return touches;
}

}  // namespace

std::vector<std::uint32_t> netsByTouch(const Document& document, const LayerGeometry& plane, base::Progress& progress) {
    const auto none = static_cast<std::uint32_t>(document.nets.size());
    std::vector<std::uint32_t> nets(plane.size());
    std::vector<std::uint32_t> unassigned;
    for (std::size_t row = 0; row < plane.size(); ++row) {
        const NetId net = document.elements.net[plane.elementOf(row).row()];
        nets[row] = net.isValid() ? static_cast<std::uint32_t>(net.row()) : none;
        if (!net.isValid()) {
            unassigned.push_back(static_cast<std::uint32_t>(row));
        }
    }
    const std::vector<Touch> touches = allTouches(plane, unassigned, progress);
    DisjointSets islands(plane.size());  // of loose figures; the others stay alone
    for (const Touch& touch : touches) {
        if (nets[touch.other] == none) {
            islands.join(touch.unassigned, touch.other);
        }
    }
    std::vector<std::uint32_t> ofIsland(plane.size(), none);
    for (const Touch& touch : touches) {
        std::uint32_t& net = ofIsland[islands.find(touch.unassigned)];
        net = std::min(net, nets[touch.other]);
    }
    for (const std::uint32_t row : unassigned) {
        nets[row] = ofIsland[islands.find(row)];
    }
    return nets;
}

}  // namespace model
