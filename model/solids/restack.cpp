#include "model/solids/restack.h"

#include <map>
#include <utility>

#include "model/board/stackup.h"
#include "model/board/stackup_checks.h"
#include "model/solids/solids.h"

namespace model {

namespace {

struct Heights {
    std::vector<Layer> layers;
    Stackup stackup;
};

Heights heightsWith(const Document& document, std::vector<ThicknessOverride> set, Diagnostics& messages) {
    StackupFacts facts = document.stackup.facts;
    facts.set = std::move(set);
    // Layers that we added ourselves follow those of the job.
    const auto own = static_cast<std::ptrdiff_t>(facts.layers.size());
    Heights heights{{document.layers.begin(), document.layers.begin() + own}, {}};
    heights.stackup = buildStackup(heights.layers, std::move(facts), messages);
    return heights;
}

/// Steps that are placed on others have the same layers at the same heights.
void setHeights(Document& document, const Heights& heights,
                std::map<const Document*, std::shared_ptr<const Document>>& done) {
    for (std::size_t row = 0; row < heights.layers.size() && row < document.layers.size(); ++row) {
        document.layers[row].z = heights.layers[row].z;
        document.layers[row].thickness = heights.layers[row].thickness;
        document.layers[row].thicknessSource = heights.layers[row].thicknessSource;
    }
    document.boardThickness = thicknessOf(heights.stackup);
    document.stackup = heights.stackup;
    placeSolids(document);
    for (std::shared_ptr<const Document>& step : document.steps) {
        std::shared_ptr<const Document>& changed = done[step.get()];
        if (!changed) {
            const auto copy = std::make_shared<Document>(*step);
            setHeights(*copy, heights, done);
            changed = copy;
        }
        step = changed;
    }
}

}  // namespace

std::shared_ptr<const Document> restack(const Document& document, std::vector<ThicknessOverride> set) {
    auto out = std::make_shared<Document>(document);
    if (document.stackup.rows.empty()) {
        return out;  // a format that states its heights
    }
    Diagnostics before;
    (void)heightsWith(document, document.stackup.facts.set, before);
    reportStackup(document, before);
    Diagnostics after;
    const Heights heights = heightsWith(document, std::move(set), after);
    std::map<const Document*, std::shared_ptr<const Document>> done;
    setHeights(*out, heights, done);
    reportStackup(*out, after);
    out->diagnostics = document.diagnostics.without(before);
    out->diagnostics.append(after);
    return out;
}

}  // namespace model
