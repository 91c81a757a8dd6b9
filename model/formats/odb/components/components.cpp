#include "model/formats/odb/components/components.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "model/formats/odb/text/records.h"

namespace model::odb {

namespace {

/// Records of the bill of materials that some writers append.
constexpr std::string_view kBillOfMaterials[] = {"CPN", "PKG", "IPN", "DSC", "VPL_VND", "VPL_MPN", "VND", "MPN"};

std::optional<PlacedComponent> componentOf(std::string_view line, const FileCursor& at) {
    Fields fields(line);
    PlacedComponent component;
    component.line = at.line;
    component.package = fields.integer();
    component.position = fields.point(at.nm);
    component.clockwiseDeg = fields.real();
    const std::string_view mirror = fields.word();
    component.isMirrored = mirror == "M" || mirror == "Y";
    component.refdes = toUtf8(fields.optionalWord());
    component.part = toUtf8(fields.optionalWord());
    return fields.failed() ? std::nullopt : std::optional(std::move(component));
}

std::optional<PlacedPin> pinOf(std::string_view line, const FileCursor& at) {
    Fields fields(line);
    PlacedPin pin;
    pin.line = at.line;
    pin.number = fields.integer();
    pin.position = fields.point(at.nm);
    fields.real();  // the pin's own rotation and mirror follow its component
    fields.word();
    pin.net = fields.integer();
    fields.optionalWord();  // the subnet, which names the pin itself
    pin.name = toUtf8(fields.optionalWord());
    return fields.failed() ? std::nullopt : std::optional(std::move(pin));
}

class ComponentsParser {
public:
    ComponentsParser(std::string_view path, Unit unit, const AttributeTypes& types, Diagnostics& diagnostics)
        : m_at{path, diagnostics, coordinateNm(unit)}, m_types(types) {}

    std::vector<PlacedComponent> parse(std::string_view text) {
        m_at.forEachLine(text, [this](std::string_view line) { record(line); });
        std::ranges::for_each(m_components, [this](PlacedComponent& component) { namePart(component); });
        return std::move(m_components);
    }

private:
    void record(std::string_view line) {
        if (m_properties.record(line, m_isInComponent ? m_components.back().properties : m_nobodys) ||
            m_attributes.record(line) || readUnit(line, m_at.nm) || line.starts_with("ID=")) {
            return;
        }
        const std::string_view word = line.substr(0, line.find_first_of(" \t;="));
        const std::string_view rest = line.substr(word.size());
        if (word == "CMP") {
            component(rest);
        } else if (word == "TOP") {
            pin(rest);
        } else if (std::ranges::find(kBillOfMaterials, word) != std::end(kBillOfMaterials)) {
            m_at.report(Severity::Info, "the bill of materials is not read");
        } else {
            m_at.report(Severity::Warning, "a record of an unknown kind was left out");
        }
    }

    void component(std::string_view line) {
        std::optional<PlacedComponent> component = componentOf(line, m_at);
        m_isInComponent = component.has_value();
        const std::int32_t number = m_count++;
        if (!component) {
            return m_at.report(Severity::Error, "the CMP record is unreadable; the component is missing");
        }
        component->number = number;
        component->properties = m_attributes.resolve(Fields(line).tail(), m_types, m_at);
        component->height = heightOf(*component);
        turnOnce(*component);
        if (std::ranges::find(component->properties, ".comp_ignore", &TextProperty::name) !=
            component->properties.end()) {
            m_at.report(Severity::Info, "the component has .comp_ignore; it is read and shown as others are");
        }
        m_components.push_back(std::move(*component));
    }

    /// 0, and a report, for what is no height.
    [[nodiscard]] Nm heightOf(const PlacedComponent& component) const {
        const auto height = std::ranges::find(component.properties, ".comp_height", &TextProperty::name);
        if (height == component.properties.end()) {
            return 0;
        }
        const std::optional<double> value = parseReal(height->value);
        const std::optional<Nm> length = value ? toLength(*value, m_at.nm) : std::nullopt;
        if (!length || *length < 0) {
            m_at.report(Severity::Warning, ".comp_height is negative or no length; the height is taken as unknown");
            return 0;
        }
        return *length;
    }

    /// Allegro calls every part `???` and has its name in a property.
    void namePart(PlacedComponent& component) {
        const auto name = std::ranges::find(component.properties, "PART_NAME", &TextProperty::name);
        const bool isUnknown = component.part.find_first_not_of('?') == std::string::npos;
        if (isUnknown && name != component.properties.end() && !name->value.empty()) {
            component.part = name->value;
            m_at.line = component.line;
            m_at.report(Severity::Info, "the component's part is not named; its property PART_NAME is taken");
        }
    }

    void turnOnce(PlacedComponent& component) const {
        if (component.clockwiseDeg >= 0.0 && component.clockwiseDeg <= 360.0) {
            return;
        }
        const double rest = std::fmod(component.clockwiseDeg, 360.0);
        component.clockwiseDeg = rest < 0.0 ? rest + 360.0 : rest;
        m_at.report(Severity::Warning,
                    "the rotation of a component is not within 0 and 360 degrees; whole turns are "
                    "taken off");
    }

    void pin(std::string_view line) {
        if (!m_isInComponent) {
            return;  // its component was reported
        }
        std::optional<PlacedPin> pin = pinOf(line, m_at);
        if (!pin) {
            return m_at.report(Severity::Warning, "the TOP record is unreadable; the pin is missing");
        }
        m_components.back().pins.push_back(std::move(*pin));
    }

    FileCursor m_at;
    const AttributeTypes& m_types;
    RecordAttributes m_attributes;
    PropertyReader m_properties;
    std::vector<PlacedComponent> m_components;
    std::int32_t m_count = 0;  ///< of CMP records
    std::vector<TextProperty> m_nobodys;
    bool m_isInComponent = false;
};

}  // namespace

std::vector<PlacedComponent> parseComponents(std::string_view text, std::string_view path, Unit defaultUnit,
                                             const AttributeTypes& types, Diagnostics& diagnostics) {
    return ComponentsParser(path, defaultUnit, types, diagnostics).parse(text);
}

}  // namespace model::odb
