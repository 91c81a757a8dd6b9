#include "model/solids/drilled_print.h"

#include <algorithm>

#include "model/base/parallel.h"
#include "model/board/holes.h"
#include "model/board/layers.h"
#include "model/figures/element_polygons.h"
#include "model/geometry/boolean.h"
#include "model/geometry/box_index.h"
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
          m_holes(document, elementsOf(document, [&](LayerId layer) { return comesOut(layer, side); })),
          m_openings(document, elementsOf(document, [&](LayerId layer) { return isMask(layer, side); })) {}

    [[nodiscard]] bool hasHoles() const { return !m_holes.isEmpty(); }

    /// What open holes take of what an element covers, by their boxes.
    [[nodiscard]] PolygonSet holesNear(const Box& box, const Discretisation& how) const {
        PolygonSet holes;
        for (const ElementId hole : m_holes.near(box)) {
            if (isOpen(hole)) {
                holes.append(discretise(m_document, hole, how));
            }
        }
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

    [[nodiscard]] bool isOpen(ElementId hole) const {
        if (m_openings.isEmpty() || !isTented(m_document, hole)) {
            return true;
        }
        const Point middle = m_document.boxOf(hole).middle();
        return std::ranges::any_of(m_openings.near({middle, middle}), [&](ElementId opening) {
            const PolygonSet region = discretise(m_document, opening, {});
            return contains(region, region.polygons, middle);
        });
    }

    const Document& m_document;
    FoundElements m_holes;
    FoundElements m_openings;
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
        const PolygonSet holes = m_face.holesNear(m_document.boxOf(element), m_how);
        if (holes.polygons.empty()) {
            return;
        }
        const PolygonSet whole = discretise(m_document, element, m_how);
        if (!intersect(whole, holes).polygons.empty()) {
            drilled.push_back({element, subtract(whole, holes)});
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
