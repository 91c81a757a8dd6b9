#include "model/odb/symbols.h"

#include "model/odb/element_maker.h"
#include "model/odb/painting.h"

namespace model::odb {

const SymbolShape& SymbolLibrary::shape(const SymbolRef& symbol) {
    const auto [place, isNew] = m_shapes.try_emplace(symbol);
    if (!isNew) {
        return place->second;
    }
    // Whoever asks for this symbol while it is being resolved is part of it.
    place->second.problem = "contains itself; it draws nothing";
    std::optional<SymbolShape> shape = standardSymbol(symbol);
    place->second = shape ? std::move(*shape) : userSymbol(symbol);
    return place->second;
}

SymbolShape SymbolLibrary::userSymbol(const SymbolRef& symbol) {
    SymbolShape shape;
    const std::optional<JobFile> file = m_job.read("symbols/" + symbol.name + "/features", m_diagnostics);
    if (!file) {
        shape.problem = "is neither a standard symbol nor in the job's symbols folder; it draws nothing";
        return shape;
    }
    const FeatureFile features = parseFeatures(file->text(), file->path, m_defaultUnit, m_diagnostics);
    DocumentBuilder scratch;
    scratch.beginLayer(scratch.addLayer({}));
    ElementMaker maker(scratch, *this, m_diagnostics);
    maker.add({&features, file->path, {}, nullptr}, nullptr);
    shape.region = regionOf(scratch.soFar(), maker.negatives());
    if (shape.region.isEmpty()) {
        shape.problem = "draws nothing";
        return shape;
    }
    shape.kind = SymbolShape::Kind::Region;
    return symbol.resize == 0 ? shape : resized(shape, symbol.resize);
}

void SymbolLibrary::reportProblem(const SymbolRef& symbol, const SymbolShape& shape, std::string_view path,
                                  std::uint32_t line) {
    const auto place = m_firstProblem.try_emplace(symbol.name, Place{std::string(path), line}).first;
    m_diagnostics.report(Severity::Warning, place->second.path, place->second.line,
                         "symbol " + symbol.name + " " + shape.problem);
}

}  // namespace model::odb
