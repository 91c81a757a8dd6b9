#include "model/formats/steps/cleared_neighbours.h"

#include <algorithm>
#include <set>
#include <span>
#include <tuple>
#include <vector>

#include "model/board/copies.h"
#include "model/formats/common/element_regions.h"
#include "model/geometry/box_index.h"
#include "model/solids/shells/area_shell.h"

namespace model::formats {

namespace {

/// A region that a copy clears outside of its outline.
struct Cleared {
    EdgeLoops region;
    Box box;
};

std::vector<Cleared> clearedAround(const Document& board, const StepInstance& copy, LayerId layer) {
    const Document& step = *board.steps[copy.step];
    const ShapeId shape = step.layer(board.layerOfCopy(layer, copy.isFlipped)).clearedAround;
    std::vector<Cleared> cleared;
    for (const EdgeLoops& own : shape.isValid() ? areaOutlines(step.shapes, shape) : std::vector<EdgeLoops>()) {
        EdgeLoops region = placed(own, copy.placement);
        const Box box = boxOf(region);
        cleared.push_back({std::move(region), box});
    }
    return cleared;
}

/// Copper that copies share along their edges is no more than what booleans round: 1 nm wide, and half a metre long.
constexpr double kLeastOverlap = 1e9;  // nm²

double areaOf(std::span<const EdgeLoops> regions) {
    double area = 0.0;
    for (const EdgeLoops& region : regions) {
        area += model::areaOf(region);
    }
    return area;
}

/// Of one element, laid elsewhere.
bool liesOver(const Cleared& cleared, const Document& step, ElementId element, const Placement& placement) {
    std::vector<EdgeLoops> copper;
    for (const EdgeLoops& region : regionsOf(step, element).regions) {
        copper.push_back(placed(region, placement));
    }
    const RegionBoolean left = differenceOf(std::span(&cleared.region, 1), copper);
    return model::areaOf(cleared.region) - areaOf(left.regions) > kLeastOverlap;
}

/// Does any of it lie over what a copy, or a copy on that, has on the layer?
bool liesOverCopper(std::span<const Cleared> cleared, const Document& board, const StepInstance& copy, LayerId layer) {
    const StepTree tree = unfoldCopies(*board.steps[copy.step]);
    for (const StepCopy& inner : tree.copies) {
        const Document& document = *tree.steps[inner.step];
        const Placement placement = copy.placement.after(inner.placement);
        const Range range = document.layer(board.layerOfCopy(layer, copy.isFlipped != inner.isFlipped)).elements;
        for (std::uint32_t i = range.first; i < range.first + range.count; ++i) {
            const Box box = placement.boxOf(document.boxOf(ElementId{i}));
            const auto isOver = [&](const Cleared& part) {
                return part.box.meets(box) && liesOver(part, document, ElementId{i}, placement);
            };
            if (std::ranges::any_of(cleared, isOver)) {
                return true;
            }
        }
    }
    return false;
}

/// How a copy lies beside another one. Panels repeat this, and steps so placed have the same result.
using Pair =
    std::tuple<std::uint32_t, bool, double, bool, std::uint32_t, bool, double, bool, std::int64_t, std::int64_t>;

Pair pairOf(const StepInstance& a, const StepInstance& b) {
    const Placement& from = a.placement;
    const Placement& to = b.placement;
    return {a.step,
            a.isFlipped,
            from.clockwiseDeg,
            from.isMirrored,
            b.step,
            b.isFlipped,
            to.clockwiseDeg,
            to.isMirrored,
            std::int64_t{to.origin.x} - from.origin.x,
            std::int64_t{to.origin.y} - from.origin.y};
}

std::vector<Box> boxesOfCopies(const Document& board) {
    std::vector<Box> boxes;
    for (const StepInstance& copy : board.instances) {
        boxes.push_back(copy.placement.boxOf(board.steps[copy.step]->extent));
    }
    return boxes;
}

/// Rows of the copies whose boxes any of it meets, rising.
std::set<std::uint32_t> near(const BoxIndex& copies, std::span<const Cleared> cleared) {
    std::set<std::uint32_t> rows;
    for (const Cleared& part : cleared) {
        copies.visit(part.box, [&](std::uint32_t row) { rows.insert(row); });
    }
    return rows;
}

}  // namespace

std::optional<std::size_t> firstClearingNeighbours(const Document& board, LayerId layer) {
    const std::vector<Box> boxes = boxesOfCopies(board);
    const BoxIndex copies(boxes);
    std::set<Pair> tested;
    for (std::size_t i = 0; i < board.instances.size(); ++i) {
        const std::vector<Cleared> cleared = clearedAround(board, board.instances[i], layer);
        for (const std::uint32_t other : near(copies, cleared)) {
            const StepInstance& beside = board.instances[other];
            if (other != i && tested.insert(pairOf(board.instances[i], beside)).second &&
                liesOverCopper(cleared, board, beside, layer)) {
                return i;
            }
        }
    }
    return std::nullopt;
}

}  // namespace model::formats
