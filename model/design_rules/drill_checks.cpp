#include "model/design_rules/drill_checks.h"

#include <algorithm>
#include <optional>

#include "model/design_rules/drilled_holes.h"
#include "model/design_rules/hole_depths.h"

namespace model {

namespace {

/// In the middle of its narrowest edge. None for what is drawn as an area.
std::optional<Spacing> acrossHole(const Document& document, ElementId hole) {
    FigureTable figures;
    figures.add(document, hole);
    if (figures.size() == 0 || figures[0].isFilled) {
        return std::nullopt;
    }
    const Edge& edge = *std::ranges::min_element(figures.edges(0), {}, &Edge::pen);
    const PointD middle = pointAt(edge, lengthOf(edge) / 2);
    return Spacing{2 * edge.pen, middle, middle};
}

class DrillChecks {
public:
    explicit DrillChecks(RuleContext& context)
        : m_context(context), m_document(context.document()), m_depths(context.document()) {}

    void run() {
        for (const Layer& layer : m_document.layers) {
            const LayerId wanted = m_context.scopeLayer();
            const Range range = !wanted.isValid() || layer.spans(wanted) ? layer.elements : Range{};
            for (std::uint32_t i = range.first; i < range.first + range.count; ++i) {
                if ((m_document.elements.flags[i] & kHole) != 0 && !hasNoSize(m_document, ElementId{i})) {
                    check(ElementId{i});
                }
            }
        }
    }

private:
    void check(ElementId hole) {
        const std::optional<Spacing> across = acrossHole(m_document, hole);
        if (across) {
            checkWidth(RuleKind::HoleSize, hole, *across);
            checkWidth(RuleKind::SlotWidth, hole, *across);
            checkDepth(hole, *across);
        }
    }

    /// None for what the kind is not for, too.
    [[nodiscard]] std::optional<std::size_t> ruleOf(RuleKind kind, ElementId hole) const {
        return isHoleFor(m_document, kind, hole) ? m_context.choice().of(kind, {}, m_context.partyOf(hole))
                                                 : std::nullopt;
    }

    void checkWidth(RuleKind kind, ElementId hole, const Spacing& across) {
        const RuleTable& table = m_context.table();
        const auto rule = ruleOf(kind, hole);
        if (rule && isBroken(table.rules[*rule], table.tolerance, across.distance)) {
            add({*rule, layerOf(hole), hole, {}, across, FindingReason::TooNarrow});
        }
    }

    void checkDepth(ElementId hole, const Spacing& across) {
        const RuleTable& table = m_context.table();
        const auto rule = ruleOf(RuleKind::AspectRatio, hole);
        const std::optional<Nm> depth = rule ? m_depths.of(hole) : std::nullopt;
        if (!depth) {
            return;
        }
        RuleFinding finding{*rule, layerOf(hole), hole, {}, across, FindingReason::TooDeep};
        finding.depth = *depth;
        if (isBelow(requiredOf(table.rules[*rule], finding), table.tolerance, across.distance)) {
            add(finding);
        }
    }

    void add(const RuleFinding& finding) {
        if (!isRepeated(finding.a)) {
            m_context.add(finding);
        }
    }

    /// Does the job have the hole before?
    [[nodiscard]] bool isRepeated(ElementId hole) {
        if (!m_holes) {
            m_holes = allHoles(m_document);
        }
        std::optional<DrilledHole> own;
        std::vector<DrilledHole> before;
        m_holes->visitNear(m_document.boxOf(hole), 0.0, [&](std::uint32_t row) {
            const DrilledHole found = drilledHole(m_document, *m_holes, row);
            if (found.element == hole) {
                own.emplace(found);
            } else if (found.element < hole) {
                before.push_back(found);
            }
        });
        return own && std::ranges::any_of(before,
                                          [&](const DrilledHole& other) { return areOneHole(m_context, other, *own); });
    }

    [[nodiscard]] LayerId layerOf(ElementId hole) const { return m_document.elements.layer[hole.row()]; }

    RuleContext& m_context;
    const Document& m_document;
    HoleDepths m_depths;
    std::optional<LayerGeometry> m_holes;  ///< once it was needed
};

}  // namespace

void checkDrills(RuleContext& context) {
    constexpr RuleKind kKinds[] = {RuleKind::HoleSize, RuleKind::SlotWidth, RuleKind::AspectRatio};
    const bool isAsked = std::ranges::any_of(kKinds, [&](RuleKind kind) {
        return !context.choice().rowsOf(kind).empty() && context.whyBeyond(kind).empty();
    });
    if (isAsked) {
        DrillChecks(context).run();
    }
}

}  // namespace model
