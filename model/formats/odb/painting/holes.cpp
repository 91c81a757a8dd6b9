#include "model/formats/odb/painting/holes.h"

#include <algorithm>

#include "model/board/holes.h"

namespace model::odb {

namespace {

enum class Plating { Unknown, Plated, Bare, Mixed };

Plating platingOf(const DrillTool& tool) {
    if (tool.type == "NON_PLATED") {
        return Plating::Bare;
    }
    return tool.type == "PLATED" || tool.type == "VIA" ? Plating::Plated : Plating::Unknown;
}

Plating join(Plating a, Plating b) {
    if (a == Plating::Unknown || a == b) {
        return b;
    }
    return b == Plating::Unknown ? a : Plating::Mixed;
}

bool isClear(Plating plating) {
    return plating == Plating::Plated || plating == Plating::Bare;
}

/// What the copper leaves: kPlating from each side, or half of a hole that is smaller than that.
Nm openSize(Nm size) {
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

Hole HoleRules::hole(const Feature& feature, Nm size, bool hasNet) const {
    Hole hole;
    hole.drilled = hole.open = size;
    if (!isPlated(feature, size, hole)) {
        return hole;
    }
    const bool isPoint = feature.kind == FeatureKind::Pad || feature.kind == FeatureKind::Line;
    const Point centre = feature.kind == FeatureKind::Line ? Point{feature.a.x + (feature.b.x - feature.a.x) / 2,
                                                                   feature.a.y + (feature.b.y - feature.a.y) / 2}
                                                           : feature.a;
    const bool hasPin = isPoint && m_pins.isAnyWithin(centre, size / 4);
    const int purpose = (isVia(feature, size, hasPin, hasNet) ? kVia : 0) | (hasPin ? kPinHole : 0);
    hole.flags = static_cast<std::uint8_t>(kHole | kPlated | purpose);
    setWall(size, hole);
    return hole;
}

bool HoleRules::isPlated(const Feature& feature, Nm size, Hole& hole) const {
    if (m_layer.addType == "BACKDRILL") {
        return false;
    }
    Plating sameSize = Plating::Unknown;
    Plating all = Plating::Unknown;
    for (const DrillTool& tool : m_tools) {
        all = join(all, platingOf(tool));
        sameSize = fits(tool, size) ? join(sameSize, platingOf(tool)) : sameSize;
    }
    if (feature.drill >= 0) {
        const bool isPlated = feature.drill != 1;
        hole.isContradicted = isClear(sameSize) && (sameSize == Plating::Plated) != isPlated;
        return isPlated;
    }
    const Plating found = isClear(sameSize) ? sameSize : all;
    hole.isPlatingAssumed = !isClear(found);
    return isClear(found) ? found == Plating::Plated : m_layer.type == LayerType::Drill;
}

bool HoleRules::isVia(const Feature& feature, Nm size, bool hasPin, bool hasNet) const {
    if (feature.drill >= 0) {
        return feature.drill == 2;
    }
    const auto has = [&](std::string_view type) {
        return std::ranges::any_of(m_tools, [&](const DrillTool& t) { return fits(t, size) && t.type == type; });
    };
    if (has("VIA") != has("PLATED")) {
        return has("VIA");
    }
    return !hasPin && (hasNet || has("VIA"));
}

void HoleRules::setWall(Nm size, Hole& hole) const {
    const DrillTool* tool = findTool(m_tools, size, true);
    if (tool != nullptr && tool->finishedSize > 0 && tool->drillSize > tool->finishedSize) {
        hole.drilled = tool->drillSize;
        hole.open = tool->finishedSize;
        return;
    }
    hole.isWallAssumed = true;
    hole.open = openSize(size);
}

}  // namespace model::odb
