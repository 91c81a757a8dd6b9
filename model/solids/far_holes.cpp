#include "model/solids/far_holes.h"

#include <algorithm>

#include "model/geometry/boolean.h"
#include "model/solids/region_distance.h"

namespace model {

namespace {

void copyLoops(const PolygonSet& from, const PolygonSet::Polygon& polygon, PolygonSet& to) {
    for (std::uint32_t i = 0; i < polygon.loopCount; ++i) {
        to.addLoop(from.loop(polygon.firstLoop + i));
    }
}

/// One polygon of a region, and the holes that belong to it.
struct Piece {
    PolygonSet region;
    EdgeStrips edges;
    std::vector<std::size_t> holes;
};

std::vector<Piece> piecesOf(const PolygonSet& region) {
    std::vector<Piece> pieces;
    for (const PolygonSet::Polygon& polygon : region.polygons) {
        PolygonSet one;
        one.beginPolygon();
        copyLoops(region, polygon, one);
        EdgeStrips edges(one);
        pieces.push_back({std::move(one), std::move(edges), {}});
    }
    return pieces;
}

}  // namespace

FarHoles::FarHoles(PolygonSet& region, const std::function<bool(const Box&)>& isFar) {
    PolygonSet near;
    for (const PolygonSet::Polygon& polygon : region.polygons) {
        near.beginPolygon();
        near.addLoop(region.loop(polygon.firstLoop));
        for (std::uint32_t i = 1; i < polygon.loopCount; ++i) {
            const std::span<const Point> hole = region.loop(polygon.firstLoop + i);
            const bool isApart = isFar(boxOf(hole));
            if (isApart) {
                m_holes.beginPolygon();
            }
            (isApart ? m_holes : near).addLoop(hole);
        }
    }
    if (!m_holes.polygons.empty()) {
        region = std::move(near);
    }
}

PolygonSet FarHoles::putBack(PolygonSet rest) const {
    if (m_holes.polygons.empty()) {
        return rest;
    }
    std::vector<Piece> pieces = piecesOf(rest);
    PolygonSet nowhere;  // rounding moved an edge over the hole
    for (std::size_t hole = 0; hole < m_holes.loopCount(); ++hole) {
        const Point inside = m_holes.loop(hole).front();
        const auto around =
            std::ranges::find_if(pieces, [&](const Piece& piece) { return piece.edges.contains(inside); });
        if (around != pieces.end()) {
            around->holes.push_back(hole);
        } else {
            nowhere.beginPolygon();
            nowhere.addLoop(m_holes.loop(hole));
        }
    }
    PolygonSet whole;
    for (const Piece& piece : pieces) {
        whole.beginPolygon();
        copyLoops(piece.region, piece.region.polygons.front(), whole);
        for (const std::size_t hole : piece.holes) {
            whole.addLoop(m_holes.loop(hole));
        }
    }
    return nowhere.polygons.empty() ? whole : subtract(whole, nowhere);
}

}  // namespace model
