#include "model/board/diagnostic_place.h"

namespace model {

std::string placeOf(const Diagnostic& entry) {
    const bool hasLine = entry.line > 0 && !entry.file.empty();
    return hasLine ? entry.file + ':' + std::to_string(entry.line) : entry.file;
}

}  // namespace model
