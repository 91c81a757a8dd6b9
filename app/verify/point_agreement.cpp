#include "app/verify/point_agreement.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <random>

#include "model/figures/distance.h"
#include "model/geometry/box_index.h"
#include "model/geometry/vectors.h"
#include "model/solids/shells/drilled_copper.h"

namespace app {

using base::Box;
using base::Nm;
using base::PointD;
using model::ElementId;

namespace {

constexpr double kNear = 50'000.0;

/// An element of a copy where it lies.
struct Member {
    std::uint32_t step = 0;
    ElementId element;
    model::Placement placement;  ///< from the step's coordinates, as it lies or upside down
    model::ZRange z;
    Box box;
};

bool covers(const model::FigureTable& figures, PointD p) {
    model::FigureTable point;
    point.addTrack(p, p, 0.0);
    for (std::size_t row = 0; row < figures.size(); ++row) {
        const auto spacing = model::spacingBetween(figures, row, point, 0, 0.0);
        if (spacing && spacing->distance <= 0.0) {
            return true;
        }
    }
    return false;
}

/// Which points of the copper of a step are drilled away, by the figures of the holes: not as the export cuts them.
class DrilledPoints {
public:
    explicit DrilledPoints(const model::Document& document) : m_document(&document) {
        for (std::size_t row = 0; row < document.layers.size(); ++row) {
            m_ofLayers.emplace_back();
            if (document.layers[row].isCopper()) {
                m_ofLayers.back() = model::holesThrough(document, model::LayerId{row});
            }
            std::vector<Box> boxes;
            for (const ElementId hole : m_ofLayers.back()) {
                boxes.push_back(document.boxOf(hole));
            }
            m_indices.emplace_back(boxes);
        }
    }

    [[nodiscard]] bool isDrilled(model::LayerId layer, PointD p) const {
        bool isOpen = false;
        m_indices[layer.row()].visit(model::boxAround(p, 1.0), [&](std::uint32_t row) {
            model::FigureTable drill;
            drill.add(*m_document, m_ofLayers[layer.row()][row]);
            isOpen = isOpen || covers(drill, p);
        });
        return isOpen;
    }

private:
    const model::Document* m_document;
    std::vector<std::vector<ElementId>> m_ofLayers;  ///< none on layers that are no copper
    std::vector<model::BoxIndex> m_indices;
};

/// The document as a model that knows which points are inside.
class DocumentSolids {
public:
    explicit DocumentSolids(const model::SolidPlan& plan) : m_plan(plan) {
        for (const model::SolidCopy& copy : plan.copies) {
            const model::StepSolids& step = plan.steps[copy.step];
            for (const ElementId element : step.elements) {
                add(copy, step, element);
            }
        }
        std::vector<Box> boxes;
        for (const Member& member : m_members) {
            boxes.push_back(member.box);
        }
        m_index = std::make_unique<model::BoxIndex>(boxes);
        for (const model::StepSolids& step : plan.steps) {
            m_holes.emplace_back(*step.document);
        }
    }

    [[nodiscard]] const std::vector<Member>& members() const { return m_members; }

    [[nodiscard]] bool contains(const std::array<double, 3>& p) const {
        bool isInside = false;
        m_index->visit(model::boxAround({p[0], p[1]}, 1.0), [&](std::uint32_t row) {
            const Member& member = m_members[row];
            const bool isAtHeight = member.z.bottom <= p[2] && p[2] <= member.z.top;
            isInside = isInside || (isAtHeight && isCovered(member, {p[0], p[1]}));
        });
        return isInside;
    }

private:
    void add(const model::SolidCopy& copy, const model::StepSolids& step, ElementId element) {
        Member member{copy.step, element, copy.placement, m_plan.heightsOf(step, element), {}};
        if (step.isMirrored) {
            member.placement = member.placement.after({{}, 0.0, true});
        }
        member.box = member.placement.boxOf(step.document->boxOf(element));
        m_members.push_back(member);
    }

    [[nodiscard]] bool isCovered(const Member& member, PointD p) const {
        const model::StepSolids& step = m_plan.steps[member.step];
        const PointD own = model::unplaced(p, member.placement);
        model::FigureTable figures;
        figures.add(*step.document, member.element);
        const model::LayerId layer = step.document->elements.layer[member.element.row()];
        return covers(figures, own) && !isInOpening(*step.document, member.element, own) &&
               !m_holes[member.step].isDrilled(layer, own);
    }

    /// Figures take the inside of a barrel for filled.
    static bool isInOpening(const model::Document& document, ElementId element, PointD p) {
        if ((document.elements.flags[element.row()] & model::kHole) == 0) {
            return false;
        }
        const std::uint32_t row = document.elements.geometry[element.row()];
        model::FigureTable opening;
        if (document.elements.kind[element.row()] == model::ElementKind::Circle) {
            opening.addDisc(document.circles[row].centre, document.circles[row].innerDiameter / 2.0);
        } else if (document.elements.kind[element.row()] == model::ElementKind::Line) {
            const model::LineGeometry& line = document.lines[row];
            opening.addTrack(base::toDouble(line.a), base::toDouble(line.b), line.innerWidth / 2.0);
        }
        return covers(opening, p);
    }

    const model::SolidPlan& m_plan;
    std::vector<Member> m_members;
    std::unique_ptr<model::BoxIndex> m_index;
    std::vector<DrilledPoints> m_holes;  ///< by step
};

/// The solids of a file by their boxes.
class FileSolids {
public:
    explicit FileSolids(const StepFile& file) : m_file(file) {
        std::vector<Box> boxes;
        for (std::size_t i = 0; i < file.size(); ++i) {
            const StepSolid solid = file.solid(i);
            const auto nm = [&](int k, double round) { return static_cast<Nm>(std::llround(solid.box[k] + round)); };
            boxes.push_back({{nm(0, -1), nm(1, -1)}, {nm(3, 1), nm(4, 1)}});
            m_heights.push_back({nm(2, -1), nm(5, 1)});
        }
        m_index = std::make_unique<model::BoxIndex>(boxes);
    }

    [[nodiscard]] bool contains(const std::array<double, 3>& p) const {
        bool isInside = false;
        m_index->visit(model::boxAround({p[0], p[1]}, 1.0), [&](std::uint32_t row) {
            const bool isAtHeight = m_heights[row].bottom <= p[2] && p[2] <= m_heights[row].top;
            isInside = isInside || (isAtHeight && m_file.contains(row, p));
        });
        return isInside;
    }

private:
    const StepFile& m_file;
    std::vector<model::ZRange> m_heights;
    std::unique_ptr<model::BoxIndex> m_index;
};

class Points {
public:
    Points(const model::SolidPlan& plan, const std::vector<Member>& members, std::uint64_t seed)
        : m_plan(plan), m_members(members), m_random(seed) {
        m_heights = {members.front().z.bottom, members.front().z.top};
        for (const Member& member : members) {
            m_box.include(member.box);
            m_heights.bottom = std::min(m_heights.bottom, member.z.bottom);
            m_heights.top = std::max(m_heights.top, member.z.top);
        }
    }

    std::array<double, 3> anywhere() {
        return {within(m_box.min.x, m_box.max.x), within(m_box.min.y, m_box.max.y),
                within(m_heights.bottom, m_heights.top)};
    }

    std::array<double, 3> nearAWall() {
        const Member& member = m_members[m_random() % m_members.size()];
        const model::StepSolids& step = m_plan.steps[member.step];
        model::FigureTable figures;
        figures.add(*step.document, member.element);
        if (figures.size() == 0) {
            return anywhere();
        }
        const auto edges = figures.edges(m_random() % figures.size());
        const model::Edge& edge = edges[m_random() % edges.size()];
        PointD p = model::pointAt(edge, within(0.0, model::lengthOf(edge)));
        const double angle = within(0.0, 6.283185307179586);
        const double reach = edge.pen + within(-kNear, kNear);
        p = {p.x + std::cos(angle) * reach, p.y + std::sin(angle) * reach};
        p = member.placement.apply(p);
        return {p.x, p.y, within(member.z.bottom - kNear / 10, member.z.top + kNear / 10)};
    }

private:
    double within(double low, double high) { return std::uniform_real_distribution<double>(low, high)(m_random); }

    const model::SolidPlan& m_plan;
    const std::vector<Member>& m_members;
    std::mt19937_64 m_random;
    Box m_box;
    model::ZRange m_heights;
};

}  // namespace

PointAgreement comparePoints(const model::SolidPlan& plan, const StepFile& file, std::uint64_t points,
                             std::uint64_t seed) {
    const DocumentSolids document(plan);
    const FileSolids solids(file);
    Points source(plan, document.members(), seed);
    PointAgreement agreement;
    for (std::uint64_t i = 0; i < points; ++i) {
        const std::array<double, 3> p = i % 2 == 0 ? source.anywhere() : source.nearAWall();
        const bool isInside = document.contains(p);
        ++agreement.points;
        agreement.inside += isInside ? 1 : 0;
        agreement.agreeing += isInside == solids.contains(p) ? 1 : 0;
    }
    return agreement;
}

}  // namespace app
