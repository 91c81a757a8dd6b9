#include "model/formats/gerber/image/apertures.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

#include "model/formats/gerber/image/expression.h"
#include "model/formats/gerber/image/primitives.h"
#include "model/formats/gerber/text/words.h"
#include "model/geometry/loops/region_booleans.h"
#include "model/geometry/outlines.h"

namespace model::gerber {

namespace {

using formats::PadShape;

/// Which values of a primitive are lengths; all others are numbers and angles. Outlines have as many as they like.
bool isLength(int code, std::size_t index) {
    switch (code) {
        case 1: return index >= 1 && index <= 3;
        case 2:
        case 20: return index >= 1 && index <= 5;
        case 21:
        case 22: return index >= 1 && index <= 4;
        case 5: return index >= 2 && index <= 4;
        case 6: return index != 5 && index <= 7;
        case 7: return index <= 4;
        default: return false;
    }
}

void toNanometres(int code, std::vector<double>& values, double nmPerUnit) {
    const std::size_t ends =
        code == 4 && values.size() > 1 && values[1] >= 0 && values[1] < static_cast<double>(values.size())
            ? 4 + 2 * static_cast<std::size_t>(values[1])
            : 0;
    for (std::size_t i = 0; i < values.size(); ++i) {
        if (isLength(code, i) || (i >= 2 && i < ends)) {
            values[i] *= nmPerUnit;
        }
    }
}

bool isAbsurd(double length) {
    return !(std::abs(length) <= base::kMaxCoordinate / 2.0);
}

/// In the middle: round, or the rectangle of old files.
void addCut(ShapeSketch& sketch, double width, double height, bool isHole) {
    if (height > 0) {
        addBox(sketch, width, height, isHole);
    } else {
        addDisc(sketch, width, isHole);
    }
}

/// A hole lies within the shape; one that does not takes away what it covers.
PadShape withHole(const PadShape& shape, double width, double height, std::vector<std::string>& problems) {
    ShapeSketch hole;
    addCut(hole, width, height, false);
    PadShape rest = combined({{true, regionsOf(formats::outlineOf(shape)), {}}, {false, regionsOf(hole), {}}});
    const bool isWithin = rest.region.contourCount() == 2 && rest.region.isHole(1);
    if (!isWithin) {
        problems.emplace_back("an aperture has a hole that reaches beyond it; what it covers is taken away");
        return rest;
    }
    PadShape result;
    result.kind = PadShape::Kind::Region;
    result.region = formats::outlineOf(shape);
    addCut(result.region, width, height, true);
    return result;
}

void addHole(PadShape& shape, std::span<const double> hole, double nmPerUnit, std::vector<std::string>& problems) {
    const double width = hole[0] * nmPerUnit;
    const double height = hole.size() > 1 ? hole[1] * nmPerUnit : 0.0;
    if (width < 0 || height < 0 || isAbsurd(width) || isAbsurd(height)) {
        problems.emplace_back("an aperture has a hole of an absurd size, which is left out");
    } else if (shape.kind == PadShape::Kind::Round && height <= 0 && width > 0 && width < shape.width) {
        shape.kind = PadShape::Kind::Ring;
        shape.height = static_cast<Nm>(std::nearbyint(width));
    } else if (width > 0) {
        shape = withHole(shape, width, height, problems);
    }
}

PadShape regularPolygon(std::span<const double> p, double nmPerUnit, std::vector<std::string>& problems) {
    PadShape shape;
    CornerCount corners = cornersOfPolygon(p[1]);
    if (!corners.problem.empty()) {
        problems.push_back(std::move(corners.problem));
    }
    const int n = corners.count;
    if (n == 0) {
        return shape;
    }
    const double turn = (p.size() > 2 ? p[2] : 0.0) * std::numbers::pi / 180.0;
    std::vector<PointD> loop;
    for (int i = 0; i < n; ++i) {
        const double angle = turn + 2 * std::numbers::pi * i / n;
        loop.push_back({p[0] / 2 * nmPerUnit * std::cos(angle), p[0] / 2 * nmPerUnit * std::sin(angle)});
    }
    shape.kind = PadShape::Kind::Region;
    addLoop(shape.region, loop, false);
    return shape;
}

PadShape sized(PadShape::Kind kind, double width, double height) {
    PadShape shape;
    shape.kind = width > 0.5 && height > 0.5 ? kind : PadShape::Kind::Nothing;
    shape.width = static_cast<Nm>(std::nearbyint(width));
    shape.height = static_cast<Nm>(std::nearbyint(height));
    if (kind == PadShape::Kind::Oval && shape.width == shape.height && shape.kind == kind) {
        shape.kind = PadShape::Kind::Round;
    }
    return shape;
}

PadShape rectangle(double width, double height) {
    PadShape shape;
    if (width > 0.5 && height > 0.5) {
        shape.kind = PadShape::Kind::Region;
        addBox(shape.region, width, height, false);
        shape.width = static_cast<Nm>(std::nearbyint(width));
        shape.height = static_cast<Nm>(std::nearbyint(height));
        shape.isSquarePen = shape.width == shape.height;
    }
    return shape;
}

}  // namespace

Macro::Macro(std::string_view body) {
    std::string plain;
    plain.reserve(body.size());
    std::ranges::copy_if(body, std::back_inserter(plain),
                         [](char c) { return c != ' ' && c != '\n' && c != '\r' && c != '\t'; });
    for (const std::string_view statement : split(plain, '*')) {
        if (!statement.empty() && statement.front() != '0') {
            m_statements.emplace_back(statement);
        }
    }
}

PadShape Macro::shape(std::span<const double> parameters, double nmPerUnit, std::vector<std::string>& problems) const {
    MacroVariables variables;
    for (std::size_t i = 0; i < parameters.size(); ++i) {
        variables[static_cast<int>(i) + 1] = parameters[i];
    }
    std::vector<Primitive> primitives;
    for (const std::string_view statement : m_statements) {
        const std::size_t equals = statement.starts_with('$') ? statement.find('=') : std::string_view::npos;
        if (equals != std::string_view::npos) {
            const std::optional<int> number = parseInteger(statement.substr(1, equals - 1));
            const std::optional<double> value = evaluate(statement.substr(equals + 1), variables);
            if (!number || !value) {
                problems.emplace_back(
                    "an aperture macro has an expression that cannot be read; the variable was left as it is");
                continue;
            }
            variables[*number] = *value;
            continue;
        }
        std::vector<double> values;
        bool isGood = true;
        for (const std::string_view part : split(statement, ',')) {
            const std::optional<double> value = part.empty() ? std::optional(0.0) : evaluate(part, variables);
            isGood = isGood && value.has_value();
            values.push_back(value.value_or(0.0));
        }
        const int code = isGood && std::abs(values[0]) < 1000 ? static_cast<int>(values[0]) : -1;
        values.erase(values.begin());
        toNanometres(code, values, nmPerUnit);
        Primitive one = primitive(code, values);
        if (!one.problem.empty()) {
            problems.push_back(std::move(one.problem));
        }
        primitives.push_back(std::move(one));
    }
    return combined(std::move(primitives));
}

/// The last of its sizes is the height of a hole.
std::size_t mostSizes(char letter) {
    return letter == 'C' ? 3 : letter == 'P' ? 5 : 4;
}

PadShape standardAperture(char letter, std::span<const double> p, double nmPerUnit, std::vector<std::string>& problems,
                          bool& isKnown) {
    isKnown = letter == 'C' || letter == 'R' || letter == 'O' || letter == 'P';
    const std::size_t needed = letter == 'C' ? 1 : 2;
    if (!isKnown || p.size() < needed) {
        if (isKnown) {
            problems.emplace_back("an aperture lacks a size; it draws nothing");
        }
        return {};
    }
    const double width = p[0] * nmPerUnit;
    const double height = letter == 'R' || letter == 'O' ? p[1] * nmPerUnit : width;
    if (isAbsurd(width) || isAbsurd(height) || width < 0 || height < 0) {
        problems.emplace_back("an aperture has an absurd size; it draws nothing");
        return {};
    }
    if (p.size() > mostSizes(letter)) {
        problems.emplace_back("an aperture has more sizes than its shape takes; the last ones are left out");
    }
    PadShape shape = letter == 'C'   ? sized(PadShape::Kind::Round, width, width)
                     : letter == 'O' ? sized(PadShape::Kind::Oval, width, height)
                     : letter == 'R' ? rectangle(width, height)
                     : width > 0.5   ? regularPolygon(p, nmPerUnit, problems)
                                     : PadShape();
    const std::size_t behind = letter == 'C' ? 1 : letter == 'P' ? 3 : 2;
    if (p.size() > behind && shape.kind != PadShape::Kind::Nothing) {
        addHole(shape, p.subspan(behind), nmPerUnit, problems);
    }
    return shape;
}

PadShape scaled(const PadShape& shape, double factor) {
    PadShape result = shape;
    result.width = toNm(shape.width * factor).value_or(0);
    result.height = toNm(shape.height * factor).value_or(0);
    result.region = {};
    for (std::size_t i = 0; i < shape.region.contourCount(); ++i) {
        std::vector<PathNode> nodes;
        for (const PathNode& node : shape.region.contour(i)) {
            const auto place = [&](Point p) {
                return Point{toNm(p.x * factor).value_or(0), toNm(p.y * factor).value_or(0)};
            };
            nodes.push_back({place(node.point), place(node.centre), node.edge});
        }
        addPath(result.region, nodes, shape.region.isHole(i));
    }
    return result;
}

PadShape turned(const PadShape& shape, const Placement& placement) {
    if (shape.kind != PadShape::Kind::Oval && shape.kind != PadShape::Kind::Region) {
        return shape;
    }
    PadShape result;
    result.kind = PadShape::Kind::Region;
    result.region.append(formats::outlineOf(shape), {{}, placement.clockwiseDeg, placement.isMirrored});
    result.isSquarePen = shape.isSquarePen && std::fmod(placement.clockwiseDeg, 90.0) == 0.0;
    result.width = shape.width;
    result.height = shape.height;
    return result;
}

}  // namespace model::gerber
