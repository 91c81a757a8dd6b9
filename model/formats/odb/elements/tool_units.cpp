#include "model/formats/odb/elements/tool_units.h"

#include <algorithm>
#include <set>

#include "model/board/holes.h"
#include "model/formats/odb/symbols/standard_symbols.h"

namespace model::odb {

namespace {

using Kind = PadShape::Kind;

/// What a drill or router has to be to make a hole of this symbol; 0: it tells no size.
Nm sizeOf(const SymbolRef& symbol) {
    const std::optional<PadShape> shape = standardSymbol(symbol);
    if (!shape) {
        return 0;
    }
    return shape->kind == Kind::Oval                                 ? std::min(shape->width, shape->height)
           : shape->kind == Kind::Round || shape->kind == Kind::Ring ? shape->width
                                                                     : 0;
}

std::set<Nm> sizesOf(const FeatureFile& file) {
    std::set<std::uint32_t> symbols;
    for (const Feature& feature : file.features) {
        const bool hasSymbol =
            feature.kind == FeatureKind::Pad || feature.kind == FeatureKind::Line || feature.kind == FeatureKind::Arc;
        if (hasSymbol && feature.index < file.symbols.size()) {
            symbols.insert(feature.index);
        }
    }
    std::set<Nm> sizes;
    for (const std::uint32_t symbol : symbols) {
        sizes.insert(sizeOf(file.symbols[symbol]));
    }
    sizes.erase(0);
    return sizes;
}

auto fitting(const std::vector<DrillTool>& tools) {
    return [&tools](Nm size) {
        return std::ranges::any_of(tools, [size](const DrillTool& tool) { return fits(tool, size); });
    };
}

void fitUnit(const JobContext& job, const std::set<Nm>& holes, Parsed<std::vector<DrillTool>>& tools) {
    Diagnostics reading;
    const auto file = job.tree.read(tools.path, reading);
    for (const ToolUnit unit : {ToolUnit::Millimetre, ToolUnit::Inch, ToolUnit::Micrometre, ToolUnit::Mil}) {
        Diagnostics diagnostics;
        std::vector<DrillTool> inUnit;
        if (file) {
            inUnit = parseTools(file->text(), file->path, diagnostics, unit);
        }
        if (std::ranges::all_of(holes, fitting(inUnit))) {
            tools.value = std::move(inUnit);
            tools.diagnostics = std::move(diagnostics);
            return;
        }
    }
}

}  // namespace

void fitToolUnits(const JobContext& job, Steps& steps) {
    for (StepData& step : steps) {
        for (StepLayer& layer : step.layers) {
            if (layer.tools.value.empty()) {
                continue;
            }
            const std::set<Nm> holes = sizesOf(layer.features.value);
            if (!holes.empty() && std::ranges::none_of(holes, fitting(layer.tools.value))) {
                fitUnit(job, holes, layer.tools);
            }
        }
    }
}

}  // namespace model::odb
