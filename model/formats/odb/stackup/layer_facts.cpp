#include "model/formats/odb/stackup/layer_facts.h"

#include <string>

namespace model::odb {

namespace {

/// Numbers that materials have; outside of them an attribute is a mistake of the writer (a loss tangent of 3.5 occurs).
constexpr double kMostDielectricConstant = 100.0;
constexpr double kMostLossTangent = 0.5;

class FactReader {
public:
    FactReader(const AttributeList& attributes, std::string_view path, Diagnostics& diagnostics)
        : m_attributes(attributes), m_path(path), m_diagnostics(diagnostics) {}

    std::optional<double> scaled(std::string_view name, double scale) const {
        const std::optional<double> value = m_attributes.number(name, m_path, m_diagnostics);
        return value ? std::optional(*value * scale) : std::nullopt;
    }

    std::optional<double> within(std::string_view name, double least, double most) const {
        const std::optional<double> value = m_attributes.number(name, m_path, m_diagnostics);
        if (value && (*value < least || *value > most)) {
            m_diagnostics.report(Severity::Warning, m_path, 0,
                                 "attribute " + std::string(name) + " is absurd; it is ignored");
            return std::nullopt;
        }
        return value;
    }

    /// 1 is air, which writers put where nothing is known.
    std::optional<double> dielectricConstant() const {
        const std::optional<double> value = within(".dielectric_constant", 1.0, kMostDielectricConstant);
        return value && *value > 1.0 ? value : std::nullopt;
    }

    std::optional<double> lossTangent() const { return within(".loss_tangent", 0.0, kMostLossTangent); }

private:
    const AttributeList& m_attributes;
    std::string_view m_path;
    Diagnostics& m_diagnostics;
};

}  // namespace

LayerFacts factsOf(const AttributeList& attributes, const MatrixLayer& layer, std::string_view path,
                   Diagnostics& diagnostics) {
    const FactReader read(attributes, path, diagnostics);
    const bool isInch = attributes.unit() == Unit::Inch;
    const std::optional<double> dielectricNm =
        read.scaled(".layer_dielectric", isInch ? base::kNmPerInch : base::kNmPerMm);
    LayerFacts facts;
    if (layer.isCopper()) {
        facts.thicknessNm = read.scaled(".copper_weight", isInch ? base::kNmPerOunce : base::kNmPerUm);
        facts.material.copperOz = isInch ? read.scaled(".copper_weight", 1.0) : std::nullopt;
        facts.material.resistivity = read.scaled(".bulk_resistivity", 1.0);
        facts.belowNm = dielectricNm;
        facts.below.dielectricConstant = read.dielectricConstant();
        facts.below.lossTangent = read.lossTangent();
    } else if (layer.type == LayerType::Dielectric || layer.type == LayerType::SolderMask) {
        facts.thicknessNm = dielectricNm;
        facts.material.dielectricConstant = read.dielectricConstant();
        facts.material.lossTangent = read.lossTangent();
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
    const std::optional<double> thickness = attributes.number(".board_thickness", file->path, diagnostics);
    return thickness ? std::optional(*thickness * static_cast<double>(coordinateNm(attributes.unit()))) : std::nullopt;
}

void addMatrixFacts(const MatrixLayer& layer, Material& material) {
    material.form = layer.form;
    if (layer.type == LayerType::Dielectric) {
        material.type = layer.dielectricType;
        material.name = layer.dielectricName;
    }
}

}  // namespace model::odb
