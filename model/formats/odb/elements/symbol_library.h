#pragma once

#include <map>
#include <string>

#include "model/formats/odb/symbols/font_library.h"
#include "model/formats/odb/symbols/standard_symbols.h"

namespace model::odb {

/// Every symbol of a job by what it draws: standard ones by their name, all others from `symbols/<name>/features`. User
/// symbols of one surface, and of features that keep apart, stay exact; others are united in paint order with a chord
/// tolerance of 1 µm. They may nest; one that contains itself draws nothing. Not thread-safe: symbols are resolved
/// while the document is built.
class SymbolLibrary {
public:
    SymbolLibrary(const formats::FileTree& job, Unit defaultUnit, Diagnostics& diagnostics)
        : m_job(job), m_defaultUnit(defaultUnit), m_diagnostics(diagnostics), m_fonts(job, diagnostics) {}

    /// The shape; stays where it is as long as the library. A symbol that cannot be drawn as it is says so
    /// in `problem`.
    const PadShape& shape(const SymbolRef& symbol);

    /// The fonts of the job's texts.
    [[nodiscard]] FontLibrary& fonts() { return m_fonts; }

    /// Reports the symbol's problem as one entry for the whole job, counted per feature located where it was met
    /// first.
    void reportProblem(const SymbolRef& symbol, const PadShape& shape, std::string_view path, std::uint32_t line);

private:
    struct Location {
        std::string path;
        std::uint32_t line = 0;
    };

    [[nodiscard]] PadShape userSymbol(const SymbolRef& symbol);

    const formats::FileTree& m_job;
    Unit m_defaultUnit;
    Diagnostics& m_diagnostics;
    FontLibrary m_fonts;
    std::map<SymbolRef, PadShape> m_shapes;
    std::map<std::string, Location> m_firstProblem;
};

}  // namespace model::odb
