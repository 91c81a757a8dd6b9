#include "model/board/diagnostic_facts.h"

#include <algorithm>

namespace model {

std::string placeOf(const Diagnostic& entry) {
    const bool hasLine = entry.line > 0 && !entry.file.empty();
    return hasLine ? entry.file + ':' + std::to_string(entry.line) : entry.file;
}

const Diagnostic* firstError(const Diagnostics& diagnostics) {
    const std::vector<Diagnostic>& entries = diagnostics.entries();
    const auto first = std::ranges::find(entries, Severity::Error, &Diagnostic::severity);
    return first != entries.end() ? &*first : nullptr;
}

}  // namespace model
