#include "model/packages/package_family.h"

#include <array>
#include <cmath>
#include <set>

#include "model/base/ascii.h"
#include "model/base/median.h"

namespace model {

namespace {

/// What stands on one pin is at least this high.
constexpr Nm kLeastPost = 500'000;
/// Terminals of leadless packages end under the body; feet of leads reach out of it and have longer pads.
constexpr Nm kLongestTerminal = 1'000'000;
/// How far the rows of pins of a DIP are apart.
constexpr Nm kLeastDip = 6 * kMm;
constexpr Nm kMostDip = 16 * kMm;
/// No quad flat package is larger.
constexpr Nm kMostQuad = 45 * kMm;
/// A surface mounted electrolytic capacitor is at least this wide.
constexpr Nm kLeastCan = 3 * kMm;
/// Inductors from this size on are blocks with terminals below, not chips.
constexpr Nm kLeastBlock = 2'500'000;

bool hasAny(std::string_view text, std::initializer_list<std::string_view> words) {
    return std::ranges::any_of(words, [&](std::string_view word) { return text.find(word) != std::string_view::npos; });
}

struct Prefix {
    std::string_view letters;
    PartKind kind;
};

constexpr Prefix kPrefixes[] = {{"R", PartKind::Resistor},    {"RN", PartKind::Resistor},   {"RP", PartKind::Resistor},
                                {"RA", PartKind::Resistor},   {"RV", PartKind::Resistor},   {"RT", PartKind::Resistor},
                                {"C", PartKind::Capacitor},   {"CP", PartKind::Capacitor},  {"CE", PartKind::Capacitor},
                                {"L", PartKind::Inductor},    {"FB", PartKind::Inductor},   {"FL", PartKind::Inductor},
                                {"T", PartKind::Inductor},    {"D", PartKind::Diode},       {"CR", PartKind::Diode},
                                {"ZD", PartKind::Diode},      {"TVS", PartKind::Diode},     {"LED", PartKind::Led},
                                {"DS", PartKind::Led},        {"LD", PartKind::Led},        {"Q", PartKind::Transistor},
                                {"TR", PartKind::Transistor}, {"U", PartKind::Ic},          {"IC", PartKind::Ic},
                                {"Y", PartKind::Crystal},     {"XTAL", PartKind::Crystal},  {"OSC", PartKind::Crystal},
                                {"X", PartKind::Crystal},     {"J", PartKind::Connector},   {"P", PartKind::Connector},
                                {"CN", PartKind::Connector},  {"CON", PartKind::Connector}, {"JP", PartKind::Connector},
                                {"USB", PartKind::Connector}, {"XS", PartKind::Connector},  {"XP", PartKind::Connector},
                                {"SW", PartKind::Switch},     {"S", PartKind::Switch},      {"BTN", PartKind::Switch},
                                {"K", PartKind::Switch},      {"TP", PartKind::Bare},       {"FID", PartKind::Bare},
                                {"FIX", PartKind::Bare},      {"MH", PartKind::Bare},       {"MTG", PartKind::Bare},
                                {"LOGO", PartKind::Bare},     {"NT", PartKind::Bare},       {"SJ", PartKind::Bare}};

PartKind kindOfRefdes(std::string_view refdes) {
    const std::string capitals = base::upperCase(refdes);
    const auto end = std::ranges::find_if(capitals, [](char c) { return c < 'A' || c > 'Z'; });
    const std::string_view letters(capitals.data(), static_cast<std::size_t>(end - capitals.begin()));
    const auto* const found = std::ranges::find(kPrefixes, letters, &Prefix::letters);
    return found != std::end(kPrefixes) ? found->kind : PartKind::Unknown;
}

double areaOf(const Box& box) {
    return static_cast<double>(box.width()) * static_cast<double>(box.height());
}

/// A pad in the middle, clearly larger than the others.
bool isCentrePad(const PinFacts& pin, const Box& all, double typicalArea) {
    const Point middle = all.middle();
    const bool isInside = std::abs(pin.position.x - middle.x) * 10 <= 2 * all.width() &&
                          std::abs(pin.position.y - middle.y) * 10 <= 2 * all.height();
    return isInside && areaOf(pin.pad) > 2.0 * typicalArea;
}

double typicalAreaOf(const PackageFacts& facts) {
    std::vector<double> areas;
    for (const PinFacts& pin : facts.pins) {
        areas.push_back(areaOf(pin.pad));
    }
    return base::medianOf(areas);
}

/// The pad in the middle; empty if there is none. What lies on it (thermal vias, windows of paste) belongs to it.
Box centrePadOf(const PackageFacts& facts) {
    constexpr std::size_t kFewest = 5;
    Box centre;
    if (facts.pins.size() < kFewest) {
        return centre;
    }
    const double typicalArea = typicalAreaOf(facts);
    const Box all = facts.boxOfPins();
    for (const PinFacts& pin : facts.pins) {
        if (isCentrePad(pin, all, typicalArea) && areaOf(pin.pad) > areaOf(centre)) {
            centre = pin.pad;
        }
    }
    return centre;
}

/// The smallest distance between neighbours of a line of pins.
Nm pitchOf(const PackageFacts& facts) {
    std::int64_t pitch = base::kMaxCoordinate;
    for (std::size_t i = 1; i < facts.pins.size(); ++i) {
        const Point a = facts.pins[i - 1].position;
        const Point b = facts.pins[i].position;
        const std::int64_t apart = std::max(std::abs(std::int64_t{a.x} - b.x), std::abs(std::int64_t{a.y} - b.y));
        pitch = apart > 0 ? std::min(pitch, apart) : pitch;
    }
    return static_cast<Nm>(pitch);
}

/// Which sides of a box points lie on, within a tolerance.
struct Sides {
    std::size_t x = 0;     ///< on the left or the right one
    std::size_t y = 0;     ///< on the lower or the upper one
    std::size_t none = 0;  ///< inside
};

Sides sidesOf(const std::vector<Point>& points, const Box& box) {
    Sides sides;
    const Nm nearX = static_cast<Nm>(box.width() / 8) + 10'000;
    const Nm nearY = static_cast<Nm>(box.height() / 8) + 10'000;
    for (const Point p : points) {
        const bool isOnX = p.x - box.min.x <= nearX || box.max.x - p.x <= nearX;
        const bool isOnY = p.y - box.min.y <= nearY || box.max.y - p.y <= nearY;
        sides.x += isOnX ? 1 : 0;
        sides.y += isOnY ? 1 : 0;
        sides.none += isOnX || isOnY ? 0 : 1;
    }
    return sides;
}

std::size_t columnsOf(const std::vector<Point>& points, Nm Point::*axis) {
    std::set<Nm> columns;
    for (const Point p : points) {
        columns.insert((p.*axis + 50'000) / 100'000);
    }
    return columns.size();
}

PinLayout layoutOfMany(const std::vector<Point>& points, const Box& box, bool& isAlongY) {
    constexpr Nm kLine = 200'000;
    if (box.width() <= kLine || box.height() <= kLine) {
        isAlongY = box.width() > box.height();
        return PinLayout::Row;
    }
    const Sides sides = sidesOf(points, box);
    const std::size_t n = points.size();
    const bool isOnX = sides.x == n;
    const bool isOnY = sides.y == n;
    if (isOnX || isOnY) {
        // Three and four pins are on both: the leads point along the way that parts them the most.
        isAlongY = isOnX && isOnY ? box.height() > box.width() : isOnY;
        return PinLayout::TwoRows;
    }
    if (sides.none == 0) {
        return PinLayout::FourSides;
    }
    const bool isGrid = n >= 9 && columnsOf(points, &Point::x) * columnsOf(points, &Point::y) <= 8 * n;
    return isGrid ? PinLayout::Grid : PinLayout::Irregular;
}

/// The longest pad of the pins along the way they point, of which the median is asked.
Nm padLength(const PackageFacts& facts) {
    std::vector<Nm> lengths;
    for (const PinFacts& pin : facts.pins) {
        lengths.push_back(static_cast<Nm>(std::max(pin.pad.width(), pin.pad.height())));
    }
    return base::medianOf(lengths);
}

bool isLeadless(const PackageFacts& facts, const PinPattern& pattern) {
    const std::string name = base::upperCase(facts.name);
    if (hasAny(name, {"DFN", "QFN", "SON", "LGA", "LCC", "MLF"})) {
        return true;
    }
    if (hasAny(name, {"QFP", "SOP", "SOIC", "SOT", "SC70", "SC-70", "SO-", "SO8"})) {
        return false;
    }
    return (pattern.hasCentrePad || facts.pins.size() >= 6) && padLength(facts) < kLongestTerminal;
}

/// Is neither side longer than the other by more than this many tenths of it?
bool isNearlySquare(const Box& box, int tenths = 13) {
    return 10 * box.width() < tenths * box.height() && 10 * box.height() < tenths * box.width();
}

/// Is the body drawn beside its pads, as of a can that lies over the edge of the board?
bool isBesidePads(const PackageFacts& facts) {
    return !facts.box.isEmpty() && !facts.box.holds(facts.boxOfPads().middle());
}

PackageFamily ofPair(const PackageFacts& facts, PartKind kind) {
    const Box box = facts.box.isEmpty() ? facts.boxOfPads() : facts.box;
    const auto smaller = std::min(box.width(), box.height());
    const bool isTantalum =
        hasAny(base::upperCase(facts.name), {"TANT", "CAPP", "7343", "6032", "3528", "CP_EIA", "CAPMP"});
    switch (kind) {
        case PartKind::Crystal: return PackageFamily::Crystal;
        case PartKind::Connector:
        case PartKind::Switch: return PackageFamily::Connector;
        default: break;
    }
    if (isBesidePads(facts)) {
        return PackageFamily::Other;
    }
    switch (kind) {
        case PartKind::Diode: return smaller < kMm ? PackageFamily::Chip : PackageFamily::TwoLeads;
        case PartKind::Inductor: return smaller >= kLeastBlock ? PackageFamily::TwoLeads : PackageFamily::Chip;
        case PartKind::Capacitor:
            return isTantalum                                    ? PackageFamily::TwoLeads
                   : smaller >= kLeastCan && isNearlySquare(box) ? PackageFamily::CanCapacitor
                                                                 : PackageFamily::Chip;
        default: return PackageFamily::Chip;
    }
}

PackageFamily ofThroughPair(const PackageFacts& facts, PartKind kind) {
    const Box pins = facts.boxOfPins();
    const auto span = std::max(pins.width(), pins.height());
    const auto across = pins.width() > pins.height() ? facts.box.height() : facts.box.width();
    if (kind == PartKind::Connector || kind == PartKind::Switch) {
        return PackageFamily::Header;
    }
    if (!facts.box.isEmpty() && 2 * across < span) {
        return PackageFamily::Axial;
    }
    const bool isCan = (kind == PartKind::Capacitor || kind == PartKind::Led) && isNearlySquare(facts.box);
    return isCan ? PackageFamily::Radial : PackageFamily::ThroughHole;
}

/// Are the pins those of a header, and is the outline no larger than a housing around them?
bool isTight(const PackageFacts& facts) {
    constexpr Nm kWidestPitch = 2'600'000;
    const Box pins = facts.boxOfPins();
    constexpr Nm kAround = 4 * kMm;
    return pitchOf(facts) <= kWidestPitch && (facts.box.isEmpty() || (facts.box.width() - pins.width() <= kAround &&
                                                                      facts.box.height() - pins.height() <= kAround));
}

PackageFamily ofThrough(const PackageFacts& facts, const PinPattern& pattern, PartKind kind) {
    const Box pins = facts.boxOfPins();
    const bool isLine = pattern.layout == PinLayout::Row || pattern.layout == PinLayout::TwoRows;
    if (pattern.layout == PinLayout::Pair) {
        const PackageFamily family = ofThroughPair(facts, kind);
        return family == PackageFamily::Header && !isTight(facts) ? PackageFamily::Connector : family;
    }
    if (kind == PartKind::Connector) {
        return isLine && isTight(facts) ? PackageFamily::Header : PackageFamily::Connector;
    }
    const bool isDual = pattern.layout == PinLayout::TwoRows && facts.pins.size() >= 6 && kind != PartKind::Switch;
    const auto apart = pattern.isAlongY ? pins.height() : pins.width();
    return isDual && apart >= kLeastDip && apart <= kMostDip ? PackageFamily::ThroughDual : PackageFamily::ThroughHole;
}

PackageFamily ofFourSides(const PackageFacts& facts, const PinPattern& pattern) {
    const Box pins = facts.boxOfPins();
    if (std::max(pins.width(), pins.height()) > kMostQuad || !isNearlySquare(pins, 30)) {
        return PackageFamily::Other;
    }
    return isLeadless(facts, pattern) ? PackageFamily::QuadFlatNoLead : PackageFamily::QuadFlat;
}

PackageFamily ofTwoRows(const PackageFacts& facts, const PinPattern& pattern, PartKind kind) {
    constexpr std::size_t kFew = 7;
    if (kind == PartKind::Led || kind == PartKind::Inductor) {
        return PackageFamily::Other;
    }
    return isLeadless(facts, pattern)  ? PackageFamily::DualFlat
           : facts.pins.size() <= kFew ? PackageFamily::SmallOutline
                                       : PackageFamily::DualInLine;
}

/// Pins that form no pattern, because terminals differ or are drawn in several parts: the name says more.
PackageFamily ofName(const PackageFacts& facts, PinLayout layout) {
    const std::string name = base::upperCase(facts.name);
    return hasAny(name, {"QFN", "LCC", "MLF"}) ? PackageFamily::QuadFlatNoLead
           : hasAny(name, {"DFN", "SON"})      ? PackageFamily::DualFlat
           : layout == PinLayout::Grid         ? PackageFamily::Grid
                                               : PackageFamily::Other;
}

PackageFamily ofSurface(const PackageFacts& facts, const PinPattern& pattern, PartKind kind) {
    constexpr std::size_t kMostOfCrystal = 8;
    if (kind == PartKind::Connector || kind == PartKind::Switch) {
        return PackageFamily::Connector;
    }
    if (kind == PartKind::Crystal && facts.pins.size() <= kMostOfCrystal) {
        return PackageFamily::Crystal;
    }
    const bool isPassive = kind == PartKind::Resistor || kind == PartKind::Capacitor;
    switch (pattern.layout) {
        case PinLayout::Pair: return ofPair(facts, kind);
        // Pads of one terminal that are drawn in parts.
        case PinLayout::Row: return isPassive ? ofPair(facts, kind) : PackageFamily::Other;
        case PinLayout::TwoRows: return ofTwoRows(facts, pattern, kind);
        case PinLayout::FourSides: return ofFourSides(facts, pattern);
        default: return ofName(facts, pattern.layout);
    }
}

/// Two bare pads that solder may join.
bool isSolderJumper(const PackageFacts& facts, const PinPattern& pattern, Nm statedHeight) {
    return pattern.layout == PinLayout::Pair && !pattern.isThrough && statedHeight <= 0 && isJumperName(facts.refdes);
}

}  // namespace

PartKind kindOf(std::string_view refdes, std::string_view package) {
    const std::string name = base::upperCase(package);
    if (hasAny(name,
               {"FIDUCIAL",     "TESTPOINT",  "TEST_POINT", "TESTPAD",  "MOUNTINGHOLE", "MOUNTING_HOLE", "LOGO",
                "SOLDERJUMPER", "NETTIE",     "NET_TIE",    "CARDEDGE", "CARD_EDGE",    "FINGER",        "PCB_TRACES",
                "-GF-",         "PLAIN_HOLE", "NO_BODY",    "TC2030",   "TAG-CONNECT",  "TAG_CONNECT"})) {
        return PartKind::Bare;
    }
    if (hasAny(name, {"LED_", "LED-", "_LED"})) {
        return PartKind::Led;
    }
    if (hasAny(name, {"XTAL", "CRYSTAL", "OSC"})) {
        return PartKind::Crystal;
    }
    const PartKind kind = kindOfRefdes(refdes);
    const bool isConnector = hasAny(name, {"CONN", "HEADER", "HDR", "JST", "MOLEX", "SAMTEC", "USB", "RJ45", "HDMI"});
    return kind == PartKind::Unknown && isConnector ? PartKind::Connector : kind;
}

bool isJumperName(std::string_view refdes) {
    return base::upperCase(refdes).starts_with("JP");
}

PinPattern patternOf(const PackageFacts& facts) {
    PinPattern pattern;
    if (facts.pins.empty()) {
        return pattern;
    }
    const Box centre = centrePadOf(facts);
    std::vector<Point> points;
    Box box;
    std::size_t through = 0;
    for (const PinFacts& pin : facts.pins) {
        through += pin.isThrough ? 1 : 0;
        if (centre.isEmpty() || !centre.holds(pin.position)) {
            points.push_back(pin.position);
            box.include(pin.position);
        }
    }
    pattern.hasCentrePad = !centre.isEmpty();
    pattern.isThrough = 2 * through > facts.pins.size();
    if (points.size() > 2) {
        pattern.layout = layoutOfMany(points, box, pattern.isAlongY);
        return pattern;
    }
    pattern.layout = points.size() < 2 ? PinLayout::Single : PinLayout::Pair;
    pattern.isAlongY = box.height() > box.width();
    return pattern;
}

PackageFamily familyOf(const PackageFacts& facts, const PinPattern& pattern, PartKind kind, Nm statedHeight) {
    if (kind == PartKind::Bare || pattern.layout == PinLayout::None || isSolderJumper(facts, pattern, statedHeight)) {
        return PackageFamily::None;
    }
    if (pattern.layout == PinLayout::Single ||
        facts.boxOfPins() == Box{facts.pins[0].position, facts.pins[0].position}) {
        return statedHeight >= kLeastPost ? PackageFamily::Post : PackageFamily::None;
    }
    return pattern.isThrough ? ofThrough(facts, pattern, kind) : ofSurface(facts, pattern, kind);
}

const char* toString(PackageFamily family) {
    constexpr std::array kNames{"none",  "chip", "two leads",    "SMD can", "SOT",       "SOIC",   "DFN",
                                "QFP",   "QFN",  "BGA",          "crystal", "connector", "header", "radial",
                                "axial", "DIP",  "through-hole", "post",    "other"};
    return kNames[static_cast<std::size_t>(family)];
}

}  // namespace model
