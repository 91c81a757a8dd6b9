#include "model/formats/odb/stackup/layer_facts.h"

#include <cmath>
#include <string>
#include <utility>

namespace model::odb {

namespace {

/// Print is 10 to 30 µm thick, and paste as thick as its stencil. Altium writes 2.54 µm where nothing is known, others
/// what they write for dielectrics.
constexpr double kLeastPrint = 5 * base::kNmPerUm;
constexpr double kMostPrint = 100 * base::kNmPerUm;
constexpr double kMostPaste = 500 * base::kNmPerUm;

constexpr const char* kWeight = ".copper_weight";
constexpr const char* kDielectric = ".layer_dielectric";

/// Ounces in a mm file are KiCad 10's, which writes the copper's own thickness where others have the dielectric's.
void addOunces(double ounces, LayerFacts& facts) {
    constexpr double kSame = 0.035;  // programs take an ounce for 34 to 35.8 µm
    facts.material.copperOz = ounces;
    facts.thicknessNm = ounces * base::kNmPerOunce;
    if (facts.belowNm && std::abs(*facts.belowNm - *facts.thicknessNm) <= kSame * *facts.thicknessNm) {
        facts.thicknessNm = std::exchange(facts.belowNm, std::nullopt);
    }
}

void addWeight(const AttributeList& attributes, LayerFacts& facts) {
    constexpr double kLeastUm = 5.0;  // of any copper
    const std::optional<double> weight = attributes.number(kWeight);
    if (!weight) {
        return;
    }
    if (attributes.unit() == Unit::Inch) {
        facts.material.copperOz = weight;
        facts.thicknessNm = *weight * base::kNmPerOunce;
    } else if (*weight > 0.0 && *weight < kLeastUm) {
        attributes.report(Severity::Info, kWeight, "too thin for copper in µm",
                          "it is taken as ounces per square foot");
        addOunces(*weight, facts);
    } else {
        facts.thicknessNm = *weight * base::kNmPerUm;
    }
}

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

void AttributeList::report(Severity severity, std::string_view name, std::string_view what,
                           std::string_view consequence) const {
    std::string message = "attribute ";
    message.append(name).append(" is ").append(what).append("; ").append(consequence);
    m_diagnostics.report(severity, m_path, m_block.lineOf(name), message);
}

std::optional<double> AttributeList::number(std::string_view name, double scale) const {
    const std::string_view value = text(name);
    const std::optional<double> number = parseReal(value);
    if (!number && !value.empty()) {
        report(Severity::Warning, name, "not a number");
    }
    return number && *number != 0.0 ? std::optional(*number * scale) : std::nullopt;
}

std::optional<double> AttributeList::numberWithin(std::string_view name, double least, double most) const {
    const std::optional<double> value = number(name);
    if (value && (*value < least || *value > most)) {
        report(Severity::Warning, name, "absurd");
        return std::nullopt;
    }
    return value;
}

std::optional<double> AttributeList::thicknessWithin(std::string_view name, double least, double most,
                                                     const std::string& what) const {
    const std::optional<double> nm = number(name, static_cast<double>(coordinateNm(m_unit)));
    if (nm && (*nm < least || *nm > most)) {
        report(Severity::Info, name, (*nm < least ? "too thin for " : "too thick for ") + what);
        return std::nullopt;
    }
    return nm;
}

LayerFacts factsOf(const AttributeList& attributes, const MatrixLayer& layer) {
    const auto coordinate = static_cast<double>(coordinateNm(attributes.unit()));
    LayerFacts facts;
    if (layer.isCopper()) {
        facts.material.resistivity = attributes.number(".bulk_resistivity");
        facts.belowNm = attributes.number(kDielectric, coordinate);
        addWeight(attributes, facts);
        addDielectric(attributes, facts.below);
    } else if (layer.type == LayerType::Dielectric || layer.type == LayerType::SolderMask) {
        facts.thicknessNm = attributes.number(kDielectric, coordinate);
        addDielectric(attributes, facts.material);
    } else if (layer.type == LayerType::SilkScreen) {
        facts.thicknessNm = attributes.thicknessWithin(kDielectric, kLeastPrint, kMostPrint, "silkscreen");
    } else if (layer.type == LayerType::SolderPaste) {
        facts.thicknessNm = attributes.thicknessWithin(kDielectric, kLeastPrint, kMostPaste, "solder paste");
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
