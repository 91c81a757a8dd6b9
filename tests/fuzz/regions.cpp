#include "regions.h"

#include <cmath>
#include <vector>

#include "model/base/assert.h"
#include "model/export/solids/step_solid_text.h"
#include "model/export/solids/step_text.h"
#include "model/geometry/loops/edge_faults.h"
#include "model/geometry/loops/edge_union.h"
#include "model/geometry/loops/fit_arcs.h"
#include "model/geometry/loops/needless_corners.h"
#include "model/geometry/loops/split_loops.h"

namespace fuzz {

namespace {

using model::EdgeLoops;
using model::PointD;
using Regions = std::vector<EdgeLoops>;

/// More would only take longer.
constexpr std::size_t kMostRegions = 24;
constexpr std::size_t kMostCorners = 60;
/// Edges move by 5 nm at most, on both sides, and what is thinner than 1 nm may go.
constexpr double kMostMovedNm = 12.0;

/// Characters are numbers around '@', shifted by the first one of the text.
class Numbers {
public:
    Numbers(std::string_view line, int shift) : m_line(line), m_unit(static_cast<double>(1 << shift)) {}

    [[nodiscard]] bool has(std::size_t count) const { return m_line.size() - m_at >= count; }
    [[nodiscard]] bool takeIf(char c) {
        const bool is = has(1) && m_line[m_at] == c;
        m_at += is ? 1 : 0;
        return is;
    }
    double raw() { return static_cast<signed char>(m_line[m_at++] - '@'); }
    double length() { return raw() * m_unit; }
    PointD point() {
        const double x = length();
        return {x, length()};
    }

private:
    std::string_view m_line;
    double m_unit;
    std::size_t m_at = 0;
};

/// Half of `bulge` of the chord beside its middle is where the arc passes.
void addEdge(EdgeLoops& loops, PointD a, PointD b, double bulge) {
    if (bulge == 0.0 || a == b) {
        return loops.addLine(a, b);
    }
    const double centre = (1 - bulge * bulge) / (4 * bulge);  // from the middle of the chord, in chords
    const PointD middle{(a.x + b.x) / 2, (a.y + b.y) / 2};
    loops.addArc(a, b, {middle.x - (b.y - a.y) * centre, middle.y + (b.x - a.x) * centre}, bulge < 0);
}

void addLoop(EdgeLoops& loops, Numbers& numbers) {
    std::vector<PointD> corners;
    std::vector<double> bulges;
    while (numbers.has(3) && corners.size() < kMostCorners && !numbers.takeIf('|')) {
        corners.push_back(numbers.point());
        bulges.push_back(numbers.raw() / 128);
    }
    for (std::size_t i = 0; i < corners.size(); ++i) {
        addEdge(loops, corners[i], corners[(i + 1) % corners.size()], bulges[i]);
    }
    static_cast<void>(loops.endLoop());
}

EdgeLoops regionOf(std::string_view line, int shift) {
    EdgeLoops loops;
    Numbers numbers(line, shift);
    if (numbers.takeIf('c')) {
        if (numbers.has(3)) {
            const PointD centre = numbers.point();
            loops.addCircle(centre, std::abs(numbers.length()) + 1);
        }
    } else if (numbers.takeIf('t')) {
        if (numbers.has(5)) {
            const PointD a = numbers.point();
            const PointD b = numbers.point();
            loops.addCapsule(a, b, std::abs(numbers.length()) + 1);
        }
    } else {
        while (numbers.has(3)) {
            addLoop(loops, numbers);
        }
    }
    return loops;
}

Regions parse(std::string_view input) {
    Regions regions;
    const int shift = input.empty() ? 0 : static_cast<unsigned char>(input[0]) % 22;
    input.remove_prefix(input.empty() ? 0 : 1);
    while (!input.empty() && regions.size() < kMostRegions) {
        const std::size_t end = std::min(input.find('\n'), input.size());
        if (EdgeLoops region = regionOf(input.substr(0, end), shift); region.loopCount() > 0) {
            regions.push_back(std::move(region));
        }
        input.remove_prefix(std::min(end + 1, input.size()));
    }
    return regions;
}

double areaOf(const Regions& regions) {
    double area = 0.0;
    for (const EdgeLoops& region : regions) {
        area += model::areaOf(region);
    }
    return area;
}

double lengthOf(const Regions& regions) {
    double length = 0.0;
    for (const EdgeLoops& region : regions) {
        for (const model::Edge& edge : region.edges) {
            length += model::lengthOf(edge);
        }
    }
    return length;
}

void checkSound(const Regions& regions) {
    for (const EdgeLoops& region : regions) {
        ASSERT(!model::findFault(region));
        ASSERT(model::areaOf(region) > 0);
    }
}

void writeSolids(const Regions& regions) {
    model::StepText text;
    model::StepSolidText solids(text, model::StepEdges::Polylines);
    for (const EdgeLoops& region : regions) {
        static_cast<void>(solids.add({region, {0, 35'000}}));
    }
    ASSERT(text.text().find("nan") == std::string::npos && text.text().find("inf") == std::string::npos);
}

/// Other ways to write a sound region leave it sound.
void checkRewritten(const Regions& regions) {
    for (const EdgeLoops& region : regions) {
        const EdgeLoops fitted = model::withFittedArcs(region, 5'000.0);
        const EdgeLoops without = model::withoutNeedlessCorners(region, 5.0);
        checkSound({fitted, without});
        const Regions pieces = model::splitLarge(region, {8, 2});
        ASSERT(std::abs(areaOf(pieces) - model::areaOf(region)) <= kMostMovedNm * (lengthOf(pieces) + 1));
    }
}

}  // namespace

void regions(std::string_view input) {
    const Regions all = parse(input);
    const Regions taken(all.begin() + static_cast<std::ptrdiff_t>(all.size() / 2), all.end());
    const auto united = model::unite(all);
    const auto cut = model::unite(taken);
    const auto left = united && cut ? model::subtract(*united, *cut) : std::nullopt;
    for (const auto& result : {united, cut, left}) {
        if (result) {
            checkSound(*result);
        }
    }
    if (united && cut && left) {
        const double moved = kMostMovedNm * (2 * lengthOf(all) + lengthOf(*left) + 1);
        ASSERT(std::abs(areaOf(*united) - areaOf(*cut) - areaOf(*left)) <= moved);
    }
    if (united) {
        writeSolids(*united);
        checkRewritten(*united);
    }
    for (const EdgeLoops& region : all) {
        if (const auto clean = model::cleaned(region)) {
            checkSound(*clean);
        }
    }
}

}  // namespace fuzz
