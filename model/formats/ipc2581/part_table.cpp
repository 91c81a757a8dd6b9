#include "model/formats/ipc2581/part_table.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "model/formats/ipc2581/xml/xml_values.h"

namespace model::ipc2581 {

using formats::DrawnComponent;
using formats::DrawnFeature;
using formats::DrawnPackage;
using formats::DrawnPackagePin;
using formats::DrawnPin;
using formats::kNoRow;

/// A meaning of an Xform, as Placement has it.
struct PartTable::Orientation {
    enum class Mirror { AsSaid, Never, Always };
    double sign;   ///< of the rotation, counter-clockwise before the mirror
    double added;  ///< degrees to it
    Mirror mirror;
};

namespace {

/// Writers round pads and parts apart by some µm (0.001 inch in coarse files).
constexpr Nm kReach = 30'000;

std::int64_t distance(Point a, Point b) {
    return std::max(std::abs(std::int64_t{a.x} - b.x), std::abs(std::int64_t{a.y} - b.y));
}

MountType mountNamed(std::string_view name) {
    return name == "SMT"        ? MountType::Surface
           : name == "THMT"     ? MountType::ThroughHole
           : name == "PRESSFIT" ? MountType::PressFit
           : name.empty()       ? MountType::Unknown
                                : MountType::Other;
}

bool isWhole(double nm) {
    return std::abs(nm) <= base::kMaxCoordinate;
}

Nm heightOf(Reading& reading, const XmlCursor& at) {
    const double nm = reading.lengthOr(at, "height", reading.unitNm(), 0.0);
    return nm > 0.0 && isWhole(nm) ? static_cast<Nm>(std::llround(nm)) : 0;
}

/// A name and a value under different attributes.
void addWord(const XmlCursor& at, const char* name, const char* value, formats::Words& words) {
    if (!at.value(name).empty()) {
        words.emplace_back(textOf(at.value(name)), textOf(at.value(value)));
    }
}

void addAttribute(const XmlCursor& at, std::string_view attribute, formats::Words& words) {
    if (!at.value(attribute).empty()) {
        words.emplace_back(std::string(attribute), textOf(at.value(attribute)));
    }
}

/// What packages bring besides an outline and pins.
bool isOtherDrawing(std::string_view name) {
    return name == "Outline" || name == "PickupPoint" || name == "LandPattern" || name == "SilkScreen" ||
           name == "AssemblyDrawing" || name == "Topside" || name == "OtherSideView";
}

Placement placementOf(const DrawnComponent& component) {
    return {component.position, component.clockwiseDeg, component.isMirrored.value_or(false)};
}

/// The way back. What is mirrored is rotated the same way once more.
Placement inverseOf(const Placement& placement) {
    Placement back{{}, placement.isMirrored ? placement.clockwiseDeg : -placement.clockwiseDeg, placement.isMirrored};
    const Point moved = back.apply(placement.origin);
    back.origin = {-moved.x, -moved.y};
    return back;
}

/// Of a pad, where it lies on the board; nothing of what is drawn otherwise.
ShapeSketch outlineOnBoard(const DrawnFeature& pad, const formats::DrawnStep& step) {
    const Placement placement{pad.a, pad.clockwiseDeg, pad.isMirrored};
    ShapeSketch outline;
    if (pad.kind == formats::DrawnKind::Pad && pad.symbol != kNoRow) {
        outline.append(formats::outlineOf(step.symbols[static_cast<std::size_t>(pad.symbol)].shape), placement);
    } else if (pad.kind == formats::DrawnKind::Region && pad.region != kNoRow) {
        outline.append(step.regions[static_cast<std::size_t>(pad.region)], placement);
    }
    return outline;
}

}  // namespace

Bom::Bom(Reading& reading) {
    for (const XmlSection& section : reading.outline().sections) {
        if (section.name != "BomItem") {
            continue;
        }
        XmlCursor at = reading.at(section);
        at.next();
        formats::Words& words = items.emplace_back();
        for (const char* attribute : {"OEMDesignNumberRef", "internalPartNumber", "description"}) {
            addAttribute(at, attribute, words);
        }
        forEachChild(at, [&] {
            if (at.name() == "RefDes") {
                const std::string_view populate = at.value("populate");
                parts.try_emplace(at.value("name"), BomPart{populate.empty() || isTrue(populate), items.size() - 1});
            } else if (at.name() == "Characteristics") {
                forEachChild(at, [&] {
                    if (at.name() == "Textual") {
                        addWord(at, "textualCharacteristicName", "textualCharacteristicValue", words);
                    } else {
                        reading.reportUnknown(at);
                    }
                });
            } else {
                reading.reportUnknown(at);
            }
        });
    }
}

void PartTable::addPackage(XmlCursor& at) {
    const auto row = static_cast<std::int32_t>(m_step.packages.size());
    if (!m_packages.try_emplace(at.value("name"), row).second) {
        return m_reading.report(Severity::Warning, at.line(), "two packages have one name; the first one is used");
    }
    DrawnPackage package;
    package.name = textOf(at.value("name"));
    m_packageHeights.push_back(heightOf(m_reading, at));
    addAttribute(at, "type", package.properties);
    addAttribute(at, "pinOne", package.properties);
    addAttribute(at, "comment", package.properties);
    std::vector<std::string_view> names;
    forEachChild(at, [&] {
        if (at.name() == "Outline" && package.outline.isEmpty()) {
            package.outline = m_shapes.sketch(at, {}, m_reading.unitNm());
        } else if (at.name() == "Pin") {
            addPackagePin(at, package, names);
        } else if (isOtherDrawing(at.name())) {
            m_reading.report(Severity::Info, at.line(),
                             "of packages the first outline and the pins are read, not their other drawings");
        } else {
            m_reading.reportUnknown(at);
        }
    });
    m_packagePins.push_back(std::move(names));
    m_step.packages.push_back(std::move(package));
}

void PartTable::addPackagePin(XmlCursor& at, DrawnPackage& package, std::vector<std::string_view>& names) {
    const double unit = m_reading.unitNm();
    const std::uint32_t line = at.line();
    DrawnPackagePin pin;
    const std::string_view number = at.value("number").empty() ? at.value("name") : at.value("number");
    const std::string_view type = at.value("type");
    pin.name = textOf(number);
    pin.kind = type == "THRU" ? PinKind::Through : type == "BLIND" ? PinKind::Blind : PinKind::Surface;
    PointD location = {m_reading.lengthOr(at, "x", unit, 0.0), m_reading.lengthOr(at, "y", unit, 0.0)};
    Turn turn;
    std::vector<XmlCursor> shapes;
    forEachChild(at, [&] {
        if (at.name() == "Location") {
            location = m_reading.point(at, unit);
        } else if (!readTurn(m_reading, at, unit, turn)) {
            shapes.push_back(at);
        }
    });
    turn.origin = {turn.origin.x + location.x, turn.origin.y + location.y};
    pin.position = m_reading.rounded(turn.origin, line);  // offsets too: a pin lies where its pad is drawn
    for (XmlCursor& shape : shapes) {
        pin.outline = pin.outline.isEmpty() ? m_shapes.sketch(shape, turn, unit) : pin.outline;
    }
    names.push_back(number);
    package.pins.push_back(std::move(pin));
}

LayerSide PartTable::sideOf(const XmlCursor& at, bool isMirrored) const {
    const int layer = m_layers.find(at.value("layerRef"));
    const LayerSide side = layer < 0 ? LayerSide::None : m_layers[static_cast<std::size_t>(layer)].drawn.side;
    if (side == LayerSide::Top || side == LayerSide::Bottom) {
        return side;
    }
    return isMirrored ? LayerSide::Bottom : LayerSide::Top;  // inner layers too: parts on steps of rigid-flex boards
}

void PartTable::addComponent(XmlCursor& at) {
    const XmlCursor start = at;
    const std::string_view refdes = at.value("refDes").empty() ? at.value("name") : at.value("refDes");
    const std::string_view packageName = at.value("packageRef");
    DrawnComponent component;
    component.refdes = textOf(refdes);
    component.part = textOf(at.value("part").empty() ? at.value("value") : at.value("part"));
    component.mount = mountNamed(at.value("mountType"));
    component.height = heightOf(m_reading, at);
    component.line = at.line();
    addAttribute(at, "value", component.properties);
    const auto package = m_packages.find(packageName);
    if (package != m_packages.end()) {
        component.package = package->second;
        const Nm height = m_packageHeights[static_cast<std::size_t>(package->second)];
        component.height = component.height > 0 ? component.height : height;
    } else {
        m_reading.report(Severity::Warning, component.line, "a component names a package that the step does not have");
    }
    Turn turn;
    forEachChild(at, [&] {
        if (at.name() == "NonstandardAttribute") {
            addWord(at, "name", "value", component.properties);
        } else if (!readTurn(m_reading, at, m_reading.unitNm(), turn)) {
            m_reading.reportUnknown(at);
        }
    });
    component.position = m_reading.rounded(turn.origin, component.line);
    component.side = sideOf(start, turn.isMirrored);
    if (const auto part = m_bom.parts.find(refdes); part != m_bom.parts.end()) {
        component.isPopulated = part->second.isPopulated;
        const formats::Words& item = m_bom.items[part->second.item];
        component.properties.insert(component.properties.end(), item.begin(), item.end());
    }
    const auto row = static_cast<std::int32_t>(m_step.components.size());
    if (!m_components.try_emplace(refdes, row).second) {
        m_reading.report(Severity::Warning, component.line,
                         "two components have one designator; pads belong to the first one");
    }
    m_sources.push_back({turn.ccwDeg, turn.isMirrored});
    const std::int32_t packageRow = component.package;
    m_step.components.push_back(std::move(component));
    addPins(row, packageRow);
}

void PartTable::addPins(std::int32_t component, std::int32_t package) {
    if (package == kNoRow) {
        return;
    }
    const std::vector<std::string_view>& names = m_packagePins[static_cast<std::size_t>(package)];
    for (std::size_t i = 0; i < names.size(); ++i) {
        addPin(component, names[i], static_cast<std::int32_t>(i));
    }
}

void PartTable::addPin(std::int32_t component, std::string_view name, std::int32_t packagePin) {
    std::vector<DrawnPin>& pins = m_step.components[static_cast<std::size_t>(component)].pins;
    m_pins[{component, name}].push_back(static_cast<std::int32_t>(pins.size()));
    DrawnPin pin;
    pin.name = textOf(name);
    pin.packagePin = packagePin;
    pins.push_back(std::move(pin));
}

void PartTable::addNet(XmlCursor& at) {
    const std::int32_t net = m_nets.row(at.value("name"));
    if (net == kNoRow) {
        return m_reading.report(Severity::Warning, at.line(), "a net without a name was left out");
    }
    formats::Words& words = m_step.nets[static_cast<std::size_t>(net)].properties;
    addAttribute(at, "netClass", words);
    addAttribute(at, "netPair", words);
    forEachChild(at, [&] {
        if (at.name() == "NonstandardAttribute") {
            addWord(at, "name", "value", m_step.nets[static_cast<std::size_t>(net)].properties);
        } else if (at.name() == "PinRef") {
            const std::int32_t component = componentNamed(at.value("componentRef"));
            if (component == kNoRow) {
                m_reading.report(Severity::Warning, at.line(), "a net names a component that the step does not have");
            } else {
                m_pinNets.try_emplace({component, at.value("pin")}, net);
            }
        } else {
            m_reading.reportUnknown(at);
        }
    });
}

std::int32_t PartTable::componentNamed(std::string_view name) const {
    const auto found = m_components.find(name);
    return found == m_components.end() ? kNoRow : found->second;
}

void PartTable::finish() {
    addMissingPins();
    orient(LayerSide::Top);
    orient(LayerSide::Bottom);
    placePins();
    linkPads();
}

/// Pins that only pads know. Files for fabrication or stencils have pads of components, and list none of these.
void PartTable::addMissingPins() {
    const bool areListed = !m_step.components.empty();
    for (const PadUse& use : m_pads) {
        const std::int32_t component = componentNamed(use.component);
        if (component == kNoRow) {
            m_reading.report(areListed ? Severity::Warning : Severity::Info, featureOf(use).line,
                             areListed ? "a pad names a component that the step does not have"
                                       : "a pad names a component, of which the step lists none");
        } else if (!m_pins.contains({component, use.pin})) {
            addPin(component, use.pin, kNoRow);
        }
    }
}

Placement PartTable::placed(std::size_t component, const Orientation& orientation) const {
    const Source& source = m_sources[component];
    const double ccw = orientation.sign * source.ccwDeg + orientation.added;
    const bool isMirrored = orientation.mirror == Orientation::Mirror::AsSaid
                                ? source.isMirrored
                                : orientation.mirror == Orientation::Mirror::Always;
    return {m_step.components[component].position, normalDegrees(-ccw), isMirrored};
}

/// How many pads lie where the orientation puts their pin.
std::size_t PartTable::score(LayerSide side, const Orientation& orientation) const {
    std::size_t count = 0;
    for (const PadUse& use : m_pads) {
        const std::int32_t row = use.isCopper ? componentNamed(use.component) : kNoRow;
        if (row == kNoRow || m_step.components[static_cast<std::size_t>(row)].side != side) {
            continue;
        }
        const DrawnComponent& component = m_step.components[static_cast<std::size_t>(row)];
        const Placement placement = placed(static_cast<std::size_t>(row), orientation);
        const auto pins = m_pins.find({row, use.pin});
        const auto fits = [&](std::int32_t pin) {
            const std::int32_t packagePin = component.pins[static_cast<std::size_t>(pin)].packagePin;
            if (packagePin == kNoRow) {
                return false;
            }
            const DrawnPackage& package = m_step.packages[static_cast<std::size_t>(component.package)];
            const Point expected = placement.apply(package.pins[static_cast<std::size_t>(packagePin)].position);
            return distance(expected, featureOf(use).a) <= kReach;
        };
        count += pins != m_pins.end() && std::ranges::any_of(pins->second, fits) ? 1 : 0;
    }
    return count;
}

void PartTable::orient(LayerSide side) {
    // As the standard has it; with y mirrored instead of x (KiCad 9); rotated the other way, which is mirrored before
    // rotated; with mirrors nobody says, or that are said in vain.
    using Mirror = Orientation::Mirror;
    static constexpr std::array<Orientation, 9> kOrientations = {{{1.0, 0.0, Mirror::AsSaid},
                                                                  {1.0, 180.0, Mirror::AsSaid},
                                                                  {-1.0, 0.0, Mirror::AsSaid},
                                                                  {-1.0, 180.0, Mirror::AsSaid},
                                                                  {1.0, 0.0, Mirror::Always},
                                                                  {1.0, 180.0, Mirror::Always},
                                                                  {-1.0, 0.0, Mirror::Always},
                                                                  {1.0, 0.0, Mirror::Never},
                                                                  {-1.0, 0.0, Mirror::Never}}};
    std::array<std::size_t, kOrientations.size()> scores{};
    std::ranges::transform(kOrientations, scores.begin(), [&](const Orientation& o) { return score(side, o); });
    const auto best = static_cast<std::size_t>(std::ranges::max_element(scores) - scores.begin());
    for (std::size_t row = 0; row < m_step.components.size(); ++row) {
        DrawnComponent& component = m_step.components[row];
        if (component.side == side) {
            const Placement placement = placed(row, kOrientations[best]);
            component.clockwiseDeg = placement.clockwiseDeg;
            component.isMirrored = placement.isMirrored;
        }
    }
    if (best != 0) {
        m_reading.report(
            Severity::Info, 0,
            side == LayerSide::Bottom
                ? "parts on the bottom are mirrored in another way than the standard has it; their pads show how"
                : "parts on the top are rotated in another way than the standard has it; their pads show how");
    }
}

void PartTable::placePins() {
    for (std::size_t row = 0; row < m_step.components.size(); ++row) {
        DrawnComponent& component = m_step.components[row];
        const Placement placement = placementOf(component);
        for (DrawnPin& pin : component.pins) {
            pin.position = component.position;
            if (pin.packagePin != kNoRow) {
                const DrawnPackage& package = m_step.packages[static_cast<std::size_t>(component.package)];
                pin.position = placement.apply(package.pins[static_cast<std::size_t>(pin.packagePin)].position);
            }
        }
    }
    for (const auto& [key, net] : m_pinNets) {
        const auto pins = m_pins.find(key);
        for (const std::int32_t pin : pins == m_pins.end() ? std::vector<std::int32_t>() : pins->second) {
            m_step.components[static_cast<std::size_t>(key.component)].pins[static_cast<std::size_t>(pin)].net = net;
        }
    }
}

/// The pin of that name whose pad lies there on another layer, else the nearest one that has no pad yet, else another
/// one: some list the pads of a package that have one name only once.
std::int32_t PartTable::pinAt(const PadUse& use, std::int32_t component) {
    std::vector<DrawnPin>& pins = m_step.components[static_cast<std::size_t>(component)].pins;
    const Point pad = featureOf(use).a;
    std::int32_t nearest = kNoRow;
    for (const std::int32_t row : m_pins.at({component, use.pin})) {
        const DrawnPin& pin = pins[static_cast<std::size_t>(row)];
        const std::int64_t reach = distance(pin.position, pad);
        const auto taken = m_taken.find({component, row});
        const bool isTaken = taken != m_taken.end();
        if (isTaken && reach <= kReach && taken->second != use.layer) {
            return row;
        }
        const bool isNearer =
            nearest == kNoRow || reach < distance(pins[static_cast<std::size_t>(nearest)].position, pad);
        nearest = !isTaken && isNearer ? row : nearest;
    }
    if (nearest != kNoRow) {
        return nearest;
    }
    addPin(component, use.pin, packagePinAt(use, component));
    return static_cast<std::int32_t>(pins.size()) - 1;
}

/// A pin of that name that its package lists, and that has its pad where the package puts it; nullptr if there is none.
const DrawnPackagePin* PartTable::fittingPin(const PadUse& use, std::int32_t component) const {
    const DrawnComponent& part = m_step.components[static_cast<std::size_t>(component)];
    const Placement placement = placementOf(part);
    for (const std::int32_t row : m_pins.at({component, use.pin})) {
        const DrawnPin& pin = part.pins[static_cast<std::size_t>(row)];
        if (pin.packagePin != kNoRow) {
            const DrawnPackage& package = m_step.packages[static_cast<std::size_t>(part.package)];
            const DrawnPackagePin& listed = package.pins[static_cast<std::size_t>(pin.packagePin)];
            if (distance(placement.apply(listed.position), pin.position) <= kReach) {
                return &listed;
            }
        }
    }
    return nullptr;
}

/// The pin of the package for another pad of a name that it lists: one that it has learned, or a new one.
std::int32_t PartTable::packagePinAt(const PadUse& use, std::int32_t component) {
    const DrawnPackagePin* const like = fittingPin(use, component);
    if (like == nullptr) {
        return kNoRow;
    }
    const DrawnComponent& part = m_step.components[static_cast<std::size_t>(component)];
    const Placement onBoard = placementOf(part);
    const DrawnFeature& pad = featureOf(use);
    std::vector<DrawnPackagePin>& pins = m_step.packages[static_cast<std::size_t>(part.package)].pins;
    const std::size_t listed = m_packagePins[static_cast<std::size_t>(part.package)].size();
    for (std::size_t i = listed; i < pins.size(); ++i) {
        if (pins[i].name == like->name && distance(onBoard.apply(pins[i].position), pad.a) <= kReach) {
            return static_cast<std::int32_t>(i);
        }
    }
    if (m_teachers.try_emplace(part.package, component).first->second != component) {
        return kNoRow;
    }
    const Placement back = inverseOf(onBoard);
    DrawnPackagePin pin{like->name, like->kind, back.apply(pad.a), {}};
    pin.outline.append(outlineOnBoard(pad, m_step), back);
    pins.push_back(std::move(pin));
    return static_cast<std::int32_t>(pins.size()) - 1;
}

bool PartTable::liesOnItsPin(const PadUse& use) const {
    const std::int32_t component = use.isCopper ? componentNamed(use.component) : kNoRow;
    if (component == kNoRow) {
        return false;
    }
    const std::vector<DrawnPin>& pins = m_step.components[static_cast<std::size_t>(component)].pins;
    return std::ranges::any_of(m_pins.at({component, use.pin}), [&](std::int32_t row) {
        const DrawnPin& pin = pins[static_cast<std::size_t>(row)];
        return pin.packagePin != kNoRow && distance(pin.position, featureOf(use).a) <= kReach;
    });
}

/// A pin lies where its pad is, if it has one on copper: that of the layer read first. Pads that lie where the package
/// puts their pin come first, so that none of another place takes it.
void PartTable::linkPads() {
    std::stable_partition(m_pads.begin(), m_pads.end(), [&](const PadUse& use) { return liesOnItsPin(use); });
    for (const PadUse& use : m_pads) {
        const std::int32_t component = use.isCopper ? componentNamed(use.component) : kNoRow;
        if (component == kNoRow) {
            continue;
        }
        const std::int32_t row = pinAt(use, component);
        DrawnPin& pin = m_step.components[static_cast<std::size_t>(component)].pins[static_cast<std::size_t>(row)];
        DrawnFeature& feature = m_step.features[use.layer][use.feature];
        feature.component = component;
        feature.pin = row;
        pin.net = pin.net == kNoRow ? feature.net : pin.net;
        if (m_taken.try_emplace({component, row}, use.layer).second) {
            pin.position = feature.a;
        }
    }
}

}  // namespace model::ipc2581
