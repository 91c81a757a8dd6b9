#include "model/export/location_picture.h"

#include <algorithm>
#include <cmath>
#include <set>

#include "model/base/units.h"
#include "model/figures/element_polygons.h"
#include "model/text/formatting.h"

namespace model {

namespace {

// A picture is so many units wide and high; on the screen a quarter of that in pixels.
constexpr double kWidth = 960;
constexpr double kHeight = 720;
constexpr double kLeastAround = 300'000;  ///< nm to the upper and lower side
constexpr double kMostAround = 4e6;
constexpr double kTimesAround = 2.5;  ///< so many widths of the spacing
constexpr double kThin = 2.0;         ///< units: points that are nearer to the last one are left out
constexpr double kChord = 0.4;        ///< units between a curve and its chords
constexpr double kHoleAround = 0.8;   ///< of the diameter of a hole that is one side

using Points = std::vector<PointD>;

/// From nanometres to units of the picture.
struct View {
    PointD middle;
    double perNm = 1.0;

    [[nodiscard]] PointD of(PointD p) const {
        return {kWidth / 2 + (p.x - middle.x) * perNm, kHeight / 2 - (p.y - middle.y) * perNm};
    }
    [[nodiscard]] Box box() const {
        const Point half{static_cast<Nm>(kWidth / 2 / perNm), static_cast<Nm>(kHeight / 2 / perNm)};
        const Point at{static_cast<Nm>(middle.x), static_cast<Nm>(middle.y)};
        return {{at.x - half.x, at.y - half.y}, {at.x + half.x, at.y + half.y}};
    }
};

/// What of a loop lies on one side of an upright or level line (Sutherland and Hodgman).
template <class DepthOf>
Points clipped(const Points& loop, const DepthOf& depthOf) {
    Points out;
    for (std::size_t i = 0; i < loop.size(); ++i) {
        const PointD a = loop[i];
        const PointD b = loop[(i + 1) % loop.size()];
        const double depthA = depthOf(a);
        const double depthB = depthOf(b);
        if (depthA >= 0) {
            out.push_back(a);
        }
        if ((depthA >= 0) != (depthB >= 0)) {
            const double t = depthA / (depthA - depthB);
            out.push_back({a.x + (b.x - a.x) * t, a.y + (b.y - a.y) * t});
        }
    }
    return out;
}

Points insidePicture(Points loop) {
    loop = clipped(loop, [](PointD p) { return p.x; });
    loop = clipped(loop, [](PointD p) { return kWidth - p.x; });
    loop = clipped(loop, [](PointD p) { return p.y; });
    return clipped(loop, [](PointD p) { return kHeight - p.y; });
}

/// "M1 2L3 4Z"; empty for less than a triangle.
std::string pathOf(const Points& loop) {
    std::string path;
    std::size_t count = 0;
    PointD last{-kWidth, -kHeight};
    for (const PointD p : loop) {
        if (std::hypot(p.x - last.x, p.y - last.y) >= kThin) {
            path += formatted("%s%ld %ld", count == 0 ? "M" : "L", std::lround(p.x), std::lround(p.y));
            last = p;
            ++count;
        }
    }
    return count < 3 ? "" : path + "Z";
}

std::string pathOf(const Document& step, ElementId element, const View& view) {
    Discretisation how;
    how.chordToleranceNm = std::clamp(kChord / view.perNm, Discretisation::kMinChordNm, Discretisation::kMaxChordNm);
    const PolygonSet polygons = discretise(step, element, how);
    std::string path;
    for (std::size_t i = 0; i < polygons.loopCount(); ++i) {
        Points loop;
        for (const Point p : polygons.loop(i)) {
            loop.push_back(view.of(base::toDouble(p)));
        }
        path += pathOf(insidePicture(std::move(loop)));
    }
    return path;
}

std::string drawn(const char* className, const std::string& path) {
    return path.empty() ? "" : std::string("<path class=\"") + className + "\" d=\"" + path + "\"/>";
}

/// Paths of what is drawn alike.
struct Groups {
    std::string other;
    std::string netA;
    std::string netB;
    std::string a;
    std::string b;

    [[nodiscard]] std::string svg(const char* otherClass) const {
        return drawn(otherClass, other) + drawn("na", netA) + drawn("nb", netB) + drawn("a", a) + drawn("b", b);
    }
};

/// Sorts elements into groups.
class Drawing {
public:
    Drawing(const Document& step, const RuleFinding& finding, const View& view)
        : m_step(step), m_finding(finding), m_view(view), m_netA(netOf(finding.a)), m_netB(netOf(finding.b)) {}

    [[nodiscard]] std::string svgOf(const LayerGeometry& items, const char* otherClass, bool hasNets) const {
        std::set<ElementId> elements;
        items.visitNear(m_view.box(), 0.0, [&](std::uint32_t row) { elements.insert(items.elementOf(row)); });
        Groups groups;
        for (const ElementId element : elements) {
            groupOf(groups, element, hasNets) += pathOf(m_step, element, m_view);
        }
        return groups.svg(otherClass);
    }

private:
    [[nodiscard]] NetId netOf(ElementId element) const {
        return element.isValid() ? m_step.elements.net[element.row()] : NetId{};
    }
    [[nodiscard]] std::string& groupOf(Groups& groups, ElementId element, bool hasNets) const {
        const NetId net = netOf(element);
        const bool isTold = hasNets && net.isValid() && m_netA != m_netB;
        return element == m_finding.a    ? groups.a
               : element == m_finding.b  ? groups.b
               : isTold && net == m_netA ? groups.netA
               : isTold && net == m_netB ? groups.netB
                                         : groups.other;
    }

    const Document& m_step;
    const RuleFinding& m_finding;
    const View& m_view;
    NetId m_netA;
    NetId m_netB;
};

std::string outlineSvg(const LayerGeometry& edge, const View& view) {
    std::string path;
    edge.visitNear(view.box(), 0.0, [&](std::uint32_t row) {
        for (const Edge& piece : edge.figures().edges(row)) {
            constexpr int kPieces = 24;
            const int count = piece.isArc() ? kPieces : 1;
            for (int i = 0; boxOf(piece).meets(view.box()) && i <= count; ++i) {
                const PointD p = view.of(pointAt(piece, lengthOf(piece) * i / count));
                path += formatted("%s%ld %ld", i == 0 ? "M" : "L", std::lround(p.x), std::lround(p.y));
            }
        }
    });
    return drawn("edge", path);
}

std::string dimensionSvg(const Spacing& spacing, const View& view) {
    const PointD a = view.of(spacing.from);
    const PointD b = view.of(spacing.to);
    const double length = std::hypot(b.x - a.x, b.y - a.y);
    std::string svg = formatted("<path class=\"space\" d=\"M%.0f %.0fL%.0f %.0f\"/>", a.x, a.y, b.x, b.y);
    if (length < 8) {
        svg += formatted("<circle class=\"space\" cx=\"%.0f\" cy=\"%.0f\" r=\"24\"/>", a.x, a.y);
    } else {
        const PointD across{(b.y - a.y) / length * 16, (a.x - b.x) / length * 16};
        for (const PointD end : {a, b}) {
            svg += formatted("<path class=\"space\" d=\"M%.0f %.0fL%.0f %.0f\"/>", end.x - across.x, end.y - across.y,
                             end.x + across.x, end.y + across.y);
        }
    }
    const std::string text = formatted("%.1f µm", spacing.distance / base::kNmPerUm);
    return svg + formatted("<text x=\"%.0f\" y=\"%.0f\">", (a.x + b.x) / 2 + 40, (a.y + b.y) / 2 - 40) + xmlText(text) +
           "</text>";
}

/// The next smaller of 1, 2, 5, 10, … of a quarter of the width.
std::string barSvg(const View& view) {
    const double most = kWidth / 4 / view.perNm;
    const double ten = std::pow(10.0, std::floor(std::log10(most)));
    const double length = most >= 5 * ten ? 5 * ten : most >= 2 * ten ? 2 * ten : ten;
    return formatted("<path class=\"bar\" d=\"M24 676V696H%.0fV676\"/><text class=\"bar\" x=\"30\" y=\"668\">",
                     24 + length * view.perNm) +
           lengthText(static_cast<Nm>(length)) + "</text>";
}

View viewOf(const Document& step, const RuleFinding& finding) {
    const Spacing& s = finding.spacing;
    double around = std::max(kLeastAround, kTimesAround * s.distance);
    for (const ElementId side : {finding.a, finding.b}) {
        if (side.isValid() && (step.elements.flags[side.row()] & kHole) != 0) {
            const Box box = step.boxOf(side);
            around = std::max(around, kHoleAround * std::min(box.max.x - box.min.x, box.max.y - box.min.y));
        }
    }
    return {{(s.from.x + s.to.x) / 2, (s.from.y + s.to.y) / 2}, kHeight / 2 / std::min(around, kMostAround)};
}

}  // namespace

const char* const LocationPictures::kStyle =
    "svg{width:240px;height:180px;background:#fff;border:1px solid #bbb}svg .o{fill:#c4c4c4}svg "
    ".h{fill:#fff;stroke:#888;"
    "stroke-width:4}svg .na{fill:#f3c9a5}svg .nb{fill:#aecdea}svg .a{fill:#d9731a;stroke:#7a3d06;stroke-width:3}svg "
    ".b{fill:#2f7fc1;stroke:#123f66;stroke-width:3}svg .edge{fill:none;stroke:#222;stroke-width:5}svg .space{fill:none;"
    "stroke:#c00020;stroke-width:6}svg text{font:600 44px sans-serif;fill:#a00018;stroke:#fff;stroke-width:10;"
    "paint-order:stroke}svg .bar{fill:none;stroke:#333;stroke-width:4}svg text.bar{font:32px sans-serif;fill:#333;"
    "stroke:#fff;stroke-width:8}";

const LocationPictures::Surroundings& LocationPictures::around(LayerId layer) {
    const auto [at, isNew] = m_layers.try_emplace(layer);
    if (isNew) {
        at->second = {layerGeometry(m_step, layer), holeGeometry(m_step, layer)};
    }
    return at->second;
}

LayerId LocationPictures::shownLayer(const RuleFinding& finding) const {
    const Layer& layer = m_step.layer(finding.layer);
    return layer.type == LayerType::Drill && layer.spanTop.isValid() ? layer.spanTop : finding.layer;
}

std::string LocationPictures::svgOf(const RuleFinding& finding) {
    const View view = viewOf(m_step, finding);
    const Surroundings& near = around(shownLayer(finding));
    const Drawing drawing(m_step, finding, view);
    const bool isCopper = m_step.layer(shownLayer(finding)).isCopper();
    return formatted("<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 %.0f %.0f\">", kWidth, kHeight) +
           drawing.svgOf(near.flat, "o", isCopper) + drawing.svgOf(near.holes, "h", false) +
           outlineSvg(edgeGeometry(m_step), view) + dimensionSvg(finding.spacing, view) + barSvg(view) + "</svg>";
}

}  // namespace model
