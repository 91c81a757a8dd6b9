#include "model/design_rules/floating_copper.h"

#include "model/nets/connectivity.h"

namespace model {

base::Status checkFloatingCopper(RuleContext& context) {
    if (context.choice().rowsOf(RuleKind::FloatingCopper).empty() ||
        !context.whyBeyond(RuleKind::FloatingCopper).empty()) {
        return base::Done{};
    }
    const Document& document = context.document();
    ASSIGN_OR_RETURN(const Connectivity copper, Connectivity::of(document, context.progress()));
    std::vector<bool> isHeld(copper.islandCount());
    for (std::uint32_t piece = 0; piece < copper.pieceCount(); ++piece) {
        isHeld[copper.island(piece)] = isHeld[copper.island(piece)] || context.isLand(copper.element(piece));
    }
    const std::vector<bool>& isText = context.textStrokes();
    std::size_t texts = 0;
    for (std::uint32_t piece = 0; piece < copper.pieceCount(); ++piece) {
        const ElementId element = copper.element(piece);
        const LayerId layer = document.elements.layer[element.row()];
        if (isHeld[copper.island(piece)]) {
            continue;
        }
        isHeld[copper.island(piece)] = true;  // said once
        const auto rule = context.choice().of(RuleKind::FloatingCopper, layer, {});
        texts += isText[element.row()] ? 1 : 0;
        if (rule && context.isWanted(layer) && !isText[element.row()]) {
            const PointD at = copper.point(piece);
            context.add({*rule, layer, element, {}, {0.0, at, at}, FindingReason::Floating});
        }
    }
    if (texts > 0) {
        context.report().notes.push_back(std::to_string(texts) +
                                         " pieces of texts in copper reach no pad, as texts do");
    }
    return base::Done{};
}

}  // namespace model
