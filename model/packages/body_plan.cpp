#include "model/packages/body_plan.h"

#include <cmath>

#include "model/packages/body_parts.h"

namespace model {

namespace {

/// The housing of a header, of all that stands over the board.
constexpr double kHousing = 0.3;

bool isRound(PackageFamily family) {
    return family == PackageFamily::CanCapacitor || family == PackageFamily::Radial || family == PackageFamily::Post;
}

bool hasDrawnShape(PackageFamily family) {
    return family == PackageFamily::Connector || family == PackageFamily::Other || family == PackageFamily::ThroughHole;
}

/// The drawn outline, fitted into a box.
PolygonSet fitted(const PackageFacts& facts, const Box& box) {
    const auto map = [](Nm at, Nm from, std::int64_t length, Nm to, std::int64_t wanted) {
        return static_cast<Nm>(to + std::llround(static_cast<double>(at - from) * static_cast<double>(wanted) /
                                                 static_cast<double>(length)));
    };
    PolygonSet polygons = facts.outline;
    for (Point& p : polygons.points) {
        p = {map(p.x, facts.box.min.x, facts.box.width(), box.min.x, box.width()),
             map(p.y, facts.box.min.y, facts.box.height(), box.min.y, box.height())};
    }
    return polygons;
}

PolygonSet outlineOf(const PackageFacts& facts, PackageFamily family, const Box& box) {
    if (hasDrawnShape(family) && !facts.outline.polygons.empty() && facts.box.width() > 0 && facts.box.height() > 0) {
        return fitted(facts, box);
    }
    PolygonSet outline;
    if (isRound(family)) {
        addDisc(box.middle(), static_cast<Nm>(std::min(box.width(), box.height()) / 2), outline);
    } else {
        addBox(box, outline);
    }
    return outline;
}

BodyMaterial materialOf(PackageFamily family, PartKind kind) {
    switch (family) {
        case PackageFamily::CanCapacitor:
        case PackageFamily::Crystal:
        case PackageFamily::Post: return BodyMaterial::Metal;
        case PackageFamily::Connector: return kind == PartKind::Switch ? BodyMaterial::Moulding : BodyMaterial::Housing;
        case PackageFamily::TwoLeads:
            return kind == PartKind::Capacitor  ? BodyMaterial::Tantalum
                   : kind == PartKind::Inductor ? BodyMaterial::Ferrite
                                                : BodyMaterial::Moulding;
        default: break;
    }
    switch (kind) {
        case PartKind::Capacitor: return family == PackageFamily::Chip ? BodyMaterial::Ceramic : BodyMaterial::Moulding;
        case PartKind::Resistor: return BodyMaterial::Resistor;
        case PartKind::Inductor: return BodyMaterial::Ferrite;
        case PartKind::Led: return BodyMaterial::Lens;
        default: return BodyMaterial::Moulding;
    }
}

void transpose(BodyPlan& plan) {
    plan.outline = transposed(plan.outline);
    plan.box = transposed(plan.box);
    plan.label = transposed(plan.label);
    for (BodyPart& part : plan.parts) {
        part.polygons = transposed(part.polygons);
    }
}

}  // namespace

BodyPlan planBody(const PackageFacts& given, Nm statedHeight) {
    const BodySize size = sizeBody(given, statedHeight);
    BodyPlan plan;
    plan.family = size.family;
    if (size.box.isEmpty()) {
        return plan;
    }
    const bool isTurned = size.pattern.isAlongY;
    const PackageFacts facts = isTurned ? transposed(given) : given;
    plan.outlineSource = given.outlineSource;
    plan.isAsDrawn = isAsDrawn(size, given);
    plan.box = isTurned ? transposed(size.box) : size.box;
    plan.outline = outlineOf(facts, plan.family, plan.box);
    plan.height = size.height;
    plan.isHeightAssumed = size.isHeightAssumed;
    plan.bodyTop = plan.family == PackageFamily::Header ? scaled(plan.height, kHousing) : plan.height;
    plan.material = materialOf(plan.family, size.kind);
    addBodyParts(facts, size.kind, plan);
    if (isTurned) {
        transpose(plan);
    }
    return plan;
}

const BodyPlan& BodyPlans::of(ComponentId id) {
    const Component& component = m_document.components[id.row()];
    const bool hasPackage = component.package.isValid();
    const std::string_view package =
        hasPackage ? m_document.packages[component.package.row()].name : std::string_view{};
    const Key key{hasPackage ? component.package.value : 0, hasPackage ? 0 : id.value + 1,
                  kindOf(component.refdes, package), isJumperName(component.refdes), component.height};
    const auto [found, isNew] = m_plans.try_emplace(key);
    if (isNew) {
        found->second = planBody(factsOf(m_document, component), component.height);
    }
    return found->second;
}

}  // namespace model
