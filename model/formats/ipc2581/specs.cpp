#include "model/formats/ipc2581/specs.h"

#include "model/formats/ipc2581/xml/xml_values.h"

namespace model::ipc2581 {

namespace {

// Numbers that materials have; 1 is air, which writers put where nothing is known.
constexpr double kMostDielectricConstant = 100.0;
constexpr double kMostLossTangent = 0.5;

std::optional<double> within(std::optional<double> value, double over, double most) {
    return value && *value > over && *value <= most ? value : std::nullopt;
}

/// nΩ·m from a conductivity in S/m or mho/cm (1 / (S/cm) = 1 Ω·cm = 1e7 nΩ·m).
std::optional<double> resistivityOf(std::optional<double> conductivity, std::string_view unit) {
    if (!conductivity || *conductivity <= 0.0) {
        return std::nullopt;
    }
    return (unit == "MHO/CM" ? 1e7 : 1e9) / *conductivity;
}

/// False if nothing is done with it.
bool readProperty(const XmlCursor& at, std::string_view kind, std::string_view type, Spec& spec) {
    const std::optional<double> value = realOf(at.value("value"));
    if (kind == "General" && type == "MATERIAL" && spec.material.empty()) {
        spec.material = textOf(at.value("text"));
    } else if (kind == "Dielectric" && type == "DIELECTRIC_CONSTANT") {
        spec.dielectricConstant = within(value, 1.0, kMostDielectricConstant);
    } else if (kind == "Dielectric" && type == "LOSS_TANGENT") {
        spec.lossTangent = within(value, 0.0, kMostLossTangent);
    } else if (kind == "Conductor" && type == "CONDUCTIVITY") {
        spec.resistivity = resistivityOf(value, at.value("unit"));
    } else if (kind == "Conductor" && type == "WEIGHT") {
        spec.copperOz = within(value, 0.0, 100.0);
    } else {
        return false;
    }
    return true;
}

bool isOfMaterial(std::string_view kind) {
    return kind == "General" || kind == "Dielectric" || kind == "Conductor";
}

Spec readSpec(XmlCursor& at, Reading& reading) {
    Spec spec;
    forEachChild(at, [&] {
        const std::string_view kind = at.name();
        const std::string_view type = at.value("type");
        if (kind == "Backdrill") {
            spec.isBackdrill = true;
        } else if (!isOfMaterial(kind)) {
            return reading.reportUnknown(at);
        }
        forEachChild(at, [&] {
            if (!readProperty(at, kind, type, spec)) {
                reading.report(Severity::Info, at.line(),
                               "of properties of Specs only names and electrical values of materials are read");
            }
        });
    });
    return spec;
}

std::string_view withoutNumber(std::string_view name) {
    const std::size_t end = name.find_last_not_of("0123456789");
    const bool isNumbered = end != std::string_view::npos && end + 1 < name.size() && name[end] == '_';
    return isNumbered ? name.substr(0, end) : name;
}

}  // namespace

Specs::Specs(Reading& reading) : m_reading(reading) {
    for (const XmlSection& section : reading.outline().sections) {
        if (section.name == "Spec") {
            XmlCursor at = reading.at(section);
            at.next();
            const std::string_view name = at.value("name");
            const auto [spec, isNew] = m_specs.try_emplace(name, readSpec(at, reading));
            if (!isNew) {
                reading.report(Severity::Info, section.line, "two Specs have one name; the first one is used");
            }
        }
    }
    for (const auto& [name, spec] : m_specs) {
        const auto [known, isNew] = m_unnumbered.try_emplace(withoutNumber(name), &spec);
        if (!isNew) {
            known->second = nullptr;  // nobody knows which one is meant
        }
    }
}

const Spec* Specs::find(const XmlCursor& reference) const {
    std::string_view id = reference.value("id");
    if (const auto exact = m_specs.find(id); exact != m_specs.end()) {
        return &exact->second;
    }
    constexpr std::string_view kPrefix = "SPEC_";
    id.remove_prefix(id.starts_with(kPrefix) ? kPrefix.size() : 0);
    const auto similar = m_unnumbered.find(id);
    const Spec* const spec = similar == m_unnumbered.end() ? nullptr : similar->second;
    m_reading.report(spec != nullptr ? Severity::Info : Severity::Warning, reference.line(),
                     spec != nullptr
                         ? "a SpecRef names a Spec with another prefix or number; the one of that layer is used"
                         : "a SpecRef names a Spec that the file does not have");
    return spec;
}

void Specs::describe(const Spec& spec, bool isCopper, Material& material) {
    material.name = material.name.empty() ? spec.material : material.name;
    if (isCopper) {
        material.resistivity = spec.resistivity;
        material.copperOz = spec.copperOz;
    } else {
        material.dielectricConstant = spec.dielectricConstant;
        material.lossTangent = spec.lossTangent;
    }
}

}  // namespace model::ipc2581
