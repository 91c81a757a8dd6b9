#include "model/formats/odb/steps/step_header.h"

#include <cmath>
#include <optional>

#include "model/base/limits.h"
#include "model/formats/odb/text/records.h"
#include "model/formats/odb/text/structured_text.h"

namespace model::odb {

namespace {

/// A length of a block; 0 when the key is absent, nothing when its value is no length.
std::optional<base::Nm> lengthOf(const Block& block, std::string_view key, Unit unit) {
    const std::string_view text = block.value(key);
    if (text.empty()) {
        return 0;
    }
    Fields fields(text);
    const base::Nm length = fields.length(coordinateNm(unit));
    return fields.failed() || !fields.atEnd() ? std::nullopt : std::optional(length);
}

bool isYes(const Block& block, std::string_view key) {
    return equalsIgnoringCase(block.value(key), "YES") || equalsIgnoringCase(block.value(key), "Y");
}

int countOf(const Block& block, std::string_view key) {
    return block.value(key).empty() ? 1 : parseInteger(block.value(key)).value_or(0);
}

std::optional<StepRepeat> repeatOf(const Block& block, Unit unit) {
    const auto x = lengthOf(block, "X", unit);
    const auto y = lengthOf(block, "Y", unit);
    const auto dx = lengthOf(block, "DX", unit);
    const auto dy = lengthOf(block, "DY", unit);
    const std::optional<double> angle = block.value("ANGLE").empty() ? 0.0 : parseReal(block.value("ANGLE"));
    if (!x || !y || !dx || !dy || !angle || block.value("NAME").empty()) {
        return std::nullopt;
    }
    StepRepeat repeat;
    repeat.step = toUtf8(block.value("NAME"));
    repeat.first = {*x, *y};
    repeat.pitch = {*dx, *dy};
    repeat.columns = countOf(block, "NX");
    repeat.rows = countOf(block, "NY");
    repeat.clockwiseDeg = std::fmod(*angle, 360.0);
    repeat.isFlipped = isYes(block, "FLIP");
    repeat.isMirrored = isYes(block, "MIRROR") != repeat.isFlipped;
    repeat.line = block.line;
    return repeat;
}

bool isSane(const StepRepeat& repeat) {
    const auto reaches = [](base::Nm from, base::Nm pitch, int count) {
        const std::int64_t end = from + std::int64_t{pitch} * (count - 1);
        return end <= base::kMaxCoordinate && end >= -base::kMaxCoordinate;
    };
    return repeat.columns >= 1 && repeat.rows >= 1 &&
           std::int64_t{repeat.columns} * repeat.rows <= std::int64_t{base::kMostCopies} &&
           reaches(repeat.first.x, repeat.pitch.x, repeat.columns) &&
           reaches(repeat.first.y, repeat.pitch.y, repeat.rows);
}

}  // namespace

StepHeader parseStepHeader(std::string_view text, std::string_view path, Unit defaultUnit, Diagnostics& diagnostics) {
    const StructuredText parsed = parseStructured(text, path, diagnostics);
    const Unit unit = parseUnit(parsed.top.value("UNITS")).value_or(defaultUnit);
    StepHeader header;
    header.datum = {lengthOf(parsed.top, "X_DATUM", unit).value_or(0),
                    lengthOf(parsed.top, "Y_DATUM", unit).value_or(0)};
    for (const Block& block : parsed.blocks) {
        if (!equalsIgnoringCase(block.name, "STEP-REPEAT")) {
            diagnostics.report(Severity::Info, path, block.line, "unknown kind of block; it was left out");
            continue;
        }
        const std::optional<StepRepeat> repeat = repeatOf(block, unit);
        if (repeat && isSane(*repeat)) {
            header.repeats.push_back(*repeat);
        } else {
            diagnostics.report(
                Severity::Error, path, block.line,
                "the STEP-REPEAT block has no name, an unreadable number or an absurd count; its copies are missing");
        }
    }
    return header;
}

}  // namespace model::odb
