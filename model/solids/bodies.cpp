#include "model/solids/bodies.h"

#include <algorithm>
#include <cmath>

#include "model/board/flip.h"
#include "model/solids/body_floors.h"

namespace model {

namespace {

/// An outline that covers more of the board than this is the board's or that of a card beside it, not a body's, unless
/// the job states how high it is.
constexpr double kMostOfBoard = 0.4;

/// What lies over so many other components is a card on connectors or a shield; without a height it hides them.
constexpr int kMostBelow = 2;
/// Smaller outlines only hold others where they are drawn too large.
constexpr Nm kLeastCard = 10'000'000;

bool isFace(const Layer& layer) {
    return layer.context == LayerContext::Board &&
           (layer.isCopper() || layer.type == LayerType::SolderMask || layer.type == LayerType::Body);
}

/// The lowest and the highest face of copper, substrate and solder mask.
ZRange facesOf(const Document& document) {
    ZRange faces{0, document.boardThickness};
    bool isFirst = true;
    for (const Layer& layer : document.layers) {
        if (isFace(layer)) {
            const Nm top = layer.z + layer.thickness;
            faces = isFirst ? ZRange{layer.z, top} : ZRange{std::min(faces.bottom, layer.z), std::max(faces.top, top)};
            isFirst = false;
        }
    }
    return faces;
}

void setHeights(Layer& layer, const ZRange& faces, const Document& document) {
    const bool isBottom = layer.side == LayerSide::Bottom;
    const Nm floor = layer.spanTop.isValid() ? heightOf(document, BodyFloor{layer.side, layer.spanTop})
                     : isBottom              ? faces.bottom
                                             : faces.top;
    layer.z = isBottom ? floor - layer.thickness : floor;
}

bool isInRange(const Box& box, const Placement& placement) {
    constexpr double kReach = base::kMaxCoordinate;
    for (const Point corner : {box.min, {box.max.x, box.min.y}, box.max, {box.min.x, box.max.y}}) {
        const PointD placed = placement.apply(base::toDouble(corner));
        if (std::abs(placed.x) > kReach || std::abs(placed.y) > kReach) {
            return false;
        }
    }
    return true;
}

class BodyMaker {
public:
    explicit BodyMaker(DocumentBuilder& builder)
        : m_builder(builder), m_document(builder.soFar()), m_plans(builder.soFar()) {
        FloorFinder finder(m_document);
        for (std::size_t row = 0; row < m_document.components.size(); ++row) {
            const LayerSide side = m_document.components[row].side;
            m_floors.push_back(finder.isEven() ? BodyFloor{side, {}} : finder.at(side, locationsOf(ComponentId{row})));
        }
    }

    [[nodiscard]] bool isUsed(const BodyFloor& floor) const {
        return std::ranges::find(m_floors, floor) != m_floors.end();
    }

    void addLayer(const BodyFloor& floor, Nm thickness, const ZRange& faces) {
        Layer layer;
        layer.name = floor.side == LayerSide::Top ? "bodies top" : "bodies bottom";
        layer.name += floor.on.isValid() ? " on " + m_document.layer(floor.on).name : "";
        layer.type = LayerType::ComponentBody;
        layer.side = floor.side;
        layer.isSynthetic = true;
        layer.spanTop = floor.on;
        layer.thickness = thickness;
        layer.thicknessSource = Source::Derived;
        setHeights(layer, faces, m_document);
        m_builder.beginLayer(m_builder.addLayer(std::move(layer)));
        for (std::size_t row = 0; row < m_document.components.size(); ++row) {
            if (m_floors[row] == floor) {
                addBody(ComponentId{row});
            }
        }
    }

private:
    void report(Severity severity, const char* text, ElementId element = {}) {
        m_builder.diagnostics().report(severity, "", 0, text, element);
    }

    void addBody(ComponentId id) {
        const Component component = m_document.components[id.row()];
        if (!component.isPopulated) {
            return report(Severity::Info, "a component that is not populated has no body");
        }
        const BodyPlan& plan = m_plans.of(id);
        const Placement placement = component.package.isValid() ? component.placement : Placement{};
        if (!mayStand(id, plan, placement)) {
            return;
        }
        const ElementId element = m_builder.addArea({shapeOf(plan), placement}, {});
        m_builder.addBody({element, id, plan.height, plan.isHeightAssumed ? Source::Assumed : Source::Job});
        reportOutline(plan, element);
        reportHeight(component.height, element);
    }

    /// Where to look for what a component stands on: in its middle, or else, where that is beside the board, at its
    /// pins.
    [[nodiscard]] std::vector<Point> locationsOf(ComponentId id) {
        const Component& component = m_document.components[id.row()];
        std::vector<Point> locations;
        const Placement placement = component.package.isValid() ? component.placement : Placement{};
        const Box& box = m_plans.of(id).box;
        if (!box.isEmpty() && isInRange(box, placement)) {
            const Box placed = placement.boxOf(box);
            locations.push_back({static_cast<Nm>(placed.min.x + placed.width() / 2),
                                 static_cast<Nm>(placed.min.y + placed.height() / 2)});
        }
        for (const Pin& pin : m_document.pinsOf(component)) {
            locations.push_back(pin.position);
        }
        return locations;
    }

    /// Reports why not.
    bool mayStand(ComponentId id, const BodyPlan& plan, const Placement& placement) {
        const Component& component = m_document.components[id.row()];
        if (plan.box.isEmpty()) {
            const std::uint32_t pins = component.package.isValid()
                                           ? m_document.packages[component.package.row()].pins.count
                                           : component.pinCount;
            report(Severity::Info, pins == 0 ? "a component without pins has no body"
                                             : "a component that is bare copper or a hole (test point, fiducial, "
                                               "mounting hole, jumper of solder) has no body");
            return false;
        }
        if (!isInRange(plan.box, placement)) {
            report(Severity::Warning, "a component reaches out of the coordinate range of ±1.07 m; it has no body");
            return false;
        }
        if (plan.isHeightAssumed && coversBoard(plan.box)) {
            report(Severity::Info,
                   "the outline of a component without a height covers more than 40 % of the board; it has no body");
            return false;
        }
        if (plan.isHeightAssumed && liesOverOthers(id, plan.box, placement)) {
            report(Severity::Info, "a component without a height lies over other components; it has no body");
            return false;
        }
        return true;
    }

    [[nodiscard]] bool liesOverOthers(ComponentId id, const Box& box, const Placement& placement) const {
        if (box.width() < kLeastCard || box.height() < kLeastCard) {
            return false;
        }
        const Box placed = placement.boxOf(box);
        int below = 0;
        for (std::size_t row = 0; row < m_document.components.size(); ++row) {
            const Component& other = m_document.components[row];
            const std::span<const Pin> pins = m_document.pinsOf(other);
            const bool isInside = std::ranges::all_of(pins, [&](const Pin& pin) { return placed.holds(pin.position); });
            below +=
                row != id.row() && other.side == m_document.components[id.row()].side && pins.size() > 1 && isInside
                    ? 1
                    : 0;
        }
        return below > kMostBelow;
    }

    [[nodiscard]] bool coversBoard(const Box& box) const {
        const auto areaOf = [](const Box& of) {
            return static_cast<double>(of.width()) * static_cast<double>(of.height());
        };
        return m_document.profile.isValid() &&
               areaOf(box) > kMostOfBoard * areaOf(m_document.shapes.shapes[m_document.profile.row()].box);
    }

    void reportOutline(const BodyPlan& plan, ElementId element) {
        if (plan.outlineSource == OutlineSource::None) {
            report(Severity::Info, "a package has no outline; the size of its body follows from its pads", element);
        } else if (plan.outlineSource == OutlineSource::Dot) {
            report(Severity::Info,
                   "the outline of a package is a dot between its pins; the size of its body follows from its pads",
                   element);
        } else if (plan.outlineSource == OutlineSource::Stated) {
            report(Severity::Info,
                   "a package draws no outline; the size of its body follows from the box it states and its pads",
                   element);
        } else if (!plan.isAsDrawn) {
            report(
                Severity::Info,
                "the outline of a package holds more than its body (pads or a courtyard); the size of its body follows "
                "from its pads and its family",
                element);
        }
    }

    void reportHeight(Nm stated, ElementId element) {
        if (stated <= 0) {
            report(Severity::Info,
                   "the job gives no height for a component; a height usual for its package is assumed for its body",
                   element);
        } else if (!isPlausibleHeight(stated)) {
            report(Severity::Warning,
                   "the height of a component is below 0.1 or above 150 mm; a height usual for its package is assumed "
                   "for its body",
                   element);
        }
    }

    /// Made once for all components of a plan.
    ShapeId shapeOf(const BodyPlan& plan) {
        ShapeId& shape = m_shapes[&plan];
        if (!shape.isValid()) {
            shape = m_builder.addShape(sketchOf(plan.outline));
        }
        return shape;
    }

    DocumentBuilder& m_builder;
    const Document& m_document;
    BodyPlans m_plans;
    std::map<const BodyPlan*, ShapeId> m_shapes;
    std::vector<BodyFloor> m_floors;  ///< by component
};

}  // namespace

void addBodies(DocumentBuilder& builder, const TallestBodies& tallest) {
    const ZRange faces = facesOf(builder.soFar());
    BodyMaker maker(builder);
    const std::vector<BodyFloor> floors = bodyFloorsOf(builder.soFar());
    const bool areAllNeeded = !tallest.isAlone || floors.size() == 2;
    for (const BodyFloor& floor : floors) {
        const Nm thickness = floor.side == LayerSide::Top ? tallest.top : tallest.bottom;
        const bool isNeeded = areAllNeeded || maker.isUsed(floor);
        if (thickness > 0 && isNeeded) {
            maker.addLayer(floor, thickness, faces);
        }
    }
    setSyntheticOpposites(builder.layers());
}

void placeBodies(Document& document) {
    const ZRange faces = facesOf(document);
    for (Layer& layer : document.layers) {
        if (layer.type == LayerType::ComponentBody) {
            setHeights(layer, faces, document);
        }
    }
}

}  // namespace model
