#include "model/packages/body_size.h"

namespace model {

namespace {

/// How far courtyards usually reach beyond what they are around (IPC-7351, nominal density).
constexpr Nm kCourtyard = 250'000;
/// An outline that reaches this far beyond all pads is a courtyard.
constexpr Nm kBeyondPads = 90'000;
/// Courtyards of ball grids are wider, for the tools of rework.
constexpr Nm kGridCourtyard = 1'000'000;
/// Terminals of chips, over the length between the middles of their pads.
constexpr double kChipLength = 1.05;
/// Chips are narrower than their pads.
constexpr double kChipWidth = 0.86;
/// Where the body of a package with leads ends: between the inner ends (0) and the middles (1) of its pads.
constexpr double kLeadStart = 0.3;

Box boxAround(Point middle, Nm width, Nm height) {
    return {{middle.x - width / 2, middle.y - height / 2}, {middle.x + width / 2, middle.y + height / 2}};
}

Box shrunk(const Box& box, Nm margin) {
    const auto limit = [&](std::int64_t side) { return std::min(margin, static_cast<Nm>(side / 4)); };
    return {{box.min.x + limit(box.width()), box.min.y + limit(box.height())},
            {box.max.x - limit(box.width()), box.max.y - limit(box.height())}};
}

bool isCourtyard(const Box& outline, const Box& pads) {
    const Box inner = outline.isEmpty() ? outline : shrunk(outline, kBeyondPads);
    return !outline.isEmpty() && inner.holds(pads.min) && inner.holds(pads.max);
}

/// Is the outline only the box around the pads, which says nothing?
bool isBoxOfPads(const Box& outline, const Box& pads) {
    return std::abs(outline.width() - pads.width()) < kBeyondPads &&
           std::abs(outline.height() - pads.height()) < kBeyondPads;
}

/// What a job draws around a part whose shape the pins do not tell.
Box drawnBox(const PackageFacts& facts) {
    const Box pads = facts.boxOfPads();
    return facts.box.isEmpty() ? pads : isCourtyard(facts.box, pads) ? shrunk(facts.box, kCourtyard) : facts.box;
}

/// The ends of a body along the direction of its leads.
struct Ends {
    Nm low = 0;
    Nm high = 0;
};

/// How far a pad reaches from the middle of its pin towards the body. The body lies over the tab of a power package.
Nm reachOf(Nm reach) {
    constexpr Nm kTab = 2 * kMm;
    return reach > kTab ? 0 : reach;
}

/// Between the pads on the left and those on the right; of a package with leads on all sides those above and below do
/// not count.
Ends betweenPads(const PackageFacts& facts) {
    const Box pins = facts.boxOfPins();
    const Nm near = static_cast<Nm>(pins.width() / 8);
    Nm left = pins.min.x;
    Nm right = pins.max.x;
    for (const PinFacts& pin : facts.pins) {
        if (pin.position.x - pins.min.x <= near) {
            left = std::max(left, pin.position.x + reachOf(pin.pad.max.x - pin.position.x));
        } else if (pins.max.x - pin.position.x <= near) {
            right = std::min(right, pin.position.x - reachOf(pin.position.x - pin.pad.min.x));
        }
    }
    return {left + scaled(pins.min.x - left, kLeadStart), right + scaled(pins.max.x - right, kLeadStart)};
}

/// Along a row of pins: what is drawn, or one pitch longer than the row.
Ends alongRow(const PackageFacts& facts) {
    const Box pads = facts.boxOfPads();
    const Box pins = facts.boxOfPins();
    const bool isDrawn = !facts.box.isEmpty() && !isBoxOfPads(facts.box, pads);
    if (isDrawn && facts.box.height() > pins.height()) {
        const Box drawn = drawnBox(facts);
        return {drawn.min.y, drawn.max.y};
    }
    const auto rows = std::max<std::size_t>(facts.pins.size() / 2, 2);
    const Nm half = static_cast<Nm>(pins.height() / static_cast<std::int64_t>(2 * (rows - 1)));
    return {pins.min.y - half, pins.max.y + half};
}

Box withLeads(const PackageFacts& facts, bool isOnFourSides) {
    const Box pins = facts.boxOfPins();
    // What ends before the middles of the pads is the body itself.
    const bool isBody = !facts.box.isEmpty() && facts.box.width() < pins.width() &&
                        (!isOnFourSides || facts.box.height() < pins.height());
    if (isBody) {
        return facts.box;
    }
    const Ends x = betweenPads(facts);
    const Ends y = isOnFourSides ? betweenPads(transposed(facts)) : alongRow(facts);
    return {{x.low, y.low}, {x.high, y.high}};
}

/// Terminals end with the body: it is about as wide as the middles of its pads are apart.
Box leadless(const PackageFacts& facts, bool isOnFourSides) {
    constexpr Nm kBeyondMiddles = 50'000;
    const Box pads = facts.boxOfPads();
    const Box pins = facts.boxOfPins();
    const bool isBody = !facts.box.isEmpty() && !isCourtyard(facts.box, pads) && !isBoxOfPads(facts.box, pads);
    if (isBody) {
        return facts.box;
    }
    const Box grown = pins.grownBy(kBeyondMiddles);
    const Ends y = isOnFourSides ? Ends{grown.min.y, grown.max.y} : alongRow(facts);
    return {{grown.min.x, y.low}, {grown.max.x, y.high}};
}

Box pairBox(const PackageFacts& facts) {
    const Box pads = facts.boxOfPads();
    const bool isBody = !facts.box.isEmpty() && facts.box.width() < pads.width() - kBeyondPads;
    if (isBody) {
        return facts.box;
    }
    constexpr Nm kClearlyWider = 150'000;
    const Nm asPads = scaled(pads.height(), kChipWidth);
    const Nm drawn = facts.box.isEmpty() ? 0 : static_cast<Nm>(drawnBox(facts).height());
    return boxAround(pads.middle(), scaled(facts.boxOfPins().width(), kChipLength),
                     drawn > asPads + kClearlyWider ? drawn : asPads);
}

Box squareInside(const Box& box) {
    const Nm side = static_cast<Nm>(std::min(box.width(), box.height()));
    return boxAround(box.middle(), side, side);
}

Box gridBox(const PackageFacts& facts) {
    const Box pads = facts.boxOfPads();
    if (facts.box.isEmpty()) {
        return pads.grownBy(kCourtyard);
    }
    const bool isWide = facts.box.width() - pads.width() > 5 * kMm / 2;
    return isWide ? shrunk(facts.box, kGridCourtyard) : facts.box;
}

/// Courtyards of connectors are wider than others, and hold the pads beside the housing: it ends over the middles of
/// those.
Box connectorBox(const PackageFacts& facts, const PinPattern& pattern) {
    constexpr Nm kWideCourtyard = 500'000;
    const Box pads = facts.boxOfPads();
    const Box pins = facts.boxOfPins();
    const bool isBeside = pattern.layout == PinLayout::TwoRows && !pattern.isThrough && pins.width() > kMm;
    if (!isBeside || !isCourtyard(facts.box, pads)) {
        return drawnBox(facts);
    }
    const Box drawn = shrunk(facts.box, kWideCourtyard);
    return {{pins.min.x, std::max(drawn.min.y, pads.min.y)}, {pins.max.x, std::min(drawn.max.y, pads.max.y)}};
}

Box axialBox(const PackageFacts& facts) {
    constexpr double kPartOfSpan = 0.6;
    const Box pins = facts.boxOfPins();
    return boxAround(pins.middle(), scaled(pins.width(), kPartOfSpan), static_cast<Nm>(drawnBox(facts).height()));
}

Box dualBox(const PackageFacts& facts) {
    constexpr Nm kShoulders = 600'000;
    const Box pins = facts.boxOfPins();
    const Ends y = alongRow(facts);
    return {{pins.min.x + kShoulders, y.low}, {pins.max.x - kShoulders, y.high}};
}

Nm partOf(std::int64_t length, double factor, Nm least, Nm most) {
    return std::clamp(scaled(length, factor), least, most);
}

Nm chipHeight(Nm width, PartKind kind) {
    const bool isFlat = kind == PartKind::Resistor || kind == PartKind::Led;
    return isFlat ? partOf(width, 0.5, 100'000, 600'000) : partOf(width, 0.9, 150'000, 3 * kMm);
}

/// In package coordinates, for facts whose leads point along x. Empty without pins.
Box bodyBox(const PackageFacts& facts, const PinPattern& pattern, PackageFamily family, PartKind kind) {
    switch (family) {
        case PackageFamily::None: return {};
        case PackageFamily::Chip: return pairBox(facts);
        case PackageFamily::TwoLeads: return kind == PartKind::Inductor ? drawnBox(facts) : pairBox(facts);
        case PackageFamily::SmallOutline:
        case PackageFamily::DualInLine: return withLeads(facts, false);
        case PackageFamily::QuadFlat: return withLeads(facts, true);
        case PackageFamily::DualFlat: return leadless(facts, false);
        case PackageFamily::QuadFlatNoLead: return leadless(facts, true);
        case PackageFamily::Grid: return gridBox(facts);
        case PackageFamily::Connector: return connectorBox(facts, pattern);
        case PackageFamily::CanCapacitor:
        case PackageFamily::Radial: return squareInside(drawnBox(facts));
        case PackageFamily::Axial: return axialBox(facts);
        case PackageFamily::ThroughDual: return dualBox(facts);
        case PackageFamily::Post:
            return squareInside(pattern.isThrough ? shrunk(facts.boxOfPads(), kMm) : drawnBox(facts));
        default: return drawnBox(facts);
    }
}

/// A height that is usual for such a body.
Nm usualHeight(const Box& body, const PackageFacts& facts, PackageFamily family, PartKind kind) {
    const std::int64_t narrow = std::min(body.width(), body.height());
    const std::int64_t wide = std::max(body.width(), body.height());
    switch (family) {
        case PackageFamily::Chip: return chipHeight(static_cast<Nm>(narrow), kind);
        case PackageFamily::TwoLeads: return partOf(narrow, 0.6, 600'000, 5 * kMm);
        case PackageFamily::CanCapacitor: return partOf(narrow, 1.0, 3 * kMm, 12 * kMm);
        case PackageFamily::SmallOutline: return partOf(narrow, 0.7, 500'000, 1'700'000);
        case PackageFamily::DualInLine:
            return facts.boxOfPins().height() / static_cast<std::int64_t>(facts.pins.size()) > 400'000 ? 1'750'000
                                                                                                       : 1'100'000;
        case PackageFamily::DualFlat: return partOf(narrow, 0.4, 350'000, 850'000);
        case PackageFamily::QuadFlat: return 1'400'000;
        case PackageFamily::QuadFlatNoLead: return 850'000;
        case PackageFamily::Grid: return 1'200'000;
        case PackageFamily::Crystal: return partOf(narrow, 0.3, 400'000, 1'300'000);
        case PackageFamily::Header: return 8'500'000;
        case PackageFamily::Connector:
            return patternOf(facts).isThrough ? partOf(narrow, 0.6, kMm, 11 * kMm) : partOf(narrow, 0.4, kMm, 6 * kMm);
        case PackageFamily::Radial: return partOf(narrow, 1.3, 3 * kMm, 30 * kMm);
        case PackageFamily::Axial: return static_cast<Nm>(std::max<std::int64_t>(narrow, kLeastBody));
        case PackageFamily::ThroughDual: return 3'800'000;
        case PackageFamily::ThroughHole:
            return kind == PartKind::Transistor ? partOf(wide, 1.4, 4 * kMm, 16 * kMm)
                                                : partOf(wide, 0.7, 2 * kMm, 12 * kMm);
        default:
            return kind == PartKind::Capacitor ? partOf(narrow, 0.9, 700'000, 12 * kMm)
                                               : partOf(narrow, 0.25, 700'000, 3 * kMm);
    }
}

}  // namespace

BodySize sizeBody(const PackageFacts& given, Nm statedHeight) {
    BodySize size;
    size.pattern = patternOf(given);
    size.kind = kindOf(given.refdes, given.name);
    size.family = familyOf(given, size.pattern, size.kind, statedHeight);
    if (size.family == PackageFamily::None) {
        return size;
    }
    const bool isTurned = size.pattern.isAlongY;
    const PackageFacts turned = isTurned ? transposed(given) : PackageFacts{};
    const PackageFacts& facts = isTurned ? turned : given;
    const Box box = bodyBox(facts, size.pattern, size.family, size.kind);
    if (box.width() <= 0 || box.height() <= 0) {
        return {};
    }
    size.box = isTurned ? transposed(box) : box;
    size.isHeightAssumed = !isPlausibleHeight(statedHeight);
    size.height = size.isHeightAssumed ? usualHeight(box, facts, size.family, size.kind) : statedHeight;
    return size;
}

bool isAsDrawn(const BodySize& size, const PackageFacts& facts) {
    return facts.outlineSource == OutlineSource::Drawn && size.box == facts.box;
}

PackageFacts transposed(const PackageFacts& facts) {
    PackageFacts result = facts;
    for (PinFacts& pin : result.pins) {
        pin = {{pin.position.y, pin.position.x}, transposed(pin.pad), pin.isThrough};
    }
    result.outline = transposed(facts.outline);
    result.box = transposed(facts.box);
    return result;
}

PolygonSet transposed(const PolygonSet& polygons) {
    PolygonSet result;
    std::vector<Point> loop;
    for (const PolygonSet::Polygon& polygon : polygons.polygons) {
        result.beginPolygon();
        for (std::uint32_t i = 0; i < polygon.loopCount; ++i) {
            loop.clear();
            for (const Point p : polygons.loop(polygon.firstLoop + i)) {
                loop.push_back({p.y, p.x});
            }
            result.addLoop(loop);
        }
    }
    return result;
}

}  // namespace model
