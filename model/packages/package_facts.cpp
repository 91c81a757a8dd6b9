#include "model/packages/package_facts.h"

#include <cmath>

namespace model {

namespace {

/// Half the width of a pad that the job draws no outline of.
constexpr Nm kHalfPad = 250'000;

Box around(Point pin) {
    Box box;
    box.include(pin);
    return box.grownBy(kHalfPad);
}

void addPackagePins(const Document& document, const Package& package, PackageFacts& facts) {
    for (std::uint32_t i = package.pins.first; i < package.pins.first + package.pins.count; ++i) {
        const PackagePin& pin = document.packagePins[i];
        const bool isDrawn = pin.outline.isValid();
        if (facts.firstPin == 0 && isFirstPin(document.text(pin.name))) {
            facts.firstPin = facts.pins.size();
        }
        facts.addPin(pin.position, isDrawn ? document.shapes.shapes[pin.outline.row()].box : Box{},
                     pin.kind == PinKind::Through);
    }
}

/// Of a component whose package is not known.
void addPlacedPins(const Document& document, const Component& component, PackageFacts& facts) {
    for (const Pin& pin : document.pinsOf(component)) {
        facts.addPin(pin.position, {}, component.mount == MountType::ThroughHole);
    }
}

}  // namespace

Nm scaled(std::int64_t length, double factor) {
    return static_cast<Nm>(std::lround(static_cast<double>(length) * factor));
}

Box PackageFacts::boxOfPads() const {
    Box all;
    for (const PinFacts& pin : pins) {
        all.include(pin.pad);
    }
    return all;
}

Box PackageFacts::boxOfPins() const {
    Box all;
    for (const PinFacts& pin : pins) {
        all.include(pin.position);
    }
    return all;
}

PackageFacts factsOf(const Document& document, const Component& component) {
    PackageFacts facts;
    facts.refdes = component.refdes;
    facts.boardDepth = document.boardThickness;
    if (!component.package.isValid()) {
        addPlacedPins(document, component, facts);
        return facts;
    }
    const Package& package = document.packages[component.package.row()];
    facts.name = package.name;
    addPackagePins(document, package, facts);
    if (package.body.isValid()) {
        facts.setOutline(discretise(document.shapes, package.body, {}), document.shapes.shapes[package.body.row()].box,
                         package.box);
    } else {
        facts.setOutline({}, {}, package.box);
    }
    return facts;
}

void PackageFacts::addPin(Point position, const Box& pad, bool isThrough) {
    pins.push_back({position, pad.isEmpty() ? around(position) : pad, isThrough});
}

void PackageFacts::setOutline(PolygonSet polygons, const Box& drawn, const Box& stated) {
    const Box pads = boxOfPads();
    const bool isDot = !drawn.isEmpty() && 4 * drawn.width() < pads.width() && 4 * drawn.height() < pads.height();
    const bool isDrawn = drawn.width() > 0 && drawn.height() > 0 && !isDot;
    const bool isStated = stated.width() > 0 && stated.height() > 0;
    outlineSource = isDrawn    ? OutlineSource::Drawn
                    : isDot    ? OutlineSource::Dot
                    : isStated ? OutlineSource::Stated
                               : OutlineSource::None;
    outline = isDrawn ? std::move(polygons) : PolygonSet{};
    box = isDrawn ? drawn : isStated ? stated : Box{};
}

bool isFirstPin(std::string_view name) {
    return name == "1" || name == "A1" || name == "01" || name == "P1";
}

}  // namespace model
