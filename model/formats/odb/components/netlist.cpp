#include "model/formats/odb/components/netlist.h"

#include <optional>

#include "model/base/ascii.h"
#include "model/formats/odb/components/eda.h"
#include "model/formats/odb/text/records.h"

namespace model::odb {

namespace {

LayerSide sideOf(std::string_view letter) {
    return letter == "T"   ? LayerSide::Top
           : letter == "D" ? LayerSide::Bottom
           : letter == "B" ? LayerSide::Through
                           : LayerSide::Inner;
}

Exposure exposureOf(std::string_view letter) {
    return letter == "e"   ? Exposure::Exposed
           : letter == "c" ? Exposure::Covered
           : letter == "p" ? Exposure::CoveredOnTop
           : letter == "s" ? Exposure::CoveredOnBottom
                           : Exposure::NotSaid;
}

std::optional<formats::NetlistPoint> pointOf(std::string_view line, std::uint32_t number, std::int64_t nm) {
    Fields fields(line);
    formats::NetlistPoint point;
    point.line = number;
    point.number = fields.integer();
    point.radius = fields.length(nm);
    point.position = fields.point(nm);
    point.side = sideOf(fields.word());
    // A pad has a size instead of a radius; a via whose radius was rounded to 0 (KiCad) has neither.
    const bool hasSize = parseReal(Fields(fields).optionalWord()).has_value();
    if (point.radius == 0 && hasSize) {
        point.width = fields.length(nm);
        point.height = fields.length(nm);
    }
    point.isEnd = fields.word() != "m";
    point.exposure = exposureOf(fields.optionalWord());
    for (std::string_view word = fields.optionalWord(); !word.empty(); word = fields.optionalWord()) {
        point.isVia = point.isVia || word == "v";
    }
    return fields.failed() ? std::nullopt : std::optional(point);
}

/// The shortest line that names a net, "$0 A": numbers that such lines could not have filled are broken.
constexpr std::size_t kBytesPerName = 5;

bool startsPoint(char c) {
    return base::isDigit(c) || c == '-';
}

}  // namespace

formats::Netlist parseNetlist(std::string_view text, std::string_view path, Unit defaultUnit,
                              Diagnostics& diagnostics) {
    formats::Netlist netlist;
    netlist.noNet = kNoNet;
    std::int64_t nm = coordinateNm(defaultUnit);
    LineReader lines(text);
    while (lines.next()) {
        const std::string_view line = lines.line();
        const auto warn = [&](std::string_view what) {
            diagnostics.report(Severity::Warning, path, lines.number(), what);
        };
        if (line.starts_with('$')) {
            Fields fields(line.substr(1));
            const std::int32_t number = fields.integer();
            if (fields.failed() || number < 0 || static_cast<std::size_t>(number) > text.size() / kBytesPerName) {
                warn("a net name that cannot be read was left out");
                continue;
            }
            netlist.names.resize(std::max(netlist.names.size(), static_cast<std::size_t>(number) + 1));
            netlist.names[static_cast<std::size_t>(number)] = toUtf8(trimmed(fields.rest()));
        } else if (startsPoint(line.front())) {
            const std::optional<formats::NetlistPoint> point = pointOf(line, lines.number(), nm);
            point ? netlist.points.push_back(*point) : warn("a netlist point that cannot be read was left out");
        } else if (!readUnit(line, nm) && !line.starts_with("H ") && line != "H") {
            warn("a record of an unknown kind was left out");
        }
    }
    return netlist;
}

}  // namespace model::odb
