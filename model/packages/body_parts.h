#pragma once

#include "model/packages/body_plan.h"

namespace model {

/// Adds leads, terminals, pins through the board and the mark of pin 1 to a plan whose body is known. Both in package
/// coordinates with the leads along x (PinPattern::isAlongY false), or on four sides.
void addBodyParts(const PackageFacts& facts, PartKind kind, BodyPlan& plan);

/// A polygon of a box, and of a disc by chords; appended.
void addBox(const Box& box, PolygonSet& polygons);
void addDisc(Point centre, Nm radius, PolygonSet& polygons);

}  // namespace model
