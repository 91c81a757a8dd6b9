#include "model/formats/ipc2581/shapes/primitives.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>

#include "model/formats/ipc2581/shapes/ring_shapes.h"
#include "model/formats/ipc2581/xml/xml_values.h"
#include "model/geometry/outlines.h"

namespace model::ipc2581 {

namespace {

using formats::PadShape;

/// Half a metre: shapes placed anywhere in the coordinate range then stay within 32 bits.
constexpr double kMostSize = base::kMaxCoordinate / 2.0;
/// So many spokes or rings at most: a limit of ours, far from what boards use.
constexpr double kMostPieces = 100.0;

Nm whole(double nm) {
    return static_cast<Nm>(std::llround(nm));
}

/// Reads sizes and remembers what is wrong with them.
class Sizes {
public:
    Sizes(const XmlCursor& at, double nm) : m_at(at), m_nm(nm) {}

    /// A size that has to be there.
    double length(std::string_view attribute) {
        const std::optional<double> value = realOf(m_at.value(attribute));
        if (!value || *value < 0) {
            m_problem = "lacks a size or has a negative one; it draws nothing";
        }
        return within(value.value_or(0.0) * m_nm);
    }
    double lengthOr(std::string_view attribute, double otherwise) {
        return m_at.value(attribute).empty() ? otherwise : length(attribute);
    }
    double coordinate(std::string_view attribute) {
        const std::optional<double> value = realOf(m_at.value(attribute));
        if (!value) {
            m_problem = "lacks a corner; it draws nothing";
        }
        return within(value.value_or(0.0) * m_nm);
    }
    double degrees(std::string_view attribute) { return realOf(m_at.value(attribute)).value_or(0.0); }
    int pieces(std::string_view attribute, double otherwise) {
        const double count = realOf(m_at.value(attribute)).value_or(otherwise);
        if (count < 0 || count > kMostPieces) {
            m_problem = "counts pieces below 0 or above 100; it draws nothing";
            return 0;
        }
        return static_cast<int>(std::lround(count));
    }
    /// Which corners are rounded or cut: those that say so, all where none says anything.
    [[nodiscard]] unsigned corners() const {
        static constexpr std::array<std::string_view, 4> kNames = {"upperRight", "upperLeft", "lowerLeft",
                                                                   "lowerRight"};
        unsigned corners = 0;
        bool isSaid = false;
        for (std::size_t i = 0; i < kNames.size(); ++i) {
            isSaid = isSaid || !m_at.value(kNames[i]).empty();
            corners |= isTrue(m_at.value(kNames[i])) ? 1U << i : 0U;
        }
        return isSaid ? corners : kAllCorners;
    }
    [[nodiscard]] std::string_view form() const { return m_at.value("shape"); }
    [[nodiscard]] std::string_view problem() const { return m_problem; }

private:
    double within(double nm) {
        if (std::abs(nm) > kMostSize) {
            m_problem = "is larger than half a metre; it draws nothing";
            return 0.0;
        }
        return nm;
    }

    const XmlCursor& m_at;
    double m_nm;
    std::string_view m_problem;
};

PadShape region(ShapeSketch sketch) {
    PadShape shape;
    shape.kind = PadShape::Kind::Region;
    shape.region = std::move(sketch);
    return shape;
}

PadShape sized(PadShape::Kind kind, double width, double height) {
    PadShape shape;
    shape.kind = kind;
    shape.width = whole(width);
    shape.height = whole(height);
    return shape;
}

template <class Draw>
PadShape drawn(const Draw& draw) {
    ShapeSketch sketch;
    draw(sketch);
    return region(std::move(sketch));
}

PadShape circle(Sizes& sizes) {
    return sized(PadShape::Kind::Round, sizes.length("diameter"), 0);
}

PadShape oval(Sizes& sizes) {
    const double width = sizes.length("width");
    return sized(PadShape::Kind::Oval, width, sizes.length("height"));
}

PadShape rectCenter(Sizes& sizes) {
    const double width = sizes.length("width");
    const double height = sizes.length("height");
    PadShape shape = drawn([&](ShapeSketch& sketch) { addBox(sketch, width, height, false); });
    shape.width = whole(width);
    shape.height = whole(height);
    shape.isSquarePen = shape.width == shape.height;
    return shape;
}

PadShape rectCorner(Sizes& sizes) {
    const Point a = rounded({sizes.coordinate("lowerLeftX"), sizes.coordinate("lowerLeftY")});
    const Point b = rounded({sizes.coordinate("upperRightX"), sizes.coordinate("upperRightY")});
    Box box;
    box.include(a);
    box.include(b);
    return drawn([&](ShapeSketch& sketch) { addBox(sketch, box); });
}

PadShape cornered(Sizes& sizes, const char* corner, CornerStyle style) {
    const double width = sizes.length("width");
    const double height = sizes.length("height");
    const double size = sizes.length(corner);
    return drawn([&](ShapeSketch& sketch) {
        addCornerBox(sketch, width, height, size, size > 0 ? sizes.corners() : 0U, style, false);
    });
}

PadShape rectRound(Sizes& sizes) {
    return cornered(sizes, "radius", CornerStyle::Rounded);
}

PadShape rectCham(Sizes& sizes) {
    return cornered(sizes, "chamfer", CornerStyle::Chamfered);
}

PadShape diamond(Sizes& sizes) {
    const double x = sizes.length("width") / 2;
    const double y = sizes.length("height") / 2;
    return drawn([&](ShapeSketch& sketch) {
        addLoop(sketch, std::array<PointD, 4>{{{x, 0}, {0, y}, {-x, 0}, {0, -y}}}, false);
    });
}

PadShape triangle(Sizes& sizes) {
    const double x = sizes.length("base") / 2;
    const double y = sizes.length("height") / 2;
    return drawn([&](ShapeSketch& sketch) {
        addLoop(sketch, std::array<PointD, 3>{{{0, y}, {-x, -y}, {x, -y}}}, false);
    });
}

PadShape ellipse(Sizes& sizes) {
    const double width = sizes.length("width");
    const double height = sizes.length("height");
    return drawn([&](ShapeSketch& sketch) { addEllipse(sketch, width, height); });
}

PadShape hexagon(Sizes& sizes) {
    const double length = sizes.length("length");
    return drawn([&](ShapeSketch& sketch) { addRingSide(sketch, "HEXAGON", length, false); });
}

PadShape octagon(Sizes& sizes) {
    const double length = sizes.length("length");
    return drawn([&](ShapeSketch& sketch) { addRingSide(sketch, "OCTAGON", length, false); });
}

PadShape donut(Sizes& sizes) {
    const double outer = sizes.length("outerDiameter");
    const double inner = sizes.length("innerDiameter");
    if (inner >= outer) {
        return {};
    }
    const std::string_view form = sizes.form();
    if (form.empty() || form == "ROUND") {
        return sized(inner > 0 ? PadShape::Kind::Ring : PadShape::Kind::Round, outer, inner);
    }
    return drawn([&](ShapeSketch& sketch) {
        addRingSide(sketch, form, outer, false);
        if (inner > 0) {
            addRingSide(sketch, form, inner, true);
        }
    });
}

PadShape thermalShape(Sizes& sizes) {
    return region(thermal(
        sizes.form(), {sizes.length("outerDiameter"), sizes.length("innerDiameter"), sizes.pieces("spokeCount", 4.0),
                       sizes.lengthOr("spokeWidth", 0.0), sizes.degrees("spokeStartAngle")}));
}

PadShape moireShape(Sizes& sizes) {
    return region(moire({sizes.length("diameter"), sizes.length("ringWidth"), sizes.length("ringGap"),
                         sizes.pieces("ringNumber", 0.0), sizes.lengthOr("lineWidth", 0.0),
                         sizes.lengthOr("lineLength", 0.0), sizes.degrees("lineAngle")}));
}

/// Two opposite quarters: top left and bottom right.
PadShape butterfly(Sizes& sizes) {
    const bool isSquare = sizes.form() == "SQUARE";
    const double h = isSquare ? sizes.lengthOr("side", 0.0) / 2 : sizes.lengthOr("diameter", 0.0) / 2;
    const Nm r = whole(h);
    const EdgeKind edge = isSquare ? EdgeKind::Line : EdgeKind::ArcCounterClockwise;
    return drawn([&](ShapeSketch& sketch) {
        for (const Nm sign : {1, -1}) {
            std::vector<PathNode> nodes = {{{0, 0}, {}, EdgeKind::Line}, {{0, sign * r}, {}, edge}};
            if (isSquare) {
                nodes.push_back({{-sign * r, sign * r}, {}, EdgeKind::Line});
            }
            nodes.push_back({{-sign * r, 0}, {}, EdgeKind::Line});
            addPath(sketch, nodes, false);
        }
    });
}

struct Rule {
    std::string_view element;
    PadShape (*make)(Sizes&);
    std::string_view sizes;  ///< the attributes that tell it, lengths before '|', with blanks between
};

constexpr Rule kRules[] = {
    {"Circle", circle, "diameter"},
    {"RectCenter", rectCenter, "width height"},
    {"RectRound", rectRound, "width height radius|upperRight upperLeft lowerLeft lowerRight"},
    {"Oval", oval, "width height"},
    {"RectCham", rectCham, "width height chamfer|upperRight upperLeft lowerLeft lowerRight"},
    {"RectCorner", rectCorner, "lowerLeftX lowerLeftY upperRightX upperRightY"},
    {"Donut", donut, "outerDiameter innerDiameter|shape"},
    {"Thermal", thermalShape, "outerDiameter innerDiameter spokeWidth|shape spokeCount spokeStartAngle"},
    {"Butterfly", butterfly, "diameter side|shape"},
    {"Diamond", diamond, "width height"},
    {"Hexagon", hexagon, "length"},
    {"Octagon", octagon, "length"},
    {"Ellipse", ellipse, "width height"},
    {"Triangle", triangle, "base height"},
    {"Moire", moireShape, "diameter ringWidth ringGap lineWidth lineLength|ringNumber lineAngle"},
};

const Rule* ruleOf(std::string_view element) {
    const auto* const rule = std::ranges::find(kRules, element, &Rule::element);
    return rule == std::end(kRules) ? nullptr : rule;
}

std::string millimetres(double nm) {
    std::array<char, 32> text{};
    const double value = std::round(nm) / base::kNmPerMm;
    const auto [end, error] = std::to_chars(text.data(), text.data() + text.size(), value);
    return {text.data(), error == std::errc() ? end : text.data()};
}

bool hasArea(const ShapeSketch& sketch) {
    for (std::size_t i = 0; i < sketch.contourCount(); ++i) {
        const PathNodes nodes = sketch.contour(i);
        if (nodes.size() > 2 ||
            std::ranges::any_of(nodes, [](const PathNode& node) { return node.edge != EdgeKind::Line; })) {
            return true;
        }
    }
    return false;
}

}  // namespace

bool isPrimitive(std::string_view element) {
    return ruleOf(element) != nullptr;
}

PadShape primitiveShape(const XmlCursor& at, double nm) {
    Sizes sizes(at, nm);
    PadShape shape = ruleOf(at.name())->make(sizes);
    const bool isEmpty = shape.kind == PadShape::Kind::Region ? !hasArea(shape.region) : shape.width <= 0;
    if (!sizes.problem().empty() || isEmpty) {
        shape = {};
        shape.problem = sizes.problem().empty() ? "has no area; it draws nothing" : sizes.problem();
    }
    return shape;
}

std::string primitiveName(const XmlCursor& at, double nm) {
    std::string name(at.name());
    std::string_view sizes = ruleOf(at.name())->sizes;
    bool isLength = true;
    while (!sizes.empty()) {
        const std::size_t end = std::min(sizes.find_first_of(" |"), sizes.size());
        const std::string_view value = at.value(sizes.substr(0, end));
        const std::optional<double> number = realOf(value);
        if (!value.empty()) {
            name += ' ';
            name += isLength && number ? millimetres(*number * nm) : textOf(value);
        }
        isLength = isLength && (end == sizes.size() || sizes[end] != '|');
        sizes.remove_prefix(std::min(end + 1, sizes.size()));
    }
    return name;
}

}  // namespace model::ipc2581
