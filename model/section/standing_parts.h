#pragma once

#include <memory>
#include <vector>

#include "model/packages/body_plan.h"
#include "model/section/line_cut.h"
#include "model/section/section_piece.h"

/// Components in a section: the bodies, leads and terminals that model/packages tells from their pins, standing on the
/// board.
namespace model {

/// Plans of the steps that are cut, made when a component is met.
class PartPlans {
public:
    [[nodiscard]] const BodyPlan& of(const Document& step, ComponentId component);

private:
    std::map<const Document*, std::unique_ptr<BodyPlans>> m_plans;
};

/// What a line cuts of the component of a body: prisms with heights from the face it stands on, outwards (negative:
/// into the board and through it). `layer` and `at` are those of the body. What is printed on it is left out.
[[nodiscard]] std::vector<SectionPiece> partPieces(const Document& step, const Body& body, const BodyPlan& plan,
                                                   const CutLine& line, const SectionPiece& like);

/// The pieces of a part moved to where it stands: on a face at this height, outwards.
void stand(std::vector<SectionPiece>& pieces, Nm face, bool isTop);

}  // namespace model
