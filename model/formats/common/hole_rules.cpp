#include "model/formats/common/hole_rules.h"

#include <algorithm>

#include "model/board/holes.h"

namespace model::formats {

namespace {

/// What the tools of a layer say together: nothing, the same, or this and that.
struct ToolsPlating {
    bool isPlated = false;
    bool isNonPlated = false;

    void include(const DrillTool& tool) {
        isPlated = isPlated || model::isPlated(tool.plating);
        isNonPlated = isNonPlated || tool.plating == Plating::NonPlated;
    }
    [[nodiscard]] bool isClear() const { return isPlated != isNonPlated; }
};

/// What the copper leaves: kPlating from each side, or half of a hole that is smaller than that.
Nm finishedSize(Nm size) {
    return size > 4 * kPlating ? size - 2 * kPlating : size / 2;
}

}  // namespace

PinLocations::PinLocations(std::vector<Point> pins) : m_pins(std::move(pins)) {
    std::ranges::sort(m_pins, {}, &Point::x);
}

bool PinLocations::isAnyWithin(Point centre, Nm reach) const {
    const auto near = [reach](Nm a, Nm b) { return std::abs(std::int64_t{a} - b) <= reach; };
    const std::int64_t low = std::int64_t{centre.x} - reach;
    auto pin = std::ranges::lower_bound(m_pins, low, {}, [](Point p) { return std::int64_t{p.x}; });
    for (; pin != m_pins.end() && near(pin->x, centre.x); ++pin) {
        if (near(pin->y, centre.y)) {
            return true;
        }
    }
    return false;
}

Hole HoleRules::hole(const DrillHit& hit, Nm size) const {
    Hole hole;
    hole.drilled = hole.finished = size;
    if (!isPlated(hit, size, hole)) {
        return hole;
    }
    const bool hasPin = hit.centre && m_pins.isAnyWithin(*hit.centre, size / 4);
    const int purpose = (isVia(hit, size, hasPin) ? kVia : 0) | (hasPin ? kPinHole : 0);
    hole.flags = static_cast<std::uint8_t>(kHole | kPlated | purpose);
    setBarrel(size, hole);
    return hole;
}

bool HoleRules::isPlated(const DrillHit& hit, Nm size, Hole& hole) const {
    if (m_layer.use == LayerUse::Backdrill) {
        return false;
    }
    ToolsPlating sameSize;
    ToolsPlating all;
    for (const DrillTool& tool : m_tools) {
        all.include(tool);
        if (fits(tool, size)) {
            sameSize.include(tool);
        }
    }
    if (hit.plating != Plating::NotSaid) {
        const bool isPlated = model::isPlated(hit.plating);
        hole.isContradicted = sameSize.isClear() && sameSize.isPlated != isPlated;
        return isPlated;
    }
    const ToolsPlating& found = sameSize.isClear() ? sameSize : all;
    hole.isPlatingAssumed = !found.isClear();
    return found.isClear() ? found.isPlated : m_layer.type == LayerType::Drill;
}

bool HoleRules::isVia(const DrillHit& hit, Nm size, bool hasPin) const {
    if (hit.plating != Plating::NotSaid) {
        return hit.plating == Plating::Via;
    }
    const auto has = [&](Plating plating) {
        return std::ranges::any_of(m_tools, [&](const DrillTool& t) { return fits(t, size) && t.plating == plating; });
    };
    if (has(Plating::Via) != has(Plating::Plated)) {
        return has(Plating::Via);
    }
    return !hasPin && (hit.hasNet || has(Plating::Via));
}

void HoleRules::setBarrel(Nm size, Hole& hole) const {
    const DrillTool* tool = findTool(m_tools, size, true);
    if (tool != nullptr && tool->finishedSize > 0 && tool->drillSize > tool->finishedSize) {
        hole.drilled = tool->drillSize;
        hole.finished = tool->finishedSize;
        return;
    }
    hole.isBarrelAssumed = true;
    hole.finished = finishedSize(size);
}

}  // namespace model::formats
