#pragma once

#include "model/design_rules/rule_context.h"

namespace model {

/// A hole that is drilled, and how far.
struct DrilledHole {
    ElementId element;
    Box box;
    const Layer& layer;
    bool isPlated = false;

    /// Back-drills and counterbores, which go into a hole that is there.
    [[nodiscard]] bool isIntoAnother() const {
        return layer.use == LayerUse::Backdrill || layer.use == LayerUse::DualDiameter;
    }
    [[nodiscard]] bool hasSpan() const { return layer.spanTop.isValid() && layer.spanBottom.isValid(); }
};

/// All holes of a step, whatever their layers.
[[nodiscard]] LayerGeometry allHoles(const Document& document);
/// The one in this row of `holes`.
[[nodiscard]] DrilledHole drilledHole(const Document& document, const LayerGeometry& holes, std::uint32_t row);

/// Have two boxes one middle, to a micrometre?
[[nodiscard]] bool areConcentric(const Box& a, const Box& b);
/// Have they one size, to a micrometre?
[[nodiscard]] bool areOfOneSize(const Box& a, const Box& b);
/// Do two holes meet in one copper layer at most? On which one lands the other begins, in a stack of microvias.
[[nodiscard]] bool areOfStack(const DrilledHole& a, const DrilledHole& b);
/// Are they one hole that the job has twice: of one middle, size, plating and net? Vias of a stack are not.
[[nodiscard]] bool areOneHole(const RuleContext& context, const DrilledHole& a, const DrilledHole& b);

}  // namespace model
