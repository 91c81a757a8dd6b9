#include "model/formats/odb/features/tools.h"

#include <string>

#include "model/formats/odb/text/records.h"
#include "model/formats/odb/text/structured_text.h"

namespace model::odb {

namespace {

/// FINISH_SIZE -1 is "unknown"; so is everything else that is no size.
base::Nm sizeOf(std::string_view text, std::int64_t nmPerUnit) {
    const std::optional<double> value = parseReal(text);
    const std::optional<base::Nm> size = value ? toLength(*value, nmPerUnit) : std::nullopt;
    return size.value_or(0) > 0 ? *size : 0;
}

Plating platingOf(std::string_view type) {
    return type == "PLATED"       ? Plating::Plated
           : type == "NON_PLATED" ? Plating::NonPlated
           : type == "VIA"        ? Plating::Via
                                  : Plating::NotSaid;
}

DrillTool toolOf(const Block& block, std::int64_t nmPerUnit) {
    DrillTool tool;
    tool.number = parseInteger(block.value("NUM")).value_or(0);
    tool.plating = platingOf(block.value("TYPE"));
    tool.process = toUtf8(block.value("TYPE2"));
    tool.bit = toUtf8(block.value("BIT"));
    tool.finishedSize = sizeOf(block.value("FINISH_SIZE"), nmPerUnit);
    tool.drillSize = sizeOf(block.value("DRILL_SIZE"), nmPerUnit);
    tool.minTolerance = sizeOf(block.value("MIN_TOL"), nmPerUnit);
    tool.maxTolerance = sizeOf(block.value("MAX_TOL"), nmPerUnit);
    return tool;
}

ToolUnit statedUnit(const StructuredText& parsed) {
    const bool isInch = parseUnit(parsed.top.value("UNITS")).value_or(Unit::Inch) == Unit::Inch;
    return isInch ? ToolUnit::Mil : ToolUnit::Micrometre;
}

std::int64_t nmPer(ToolUnit unit) {
    switch (unit) {
        case ToolUnit::Micrometre: return symbolNm(Unit::Millimetre);
        case ToolUnit::Inch: return coordinateNm(Unit::Inch);
        case ToolUnit::Millimetre: return coordinateNm(Unit::Millimetre);
        default: return symbolNm(Unit::Inch);
    }
}

const char* nameOf(ToolUnit unit) {
    constexpr const char* kNames[] = {"", "mil", "µm", "inches", "mm"};
    return kNames[static_cast<std::size_t>(unit)];
}

/// At the line that states the unit, or else at the first tool.
void reportUnit(const StructuredText& parsed, ToolUnit stated, ToolUnit unit, std::string_view path,
                Diagnostics& diagnostics) {
    const std::uint32_t first = parsed.blocks.empty() ? 0 : parsed.blocks.front().line;
    const std::uint32_t line = parsed.top.lineOf("UNITS");
    diagnostics.report(Severity::Info, path, line > 0 ? line : first,
                       std::string("no hole has the size of a tool in ") + nameOf(stated) + ", but all do in " +
                           nameOf(unit) + "; sizes of tools are taken as " + nameOf(unit));
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

std::vector<DrillTool> parseTools(std::string_view text, std::string_view path, Diagnostics& diagnostics,
                                  ToolUnit unit) {
    const StructuredText parsed = parseStructured(text, path, diagnostics);
    const ToolUnit stated = statedUnit(parsed);
    unit = unit == ToolUnit::Stated ? stated : unit;
    if (unit != stated) {
        reportUnit(parsed, stated, unit, path, diagnostics);
    }
    std::vector<DrillTool> tools;
    for (const Block& block : parsed.blocks) {
        if (!equalsIgnoringCase(block.name, "TOOLS") && !equalsIgnoringCase(block.name, "TOOL")) {
            diagnostics.report(Severity::Info, path, block.line, "unknown kind of block; it was left out");
            continue;
        }
        tools.push_back(toolOf(block, nmPer(unit)));
        reportOdd(tools.back(), path, block.line, diagnostics);
    }
    return tools;
}

}  // namespace model::odb
