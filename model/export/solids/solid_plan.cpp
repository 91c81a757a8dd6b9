#include "model/export/solids/solid_plan.h"

#include <algorithm>
#include <map>
#include <set>

#include "model/board/holes.h"
#include "model/board/layers.h"
#include "model/geometry/loops/fit_arcs.h"
#include "model/geometry/loops/needless_corners.h"
#include "model/geometry/loops/region_booleans.h"
#include "model/solids/drilled_print.h"

namespace model {

namespace {

/// Round holes that the choice leaves out.
bool isNarrowHole(const Document& document, ElementId element, Nm minHole) {
    const std::size_t row = element.row();
    return (document.elements.flags[row] & kHole) != 0 && document.elements.kind[row] == ElementKind::Circle &&
           document.circles[document.elements.geometry[row]].diameter < minHole;
}

/// How a copy of a step lies, but for where.
struct CopyKind {
    bool isFlipped = false;
    bool isMirrored = false;
    auto operator<=>(const CopyKind&) const = default;
};

/// Which elements of a document the choice wants, of layers by where its copies have them.
class Filter {
public:
    Filter(const Document& document, const CopyKind& kind, const SolidChoice& choice)
        : m_document(document), m_kind(kind), m_choice(choice) {
        for (const std::string& name : choice.nets) {
            if (const NetId net = document.findNet(name); net.isValid()) {
                m_nets.insert(net);
            }
        }
    }

    [[nodiscard]] bool takes(LayerId id) const {
        const Layer& layer = m_document.layer(id);
        const bool isChosen = std::ranges::count(m_choice.layers, m_document.layerOfCopy(id, m_kind.isFlipped)) > 0;
        if (m_choice.isOuterOnly && !isOutside(layer, isChosen)) {
            return false;
        }
        return m_choice.layers.empty() ? isSolidLayer(layer) : isChosen;
    }

    [[nodiscard]] bool takes(ElementId element) const {
        const std::size_t row = element.row();
        const Layer& layer = m_document.layer(m_document.elements.layer[row]);
        if (layer.isSynthetic && layer.type != LayerType::ComponentBody) {
            return true;
        }
        const std::uint8_t flags = m_document.elements.flags[row];
        if (m_choice.isOuterOnly && layer.isCopper() && !isSolderPad(row)) {
            return false;
        }
        const bool isConductor = layer.isCopper() || (flags & kHole) != 0;
        if (isConductor && !m_choice.nets.empty() && !m_nets.contains(m_document.elements.net[row])) {
            return false;
        }
        return !isTooNarrow(row) && (!m_choice.window || m_choice.window->meets(m_document.boxOf(element)));
    }

private:
    static bool isOutside(const Layer& layer, bool isChosen) {
        const bool isOuterCopper =
            layer.isCopper() && (layer.side == LayerSide::Top || layer.side == LayerSide::Bottom);
        return (isOuterCopper && isChosen) || layer.type == LayerType::Body || layer.type == LayerType::ComponentBody;
    }

    [[nodiscard]] bool isSolderPad(std::size_t row) const {
        const SubnetId subnet = m_document.elements.subnet[row];
        const bool isOfVia = subnet.isValid() && m_document.subnets[subnet.row()].kind == SubnetKind::Via;
        return (m_document.elements.flags[row] & kPad) != 0 && !isOfVia;
    }

    [[nodiscard]] bool isTooNarrow(std::size_t row) const {
        return isNarrowHole(m_document, ElementId{row}, m_choice.minHole);
    }

    const Document& m_document;
    CopyKind m_kind;
    const SolidChoice& m_choice;
    std::set<NetId> m_nets;  ///< of SolidChoice::nets those that the document has
};

ComponentId componentOf(const Document& document, ElementId element) {
    const Body* body = document.bodyOf(element);
    return body != nullptr ? body->component : ComponentId{};
}

/// Orders the elements of a layer by net, bodies by component.
struct Member {
    NetId net;
    ComponentId component;
    ElementId element;
    auto operator<=>(const Member&) const = default;
};

void addLayer(StepSolids& step, LayerId layer, std::vector<Member>& members) {
    std::ranges::sort(members);
    for (const Member& member : members) {
        const bool isNew = step.groups.empty() || step.groups.back().layer != layer ||
                           step.groups.back().net != member.net || step.groups.back().component != member.component;
        if (isNew) {
            const auto first = static_cast<std::uint32_t>(step.elements.size());
            step.groups.push_back({layer, member.net, member.component, {first, 0}});
        }
        step.elements.push_back(member.element);
        ++step.groups.back().elements.count;
    }
}

bool isSolid(const Document& document, ElementId element, bool isFlipped) {
    const ZRange z = solidHeightsOf(document, element, isFlipped);
    const bool isOfHoles = isHoles(document.layer(document.elements.layer[element.row()]).type);
    return z.top > z.bottom && (!isOfHoles || isPlatedHole(document.elements.flags[element.row()]));
}

StepSolids solidsOf(const Document& document, const CopyKind& kind, const SolidChoice& choice) {
    StepSolids step;
    step.document = &document;
    step.isFlipped = kind.isFlipped;
    step.isMirrored = kind.isMirrored;
    const Filter filter(document, kind, choice);
    std::vector<Member> members;
    for (std::size_t row = 0; row < document.layers.size(); ++row) {
        const LayerId layer{static_cast<std::uint32_t>(row)};
        if (!filter.takes(layer)) {
            continue;
        }
        members.clear();
        const Range range = document.layers[row].elements;
        for (std::uint32_t i = range.first; i < range.first + range.count; ++i) {
            const ElementId element{i};
            if (filter.takes(element) && isSolid(document, element, kind.isFlipped)) {
                members.push_back({document.elements.net[i], componentOf(document, element), element});
            }
        }
        addLayer(step, layer, members);
    }
    return step;
}

void countUses(StepSolids& step) {
    for (const ElementId element : step.elements) {
        if (const auto shape = step.holes->sharedShapeOf(element)) {
            ++step.uses[shape->key];
        }
    }
}

/// Takes round holes narrower than `minHole` out of a region.
void closeHoles(EdgeLoops& region, Nm minHole) {
    EdgeLoops kept;
    kept.loopStart.clear();
    for (std::size_t i = 0; i < region.loopCount(); ++i) {
        const std::span<const Edge> loop = region.loop(i);
        const bool isNarrow = i > 0 && loop.front().isFullCircle() && 2 * loop.front().radius < minHole;
        if (!isNarrow) {
            kept.loopStart.push_back(static_cast<std::uint32_t>(kept.edges.size()));
            kept.edges.insert(kept.edges.end(), loop.begin(), loop.end());
        }
    }
    kept.loopStart.push_back(static_cast<std::uint32_t>(kept.edges.size()));
    region = std::move(kept);
}

const MilledElement* milledOf(const StepSolids& step, ElementId element) {
    const auto found = std::ranges::lower_bound(step.milled, element, {}, &MilledElement::element);
    return found != step.milled.end() && found->element == element ? &*found : nullptr;
}

constexpr Placement kMirror{{}, 0.0, true};

constexpr std::string_view kCoarseHoles = "holes are cut out of it with chords of 1 µm";

/// A hole that the outline of the board crosses has been cut out of what it passes when that was milled.
std::shared_ptr<const CopperHoles> holesOf(const StepSolids& step, const SolidChoice& choice,
                                           const base::Progress& progress) {
    auto holes = std::make_shared<CopperHoles>(*step.document, [&](ElementId hole) {
        return !isNarrowHole(*step.document, hole, choice.minHole) && milledOf(step, hole) == nullptr;
    });
    holes->compare(step.elements, progress);
    return holes;
}

/// Cuts out what is drilled through copper of a layer.
RegionBoolean drilledOn(const StepSolids& step, LayerId layer, EdgeLoops region) {
    const std::vector<RegionSearch> holes = step.holes->near(layer, boxOf(region));
    return drilled(std::move(region), holes);
}

void drill(const StepSolids& step, LayerId layer, ElementOutlines& outlines) {
    RegionBoolean rest;
    for (EdgeLoops& region : outlines.regions) {
        rest.append(drilledOn(step, layer, std::move(region)));
    }
    outlines.regions = std::move(rest.regions);
    if (!rest.isExact && outlines.problem.empty()) {
        outlines.problem = kCoarseHoles;
    }
}

/// The regions of an element, milled.
ElementOutlines milledOutlinesOf(const StepSolids& step, ElementId element) {
    const MilledElement* milled = milledOf(step, element);
    return milled != nullptr ? ElementOutlines{regionsOf(milled->rest), {}} : outlinesOf(*step.document, element);
}

/// A region as the choice wants it, mirrored if the step is.
EdgeLoops finished(EdgeLoops region, const SolidChoice& choice, bool isMirrored) {
    region = withoutNeedlessCorners(region, kCornerTolerance);
    if (choice.hasFittedArcs) {
        region = withFittedArcs(region, kArcTolerance);
    }
    return isMirrored ? placed(region, kMirror) : region;
}

/// The rows of documents of a panel, one for each way in which copies lie.
class StepRows {
public:
    explicit StepRows(SolidPlan& plan) : m_plan(plan) {}

    std::uint32_t rowOf(const Document& document, const CopyKind& kind) {
        const auto next = static_cast<std::uint32_t>(m_plan.steps.size());
        const auto [found, isNew] = m_rows.try_emplace({&document, kind}, next);
        if (isNew) {
            m_plan.steps.push_back(solidsOf(document, kind, m_plan.choice));
        }
        return found->second;
    }

private:
    SolidPlan& m_plan;
    std::map<std::pair<const Document*, CopyKind>, std::uint32_t> m_rows;
};

/// A mirrored placement of a step, as one of the mirrored step.
Placement ofMirrored(const Placement& placement) {
    return placement.isMirrored ? Placement{placement.origin, -placement.clockwiseDeg, false} : placement;
}

base::Status checkNets(const StepTree& tree, const SolidChoice& choice) {
    for (const std::string& name : choice.nets) {
        const bool isThere =
            std::ranges::any_of(tree.steps, [&](const Document* step) { return step->findNet(name).isValid(); });
        if (!isThere) {
            return base::Error{base::ErrorCode::BadUsage, "there is no net " + name};
        }
    }
    return base::Done{};
}

/// What a choice leaves of the board beside substrates and films, which are there whatever is chosen: none is a
/// mistake. A window that only the board itself reaches into is no mistake.
base::Status checkLeft(const SolidPlan& plan, const Document& board) {
    const SolidChoice& choice = plan.choice;
    const auto isIn = [&](const auto& isWanted) {
        return std::ranges::any_of(plan.steps, [&](const StepSolids& step) {
            return std::ranges::any_of(step.groups,
                                       [&](const SolidGroup& group) { return isWanted(*step.document, group); });
        });
    };
    const bool isOfNets = isIn([&](const Document& step, const SolidGroup& group) {
        return group.net.isValid() && std::ranges::count(choice.nets, step.nets[group.net.row()].name) > 0;
    });
    const bool isDrawn = isIn([](const Document& step, const SolidGroup& group) {
        return group.component.isValid() || !step.layer(group.layer).isSynthetic;
    });
    const bool isMissed = choice.window && !isDrawn && !choice.window->meets(board.board);
    if (plan.elements == 0 || isMissed || (!choice.nets.empty() && !isOfNets)) {
        return base::Error{base::ErrorCode::BadUsage, "nothing on the board is left to export with these choices"};
    }
    return base::Done{};
}

}  // namespace

bool isSolidLayer(const Layer& layer) {
    switch (layer.type) {
        case LayerType::Signal:
        case LayerType::PowerGround:
        case LayerType::Mixed:
        case LayerType::Drill:
        case LayerType::Rout: return layer.context == LayerContext::Board;
        case LayerType::SilkScreen: return layer.context == LayerContext::Board && !isDrawingAsSilkscreen(layer);
        case LayerType::Body:
        case LayerType::ComponentBody: return true;
        case LayerType::SolderMask: return layer.isSynthetic;
        default: return false;
    }
}

std::vector<ChosenOpenings> chosenOpenings(const Document& board, const SolidChoice& choice) {
    const auto isChosen = [&](LayerId id) { return std::ranges::count(choice.layers, id) > 0; };
    std::vector<ChosenOpenings> found;
    for (const LayerId id : choice.layers) {
        const Layer& openings = board.layer(id);
        const auto mask = std::ranges::find_if(board.layers, [&](const Layer& layer) {
            return layer.type == LayerType::SolderMask && layer.isSynthetic && layer.side == openings.side;
        });
        const bool isOpenings = openings.type == LayerType::SolderMask && !openings.isSynthetic;
        if (isOpenings && mask != board.layers.end()) {
            const LayerId maskId{static_cast<std::size_t>(mask - board.layers.begin())};
            if (!isChosen(maskId)) {
                found.push_back({id, maskId});
            }
        }
    }
    return found;
}

std::string SolidPlan::nameOf(const StepSolids& step, const SolidGroup& group) const {
    const Document& document = *step.document;
    if (group.component.isValid()) {
        return document.components[group.component.row()].refdes;
    }
    if (group.net.isValid()) {
        return document.nets[group.net.row()].name;
    }
    return document.layer(group.layer).isSynthetic ? document.layer(group.layer).name : "no net";
}

ZRange SolidPlan::heightsOf(const StepSolids& step, ElementId element) const {
    return solidHeightsOf(*step.document, element, step.isFlipped);
}

ElementShells SolidPlan::shellsOf(const StepSolids& step, ElementId element) const {
    ElementOutlines outlines = milledOutlinesOf(step, element);
    drill(step, step.document->elements.layer[element.row()], outlines);
    return shellsOf(step, element, std::move(outlines));
}

ElementShells SolidPlan::undrilledShellsOf(const StepSolids& step, ElementId element) const {
    return shellsOf(step, element, milledOutlinesOf(step, element));
}

ElementShells SolidPlan::shellsOf(const StepSolids& step, ElementId element, ElementOutlines outlines) const {
    ElementShells result;
    result.problem = outlines.problem;
    const LayerId layer = step.document->elements.layer[element.row()];
    const bool isSubstrate = step.document->layer(layer).type == LayerType::Body;
    const ZRange z = heightsOf(step, element);
    for (EdgeLoops& region : outlines.regions) {
        if (isSubstrate && choice.minHole > 0) {
            closeHoles(region, choice.minHole);
        }
        result.shells.push_back({finished(std::move(region), choice, step.isMirrored), z});
    }
    return result;
}

std::vector<EdgeLoops> SolidPlan::holesNear(const StepSolids& step, LayerId layer, const Box& box) const {
    std::vector<EdgeLoops> holes;
    for (const RegionSearch& hole : step.holes->near(layer, step.isMirrored ? kMirror.boxOf(box) : box)) {
        holes.push_back(step.isMirrored ? placed(hole.region(), kMirror) : hole.region());
    }
    return holes;
}

std::optional<SharedShape> SolidPlan::sharedShapeOf(const StepSolids& step, ElementId element) const {
    if (milledOf(step, element) != nullptr) {
        return std::nullopt;
    }
    std::optional<SharedShape> shape = step.holes->sharedShapeOf(element);
    const auto uses = shape ? step.uses.find(shape->key) : step.uses.end();
    if (uses == step.uses.end() || uses->second < 2) {
        return std::nullopt;
    }
    if (step.isFlipped) {
        const ZRange z = heightsOf(step, element);
        shape->key.bottom = z.bottom;
        shape->key.top = z.top;
    }
    if (step.isMirrored) {
        shape->placement.origin.x = -shape->placement.origin.x;
        shape->placement.clockwiseDeg = -shape->placement.clockwiseDeg;
    }
    return shape;
}

std::optional<MergedShells> SolidPlan::mergedShellsOf(const StepSolids& step, const SolidGroup& group) const {
    const auto members = std::span(step.elements).subspan(group.elements.first, group.elements.count);
    const bool isMilled =
        std::ranges::any_of(members, [&](ElementId element) { return milledOf(step, element) != nullptr; });
    if (!choice.isMerged || isMilled || !group.net.isValid() || !step.document->layer(group.layer).isCopper()) {
        return std::nullopt;
    }
    MergedShells merged = mergedShells(*step.document, members);
    const ZRange z = heightsOf(step, members.front());
    std::vector<Shell> shells;
    for (Shell& shell : merged.shells) {
        RegionBoolean rest = drilledOn(step, group.layer, std::move(shell.outline));
        merged.problems += rest.isExact ? 0 : 1;
        for (EdgeLoops& region : rest.regions) {
            shells.push_back({finished(std::move(region), choice, step.isMirrored), z});
        }
    }
    merged.shells = std::move(shells);
    return merged;
}

ElementShells SolidPlan::shellsOf(const StepSolids& step, const ShapeKey& key) const {
    ElementOutlines outlines = outlinesOf(*step.document, key);
    RegionBoolean rest;
    for (EdgeLoops& region : outlines.regions) {
        rest.append(drilled(std::move(region), step.holes->through(key)));
    }
    ElementShells result;
    result.problem = !rest.isExact && outlines.problem.empty() ? kCoarseHoles : outlines.problem;
    for (EdgeLoops& region : rest.regions) {
        result.shells.push_back({finished(std::move(region), choice, step.isMirrored), {key.bottom, key.top}});
    }
    return result;
}

base::Result<SolidPlan> planSolids(const Document& board, const SolidChoice& choice, const base::Progress& progress) {
    const StepTree tree = unfoldCopies(board);
    RETURN_IF_ERROR(checkNets(tree, choice));
    SolidPlan plan{choice, {}, {}, 0};
    StepRows rows(plan);
    for (const StepCopy& copy : tree.copies) {
        const CopyKind kind{copy.isFlipped, copy.placement.isMirrored};
        plan.copies.push_back({rows.rowOf(*tree.steps[copy.step], kind), ofMirrored(copy.placement)});
    }
    for (StepSolids& step : plan.steps) {
        const bool isPlaced = &step != &plan.steps[plan.copies.front().step];
        if (!choice.isAsDesigned && isPlaced) {
            step.milled = findInCutouts(*step.document, {}, progress).elements;
        } else if (!choice.isAsDesigned && plan.copies.size() == 1) {
            step.milled = findMilled(*step.document, {}, progress).elements;
        }
        if (!choice.isAsDesigned) {
            addDrilledPrint(findDrilledPrint(*step.document, {}, progress), step.milled);
        }
        step.holes = holesOf(step, choice, progress);
        countUses(step);
        plan.elements += step.elements.size();
        if (progress.isCancelled()) {
            return base::Error{base::ErrorCode::Cancelled, "the export was cancelled"};
        }
    }
    RETURN_IF_ERROR(checkLeft(plan, board));
    return plan;
}

}  // namespace model
