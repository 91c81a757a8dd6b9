#include "model/formats/kicad/mask_webs.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <utility>
#include <vector>

#include "model/formats/kicad/shapes/regions.h"
#include "model/geometry/loops/region_booleans.h"
#include "model/geometry/outlines.h"
#include "model/geometry/region.h"

namespace model::kicad {

namespace {

using formats::DrawnFeature;
using formats::DrawnKind;

struct Opening {
    ShapeSketch shape;
    Box box;
    std::uint32_t line = 0;
};

ShapeSketch shapeOf(const formats::DrawnStep& step, const DrawnFeature& feature) {
    ShapeSketch shape;
    if (feature.kind == DrawnKind::Region) {
        return step.regions[static_cast<std::size_t>(feature.region)];
    }
    const formats::PadShape& symbol = step.symbols[static_cast<std::size_t>(feature.symbol)].shape;
    if (feature.kind == DrawnKind::Pad) {
        shape.append(formats::outlineOf(symbol), {feature.a, feature.clockwiseDeg, feature.isMirrored});
        return shape;
    }
    const EdgeKind edge = feature.kind == DrawnKind::Line ? EdgeKind::Line
                          : feature.isClockwise           ? EdgeKind::ArcClockwise
                                                          : EdgeKind::ArcCounterClockwise;
    return united(penAlong({feature.a, feature.centre, edge}, feature.b, symbol.width));
}

/// Openings that lie within a distance of each other, by their boxes, directly or through others.
std::vector<std::vector<std::size_t>> clustersOf(const std::vector<Opening>& openings, Nm distance) {
    std::vector<std::size_t> leader(openings.size());
    std::iota(leader.begin(), leader.end(), std::size_t{0});
    const auto find = [&](std::size_t i) {
        while (leader[i] != i) {
            leader[i] = leader[leader[i]];
            i = leader[i];
        }
        return i;
    };
    std::vector<std::size_t> order = leader;
    std::ranges::sort(order, {}, [&](std::size_t i) { return openings[i].box.min.x; });
    for (std::size_t i = 0; i < order.size(); ++i) {
        const Box& a = openings[order[i]].box;
        for (std::size_t k = i + 1; k < order.size() && openings[order[k]].box.min.x - a.max.x < distance; ++k) {
            const Box& b = openings[order[k]].box;
            if (b.min.y - a.max.y < distance && a.min.y - b.max.y < distance) {
                leader[find(order[i])] = find(order[k]);
            }
        }
    }
    std::vector<std::vector<std::size_t>> clusters(openings.size());
    for (std::size_t i = 0; i < openings.size(); ++i) {
        clusters[find(i)].push_back(i);
    }
    std::erase_if(clusters, [](const auto& cluster) { return cluster.size() < 2; });
    return clusters;
}

/// All of the openings, grown and shrunk again.
ShapeSketch closed(const std::vector<Opening>& openings, const std::vector<std::size_t>& cluster, double reach) {
    std::vector<EdgeLoops> regions;
    for (const std::size_t i : cluster) {
        for (EdgeLoops& region : regionsOf(openings[i].shape)) {
            regions.push_back(std::move(region));
        }
    }
    return grown(grown(united(regions), reach), -reach);
}

}  // namespace

void joinMaskOpenings(Canvas& canvas, double leastWeb) {
    if (!(leastWeb > 0.0 && leastWeb < base::kNmPerMm * 10.0)) {
        return;
    }
    for (std::size_t row = 0; row < canvas.step().features.size(); ++row) {
        if (canvas.job().layers[row].type != LayerType::SolderMask) {
            continue;
        }
        std::vector<Opening> openings;
        for (const DrawnFeature& feature : canvas.step().features[row]) {
            Opening opening{shapeOf(canvas.step(), feature), {}, feature.line};
            if (!opening.shape.isEmpty()) {
                opening.box = boxOf(opening.shape);
                openings.push_back(std::move(opening));
            }
        }
        for (const std::vector<std::size_t>& cluster : clustersOf(openings, asNm(leastWeb))) {
            Origin origin;
            origin.line = openings[cluster.front()].line;
            origin.attributes = canvas.attributes({{"mask_web", "narrower than the board's minimum, opened"}});
            canvas.drawRegion(static_cast<std::int32_t>(row), origin, closed(openings, cluster, leastWeb / 2.0));
        }
    }
}

}  // namespace model::kicad
