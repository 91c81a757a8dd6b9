#include "model/packages/body_parts.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <optional>

namespace model {

namespace {

/// How far a part that wraps around another one stands out, so that it hides it.
constexpr Nm kWrap = 15'000;
/// Pins end this far behind the board.
constexpr Nm kBehindBoard = 1'000'000;

enum class Side { Left, Right, Lower, Upper };

/// How far the middle of a pin lies outside of a side.
Nm distanceTo(Side side, const Box& body, Point p) {
    switch (side) {
        case Side::Left: return body.min.x - p.x;
        case Side::Right: return p.x - body.max.x;
        case Side::Lower: return body.min.y - p.y;
        default: return p.y - body.max.y;
    }
}

/// The side a pin is next to, wherever it lies.
Side nearestSide(Point pin, const Box& body) {
    constexpr std::array kSides = {Side::Left, Side::Right, Side::Lower, Side::Upper};
    return *std::ranges::max_element(kSides, {}, [&](Side side) { return distanceTo(side, body, pin); });
}

/// The side of the body a pin lies on; none below it.
std::optional<Side> sideOf(Point pin, const Box& body) {
    const Side nearest = nearestSide(pin, body);
    return distanceTo(nearest, body, pin) <= 0 ? std::nullopt : std::optional(nearest);
}

bool isOnX(Side side) {
    return side == Side::Left || side == Side::Right;
}

/// From one distance outside of a side of the body to another one, around the middle of a pin.
Box outwards(Side side, const Box& body, const PinFacts& pin, Nm from, Nm to, Nm half) {
    const Point p = pin.position;
    switch (side) {
        case Side::Left: return {{body.min.x - to, p.y - half}, {body.min.x - from, p.y + half}};
        case Side::Right: return {{body.max.x + from, p.y - half}, {body.max.x + to, p.y + half}};
        case Side::Lower: return {{p.x - half, body.min.y - to}, {p.x + half, body.min.y - from}};
        default: return {{p.x - half, body.max.y + from}, {p.x + half, body.max.y + to}};
    }
}

void add(PolygonSet polygons, Nm bottom, Nm top, BodyMaterial material, BodyPlan& plan) {
    if (!polygons.polygons.empty() && bottom < top) {
        plan.parts.push_back({std::move(polygons), bottom, top, material});
    }
}

/// Leads that leave the body at half its height, go down and end flat on their pads.
void addGullWings(const PackageFacts& facts, BodyPlan& plan) {
    const Nm metal = std::clamp(plan.height / 10, 60'000, 200'000);
    const Nm shoulder = plan.height / 2;
    PolygonSet shoulders;
    PolygonSet risers;
    PolygonSet feet;
    for (const PinFacts& pin : facts.pins) {
        const std::optional<Side> side = sideOf(pin.position, plan.box);
        if (!side || pin.isThrough) {
            continue;
        }
        const auto padLength = isOnX(*side) ? pin.pad.width() : pin.pad.height();
        const auto padWidth = isOnX(*side) ? pin.pad.height() : pin.pad.width();
        const Nm half = scaled(padWidth, 0.36);
        const Nm toe = distanceTo(*side, plan.box, pin.position) + scaled(padLength, 0.3);
        const Nm knee = std::max(scaled(toe, 0.4), metal);
        addBox(outwards(*side, plan.box, pin, -kWrap, knee, half), shoulders);
        addBox(outwards(*side, plan.box, pin, knee - metal, knee, half), risers);
        addBox(outwards(*side, plan.box, pin, knee, std::max(toe, knee + metal), half), feet);
    }
    add(std::move(shoulders), shoulder - metal, shoulder, BodyMaterial::Metal, plan);
    add(std::move(risers), 0, shoulder - metal, BodyMaterial::Metal, plan);
    add(std::move(feet), 0, metal, BodyMaterial::Metal, plan);
}

/// Flat terminals that end with the side of the body.
void addTerminals(const PackageFacts& facts, BodyPlan& plan) {
    constexpr Nm kInwards = 250'000;
    const Nm top = std::min(plan.height / 3, 200'000);
    PolygonSet terminals;
    for (const PinFacts& pin : facts.pins) {
        const Side side = nearestSide(pin.position, plan.box);
        const auto padWidth = isOnX(side) ? pin.pad.height() : pin.pad.width();
        const auto padLength = isOnX(side) ? pin.pad.width() : pin.pad.height();
        const bool isAtSide = 2 * std::int64_t{std::abs(distanceTo(side, plan.box, pin.position))} <= padLength;
        if (isAtSide && !pin.isThrough) {
            addBox(outwards(side, plan.box, pin, -kInwards, kWrap, scaled(padWidth, 0.4)), terminals);
        }
    }
    add(std::move(terminals), 0, top, BodyMaterial::Metal, plan);
}

/// Metal around both ends.
void addCaps(double partOfLength, BodyPlan& plan) {
    const Box outer = plan.box.grownBy(kWrap);
    const Nm length = scaled(plan.box.width(), partOfLength);
    PolygonSet caps;
    addBox({outer.min, {plan.box.min.x + length, outer.max.y}}, caps);
    addBox({{plan.box.max.x - length, outer.min.y}, outer.max}, caps);
    add(std::move(caps), 0, plan.height + kWrap, BodyMaterial::Metal, plan);
}

/// Bent around the ends of a moulded body, half its height up.
void addClips(const PackageFacts& facts, BodyPlan& plan) {
    constexpr Nm kMetal = 120'000;
    const Nm half = std::min(scaled(facts.boxOfPads().height(), 0.4), scaled(plan.box.height(), 0.5));
    const Point middle = plan.box.middle();
    const Nm inwards = scaled(plan.box.width(), 0.15);
    PolygonSet clips;
    addBox({{plan.box.min.x - kMetal, middle.y - half}, {plan.box.min.x + inwards, middle.y + half}}, clips);
    addBox({{plan.box.max.x - inwards, middle.y - half}, {plan.box.max.x + kMetal, middle.y + half}}, clips);
    add(std::move(clips), 0, plan.height / 2, BodyMaterial::Metal, plan);
}

/// Pins from `top` through the board and out of its other side.
void addPins(const PackageFacts& facts, Nm top, BodyMaterial material, BodyPlan& plan) {
    PolygonSet pins;
    for (const PinFacts& pin : facts.pins) {
        if (pin.isThrough) {
            const Nm half = std::clamp(scaled(std::min(pin.pad.width(), pin.pad.height()), 0.2), 100'000, 400'000);
            Box box;
            box.include(pin.position);
            addBox(box.grownBy(half), pins);
        }
    }
    add(std::move(pins), -facts.boardDepth - kBehindBoard, top, material, plan);
}

/// From the ends of a body that lies along the board to the pins.
void addBentLeads(const PackageFacts& facts, BodyPlan& plan) {
    constexpr Nm kHalf = 250'000;
    const Nm middle = plan.height / 2;
    PolygonSet leads;
    for (const PinFacts& pin : facts.pins) {
        if (const std::optional<Side> side = sideOf(pin.position, plan.box)) {
            addBox(outwards(*side, plan.box, pin, -kWrap, distanceTo(*side, plan.box, pin.position) + kHalf, kHalf),
                   leads);
        }
    }
    add(std::move(leads), middle - kHalf, middle + kHalf, BodyMaterial::Metal, plan);
    addPins(facts, middle, BodyMaterial::Metal, plan);
}

/// The lower end of an electrolytic capacitor stands on a plate.
void addPlate(const PackageFacts& facts, BodyPlan& plan) {
    PolygonSet plate;
    addBox(plan.box.grownBy(kWrap), plate);
    add(std::move(plate), 0, plan.height / 8, BodyMaterial::Moulding, plan);
    PolygonSet feet;
    for (const PinFacts& pin : facts.pins) {
        const Side side = nearestSide(pin.position, plan.box);
        addBox(outwards(side, plan.box, pin, -kMm / 2, kMm / 2, 350'000), feet);
    }
    add(std::move(feet), 0, 150'000, BodyMaterial::Metal, plan);
}

void addLeads(const PackageFacts& facts, PartKind kind, BodyPlan& plan) {
    switch (plan.family) {
        case PackageFamily::Chip: addCaps(kind == PartKind::Led ? 0.15 : 0.22, plan); break;
        case PackageFamily::TwoLeads: addClips(facts, plan); break;
        case PackageFamily::CanCapacitor: addPlate(facts, plan); break;
        case PackageFamily::DualFlat:
        case PackageFamily::QuadFlatNoLead: addTerminals(facts, plan); break;
        case PackageFamily::Axial:
        case PackageFamily::ThroughDual: addBentLeads(facts, plan); break;
        case PackageFamily::Header: addPins(facts, plan.height, BodyMaterial::Gold, plan); break;
        case PackageFamily::Post: addPins(facts, kPrint, BodyMaterial::Metal, plan); break;
        case PackageFamily::Crystal:
        case PackageFamily::Grid: break;
        default: addGullWings(facts, plan); addPins(facts, std::min(plan.height, kMm), BodyMaterial::Metal, plan);
    }
}

/// A band over the end where pin 1 is.
void addBand(const PackageFacts& facts, BodyPlan& plan) {
    const bool isLeft = facts.pins[facts.firstPin].position.x < plan.box.middle().x;
    const Nm from =
        isLeft ? plan.box.min.x + scaled(plan.box.width(), 0.12) : plan.box.max.x - scaled(plan.box.width(), 0.28);
    PolygonSet band;
    addBox({{from, plan.box.min.y + kWrap}, {from + scaled(plan.box.width(), 0.16), plan.box.max.y - kWrap}}, band);
    add(std::move(band), plan.bodyTop, plan.bodyTop + kPrint, printOn(plan.material), plan);
}

/// A dot in the corner next to pin 1, or next to where it is along the side.
void addDot(const PackageFacts& facts, BodyPlan& plan) {
    const auto narrow = std::min(plan.box.width(), plan.box.height());
    const Nm radius = std::min(scaled(narrow, 0.09), 400'000);
    const Box inner = plan.box.grownBy(-2 * radius);
    const Point pin = facts.pins[facts.firstPin].position;
    PolygonSet dot;
    addDisc({std::clamp(pin.x, inner.min.x, inner.max.x), std::clamp(pin.y, inner.min.y, inner.max.y)}, radius, dot);
    add(std::move(dot), plan.bodyTop, plan.bodyTop + kPrint, printOn(plan.material), plan);
}

void addMark(const PackageFacts& facts, PartKind kind, BodyPlan& plan) {
    switch (plan.family) {
        case PackageFamily::Chip:
        case PackageFamily::TwoLeads:
            if (kind == PartKind::Diode || (kind == PartKind::Capacitor && plan.family == PackageFamily::TwoLeads)) {
                addBand(facts, plan);
            }
            break;
        case PackageFamily::CanCapacitor:
        case PackageFamily::Radial:
        case PackageFamily::Axial:
        case PackageFamily::Post: break;
        default:
            if (facts.pins.size() > 2) {
                addDot(facts, plan);
            }
    }
}

/// What is left of the top for the designator.
Box labelOf(const BodyPlan& plan) {
    constexpr Nm kEdge = 60'000;
    if (plan.family == PackageFamily::Post || plan.family == PackageFamily::Header) {
        return {};
    }
    const Nm margin =
        plan.family == PackageFamily::Chip ? scaled(plan.box.width(), 0.22) : scaled(plan.box.width(), 0.1);
    const bool isRound = plan.family == PackageFamily::Radial || plan.family == PackageFamily::CanCapacitor;
    const Nm across = isRound ? scaled(plan.box.height(), 0.15) : scaled(plan.box.height(), 0.05);
    return {{plan.box.min.x + margin + kEdge, plan.box.min.y + across},
            {plan.box.max.x - margin - kEdge, plan.box.max.y - across}};
}

}  // namespace

void addBox(const Box& box, PolygonSet& polygons) {
    const std::array<Point, 4> corners{{box.min, {box.max.x, box.min.y}, box.max, {box.min.x, box.max.y}}};
    if (box.width() > 0 && box.height() > 0) {
        polygons.beginPolygon();
        polygons.addLoop(corners);
    }
}

void addDisc(Point centre, Nm radius, PolygonSet& polygons) {
    constexpr int kChords = 32;
    std::array<Point, kChords> points{};
    for (int i = 0; i < kChords; ++i) {
        const double angle = 2.0 * std::numbers::pi * i / kChords;
        points[static_cast<std::size_t>(i)] = {centre.x + scaled(radius, std::cos(angle)),
                                               centre.y + scaled(radius, std::sin(angle))};
    }
    polygons.beginPolygon();
    polygons.addLoop(points);
}

void addBodyParts(const PackageFacts& facts, PartKind kind, BodyPlan& plan) {
    addLeads(facts, kind, plan);
    addMark(facts, kind, plan);
    plan.label = labelOf(plan);
}

}  // namespace model
