#include "model/solids/drilled_print.h"

#include <algorithm>
#include <array>
#include <optional>

#include "model/base/parallel.h"
#include "model/board/holes.h"
#include "model/board/layers.h"
#include "model/figures/element_polygons.h"
#include "model/figures/tracks.h"
#include "model/geometry/boolean.h"
#include "model/geometry/box_index.h"
#include "model/solids/far_holes.h"
#include "model/solids/region_distance.h"
#include "model/solids/solids.h"

namespace model {

namespace {

/// Elements that can be found by where they are.
class FoundElements {
public:
    FoundElements(const Document& document, std::vector<ElementId> elements)
        : m_elements(std::move(elements)), m_index(boxesOf(document, m_elements)) {}

    /// Those whose boxes share a point with it, rising.
    [[nodiscard]] std::vector<ElementId> near(const Box& box) const {
        std::vector<ElementId> found;
        m_index.visit(box, [&](std::uint32_t row) { found.push_back(m_elements[row]); });
        std::ranges::sort(found);
        return found;
    }
    [[nodiscard]] bool isEmpty() const { return m_elements.empty(); }

private:
    static std::vector<Box> boxesOf(const Document& document, const std::vector<ElementId>& elements) {
        std::vector<Box> boxes;
        std::ranges::transform(elements, std::back_inserter(boxes),
                               [&](ElementId element) { return document.boxOf(element); });
        return boxes;
    }

    std::vector<ElementId> m_elements;
    BoxIndex m_index;
};

/// Of all layers of the job that `isWanted`.
template <class IsWanted>
std::vector<ElementId> elementsOf(const Document& document, const IsWanted& isWanted) {
    std::vector<ElementId> elements;
    for (std::size_t row = 0; row < document.layers.size(); ++row) {
        const Layer& layer = document.layers[row];
        for (std::uint32_t i = 0; i < layer.elements.count && isWanted(LayerId{row}); ++i) {
            elements.emplace_back(layer.elements.first + i);
        }
    }
    return elements;
}

/// One face of the board: the holes that come out there, and where its solder mask is open.
class Face {
public:
    Face(const Document& document, LayerSide side)
        : m_document(document),
          m_holes(document, holesOf(side)),
          m_openings(document, elementsOf(document, [&](LayerId layer) { return isMask(layer, side); })) {}

    [[nodiscard]] bool hasHoles() const { return !m_holes.isEmpty(); }

    /// Open holes whose boxes share a point with it.
    [[nodiscard]] std::vector<ElementId> openNear(const Box& box) const {
        std::vector<ElementId> holes = m_holes.near(box);
        std::erase_if(holes, [this](ElementId hole) { return !isOpen(hole); });
        return holes;
    }

private:
    [[nodiscard]] bool comesOut(LayerId id, LayerSide side) const {
        const Layer& layer = m_document.layer(id);
        const Layer& copper = m_document.layer(outerCopper(m_document, side));
        return isHoles(layer.type) && layer.context == LayerContext::Board &&
               (side == LayerSide::Top ? layer.z + layer.thickness >= copper.z + copper.thickness
                                       : layer.z <= copper.z);
    }
    [[nodiscard]] bool isMask(LayerId id, LayerSide side) const {
        const Layer& layer = m_document.layer(id);
        return layer.type == LayerType::SolderMask && layer.context == LayerContext::Board && !layer.isSynthetic &&
               faceOf(m_document, id) == side;
    }

    /// Not what a layer of routed paths holds beside: the edge of what stays, or a drawing.
    [[nodiscard]] std::vector<ElementId> holesOf(LayerSide side) const {
        std::vector<ElementId> holes = elementsOf(m_document, [&](LayerId layer) { return comesOut(layer, side); });
        std::erase_if(holes, [&](ElementId id) { return (m_document.elements.flags[id.row()] & kHole) == 0; });
        return holes;
    }
    [[nodiscard]] bool isOpen(ElementId hole) const {
        if (m_openings.isEmpty() || !isTented(m_document, hole)) {
            return true;
        }
        const Point middle = m_document.boxOf(hole).middle();
        return std::ranges::any_of(m_openings.near({middle, middle}),
                                   [&](ElementId opening) { return covers(opening, middle); });
    }
    /// Painted openings have hundreds of tracks; the straight ones need no chords.
    [[nodiscard]] bool covers(ElementId opening, Point p) const {
        const ElementKind kind = m_document.elements.kind[opening.row()];
        const bool isSquarePen = (m_document.elements.flags[opening.row()] & kSquarePen) != 0;
        if ((kind == ElementKind::Trail || kind == ElementKind::Line) && !isSquarePen) {
            const std::optional<bool> isCovered = coveredByTracks(opening, p);
            if (isCovered) {
                return *isCovered;
            }
        }
        const PolygonSet region = discretise(m_document, opening, {});
        return contains(region, region.polygons, p);
    }
    /// Nothing where they are not all straight.
    [[nodiscard]] std::optional<bool> coveredByTracks(ElementId opening, Point p) const {
        bool isStraight = true;
        bool isCovered = false;
        forEachTrack(m_document, opening, [&](const PathNode& node, Point end, Nm width, Nm) {
            isStraight = isStraight && node.edge == EdgeKind::Line;
            isCovered = isCovered || (isStraight && width > 0 && segmentDistance(p, p, node.point, end) <= width / 2.0);
        });
        return isStraight || isCovered ? std::optional(isCovered) : std::nullopt;
    }

    const Document& m_document;
    FoundElements m_holes;
    FoundElements m_openings;
};

/// What an element covers. Logos and frames are around many holes that they do not meet, and are not cut for those.
class PrintRegion {
public:
    /// `region`: not empty; `mayOverlap`: its polygons, as tracks of one element do where they turn.
    PrintRegion(PolygonSet region, bool mayOverlap)
        : m_region(std::move(region)), m_edges(m_region), m_mayOverlap(mayOverlap) {}

    [[nodiscard]] bool mayMeet(const Box& hole) const {
        return m_edges.meets(hole) || covers(hole.min) || isWithin(hole);
    }
    [[nodiscard]] bool meets(const Document& document, ElementId hole, const Discretisation& how) const {
        if (document.elements.kind[hole.row()] == ElementKind::Circle) {
            return meetsDisc(document.circles[document.elements.geometry[hole.row()]]);
        }
        return meets(discretise(document, hole, how));
    }
    [[nodiscard]] PolygonSet without(const PolygonSet& holes) const {
        const EdgeStrips opened(holes);
        PolygonSet rest = m_region;
        const FarHoles far(rest, [&](const Box& hole) {
            constexpr Nm kFar = 5;  // booleans round to the grid
            const Box around = hole.grownBy(kFar);
            return !opened.meets(around) && !contains(holes, holes.polygons, around.min);
        });
        return far.putBack(subtract(rest, holes));
    }

private:
    /// Most holes are round, and need no chords: what comes closer to their middle than their radius meets them. The
    /// middle is a triangle of 1 nm.
    [[nodiscard]] bool meetsDisc(const CircleGeometry& disc) const {
        constexpr double kGraze = 5'000.0;  // nm; chords of the hole would take nothing
        const Point at = disc.centre;
        const std::array<Point, 3> corners{at, {at.x + 1, at.y}, {at.x, at.y + 1}};
        PolygonSet middle;
        middle.beginPolygon();
        middle.addLoop(corners);
        return m_edges.comesNear(middle, middle.polygons, boxOf(corners), disc.diameter / 2.0 - kGraze) || covers(at);
    }
    [[nodiscard]] bool meets(const PolygonSet& hole) const {
        constexpr double kMeeting = 1.0;  // nm
        if (hole.points.empty()) {
            return false;  // a routed path without a width
        }
        return m_edges.comesNear(hole, hole.polygons, boxOf(hole.points), kMeeting) || covers(hole.points.front()) ||
               contains(hole, hole.polygons, m_region.points.front());
    }
    [[nodiscard]] bool covers(Point p) const {
        return m_mayOverlap ? contains(m_region, m_region.polygons, p) : m_edges.contains(p);
    }
    [[nodiscard]] bool isWithin(const Box& hole) const { return hole.holds(m_region.points.front()); }

    PolygonSet m_region;
    EdgeStrips m_edges;
    bool m_mayOverlap;
};

/// What is printed on one face.
class Printed {
public:
    Printed(const Document& document, LayerSide side, const Discretisation& how)
        : m_document(document), m_how(how), m_face(document, side) {
        if (m_face.hasHoles()) {
            m_elements = elementsOf(document, [&](LayerId layer) { return isPrint(layer, side); });
        }
    }

    /// Adds those elements that holes cut.
    void drill(const base::Progress& progress, std::vector<MilledElement>& drilled) const {
        constexpr std::size_t kChunk = 1024;
        std::vector<std::vector<MilledElement>> chunks((m_elements.size() + kChunk - 1) / kChunk);
        base::parallelFor(chunks.size(), [&](std::size_t chunk) {
            const std::size_t end = std::min((chunk + 1) * kChunk, m_elements.size());
            for (std::size_t i = chunk * kChunk; i < end && !progress.isCancelled(); ++i) {
                drill(m_elements[i], chunks[chunk]);
            }
        });
        for (std::vector<MilledElement>& chunk : chunks) {
            std::ranges::move(chunk, std::back_inserter(drilled));
        }
    }

private:
    [[nodiscard]] bool isPrint(LayerId id, LayerSide side) const {
        const Layer& layer = m_document.layer(id);
        return groupOf(layer) == LayerGroup::Silkscreen && layer.context == LayerContext::Board &&
               faceOf(m_document, id) == side;
    }

    void drill(ElementId element, std::vector<MilledElement>& drilled) const {
        const std::vector<ElementId> near = m_face.openNear(m_document.boxOf(element));
        if (near.empty()) {
            return;
        }
        PolygonSet region = discretise(m_document, element, m_how);
        if (region.polygons.empty()) {
            return;  // a line without a width
        }
        const bool mayOverlap = m_document.elements.kind[element.row()] == ElementKind::Trail;
        const PrintRegion print(std::move(region), mayOverlap);
        PolygonSet holes;
        for (const ElementId hole : near) {
            if (print.mayMeet(m_document.boxOf(hole)) && print.meets(m_document, hole, m_how)) {
                holes.append(discretise(m_document, hole, m_how));
            }
        }
        if (!holes.polygons.empty()) {
            drilled.push_back({element, print.without(holes)});
        }
    }

    const Document& m_document;
    Discretisation m_how;
    Face m_face;
    std::vector<ElementId> m_elements;
};

}  // namespace

std::vector<MilledElement> findDrilledPrint(const Document& document, const Discretisation& how,
                                            const base::Progress& progress) {
    std::vector<MilledElement> drilled;
    if (!outerCopper(document, LayerSide::Top).isValid()) {
        return drilled;
    }
    for (const LayerSide side : {LayerSide::Top, LayerSide::Bottom}) {
        Printed(document, side, how).drill(progress, drilled);
    }
    std::ranges::sort(drilled, {}, &MilledElement::element);
    return drilled;
}

void addDrilledPrint(std::vector<MilledElement> print, std::vector<MilledElement>& milled) {
    const auto end = static_cast<std::ptrdiff_t>(milled.size());
    for (MilledElement& drilled : print) {
        const auto same = std::ranges::lower_bound(milled.begin(), milled.begin() + end, drilled.element, {},
                                                   &MilledElement::element);
        if (same != milled.begin() + end && same->element == drilled.element) {
            same->rest = intersect(same->rest, drilled.rest);
        } else {
            milled.push_back(std::move(drilled));
        }
    }
    std::ranges::sort(milled, {}, &MilledElement::element);
}

}  // namespace model
