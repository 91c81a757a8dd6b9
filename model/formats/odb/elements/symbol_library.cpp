#include "model/formats/odb/elements/symbol_library.h"

#include "model/formats/common/painting.h"
#include "model/formats/odb/elements/feature_elements.h"

namespace model::odb {

const PadShape& SymbolLibrary::shape(const SymbolRef& symbol) {
    const auto [location, isNew] = m_shapes.try_emplace(symbol);
    if (!isNew) {
        return location->second;
    }
    // Whatever needs this symbol while it is being resolved is part of it.
    location->second.problem = "contains itself; it draws nothing";
    std::optional<PadShape> shape = standardSymbol(symbol);
    location->second = shape ? std::move(*shape) : userSymbol(symbol);
    return location->second;
}

PadShape SymbolLibrary::userSymbol(const SymbolRef& symbol) {
    PadShape shape;
    const std::optional<formats::TreeFile> file = m_job.read("symbols/" + symbol.name + "/features", m_diagnostics);
    if (!file) {
        shape.problem = "is neither a standard symbol nor in the job's symbols folder; it draws nothing";
        return shape;
    }
    const FeatureFile features = parseFeatures(file->text(), file->path, m_defaultUnit, m_diagnostics);
    DocumentBuilder scratch;
    scratch.beginLayer(scratch.addLayer({}));
    const std::vector<std::uint8_t> negatives =
        addFeatures(scratch, *this, m_diagnostics, {&features, file->path, {}, nullptr}, nullptr);
    shape.region = formats::regionOf(scratch.soFar(), negatives, m_diagnostics, file->path);
    if (shape.region.isEmpty()) {
        shape.problem = "draws nothing";
        return shape;
    }
    shape.kind = PadShape::Kind::Region;
    return symbol.resize == 0 ? shape : resized(shape, symbol.resize);
}

void SymbolLibrary::reportProblem(const SymbolRef& symbol, const PadShape& shape, std::string_view path,
                                  std::uint32_t line) {
    const auto location = m_firstProblem.try_emplace(symbol.name, Location{std::string(path), line}).first;
    m_diagnostics.report(Severity::Warning, location->second.path, location->second.line,
                         "symbol " + symbol.name + " " + shape.problem);
}

}  // namespace model::odb
