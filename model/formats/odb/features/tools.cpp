#include "model/formats/odb/features/tools.h"

#include "model/formats/odb/text/records.h"
#include "model/formats/odb/text/structured_text.h"

namespace model::odb {

namespace {

/// FINISH_SIZE -1 is "unknown"; so is everything else that is no size.
base::Nm sizeOf(std::string_view text, Unit unit) {
    const std::optional<double> value = parseReal(text);
    const std::optional<base::Nm> size = value ? toLength(*value, symbolNm(unit)) : std::nullopt;
    return size.value_or(0) > 0 ? *size : 0;
}

Plating platingOf(std::string_view type) {
    return type == "PLATED"       ? Plating::Plated
           : type == "NON_PLATED" ? Plating::NonPlated
           : type == "VIA"        ? Plating::Via
                                  : Plating::NotSaid;
}

DrillTool toolOf(const Block& block, Unit unit) {
    DrillTool tool;
    tool.number = parseInteger(block.value("NUM")).value_or(0);
    tool.plating = platingOf(block.value("TYPE"));
    tool.process = toUtf8(block.value("TYPE2"));
    tool.bit = toUtf8(block.value("BIT"));
    tool.finishedSize = sizeOf(block.value("FINISH_SIZE"), unit);
    tool.drillSize = sizeOf(block.value("DRILL_SIZE"), unit);
    tool.minTolerance = sizeOf(block.value("MIN_TOL"), unit);
    tool.maxTolerance = sizeOf(block.value("MAX_TOL"), unit);
    return tool;
}

void reportOdd(const DrillTool& tool, std::string_view path, std::uint32_t line, Diagnostics& diagnostics) {
    if (tool.finishedSize == 0 && tool.drillSize == 0) {
        diagnostics.report(Severity::Info, path, line, "a tool without a size; no hole is matched to it");
    } else if (isPlated(tool.plating) && tool.drillSize > 0 && tool.finishedSize > tool.drillSize) {
        diagnostics.report(Severity::Warning, path, line,
                           "a plated tool whose finished size is larger than its drilled size; its barrel is assumed");
    } else if (tool.plating == Plating::NotSaid) {
        diagnostics.report(Severity::Info, path, line,
                           "a tool of unknown TYPE; it does not say whether holes are plated");
    }
}

}  // namespace

std::vector<DrillTool> parseTools(std::string_view text, std::string_view path, Diagnostics& diagnostics) {
    const StructuredText parsed = parseStructured(text, path, diagnostics);
    const Unit unit = parseUnit(parsed.top.value("UNITS")).value_or(Unit::Inch);
    std::vector<DrillTool> tools;
    for (const Block& block : parsed.blocks) {
        if (!equalsIgnoringCase(block.name, "TOOLS") && !equalsIgnoringCase(block.name, "TOOL")) {
            diagnostics.report(Severity::Info, path, block.line, "unknown kind of block; it was left out");
            continue;
        }
        tools.push_back(toolOf(block, unit));
        reportOdd(tools.back(), path, block.line, diagnostics);
    }
    return tools;
}

}  // namespace model::odb
