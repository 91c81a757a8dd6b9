#include "model/odb/components.h"

#include <optional>

#include "model/odb/records.h"

namespace model::odb {

namespace {

std::optional<PlacedComponent> componentOf(std::string_view line, std::uint32_t number, std::int64_t nm) {
    Fields fields(line);
    PlacedComponent component;
    component.line = number;
    component.package = fields.integer();
    component.position = fields.point(nm);
    component.clockwiseDeg = fields.real();
    const std::string_view mirror = fields.word();
    component.isMirrored = mirror == "M" || mirror == "Y";
    component.refdes = toUtf8(fields.optionalWord());
    component.part = toUtf8(fields.optionalWord());
    return fields.failed() ? std::nullopt : std::optional(std::move(component));
}

std::optional<PlacedPin> pinOf(std::string_view line, std::int64_t nm) {
    Fields fields(line);
    PlacedPin pin;
    pin.number = fields.integer();
    pin.position = fields.point(nm);
    fields.real();  // the pin's own rotation and mirror follow its component
    fields.word();
    pin.net = fields.integer();
    fields.optionalWord();  // subnet
    pin.name = toUtf8(fields.optionalWord());
    return fields.failed() ? std::nullopt : std::optional(std::move(pin));
}

}  // namespace

std::vector<PlacedComponent> parseComponents(std::string_view text, std::string_view path, Unit defaultUnit,
                                             Diagnostics& diagnostics) {
    std::vector<PlacedComponent> components;
    std::int64_t nm = coordinateNm(defaultUnit);
    bool isInComponent = false;
    LineReader lines(text);
    while (lines.next()) {
        const std::string_view line = lines.line();
        if (line.starts_with("CMP ")) {
            std::optional<PlacedComponent> component = componentOf(line.substr(4), lines.number(), nm);
            isInComponent = component.has_value();
            if (component) {
                components.push_back(std::move(*component));
            } else {
                diagnostics.report(Severity::Error, path, lines.number(),
                                   "the CMP record is unreadable; the component is missing");
            }
        } else if (line.starts_with("TOP ") && isInComponent) {
            if (std::optional<PlacedPin> pin = pinOf(line.substr(4), nm)) {
                components.back().pins.push_back(std::move(*pin));
            } else {
                diagnostics.report(Severity::Warning, path, lines.number(),
                                   "the TOP record is unreadable; the pin is missing");
            }
        } else if (line.starts_with("UNITS") || line.starts_with("U ")) {
            const std::size_t equals = line.find('=');
            const auto unit = parseUnit(trimmed(line.substr(equals == std::string_view::npos ? 1 : equals + 1)));
            nm = unit ? coordinateNm(*unit) : nm;
        }
        // Properties (PRP), bills of material and attribute tables are not needed yet.
    }
    return components;
}

}  // namespace model::odb
