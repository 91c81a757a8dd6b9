#include "model/formats/common/hole_rules.h"

#include <algorithm>

#include "model/board/holes.h"

namespace model::formats {

namespace {

/// What the copper leaves: kPlating from each side, or half of a hole that is smaller than that.
Nm finishedSize(Nm size) {
    return size > 4 * kPlating ? size - 2 * kPlating : size / 2;
}

void setBarrel(const DrillTool* tool, Nm size, Hole& hole) {
    if (tool != nullptr && tool->finishedSize > 0 && tool->drillSize > tool->finishedSize) {
        hole.drilled = tool->drillSize;
        hole.finished = tool->finishedSize;
        return;
    }
    hole.isBarrelAssumed = true;
    hole.finished = finishedSize(size);
}

/// Boards of one copper layer have nothing that plating would join, and are made without.
bool passesOneLayer(const Layer& layer) {
    return layer.spanTop.isValid() && layer.spanTop == layer.spanBottom;
}

}  // namespace

void ToolsPlating::include(const DrillTool& tool) {
    isPlated = isPlated || model::isPlated(tool.plating);
    isNonPlated = isNonPlated || tool.plating == Plating::NonPlated;
}

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

HoleRules::HoleRules(const Layer& layer, const std::vector<DrillTool>& tools, const PinLocations& pins)
    : m_layer(layer), m_tools(tools), m_pins(pins) {
    for (const DrillTool& tool : m_tools) {
        m_all.include(tool);
    }
}

const HoleRules::ToolsOfSize& HoleRules::toolsOf(Nm size) const {
    const auto [at, isNew] = m_ofSize.try_emplace(size);
    ToolsOfSize& found = at->second;
    if (isNew) {
        found.plated = findTool(m_tools, size, true);
        for (const DrillTool& tool : m_tools) {
            if (fits(tool, size)) {
                found.plating.include(tool);
                found.hasVia = found.hasVia || tool.plating == Plating::Via;
                found.hasPlated = found.hasPlated || tool.plating == Plating::Plated;
            }
        }
    }
    return found;
}

Hole HoleRules::hole(const DrillHit& hit, Nm size) const {
    Hole hole;
    hole.drilled = hole.finished = size;
    const ToolsOfSize& tools = toolsOf(size);
    if (!isPlated(hit, tools, hole)) {
        return hole;
    }
    const bool hasPin = hit.centre && m_pins.isAnyWithin(*hit.centre, size / 4);
    const int purpose = (isVia(hit, tools, hasPin) ? kVia : 0) | (hasPin ? kPinHole : 0);
    hole.flags = static_cast<std::uint8_t>(kHole | kPlated | purpose);
    setBarrel(tools.plated, size, hole);
    return hole;
}

bool HoleRules::isPlated(const DrillHit& hit, const ToolsOfSize& tools, Hole& hole) const {
    if (m_layer.use == LayerUse::Backdrill) {
        return false;
    }
    if (hit.plating != Plating::NotSaid) {
        const bool isPlated = model::isPlated(hit.plating);
        hole.isContradicted = tools.plating.isClear() && tools.plating.isPlated != isPlated;
        return isPlated;
    }
    const ToolsPlating& found = tools.plating.isClear() ? tools.plating : m_all;
    hole.isPlatingAssumed = !found.isClear();
    return found.isClear() ? found.isPlated : m_layer.type == LayerType::Drill && !passesOneLayer(m_layer);
}

bool HoleRules::isVia(const DrillHit& hit, const ToolsOfSize& tools, bool hasPin) {
    if (hit.isVia || hit.plating != Plating::NotSaid) {
        return hit.isVia || hit.plating == Plating::Via;
    }
    if (tools.hasVia != tools.hasPlated) {
        return tools.hasVia;
    }
    return !hasPin && (hit.hasNet || tools.hasVia);
}

}  // namespace model::formats
