#include <algorithm>
#include <cmath>

#include "model/base/limits.h"
#include "model/base/units.h"
#include "model/formats/gerber/drills/drill_parser.h"
#include "model/formats/gerber/text/words.h"
#include "model/geometry/outlines.h"
#include "model/geometry/vectors.h"

namespace model::gerber {

using formats::DrawnFeature;
using formats::DrawnKind;

namespace {

constexpr Nm kNoSize = 10;              ///< of a tool without one: the hole stays a hole, and nothing is invented
constexpr double kRounding = 20'000.0;  ///< nm: what coarse formats make of a radius

/// False, and not moved as a whole, if it would lie beyond any board.
bool isMoved(DrawnFeature& feature, PointD by) {
    for (Point* p : {&feature.a, &feature.b, &feature.centre}) {
        const std::optional<Nm> x = toNm(static_cast<double>(p->x) + by.x);
        const std::optional<Nm> y = toNm(static_cast<double>(p->y) + by.y);
        if (!x || !y) {
            return false;
        }
        *p = {*x, *y};
    }
    return true;
}

}  // namespace

void DrillParser::moveTo(std::optional<double> x, std::optional<double> y) {
    const auto next = [&](std::optional<double> value, double origin, double now) {
        return !value ? now : m_isIncremental ? now + *value : origin + *value;
    };
    m_position = {next(x, m_origin.x, m_position.x), next(y, m_origin.y, m_position.y)};
}

void DrillParser::operate(const Target& target) {
    const PointD from = m_position;
    moveTo(target.x, target.y);
    if (target.isSlot) {
        m_last = Last::Slot;
        add(DrawnKind::Line, m_slotStart, m_position, {});
    } else if (m_isRouting) {
        route(from, target);
    } else {
        if (m_motion > 0) {
            report(Severity::Warning, "a routed path (G01, G02, G03) without G00 before it; its places are drilled");
        }
        m_last = Last::Hole;
        add(DrawnKind::Pad, m_position, m_position, {});
    }
}

void DrillParser::route(PointD from, const Target& target) {
    const bool cuts = m_motion > 0 && (m_isDown || !m_hasPlunges);
    if (!cuts) {
        return;
    }
    m_isPlungeOpen = false;
    m_last = Last::Path;
    const std::optional<PointD> centre = m_motion > 1 ? centreOf(from, target) : std::nullopt;
    add(centre ? DrawnKind::Arc : DrawnKind::Line, from, m_position, centre.value_or(PointD{}));
}

void DrillParser::plunge() {
    drillPlunge();
    m_isDown = m_isPlungeOpen = true;
}

/// A tool that goes down and up again in one place leaves a hole of its size.
void DrillParser::drillPlunge() {
    if (m_isPlungeOpen && m_isRouting) {
        m_last = Last::Hole;
        add(DrawnKind::Pad, m_position, m_position, {});
    }
    m_isPlungeOpen = false;
}

void DrillParser::lift() {
    drillPlunge();
    m_isDown = false;
}

/// Nothing, and a report, if the arc cannot be drawn as one.
std::optional<PointD> DrillParser::centreOf(PointD from, const Target& target) {
    if (!target.hasCentre() && target.radius.value_or(0.0) > 0) {
        return centreOfRadius(from, *target.radius);
    }
    const PointD centre{from.x + target.i.value_or(0.0), from.y + target.j.value_or(0.0)};
    const double radius = distance(centre, from);
    const double end = distance(centre, m_position);
    if (radius < 0.5 || end < 0.5) {
        report(Severity::Warning, "a routed arc without a radius; taken as a straight line");
        return std::nullopt;
    }
    if (std::abs(radius - end) > std::max(0.05 * std::max(radius, end), kRounding)) {
        report(Severity::Warning, "a routed arc whose ends are not equally far from its centre; drawn as a spiral");
    }
    return centre;
}

/// Of the arc that is no more than half a circle.
std::optional<PointD> DrillParser::centreOfRadius(PointD from, double radius) {
    const PointD to = m_position;
    const double chord = distance(from, to);
    if (chord < 0.5) {
        report(Severity::Warning,
               "a routed circle with a radius (A) but no centre (I, J), which may lie anywhere; only the hole where it "
               "begins is drawn");
        return std::nullopt;
    }
    if (radius < chord / 2 - kRounding) {
        report(Severity::Warning, "a routed arc whose radius (A) is too small for its ends; drawn as half a circle");
    }
    const double height = std::sqrt(std::max(0.0, radius * radius - chord * chord / 4));
    const double side = m_motion == 2 ? 1.0 : -1.0;  // clockwise: the centre is on the right
    return PointD{(from.x + to.x) / 2 + side * height * (to.y - from.y) / chord,
                  (from.y + to.y) / 2 - side * height * (to.x - from.x) / chord};
}

void DrillParser::add(DrawnKind kind, PointD a, PointD b, PointD centre) {
    if (m_isInHeader) {
        report(Severity::Info, "a hole before the end of the header");
    }
    const bool isNear = toNm(a.x) && toNm(a.y) && toNm(b.x) && toNm(b.y) && toNm(centre.x) && toNm(centre.y);
    if (!isNear) {
        return report(Severity::Warning, "a coordinate is larger than any board (1.07 m); the hole is left out");
    }
    Tool& tool = m_tools[m_tool];
    if (tool.symbol < 0) {
        use(tool);
    }
    DrawnFeature feature = attributed(tool);
    feature.kind = kind;
    feature.isClockwise = m_motion == 2;
    feature.symbol = tool.symbol;
    feature.plating = tool.plating;
    feature.a = rounded(a);
    feature.b = rounded(b);
    feature.centre = rounded(centre);
    feature.line = m_line;
    ++(kind == DrawnKind::Pad ? m_image.flashes : m_image.draws);
    m_image.features.push_back(feature);
}

void DrillParser::use(Tool& tool) {
    formats::DrawnSymbol symbol;
    symbol.name = "T" + std::to_string(m_tool) + " " + shortNumber(base::toMm(tool.size)) + " mm";
    symbol.shape.kind = formats::PadShape::Kind::Round;
    const std::optional<Nm> size = toNm(tool.size);
    if (size && *size > 20 * static_cast<Nm>(base::kNmPerMm)) {
        report(Severity::Warning, "a tool of more than 20 mm: its size may be in another unit");
    }
    symbol.shape.width = std::max(size.value_or(kNoSize), kNoSize);
    tool.symbol = static_cast<std::int32_t>(m_image.symbols.size());
    m_image.symbols.push_back(std::move(symbol));
}

/// R04X001Y0: the last hole or slot again, so often, each that much farther.
void DrillParser::repeat(const DrillValues& parts) {
    const int count = parseInteger(parts[0].digits).value_or(0);
    m_isBad = false;
    double dx = 0.0;
    double dy = 0.0;
    for (const DrillValue& part : parts) {
        (part.letter == 'X'   ? dx
         : part.letter == 'Y' ? dy
                              : m_ignored) = part.letter == 'R' ? 0.0 : length(part.digits);
    }
    if (m_isBad || count < 1 || m_last == Last::Nothing) {
        return report(Severity::Warning, "a repetition of a hole that cannot be read; it was left out");
    }
    if (m_last == Last::Path) {
        return report(Severity::Warning, "a repetition behind a routed path, which is no hole; it was left out");
    }
    if (!mayRepeat(static_cast<std::size_t>(count))) {
        return;
    }
    for (int i = 0; i < count; ++i) {
        m_position = {m_position.x + dx, m_position.y + dy};
        m_slotStart = {m_slotStart.x + dx, m_slotStart.y + dy};
        if (!toNm(m_position.x) || !toNm(m_position.y)) {
            return report(Severity::Warning,
                          "a repetition of a hole goes beyond any board, more than 1.07 m from the origin; the rest of "
                          "it is left out");
        }
        const bool isSlot = m_last == Last::Slot;
        add(isSlot ? DrawnKind::Line : DrawnKind::Pad, isSlot ? m_slotStart : m_position, m_position, {});
    }
}

bool DrillParser::mayRepeat(std::size_t count) {
    m_repeated += count;
    if (m_repeated > base::kMostRepeated) {
        report(Severity::Error,
               "repetitions draw " + base::moreThan(base::kMostRepeated, "holes") + "; the rest is left out");
    }
    return m_repeated <= base::kMostRepeated;
}

/// M02X1Y2: the holes between M25 and M01 again, that much farther than the last time.
void DrillParser::repeatPattern(const DrillValues& parts) {
    m_isConsumed = true;
    double dx = 0.0;
    double dy = 0.0;
    for (const DrillValue& part : parts) {
        if (part.letter == 'X' || part.letter == 'Y') {
            (part.letter == 'X' ? dx : dy) = length(part.digits);
        }
    }
    const std::size_t count = m_patternEnd - std::min(m_patternBegin, m_patternEnd);
    if (m_isBad) {
        return report(Severity::Warning, "a repeated pattern of holes that cannot be read; it was left out");
    }
    if (!mayRepeat(count)) {
        return;
    }
    for (std::size_t i = 0; i < count; ++i) {
        DrawnFeature feature = m_image.features[m_patternBegin + i];
        if (isMoved(feature, {dx, dy})) {
            m_image.features.push_back(feature);
        } else {
            report(Severity::Warning,
                   "a repeated pattern of holes goes beyond any board, more than 1.07 m from the origin; what lies "
                   "there is left out");
        }
    }
    m_patternBegin = m_patternEnd;
    m_patternEnd = m_image.features.size();
}

void DrillParser::listTool(int number, const Tool& tool) {
    if (tool.symbol < 0) {
        return;
    }
    DrillTool row;
    row.number = number;
    row.plating = tool.plating;
    row.finishedSize = row.drillSize = std::max(toNm(tool.size).value_or(kNoSize), kNoSize);
    m_image.tools.push_back(row);
}

void DrillParser::finishTools() {
    for (const auto& [number, tool] : m_tools) {
        listTool(number, tool);
    }
}

}  // namespace model::gerber
