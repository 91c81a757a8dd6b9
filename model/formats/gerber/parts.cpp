#include "model/formats/gerber/parts.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <unordered_map>
#include <vector>

#include "model/base/units.h"
#include "model/formats/gerber/placement_shift.h"
#include "model/formats/gerber/text/words.h"
#include "model/geometry/edges.h"
#include "model/geometry/outlines.h"

namespace model::gerber {

using formats::DrawnComponent;
using formats::DrawnPackage;
using formats::kNoRow;

namespace {

/// Of tables that do not say theirs, which are read as if in mm; the likeliest first.
struct Unit {
    double factor;
    std::string_view name;
};
constexpr std::array kUnits = {
    Unit{1.0, "mm"},
    Unit{base::kNmPerMil / base::kNmPerMm, "mil"},
    Unit{base::kNmPerInch / base::kNmPerMm, "inch"},
};

Box pinBox(const DrawnComponent& component) {
    Box box;
    for (const formats::DrawnPin& pin : component.pins) {
        box.include(pin.position);
    }
    return box;
}

}  // namespace

std::int32_t PartList::component(const std::string& refdes) {
    const auto [found, isNew] = m_rows.try_emplace(refdes, static_cast<std::int32_t>(m_step.components.size()));
    if (isNew) {
        DrawnComponent component;
        component.refdes = refdes;
        m_step.components.push_back(std::move(component));
        m_facts.emplace_back();
    }
    return found->second;
}

std::int32_t PartList::find(const std::string& refdes) const {
    const auto found = m_rows.find(refdes);
    return found == m_rows.end() ? kNoRow : found->second;
}

std::int32_t PartList::pin(std::int32_t component, const std::string& name, Point position, std::int32_t net) {
    DrawnComponent& part = m_step.components[static_cast<std::size_t>(component)];
    const auto [found, isNew] = m_facts[static_cast<std::size_t>(component)].pins.try_emplace(
        name + '\x1f' + std::to_string(position.x) + ' ' + std::to_string(position.y),
        static_cast<std::int32_t>(part.pins.size()));
    if (isNew) {
        part.pins.push_back({name, position, net, kNoRow});
    }
    return found->second;
}

void PartList::isSeenOn(std::int32_t component, LayerSide side, bool isPad, bool isThrough) {
    Facts& facts = m_facts[static_cast<std::size_t>(component)];
    facts.hasThrough = facts.hasThrough || isThrough;
    if (side == LayerSide::Top) {
        ++(isPad ? facts.top : facts.legendTop);
    } else if (side == LayerSide::Bottom) {
        ++(isPad ? facts.bottom : facts.legendBottom);
    }
}

/// Of the places to their pins.
std::optional<Point> PartList::shiftOf(const PlacementFile& file, double factor) const {
    std::vector<PlacedPins> placed;
    for (const PlacedPart& part : file.parts) {
        const std::int32_t row = find(part.refdes);
        if (row != kNoRow && !m_step.components[static_cast<std::size_t>(row)].pins.empty()) {
            placed.push_back({{part.position.x * factor, part.position.y * factor}, {}});
            for (const formats::DrawnPin& pin : m_step.components[static_cast<std::size_t>(row)].pins) {
                placed.back().pins.push_back(pin.position);
            }
        }
    }
    return placementShift(placed);
}

std::optional<PartList::Fit> PartList::fitOf(const PlacementFile& file, const PadIndex& pads, const Box& board) const {
    const std::size_t units = file.saysUnit ? 1 : kUnits.size();
    for (std::size_t i = 0; i < units; ++i) {
        if (const std::optional<Point> shift = shiftOf(file, kUnits[i].factor)) {
            return Fit{kUnits[i].factor, *shift, true};
        }
    }
    for (std::size_t i = 0; i < units; ++i) {
        const auto inside = std::ranges::count_if(file.parts, [&](const PlacedPart& part) {
            const auto x = toNm(part.position.x * kUnits[i].factor);
            const auto y = toNm(part.position.y * kUnits[i].factor);
            return x && y && (pads.pads().empty() || board.holds({*x, *y}));
        });
        if (static_cast<std::size_t>(inside) * 2 >= file.parts.size()) {
            return Fit{kUnits[i].factor, {}};
        }
    }
    return std::nullopt;
}

void PartList::place(const PlacementFile& file, std::string_view path, const PadIndex& pads, const Box& board,
                     Diagnostics& diagnostics) {
    const std::optional<Fit> fit = file.isOnImages ? Fit{} : fitOf(file, pads, board);
    if (!fit) {
        return diagnostics.report(Severity::Warning, path, 0,
                                  "the places of components do not lie on the board, and nothing tells the origin they "
                                  "count from; they are not used");
    }
    if (!file.saysUnit) {
        diagnostics.report(Severity::Info, path, file.parts.front().line,
                           "the table of places does not say its unit; taken as " +
                               std::string(std::ranges::find(kUnits, fit->factor, &Unit::factor)->name) +
                               (fit->factor == 1.0 ? ""
                                : fit->isByPins    ? ", as components then lie on their pins"
                                                   : ", as places in mm would lie beyond the board"));
    }
    if (fit->shift != Point{}) {
        diagnostics.report(Severity::Info, path, 0,
                           "places of components count from another origin, found by their pins");
    }
    std::unordered_map<std::string, base::PointD> places;
    for (const PlacedPart& part : file.parts) {
        const auto x = toNm(part.position.x * fit->factor + fit->shift.x);
        const auto y = toNm(part.position.y * fit->factor + fit->shift.y);
        if (!x || !y) {
            diagnostics.report(
                Severity::Warning, path, part.line,
                "a component is placed beyond any board, more than 1.07 m from the origin; its place was left out");
            continue;
        }
        if (const auto [place, isNew] = places.try_emplace(part.refdes, part.position);
            !isNew && place->second != part.position) {
            diagnostics.report(Severity::Warning, path, part.line,
                               "two components have one designator; they are taken for one, which lies where the last "
                               "one is");
        }
        const std::int32_t row = component(part.refdes);
        DrawnComponent& target = m_step.components[static_cast<std::size_t>(row)];
        Facts& facts = m_facts[static_cast<std::size_t>(row)];
        target.position = {*x, *y};
        target.part = part.value;
        target.side = part.side == LayerSide::Bottom ? LayerSide::Bottom : LayerSide::Top;
        // As Placement: rotated clockwise, then mirrored; programs count counter-clockwise as seen from the top.
        const double turn = target.side == LayerSide::Bottom ? part.rotationDeg : -part.rotationDeg;
        target.clockwiseDeg = std::fmod(std::fmod(turn, 360.0) + 360.0, 360.0);
        target.isMirrored = target.side == LayerSide::Bottom;
        target.line = part.line;
        facts.package = part.package;
        facts.isPlaced = true;
        facts.hasSide = part.side != LayerSide::None;
    }
    m_step.componentsFile = path;
}

void PartList::addPackage(DrawnComponent& component, const Facts& facts) {
    if (component.pins.empty() && facts.package.empty()) {
        return;
    }
    const Placement placement{component.position, component.clockwiseDeg, component.isMirrored.value_or(false)};
    DrawnPackage package;
    package.name = facts.package;
    std::string key = facts.package;
    for (formats::DrawnPin& pin : component.pins) {
        const Point at = rounded(unplaced(base::toDouble(pin.position), placement));
        pin.packagePin = static_cast<std::int32_t>(package.pins.size());
        package.pins.push_back({pin.name, facts.hasThrough ? PinKind::Through : PinKind::Surface, at, {}});
        // Rounding of rotations must not make two packages of one.
        key += '\x1f' + pin.name + ' ' + std::to_string((at.x + 2'000) / 4'000) + ' ' +
               std::to_string((at.y + 2'000) / 4'000);
    }
    const auto [found, isNew] = m_packages.try_emplace(key, static_cast<std::int32_t>(m_step.packages.size()));
    if (isNew) {
        if (package.name.empty()) {
            package.name = "pins of " + component.refdes;
        }
        m_step.packages.push_back(std::move(package));
    }
    component.package = found->second;
}

void PartList::finish(Diagnostics& diagnostics) {
    for (std::size_t row = 0; row < m_step.components.size(); ++row) {
        DrawnComponent& component = m_step.components[row];
        const Facts& facts = m_facts[row];
        component.mount = component.pins.empty() ? MountType::Unknown
                          : facts.hasThrough     ? MountType::ThroughHole
                                                 : MountType::Surface;
        if (!facts.isPlaced || !facts.hasSide) {
            const bool isBottom = facts.top != facts.bottom               ? facts.bottom > facts.top
                                  : facts.legendTop != facts.legendBottom ? facts.legendBottom > facts.legendTop
                                                                          : false;
            component.side = isBottom ? LayerSide::Bottom : LayerSide::Top;
            component.isMirrored = isBottom;
        }
        if (!facts.isPlaced) {
            const Box box = pinBox(component);
            component.position = box.isEmpty() ? Point{} : box.middle();
            component.isPlaced = false;
            diagnostics.report(Severity::Info, m_step.componentsFile, 0,
                               "no file places the components; each lies in the middle of its pins, not rotated");
        }
        addPackage(component, facts);
    }
}

}  // namespace model::gerber
