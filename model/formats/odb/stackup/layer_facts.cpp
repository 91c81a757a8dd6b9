#include "model/formats/odb/stackup/layer_facts.h"

#include <string>

namespace model::odb {

namespace {

void addDielectric(const AttributeList& attributes, Material& material) {
    // Numbers that materials have; outside of them an attribute is a mistake (a loss tangent of 3.5 occurs).
    constexpr double kMostDielectricConstant = 100.0;
    constexpr double kMostLossTangent = 0.5;
    const auto constant = attributes.numberWithin(".dielectric_constant", 1.0, kMostDielectricConstant);
    // 1 is air, which writers put where nothing is known.
    material.dielectricConstant = constant && *constant > 1.0 ? constant : std::nullopt;
    material.lossTangent = attributes.numberWithin(".loss_tangent", 0.0, kMostLossTangent);
}

}  // namespace

AttributeList::AttributeList(std::string_view text, std::string_view path, Unit defaultUnit, Diagnostics& diagnostics)
    : m_block(parseStructured(text, path, diagnostics).top),
      m_unit(parseUnit(m_block.value("UNITS")).value_or(defaultUnit)),
      m_path(path),
      m_diagnostics(diagnostics) {}

void AttributeList::report(std::string_view name, std::string_view what) const {
    m_diagnostics.report(Severity::Warning, m_path, 0,
                         "attribute " + std::string(name) + " is " + std::string(what) + "; it is ignored");
}

std::optional<double> AttributeList::number(std::string_view name, double scale) const {
    const std::string_view value = text(name);
    const std::optional<double> number = parseReal(value);
    if (!number && !value.empty()) {
        report(name, "not a number");
    }
    return number && *number != 0.0 ? std::optional(*number * scale) : std::nullopt;
}

std::optional<double> AttributeList::numberWithin(std::string_view name, double least, double most) const {
    const std::optional<double> value = number(name);
    if (value && (*value < least || *value > most)) {
        report(name, "absurd");
        return std::nullopt;
    }
    return value;
}

LayerFacts factsOf(const AttributeList& attributes, const MatrixLayer& layer) {
    const bool isInch = attributes.unit() == Unit::Inch;
    const std::optional<double> dielectricNm =
        attributes.number(".layer_dielectric", isInch ? base::kNmPerInch : base::kNmPerMm);
    LayerFacts facts;
    if (layer.isCopper()) {
        facts.thicknessNm = attributes.number(".copper_weight", isInch ? base::kNmPerOunce : base::kNmPerUm);
        facts.material.copperOz = isInch ? attributes.number(".copper_weight") : std::nullopt;
        facts.material.resistivity = attributes.number(".bulk_resistivity");
        facts.belowNm = dielectricNm;
        addDielectric(attributes, facts.below);
    } else if (layer.type == LayerType::Dielectric || layer.type == LayerType::SolderMask) {
        facts.thicknessNm = dielectricNm;
        addDielectric(attributes, facts.material);
    }
    return facts;
}

std::optional<double> boardThicknessIn(const formats::FileTree& tree, const std::string& path, Unit defaultUnit,
                                       Diagnostics& diagnostics) {
    const auto file = tree.read(path, diagnostics);
    if (!file) {
        return std::nullopt;
    }
    const AttributeList attributes(file->text(), file->path, defaultUnit, diagnostics);
    return attributes.number(".board_thickness", static_cast<double>(coordinateNm(attributes.unit())));
}

void addMatrixFacts(const MatrixLayer& layer, Material& material) {
    material.form = layer.form;
    if (layer.type == LayerType::Dielectric) {
        material.type = layer.dielectricType;
        material.name = layer.dielectricName;
    }
}

}  // namespace model::odb
