#include "model/formats/odb/repeated_drills.h"

#include <algorithm>
#include <optional>
#include <tuple>
#include <vector>

#include "model/formats/odb/text/records.h"

namespace model::odb {

namespace {

/// A hit or a slot: how it is drawn, from where to where, with which symbol and plating.
using DrawnHole = std::tuple<FeatureKind, Point, Point, SymbolRef, Plating>;
/// By step, sorted.
using HolesOfLayer = std::vector<std::vector<DrawnHole>>;

bool isPlainDrill(const MatrixLayer& layer) {
    return layer.type == LayerType::Drill && layer.context == LayerContext::Board && layer.use == LayerUse::Plain;
}

bool haveOneSpan(const MatrixLayer& a, const MatrixLayer& b) {
    const auto isSame = [](const std::string& left, const std::string& right) {
        return equalsIgnoringCase(left, right);
    };
    return (isSame(a.startName, b.startName) && isSame(a.endName, b.endName)) ||
           (isSame(a.startName, b.endName) && isSame(a.endName, b.startName));
}

std::vector<DrawnHole> holesIn(const FeatureFile& file) {
    std::vector<DrawnHole> holes;
    for (const Feature& feature : file.features) {
        const bool hasPen =
            feature.kind == FeatureKind::Pad || feature.kind == FeatureKind::Line || feature.kind == FeatureKind::Arc;
        const SymbolRef symbol =
            hasPen && feature.index < file.symbols.size() ? file.symbols[feature.index] : SymbolRef{};
        holes.emplace_back(feature.kind, feature.a, feature.kind == FeatureKind::Pad ? Point{} : feature.b, symbol,
                           feature.plating);
    }
    std::ranges::sort(holes);
    return holes;
}

bool holdsOtherThanHoles(const HolesOfLayer& layer) {
    const auto isOther = [](const DrawnHole& hole) {
        return std::get<FeatureKind>(hole) != FeatureKind::Pad && std::get<FeatureKind>(hole) != FeatureKind::Line;
    };
    return std::ranges::any_of(layer, [&](const auto& step) { return std::ranges::any_of(step, isOther); });
}

/// Has `all` every hole of `some`, and has `some` any?
bool repeats(const HolesOfLayer& some, const HolesOfLayer& all) {
    bool hasAny = false;
    for (std::size_t step = 0; step < some.size(); ++step) {
        if (!std::ranges::includes(all[step], some[step])) {
            return false;
        }
        hasAny = hasAny || !some[step].empty();
    }
    return hasAny;
}

}  // namespace

void setRepeatedDrillsAside(Matrix& matrix, const Steps& steps, Diagnostics& diagnostics) {
    std::vector<std::size_t> rows;
    for (std::size_t row = 0; row < matrix.layers.size(); ++row) {
        if (isPlainDrill(matrix.layers[row])) {
            rows.push_back(row);
        }
    }
    if (rows.size() < 2) {
        return;
    }
    std::vector<HolesOfLayer> holes(matrix.layers.size());
    for (const std::size_t row : rows) {
        for (const StepData& step : steps) {
            holes[row].push_back(holesIn(step.layers[row].features.value));
        }
    }
    // From the last one on: of two that are the same, the first one stays.
    for (auto row = rows.rbegin(); row != rows.rend(); ++row) {
        MatrixLayer& layer = matrix.layers[*row];
        const auto other = std::ranges::find_if(rows, [&](std::size_t candidate) {
            const MatrixLayer& drills = matrix.layers[candidate];
            return candidate != *row && isPlainDrill(drills) && haveOneSpan(layer, drills) &&
                   repeats(holes[*row], holes[candidate]);
        });
        if (other != rows.end() && !holdsOtherThanHoles(holes[*row])) {
            layer.type = LayerType::Document;
            layer.context = LayerContext::Misc;
            diagnostics.report(Severity::Info, "matrix/matrix", layer.line,
                               "layer " + layer.name + " has only holes that " + matrix.layers[*other].name +
                                   " has too; it is shown as a drawing, so that they are drilled once");
        }
    }
}

}  // namespace model::odb
