#include "model/solids/bodies.h"

#include <array>
#include <cmath>

namespace model {

namespace {

/// Half the width of a pin that the job draws no outline of.
constexpr Nm kHalfPin = 250'000;

constexpr const char* kBoxOfPins = "a package has no outline; the box of its pins is taken for its body";
constexpr const char* kTooSmall =
    "the outline of a package is a dot between its pins; the box around them is taken for its body";

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

void setHeights(Layer& layer, const ZRange& faces) {
    layer.z = layer.side == LayerSide::Bottom ? faces.bottom - layer.thickness : faces.top;
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
        : m_builder(builder), m_document(builder.soFar()), m_outlines(builder.soFar().packages.size()) {}

    void addLayer(LayerSide side, Nm thickness, const ZRange& faces) {
        if (thickness <= 0) {
            return;
        }
        Layer layer;
        layer.name = side == LayerSide::Top ? "component bodies top" : "component bodies bottom";
        layer.type = LayerType::ComponentBody;
        layer.side = side;
        layer.isSynthetic = true;
        layer.thickness = thickness;
        layer.thicknessSource = Source::Derived;
        setHeights(layer, faces);
        m_builder.beginLayer(m_builder.addLayer(std::move(layer)));
        for (std::size_t row = 0; row < m_document.components.size(); ++row) {
            if (m_document.components[row].side == side) {
                addBody(ComponentId{row});
            }
        }
    }

private:
    /// An outline and from where it comes: nullptr if the package draws it, else what to report.
    struct Outline {
        ShapeId shape;
        const char* message = nullptr;
        bool isKnown = false;
    };

    void report(Severity severity, const char* text, ElementId element = {}) {
        m_builder.diagnostics().report(severity, "", 0, text, element);
    }

    void addBody(ComponentId id) {
        const Component component = m_document.components[id.row()];
        if (!component.isPopulated) {
            return report(Severity::Info, "a component that is not populated has no body");
        }
        const bool hasPackage = component.package.isValid();
        const Outline outline = hasPackage ? ofPackage(component.package) : ofPins(component);
        const Placement placement = hasPackage ? component.placement : Placement{};
        if (!outline.shape.isValid()) {
            return report(Severity::Warning, outline.message);
        }
        if (!isInRange(m_document.shapes.shapes[outline.shape.row()].box, placement)) {
            return report(Severity::Warning,
                          "a component reaches out of the coordinate range of ±1.07 m; it has no body");
        }
        const ElementId element = m_builder.addArea({outline.shape, placement}, {});
        m_builder.addBody({element, id, bodyHeight(component.height),
                           component.height > 0 && component.height <= kMostBody ? Source::Job : Source::Assumed});
        if (outline.message != nullptr) {
            report(Severity::Info, outline.message, element);
        }
        reportHeight(component.height, element);
    }

    void reportHeight(Nm stated, ElementId element) {
        if (stated <= 0) {
            report(Severity::Info, "the job gives no height for a component; its body is taken as 1 mm high", element);
        } else if (stated > kMostBody) {
            report(Severity::Warning, "the height of a component is absurd; its body is taken as 150 mm high", element);
        }
    }

    /// Made once for all components of the package.
    const Outline& ofPackage(PackageId id) {
        Outline& outline = m_outlines[id.row()];
        if (!outline.isKnown) {
            outline = outlineOf(m_document.packages[id.row()]);
            outline.isKnown = true;
        }
        return outline;
    }

    Outline outlineOf(const Package& package) {
        const Box pins = boxOfPins(package);
        if (package.body.isValid()) {
            const bool isBelieved = !isPlaceholder(m_document.shapes.shapes[package.body.row()].box, pins);
            return isBelieved ? Outline{package.body} : withoutOutline(package.box, pins, kTooSmall, kTooSmall);
        }
        return withoutOutline(package.box, pins, "a package draws no outline; the box it states is taken for its body",
                              kBoxOfPins);
    }

    /// Some programs write a dot where they know no outline (odb-notes, Nets and parts).
    static bool isPlaceholder(const Box& outline, const Box& pins) {
        return 4 * outline.width() < pins.width() && 4 * outline.height() < pins.height();
    }

    Outline withoutOutline(const Box& stated, const Box& pins, const char* ofStated, const char* ofPins) {
        const bool isStated = stated.width() > 0 && stated.height() > 0;
        return isStated ? Outline{boxShape(stated), ofStated} : ofBox(pins, ofPins);
    }

    [[nodiscard]] Box boxOfPins(const Package& package) const {
        Box pins;
        for (std::uint32_t i = package.pins.first; i < package.pins.first + package.pins.count; ++i) {
            const PackagePin& pin = m_document.packagePins[i];
            const bool isDrawn = pin.outline.isValid();
            pins.include(isDrawn ? m_document.shapes.shapes[pin.outline.row()].box : around(pin.position));
        }
        return pins;
    }

    /// Of a component whose package is not known.
    Outline ofPins(const Component& component) {
        Box pins;
        for (const Pin& pin : m_document.pinsOf(component)) {
            pins.include(around(pin.position));
        }
        return ofBox(pins, kBoxOfPins);
    }

    Outline ofBox(const Box& pins, const char* message) {
        if (pins.width() <= 0 || pins.height() <= 0) {
            return {{}, "a component has neither an outline nor pins; it has no body"};
        }
        return {boxShape(pins), message};
    }

    static Box around(Point pin) {
        Box box;
        box.include(pin);
        return box.grownBy(kHalfPin);
    }

    ShapeId boxShape(const Box& box) {
        ShapeSketch sketch;
        const std::array<Point, 4> corners{{box.min, {box.max.x, box.min.y}, box.max, {box.min.x, box.max.y}}};
        sketch.addPolygon(corners, false);
        return m_builder.addShape(sketch);
    }

    DocumentBuilder& m_builder;
    const Document& m_document;
    std::vector<Outline> m_outlines;  ///< by package
};

}  // namespace

void addBodies(DocumentBuilder& builder, const TallestBodies& tallest) {
    const ZRange faces = facesOf(builder.soFar());
    BodyMaker maker(builder);
    maker.addLayer(LayerSide::Top, tallest.top, faces);
    maker.addLayer(LayerSide::Bottom, tallest.bottom, faces);
}

void placeBodies(Document& document) {
    const ZRange faces = facesOf(document);
    for (Layer& layer : document.layers) {
        if (layer.type == LayerType::ComponentBody) {
            setHeights(layer, faces);
        }
    }
}

}  // namespace model
