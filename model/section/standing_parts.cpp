#include "model/section/standing_parts.h"

#include <utility>

namespace model {

namespace {

bool isPrint(BodyMaterial material) {
    return material == BodyMaterial::Print || material == BodyMaterial::DarkPrint;
}

bool isMetal(BodyMaterial material) {
    return material == BodyMaterial::Metal || material == BodyMaterial::Gold;
}

/// Adds a prism of a part, as the line cuts it.
void add(const PolygonSet& polygons, const CutLine& line, Nm bottom, Nm top, bool isTerminal, SectionPiece piece,
         std::vector<SectionPiece>& out) {
    piece.bottom = bottom;
    piece.top = top;
    piece.material = isTerminal ? SectionMaterial::Terminal : SectionMaterial::Part;
    for (const Interval& interval : cutPolygons(polygons, line)) {
        piece.from = interval.from;
        piece.to = interval.to;
        out.push_back(piece);
    }
}

}  // namespace

const BodyPlan& PartPlans::of(const Document& step, ComponentId component) {
    std::unique_ptr<BodyPlans>& plans = m_plans[&step];
    if (plans == nullptr) {
        plans = std::make_unique<BodyPlans>(step);
    }
    return plans->of(component);
}

std::vector<SectionPiece> partPieces(const Document& step, const Body& body, const BodyPlan& plan, const CutLine& line,
                                     const SectionPiece& like) {
    const AreaGeometry& area = step.areas[step.elements.geometry[body.element.row()]];
    const CutLine own = line.seenFrom(area.placement);
    std::vector<SectionPiece> out;
    add(plan.outline, own, 0, plan.bodyTop, isMetal(plan.material), like, out);
    for (const BodyPart& part : plan.parts) {
        if (!isPrint(part.material)) {
            add(part.polygons, own, part.bottom, part.top, isMetal(part.material), like, out);
        }
    }
    return out;
}

void stand(std::vector<SectionPiece>& pieces, Nm face, bool isTop) {
    for (SectionPiece& piece : pieces) {
        const Nm bottom = isTop ? face + piece.bottom : face - piece.top;
        const Nm top = isTop ? face + piece.top : face - piece.bottom;
        piece.bottom = bottom;
        piece.top = top;
    }
}

}  // namespace model
