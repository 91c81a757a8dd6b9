#include "model/odb/tools.h"

#include "model/odb/records.h"
#include "model/odb/structured_text.h"

namespace model::odb {

namespace {

/// FINISH_SIZE -1 is "unknown"; so is everything else that is no size.
base::Nm sizeOf(std::string_view text, Unit unit) {
    const std::optional<double> value = parseReal(text);
    const std::optional<base::Nm> size = value ? toLength(*value, symbolNm(unit)) : std::nullopt;
    return size.value_or(0) > 0 ? *size : 0;
}

}  // namespace

std::vector<Tool> parseTools(std::string_view text, std::string_view path, Diagnostics& diagnostics) {
    const StructuredText parsed = parseStructured(text, path, diagnostics);
    const Unit unit = parseUnit(parsed.top.value("UNITS")).value_or(Unit::Inch);
    std::vector<Tool> tools;
    for (const Block& block : parsed.blocks) {
        if (!equalsIgnoringCase(block.name, "TOOLS") && !equalsIgnoringCase(block.name, "TOOL")) {
            diagnostics.report(Severity::Info, path, block.line, "unknown kind of block; it was left out");
            continue;
        }
        tools.push_back({parseInteger(block.value("NUM")).value_or(0), toUtf8(block.value("TYPE")),
                         sizeOf(block.value("FINISH_SIZE"), unit), sizeOf(block.value("DRILL_SIZE"), unit)});
    }
    return tools;
}

}  // namespace model::odb
