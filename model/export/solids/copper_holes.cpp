#include "model/export/solids/copper_holes.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <unordered_map>

namespace model {

namespace {

/// In the coordinates of a shape that `placement` lays on the board.
std::optional<Point> centreIn(const Placement& placement, const RegionSearch& hole) {
    const EdgeLoops& region = hole.region();
    if (region.edges.size() != 1 || !region.edges.front().isFullCircle()) {
        return std::nullopt;
    }
    const PointD own = unplaced(region.edges.front().centre, placement);
    return Point{static_cast<Nm>(std::llround(own.x)), static_cast<Nm>(std::llround(own.y))};
}

}  // namespace

/// The regions of shapes, each made once.
class CopperHoles::Shapes {
public:
    explicit Shapes(const Document& document) : m_document(document) {}

    const std::vector<RegionSearch>& of(const ShapeKey& key) {
        const auto [found, isNew] = m_regions.try_emplace(key);
        if (isNew) {
            for (EdgeLoops& region : outlinesOf(m_document, key).regions) {
                found->second.emplace_back(std::move(region));
            }
        }
        return found->second;
    }

private:
    const Document& m_document;
    std::unordered_map<ShapeKey, std::vector<RegionSearch>, ShapeKeyHash> m_regions;
};

CopperHoles::CopperHoles(const Document& document, const std::function<bool(ElementId)>& isOpen)
    : m_document(&document), m_ofLayers(document.layers.size()) {
    std::map<std::vector<ElementId>, std::vector<std::size_t>> layersOfHoles;
    for (std::size_t row = 0; row < document.layers.size(); ++row) {
        if (document.layers[row].isCopper()) {
            std::vector<ElementId> holes = holesThrough(document, LayerId{row});
            std::erase_if(holes, [&](ElementId hole) { return !isOpen(hole); });
            layersOfHoles[std::move(holes)].push_back(row);
        }
    }
    for (const auto& [holes, layers] : layersOfHoles) {
        const auto regions = std::make_shared<const HoleRegions>(document, holes);
        for (const std::size_t row : layers) {
            m_ofLayers[row] = regions;
        }
    }
}

std::vector<RegionSearch> CopperHoles::near(LayerId layer, const Box& box) const {
    const std::shared_ptr<const HoleRegions>& holes = m_ofLayers[layer.row()];
    return holes ? holes->near(box) : std::vector<RegionSearch>();
}

std::size_t CopperHoles::countNear(LayerId layer, const Box& box) const {
    const std::shared_ptr<const HoleRegions>& holes = m_ofLayers[layer.row()];
    return holes ? holes->countNear(box) : 0;
}

void CopperHoles::compare(std::span<const ElementId> elements, const base::Progress& progress) {
    std::vector<std::pair<ElementId, SharedShape>> sharing;
    std::unordered_map<ShapeKey, std::uint32_t, ShapeKeyHash> uses;
    for (const ElementId element : elements) {
        if (const auto shape = model::sharedShapeOf(*m_document, element)) {
            ++uses[shape->key];
            sharing.emplace_back(element, *shape);
        }
    }
    std::erase_if(sharing, [&](const auto& user) { return uses[user.second.key] < 2; });
    Shapes shapes(*m_document);
    for (const auto& [element, shape] : sharing) {
        if (progress.isCancelled()) {
            break;
        }
        const std::vector<RegionSearch> holes =
            near(m_document->elements.layer[element.row()], m_document->boxOf(element));
        if (holes.empty()) {
            continue;
        }
        const std::optional<Pattern> pattern = patternOf(shape, holes, shapes);
        if (!pattern) {
            m_drilled.push_back({element, std::nullopt});
        } else if (!pattern->empty()) {
            m_drilled.push_back({element, rowOf(*pattern)});
        }
    }
    std::ranges::sort(m_drilled, {}, &DrilledElement::element);
}

std::optional<CopperHoles::Pattern> CopperHoles::patternOf(const SharedShape& shape,
                                                           const std::vector<RegionSearch>& holes,
                                                           Shapes& shapes) const {
    Pattern pattern;
    for (const RegionSearch& hole : holes) {
        const std::optional<Point> centre = centreIn(shape.placement, hole);
        if (!centre) {
            return std::nullopt;
        }
        const RoundHole round{*centre, static_cast<Nm>(std::llround(2 * hole.region().edges.front().radius))};
        const RegionSearch own = regionsOf({round}).front();
        if (std::ranges::any_of(shapes.of(shape.key),
                                [&](const RegionSearch& region) { return lieOf(own, region) != CutLie::Apart; })) {
            pattern.push_back(round);
        }
    }
    std::ranges::sort(pattern);
    return pattern;
}

std::uint32_t CopperHoles::rowOf(const Pattern& pattern) {
    const auto [found, isNew] = m_rows.try_emplace(pattern, static_cast<std::uint32_t>(m_patterns.size()));
    if (isNew) {
        m_patterns.push_back(pattern);
    }
    return found->second;
}

std::optional<SharedShape> CopperHoles::sharedShapeOf(ElementId element) const {
    std::optional<SharedShape> shape = model::sharedShapeOf(*m_document, element);
    const auto found = std::ranges::lower_bound(m_drilled, element, {}, &DrilledElement::element);
    if (!shape || found == m_drilled.end() || found->element != element) {
        return shape;
    }
    if (!found->pattern) {
        return std::nullopt;
    }
    shape->key.drilled = *found->pattern;
    return shape;
}

std::vector<RegionSearch> CopperHoles::through(const ShapeKey& key) const {
    return regionsOf(m_patterns[key.drilled]);
}

std::vector<RegionSearch> CopperHoles::regionsOf(const Pattern& pattern) {
    std::vector<RegionSearch> regions;
    for (const RoundHole& hole : pattern) {
        EdgeLoops circle;
        circle.addCircle(base::toDouble(hole.centre), hole.diameter / 2.0);
        regions.emplace_back(std::move(circle));
    }
    return regions;
}

}  // namespace model
