#pragma once

#include <memory>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

#include "model/base/progress.h"
#include "model/base/result.h"
#include "model/board/copies.h"
#include "model/export/solids/copper_holes.h"
#include "model/export/solids/solid_choice.h"
#include "model/solids/milling.h"
#include "model/solids/shells/element_shells.h"
#include "model/solids/shells/merged_shells.h"
#include "model/solids/shells/shared_shape.h"

namespace model {

/// The solids of one net on one layer, or of one component's body.
struct SolidGroup {
    LayerId layer;
    NetId net;              ///< none: what has no net
    ComponentId component;  ///< on layers of bodies
    Range elements;         ///< of StepSolids::elements
};

/// What of one document of a panel (or of the only one) is written, as it lies, upside down or mirrored.
struct StepSolids {
    const Document* document = nullptr;
    bool isFlipped = false;           ///< of copies that lie upside down: heights are those of heightsInCopy
    bool isMirrored = false;          ///< of copies with such a placement: solids are mirrored x -> -x
    std::vector<SolidGroup> groups;   ///< by layer as in the document, then by net
    std::vector<ElementId> elements;  ///< group by group
    std::vector<MilledElement> milled;
    /// What is drilled through its copper: all holes of the document, whatever is chosen, but for narrow ones
    /// (SolidChoice::minHole) and those that milling has cut out already.
    std::shared_ptr<const CopperHoles> holes;
    /// How often each shape appears; one that appears twice or more is worth sharing.
    std::unordered_map<ShapeKey, std::uint32_t, ShapeKeyHash> uses;
};

/// Where solids of a row of SolidPlan::steps are placed.
struct SolidCopy {
    std::uint32_t step = 0;
    Placement placement;  ///< never mirrored
};

/// Why an element is not among what was written, or not all of it.
struct MissingSolid {
    std::uint32_t step = 0;
    ElementId element;
    std::string_view reason;
};

/// What is written, in which tree: board or step, layer, net. Steps are there once, however many copies a panel has.
struct SolidPlan {
    SolidChoice choice;
    std::vector<StepSolids> steps;  ///< the board itself first
    std::vector<SolidCopy> copies;  ///< the board itself first
    std::uint64_t elements = 0;     ///< of all steps, each once

    /// The name of a group as people read it: the net, "no net", or the component.
    [[nodiscard]] std::string nameOf(const StepSolids& step, const SolidGroup& group) const;
    /// The solids of an element as the choice wants them: milled, copper drilled, with small holes closed, in the
    /// coordinates of the step, or of the mirrored step. None, and no problem, where a drill takes all of it.
    [[nodiscard]] ElementShells shellsOf(const StepSolids& step, ElementId element) const;
    /// The same without what is drilled through copper: for what is united first and drilled then.
    [[nodiscard]] ElementShells undrilledShellsOf(const StepSolids& step, ElementId element) const;
    /// What is to be drilled out of copper of that layer near a box, in the coordinates of the shells.
    [[nodiscard]] std::vector<EdgeLoops> holesNear(const StepSolids& step, LayerId layer, const Box& box) const;
    /// From where to where it is solid.
    [[nodiscard]] ZRange heightsOf(const StepSolids& step, ElementId element) const;
    /// Its shape, if that appears more than once in the step.
    [[nodiscard]] std::optional<SharedShape> sharedShapeOf(const StepSolids& step, ElementId element) const;
    /// With SolidChoice::isMerged, the copper of a net as few solids; elsewhere, and where something of it is milled,
    /// nothing: then its elements are written one by one. Drilled.
    [[nodiscard]] std::optional<MergedShells> mergedShellsOf(const StepSolids& step, const SolidGroup& group) const;
    /// The solids of such a shape, where SharedShape::placement is none.
    [[nodiscard]] ElementShells shellsOf(const StepSolids& step, const ShapeKey& key) const;

private:
    [[nodiscard]] ElementShells shellsOf(const StepSolids& step, ElementId element, ElementOutlines outlines) const;
};

/// A layer of the job that draws where a solder mask is open, and the synthetic layer that is the mask.
struct ChosenOpenings {
    LayerId openings;
    LayerId mask;
};
/// Those that are chosen by name without the mask: their solids are the openings filled, at the height of the mask.
[[nodiscard]] std::vector<ChosenOpenings> chosenOpenings(const Document& board, const SolidChoice& choice);

/// Errors: BadUsage for a net that is not there, or when nothing is left to write: no copper of the nets, or nothing in
/// the window, where substrates, which are never cut, do not count unless the board reaches into it; Cancelled.
[[nodiscard]] base::Result<SolidPlan> planSolids(const Document& board, const SolidChoice& choice,
                                                 const base::Progress& progress);

}  // namespace model
