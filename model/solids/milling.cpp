#include "model/solids/milling.h"

#include <algorithm>
#include <array>

#include "model/base/parallel.h"
#include "model/board/copies.h"
#include "model/board/holes.h"
#include "model/figures/element_polygons.h"
#include "model/geometry/boolean.h"
#include "model/geometry/box_index.h"
#include "model/solids/far_holes.h"
#include "model/solids/region_distance.h"

namespace model {

namespace {

/// Edges closer than this meet, nm.
constexpr double kMeeting = 1.0;
/// Booleans round to the grid: they move no edge so far, nm.
constexpr Nm kFar = 5;

/// How an element lies to the outline.
enum class Lie : std::uint8_t { Within, Beyond, Across };

class Outline {
public:
    explicit Outline(PolygonSet region) : m_region(std::move(region)), m_edges(m_region) {}

    [[nodiscard]] const PolygonSet& region() const { return m_region; }

    [[nodiscard]] bool isWithin(const Box& box) const { return !m_edges.meets(box) && m_edges.contains(box.min); }
    [[nodiscard]] bool isCrossedBy(const Box& box) const { return m_edges.meets(box); }
    [[nodiscard]] bool holds(Point p) const { return m_edges.contains(p); }

    /// Where an element lies, by its box if that is enough; else `polygons()` is what it covers.
    template <class Polygons>
    [[nodiscard]] Lie lieOf(const Box& box, const Polygons& polygons) const {
        if (!m_edges.meets(box)) {
            return m_edges.contains(box.min) ? Lie::Within : Lie::Beyond;
        }
        const PolygonSet set = polygons();
        if (set.polygons.empty()) {
            return Lie::Within;
        }
        if (m_edges.comesNear(set, set.polygons, box, kMeeting) || surroundsLoop(set, box)) {
            return reachesBeyond(set) ? Lie::Across : Lie::Within;
        }
        return m_edges.contains(set.points[0]) ? Lie::Within : Lie::Beyond;
    }

private:
    [[nodiscard]] bool surroundsLoop(const PolygonSet& set, const Box& box) const {
        for (std::size_t i = 0; i < m_region.loopCount(); ++i) {
            const Point p = m_region.loop(i)[0];
            if (box.holds(p) && contains(set, set.polygons, p)) {
                return true;
            }
        }
        return false;
    }

    [[nodiscard]] bool reachesBeyond(PolygonSet set) const {
        const FarHoles within(set,
                              [this](const Box& hole) { return isWithin(hole); });  // make no part of what is beyond
        return !grow(subtract(set, m_region), -static_cast<double>(kMillingTolerance)).polygons.empty();
    }

    PolygonSet m_region;
    EdgeStrips m_edges;
};

/// The holes that the outline crosses, and what they pass.
class CrossedHoles {
public:
    CrossedHoles(const Document& document, const std::vector<ElementId>& holes, const Discretisation& how)
        : m_document(document), m_index(boxesOf(document, holes)) {
        for (const ElementId hole : holes) {
            PolygonSet region = unite(discretise(document, hole, how));  // tracks of a slot overlap where it turns
            EdgeStrips edges(region);
            m_holes.push_back({std::move(region), std::move(edges), document.heightsOf(hole)});
        }
    }

    /// Rows of those that reach into the box of an element, rising. No hole passes another.
    [[nodiscard]] std::vector<std::uint32_t> through(ElementId element) const {
        std::vector<std::uint32_t> found;
        if (m_holes.empty() || isHole(m_document, element)) {
            return found;
        }
        const ZRange heights = m_document.heightsOf(element);
        const Box box = m_document.boxOf(element);
        m_index.visit(box, [&](std::uint32_t row) {
            const Hole& hole = m_holes[row];
            const bool isInReach = heights.bottom <= hole.heights.top && hole.heights.bottom <= heights.top;
            // Slots around a board have boxes as large as the board.
            if (isInReach && (hole.edges.meets(box) || hole.edges.contains(box.min))) {
                found.push_back(row);
            }
        });
        std::ranges::sort(found);
        return found;
    }

    /// What is open because of a hole.
    [[nodiscard]] const PolygonSet& regionOf(std::uint32_t row) const { return m_holes[row].region; }

    [[nodiscard]] static bool isHole(const Document& document, ElementId element) {
        return (document.elements.flags[element.row()] & kHole) != 0;
    }

private:
    struct Hole {
        PolygonSet region;
        EdgeStrips edges;
        ZRange heights;
    };

    static std::vector<Box> boxesOf(const Document& document, const std::vector<ElementId>& holes) {
        std::vector<Box> boxes;
        std::ranges::transform(holes, std::back_inserter(boxes), [&](ElementId hole) { return document.boxOf(hole); });
        return boxes;
    }

    const Document& m_document;
    BoxIndex m_index;
    std::vector<Hole> m_holes;
};

bool isCopper(const Document& document, ElementId element) {
    return document.layer(document.elements.layer[element.row()]).isCopper();
}

/// How many copper elements lie beyond an outline.
struct CopperCount {
    std::size_t within = 0;
    std::size_t beyond = 0;

    void add(bool isWithin, std::size_t count = 1) { (isWithin ? within : beyond) += count; }
};

/// The copper of a step without its copies.
struct StepCopper {
    std::vector<Box> boxes;  ///< by element
    Box extent;
};

StepCopper copperOf(const Document& step) {
    StepCopper copper;
    for (std::uint32_t row = 0; row < step.elements.size(); ++row) {
        if (isCopper(step, ElementId{row})) {
            copper.boxes.push_back(step.boxOf(ElementId{row}));
            copper.extent.include(copper.boxes.back());
        }
    }
    return copper;
}

/// Adds one copy: whole if the outline does not cross it, else each element by the middle of its box.
void addCopy(const StepCopper& copper, const Placement& placement, const Outline& outline, CopperCount& count) {
    const Box extent = placement.boxOf(copper.extent);
    if (!outline.isCrossedBy(extent)) {
        count.add(outline.holds(extent.min), copper.boxes.size());
        return;
    }
    for (const Box& box : copper.boxes) {
        count.add(outline.holds(placement.boxOf(box).middle()));
    }
}

void addCopies(const Document& document, const Outline& outline, CopperCount& count) {
    const StepTree tree = unfoldCopies(document);
    std::vector<StepCopper> steps(tree.steps.size());
    std::ranges::transform(tree.steps, steps.begin(), [](const Document* step) { return copperOf(*step); });
    for (std::size_t row = 1; row < tree.copies.size(); ++row) {  // behind the board itself
        const StepCopy& copy = tree.copies[row];
        if (!steps[copy.step].boxes.empty()) {
            addCopy(steps[copy.step], copy.placement, outline, count);
        }
    }
}

class Miller {
public:
    /// `region`: what is not milled.
    Miller(const Document& document, PolygonSet region, const Discretisation& how, const base::Progress& progress)
        : m_document(document), m_how(how), m_progress(progress), m_outline(std::move(region)) {}

    [[nodiscard]] MilledBoard run() {
        findLies();
        if (isOutlineDoubtful()) {
            return {.elements = {}, .isOutlineDoubtful = true};
        }
        std::vector<MilledElement> milled;
        const CrossedHoles holes(m_document, crossedHoles(), m_how);
        forEachOfJob([&](ElementId element) {
            if (lieOf(element) != Lie::Within || !holes.through(element).empty()) {
                milled.push_back({element, {}});
            }
        });
        std::ranges::sort(milled, {}, &MilledElement::element);
        base::parallelFor(milled.size(), [&](std::size_t row) {
            if (!m_progress.isCancelled() && lieOf(milled[row].element) != Lie::Beyond) {
                milled[row].rest = restOf(milled[row].element, holes);
            }
        });
        return {.elements = std::move(milled)};
    }

private:
    [[nodiscard]] PolygonSet polygonsOf(ElementId element) const { return discretise(m_document, element, m_how); }
    [[nodiscard]] Lie lieOf(ElementId element) const { return m_lies[element.row()]; }

    /// Not those of layers that we add.
    template <class Visit>
    void forEachOfJob(const Visit& visit) const {
        for (const Layer& layer : m_document.layers) {
            for (std::uint32_t i = 0; i < layer.elements.count && !layer.isSynthetic; ++i) {
                visit(ElementId{layer.elements.first + i});
            }
        }
    }

    void findLies() {
        std::vector<ElementId> elements;
        forEachOfJob([&](ElementId element) { elements.push_back(element); });
        m_lies.assign(m_document.elements.size(), Lie::Within);
        constexpr std::size_t kChunk = 1024;
        base::parallelFor((elements.size() + kChunk - 1) / kChunk, [&](std::size_t chunk) {
            const std::size_t end = std::min((chunk + 1) * kChunk, elements.size());
            for (std::size_t i = chunk * kChunk; i < end && !m_progress.isCancelled(); ++i) {
                const ElementId element = elements[i];
                m_lies[element.row()] = m_outline.lieOf(m_document.boxOf(element), [&] { return polygonsOf(element); });
            }
        });
    }

    [[nodiscard]] bool isOutlineDoubtful() const {
        CopperCount count;
        forEachOfJob([&](ElementId element) {
            if (isCopper(m_document, element)) {
                count.add(lieOf(element) != Lie::Beyond);
            }
        });
        if (!m_document.instances.empty()) {
            addCopies(m_document, m_outline, count);
        }
        return count.beyond > count.within;
    }

    [[nodiscard]] std::vector<ElementId> crossedHoles() const {
        std::vector<ElementId> holes;
        forEachOfJob([&](ElementId element) {
            if (lieOf(element) == Lie::Across && CrossedHoles::isHole(m_document, element)) {
                holes.push_back(element);
            }
        });
        return holes;
    }

    [[nodiscard]] PolygonSet restOf(ElementId element, const CrossedHoles& holes) const {
        PolygonSet open;
        if (CrossedHoles::isHole(m_document, element)) {
            open = discretiseOpening(m_document, element, m_how);
        }
        for (const std::uint32_t hole : holes.through(element)) {
            open.append(holes.regionOf(hole));
        }
        const EdgeStrips opened(open);
        const bool isAcross = lieOf(element) == Lie::Across;
        PolygonSet rest = polygonsOf(element);
        const FarHoles far(rest, [&](const Box& hole) {
            const Box around = hole.grownBy(kFar);
            const bool isOpened = opened.meets(around) || opened.contains(around.min);
            return !isOpened && (!isAcross || m_outline.isWithin(around));
        });
        if (!open.polygons.empty()) {
            rest = subtract(rest, open);
        }
        return far.putBack(isAcross ? intersect(rest, m_outline.region()) : std::move(rest));
    }

    const Document& m_document;
    Discretisation m_how;
    const base::Progress& m_progress;
    Outline m_outline;
    std::vector<Lie> m_lies;  ///< by element
};

/// Around all that a step draws, and clear of it.
Box boxAround(const Document& step) {
    Box box = step.shapes.shapes[step.profile.row()].box;
    for (std::uint32_t row = 0; row < step.elements.size(); ++row) {
        box.include(step.boxOf(ElementId{row}));
    }
    constexpr Nm kClear = 1'000'000;
    return box.grownBy(kClear);
}

/// All but the cut-outs.
PolygonSet around(const PolygonSet& cutouts, const Document& step) {
    const Box box = boxAround(step);
    const std::array<Point, 4> corners{box.min, Point{box.max.x, box.min.y}, box.max, Point{box.min.x, box.max.y}};
    PolygonSet all;
    all.beginPolygon();
    all.addLoop(corners);
    return subtract(all, cutouts);
}

}  // namespace

MilledBoard findMilled(const Document& document, const Discretisation& how, const base::Progress& progress) {
    if (!document.profile.isValid()) {
        return {};
    }
    return Miller(document, discretise(document.shapes, document.profile, how), how, progress).run();
}

PolygonSet cutoutsOf(const Document& step, const Discretisation& how) {
    const bool hasCutouts =
        step.profile.isValid() && std::ranges::any_of(step.shapes.contoursOf(step.profile), &Contour::isHole);
    if (!hasCutouts) {
        return {};
    }
    const PolygonSet outline = discretise(step.shapes, step.profile, how);
    PolygonSet filled;
    for (const PolygonSet::Polygon& polygon : outline.polygons) {
        filled.beginPolygon();
        filled.addLoop(outline.loop(polygon.firstLoop));
    }
    return subtract(filled, outline);
}

std::vector<PolygonSet> cutoutsOfCopies(const StepTree& tree, const Discretisation& how) {
    std::vector<PolygonSet> ofSteps(tree.steps.size());
    for (std::size_t row = 1; row < tree.steps.size(); ++row) {
        ofSteps[row] = cutoutsOf(*tree.steps[row], how);
    }
    std::vector<PolygonSet> ofCopies(tree.copies.size());
    for (std::size_t row = 1; row < tree.copies.size(); ++row) {
        ofCopies[row] = placed(ofSteps[tree.copies[row].step], tree.copies[row].placement);
    }
    return ofCopies;
}

MilledBoard findInCutouts(const Document& step, const Discretisation& how, const base::Progress& progress) {
    const PolygonSet cutouts = cutoutsOf(step, how);
    return cutouts.polygons.empty() ? MilledBoard{} : Miller(step, around(cutouts, step), how, progress).run();
}

}  // namespace model
