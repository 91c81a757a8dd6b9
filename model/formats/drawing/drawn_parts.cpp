#include "model/formats/drawing/drawn_parts.h"

#include <algorithm>
#include <array>
#include <cstdlib>

#include "model/formats/steps/elements_of_feature.h"
#include "model/geometry/outlines.h"
#include "model/packages/body_size.h"

namespace model::formats {

namespace {

/// How far a placed pin may be from where the job says it is: rotations and coordinates are rounded.
constexpr Nm kPinTolerance = 1'000;

bool isNear(Point a, Point b) {
    return std::abs(std::int64_t{a.x} - b.x) <= kPinTolerance && std::abs(std::int64_t{a.y} - b.y) <= kPinTolerance;
}

template <class Rows>
auto* rowOf(Rows& rows, std::int32_t row) {
    return row >= 0 && static_cast<std::size_t>(row) < rows.size() ? &rows[static_cast<std::size_t>(row)] : nullptr;
}

const DrawnPackagePin* packagePinOf(const DrawnPackage* package, const DrawnPin& pin) {
    return package != nullptr ? rowOf(package->pins, pin.packagePin) : nullptr;
}

class PartsMaker {
public:
    PartsMaker(DocumentBuilder& builder, const DrawnStep& step, const DrawnNets& nets)
        : m_builder(builder), m_step(step), m_nets(nets) {}

    void run() {
        for (const DrawnPackage& package : m_step.packages) {
            addPackage(package);
        }
        const std::array<bool, 2> isMirrored{pinsAreMirrored(LayerSide::Top), pinsAreMirrored(LayerSide::Bottom)};
        for (const DrawnComponent& component : m_step.components) {
            const bool isOfSide = isMirrored[component.side == LayerSide::Bottom ? 1 : 0];
            addComponent(component, component.isMirrored.value_or(isOfSide));
        }
    }

private:
    ShapeId shapeOf(const ShapeSketch& sketch) { return sketch.isEmpty() ? ShapeId{} : m_builder.addShape(sketch); }

    void addPackage(const DrawnPackage& from) {
        std::vector<PackagePin> pins;
        pins.reserve(from.pins.size());
        for (const DrawnPackagePin& pin : from.pins) {
            pins.push_back({m_builder.string(pin.name), pin.kind, pin.position, shapeOf(pin.outline)});
        }
        Package package;
        package.name = from.name;
        package.pitch = from.pitch;
        package.box = from.box;
        package.body = shapeOf(from.outline);
        package.properties = addProperties(m_builder, from.properties);
        m_builder.addPackage(std::move(package), pins);
    }

    /// How many of a component's pins a placement puts where the job says they are.
    [[nodiscard]] std::size_t fittingPins(const DrawnComponent& component, bool isMirrored) const {
        const DrawnPackage* package = rowOf(m_step.packages, component.package);
        const Placement placement{component.position, component.clockwiseDeg, isMirrored};
        return static_cast<std::size_t>(std::ranges::count_if(component.pins, [&](const DrawnPin& pin) {
            const DrawnPackagePin* known = packagePinOf(package, pin);
            return known != nullptr && isNear(placement.apply(known->position), pin.position);
        }));
    }

    /// Those of this side that do not say themselves.
    [[nodiscard]] bool pinsAreMirrored(LayerSide side) const {
        std::size_t plain = 0;
        std::size_t mirrored = 0;
        for (const DrawnComponent& component : m_step.components) {
            if (component.side == side && !component.isMirrored) {
                plain += fittingPins(component, false);
                mirrored += fittingPins(component, true);
            }
        }
        return plain == mirrored ? side == LayerSide::Bottom : mirrored > plain;
    }

    void addComponent(const DrawnComponent& from, bool isMirrored) {
        const DrawnPackage* package = rowOf(m_step.packages, from.package);
        std::vector<Pin> pins;
        pins.reserve(from.pins.size());
        std::size_t known = 0;
        for (const DrawnPin& pin : from.pins) {
            pins.push_back(pinFrom(pin, from.package, package));
            known += packagePinOf(package, pin) != nullptr ? 1 : 0;
        }
        if (fittingPins(from, isMirrored) < known) {
            m_builder.diagnostics().report(Severity::Warning, m_step.componentsFile, from.line,
                                           "the pins of a component do not lie where its package puts them; they stay "
                                           "where the job says they are");
        }
        Component component;
        component.refdes = from.refdes;
        component.part = from.part;
        component.package = package != nullptr ? PackageId{static_cast<std::size_t>(from.package)} : PackageId{};
        component.placement = {from.position, from.clockwiseDeg, isMirrored};
        component.isPlaced = from.isPlaced;
        component.side = from.side;
        component.height = from.height;
        component.mount = from.mount;
        component.isPopulated = from.isPopulated;
        component.properties = addProperties(m_builder, from.properties);
        m_builder.addComponent(std::move(component), pins);
    }

    Pin pinFrom(const DrawnPin& from, std::int32_t packageRow, const DrawnPackage* package) {
        const DrawnPackagePin* known = packagePinOf(package, from);
        Pin pin;
        pin.name = m_builder.string(from.name.empty() && known != nullptr ? known->name : from.name);
        pin.position = from.position;
        pin.net = m_nets.net(from.net);
        if (known != nullptr) {
            const Range pins = m_builder.soFar().packages[static_cast<std::size_t>(packageRow)].pins;
            pin.packagePin = pins.first + static_cast<std::uint32_t>(from.packagePin);
        }
        return pin;
    }

    DocumentBuilder& m_builder;
    const DrawnStep& m_step;
    const DrawnNets& m_nets;
};

/// The height a component's body will have, or a little more: outlines are taken for their boxes.
Nm heightOf(const DrawnComponent& component, const DrawnStep& step, Nm boardThickness) {
    PackageFacts facts;
    facts.refdes = component.refdes;
    facts.boardDepth = boardThickness;
    const DrawnPackage* package = rowOf(step.packages, component.package);
    if (package == nullptr) {
        for (const DrawnPin& pin : component.pins) {
            facts.addPin(pin.position, {}, component.mount == MountType::ThroughHole);
        }
        return sizeBody(facts, component.height).height;
    }
    facts.name = package->name;
    for (const DrawnPackagePin& pin : package->pins) {
        facts.addPin(pin.position, boxOf(pin.outline), pin.kind == PinKind::Through);
    }
    facts.setOutline({}, boxOf(package->outline), package->box);
    return sizeBody(facts, component.height).height;
}

}  // namespace

void addParts(DocumentBuilder& builder, const DrawnStep& step, const DrawnNets& nets) {
    PartsMaker(builder, step, nets).run();
}

TallestBodies tallestParts(const DrawnJob& job, const Document& document) {
    TallestBodies tallest;
    tallest.isAlone = job.steps.size() == 1;
    for (const DrawnStep& step : job.steps) {
        for (const DrawnComponent& component : step.components) {
            Nm& side = component.side == LayerSide::Bottom ? tallest.bottom : tallest.top;
            side = std::max(side, heightOf(component, step, document.boardThickness));
        }
    }
    return tallest;
}

void addGroups(DocumentBuilder& builder, const LayerRows& layers, const DrawnStep& step) {
    for (const DrawnGroup& from : step.groups) {
        std::vector<ElementId> elements;
        for (const auto& [row, feature] : from.features) {
            if (row < 0 || feature >= featuresOf(step, static_cast<std::size_t>(row)).size()) {
                builder.diagnostics().report(Severity::Warning, "", 0, "a group names a feature that is not there");
                continue;
            }
            const auto made = elementsOf(builder.soFar(), layers.id(static_cast<std::size_t>(row)), feature);
            elements.insert(elements.end(), made.begin(), made.end());
        }
        std::ranges::sort(elements);
        elements.erase(std::unique(elements.begin(), elements.end()), elements.end());
        ElementGroup group;
        group.type = builder.string(from.type);
        group.properties = addProperties(builder, from.properties);
        builder.addGroup(group, elements);
    }
}

}  // namespace model::formats
