#include "model/formats/odb/stackup/stackup_xml.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <pugixml.hpp>

#include "model/board/stackup.h"
#include "model/formats/odb/text/records.h"

namespace model::odb {

namespace {

/// An element's name, whatever XML namespace it is written in.
bool isNamed(const pugi::xml_node& node, std::string_view name) {
    const std::string_view full = node.name();
    const std::size_t colon = full.find(':');
    return (colon == std::string_view::npos ? full : full.substr(colon + 1)) == name;
}

pugi::xml_node child(const pugi::xml_node& parent, std::string_view name) {
    return parent.find_child([name](const pugi::xml_node& node) { return isNamed(node, name); });
}

std::optional<double> number(const pugi::xml_node& node, const char* attribute) {
    const std::optional<double> value = parseReal(node.attribute(attribute).value());
    return value && *value > 0 ? value : std::nullopt;
}

std::optional<double> nmPerUnit(std::string_view unit) {
    static constexpr std::array<std::pair<std::string_view, double>, 4> kUnits = {
        {{"MM", base::kNmPerMm}, {"MICRON", base::kNmPerUm}, {"INCH", base::kNmPerInch}, {"MIL", base::kNmPerMil}}};
    const auto* const found =
        std::ranges::find_if(kUnits, [unit](const auto& entry) { return equalsIgnoringCase(entry.first, unit); });
    return found == kUnits.end() ? std::nullopt : std::optional(found->second);
}

/// A property within bounds that materials have.
std::optional<double> within(std::optional<double> value, double most) {
    return value && *value <= most ? value : std::nullopt;
}

class XmlReader {
public:
    XmlReader(std::string_view text, std::string_view path, Diagnostics& diagnostics)
        : m_text(text), m_path(path), m_diagnostics(diagnostics) {}

    StackupXml read() {
        const pugi::xml_parse_result result = m_document.load_buffer(m_text.data(), m_text.size());
        if (!result) {
            report(Severity::Error, lineAt(result.offset),
                   std::string("the file is no XML (") + result.description() + "); the attributes are used instead");
            return {};
        }
        const pugi::xml_node file = child(m_document, "StackupFile");
        pugi::xml_node source = child(file, "EdaData");
        source = child(source, "Stackup") ? source : child(file, "SupplierData");
        const pugi::xml_node stackup = child(source, "Stackup");
        if (!stackup) {
            report(Severity::Warning, 0, "the file holds no Stackup; the attributes are used instead");
            return {};
        }
        m_defaultNm = nmPerUnit(file.attribute("DefaultUnits").value()).value_or(base::kNmPerMil);
        m_specs = child(source, "Specs");
        StackupXml out;
        out.boardNm = length(stackup, "StackupThickness", "Units");
        for (const pugi::xml_node& group : stackup.children()) {
            for (const pugi::xml_node& layer : group.children()) {
                if (isNamed(group, "Group") && isNamed(layer, "Layer")) {
                    out.layers.push_back(layerOf(layer));
                }
            }
        }
        return out;
    }

private:
    std::uint32_t lineAt(std::ptrdiff_t offset) const {
        const auto end = m_text.begin() + std::clamp<std::ptrdiff_t>(offset, 0, std::ssize(m_text));
        return static_cast<std::uint32_t>(std::count(m_text.begin(), end, '\n') + 1);
    }

    void report(Severity severity, std::uint32_t line, const std::string& text) {
        m_diagnostics.report(severity, m_path, line, text);
    }

    std::optional<double> length(const pugi::xml_node& node, const char* attribute, const char* unit) const {
        const std::optional<double> value = number(node, attribute);
        return value ? std::optional(*value * nmPerUnit(node.attribute(unit).value()).value_or(m_defaultNm))
                     : std::nullopt;
    }

    XmlLayer layerOf(const pugi::xml_node& node) {
        XmlLayer layer;
        layer.name = toUtf8(node.attribute("LayerName").value());
        layer.isDielectric = equalsIgnoringCase(node.attribute("LayerType").value(), "DIELECTRIC");
        layer.line = lineAt(node.offset_debug());
        const pugi::xml_node specRef = child(node, "SpecRef");
        const pugi::xml_node wanted = child(specRef, "Material");
        if (const pugi::xml_node material = findMaterial(specRef, wanted)) {
            describe(material, wanted, layer);
        } else if (wanted) {
            report(Severity::Warning, layer.line, "layer " + layer.name + ": its material is not in the file");
        }
        return layer;
    }

    pugi::xml_node findMaterial(const pugi::xml_node& specRef, const pugi::xml_node& wanted) const {
        const auto isWanted = [&](const pugi::xml_node& node) {
            return isNamed(node, "Material") && std::string_view(node.attribute("MaterialName").value()) ==
                                                    std::string_view(wanted.attribute("MaterialName").value());
        };
        const std::string_view spec = specRef.attribute("MaterialSpecName").value();
        for (const pugi::xml_node& node : m_specs.children()) {
            const bool isSpec = isNamed(node, "Spec") && spec == std::string_view(node.attribute("SpecName").value());
            if (wanted && isSpec && node.find_child(isWanted)) {
                return node.find_child(isWanted);
            }
        }
        return {};
    }

    void describe(const pugi::xml_node& material, const pugi::xml_node& wanted, XmlLayer& layer) const {
        const pugi::xml_node conductor = child(material, "Conductor");
        const pugi::xml_node dielectric = child(material, "Dielectric");
        const pugi::xml_node property = propertyOf(conductor ? conductor : dielectric, wanted);
        layer.material.name = toUtf8(material.attribute("MaterialName").value());
        layer.material.type = toUtf8(dielectric.attribute("DielectricType").value());
        layer.material.copperOz = number(conductor, "CopperWeight_oz_ft2");
        layer.material.dielectricConstant = within(number(property, "DielectricConstant_Dk"), 100.0);
        layer.material.lossTangent = within(number(property, "LossTangent_Df"), 0.5);
        if (const auto conductivity = number(property, "Conductivity_mho_cm")) {
            layer.material.resistivity = 1e7 / *conductivity;  // 1 / (S/cm) = 1 Ω·cm = 1e7 nΩ·m
        }
        layer.thicknessNm = thicknessOf(property, "Units_Thickness");
        if (!layer.thicknessNm) {
            layer.thicknessNm = thicknessOf(child(material, "Default_Thickness"), "Units");
        }
        if (!layer.thicknessNm && layer.material.copperOz) {
            layer.thicknessNm = *layer.material.copperOz * base::kNmPerOunce;
        }
    }

    std::optional<double> thicknessOf(const pugi::xml_node& node, const char* unit) const {
        const std::optional<double> finished = length(node, "Finished_Thickness", unit);
        return finished ? finished : length(node, "Thickness", unit);
    }

    /// The property the layer names by set and frequency, else the first of the set.
    static pugi::xml_node propertyOf(const pugi::xml_node& parent, const pugi::xml_node& wanted) {
        const std::string_view set = wanted.attribute("PropertyName").value();
        pugi::xml_node properties = parent.find_child([set](const pugi::xml_node& node) {
            return isNamed(node, "Properties") && set == std::string_view(node.attribute("PropertyName").value());
        });
        properties = properties ? properties : child(parent, "Properties");
        const std::optional<double> frequency = number(wanted, "FrequencyVal");
        const pugi::xml_node exact = properties.find_child([&](const pugi::xml_node& node) {
            return isNamed(node, "Property") && frequency && number(node, "FrequencyVal") == frequency;
        });
        return exact ? exact : child(properties, "Property");
    }

    std::string_view m_text;
    std::string_view m_path;
    Diagnostics& m_diagnostics;
    pugi::xml_document m_document;
    pugi::xml_node m_specs;
    double m_defaultNm = base::kNmPerMil;
};

/// Puts what one file says over what the other says.
class Merger {
public:
    Merger(std::string_view path, StackupFacts& facts, Diagnostics& diagnostics)
        : m_path(path), m_facts(facts), m_diagnostics(diagnostics) {}

    void board(std::optional<double> nm) { take(nm, m_facts.boardNm, 0.01, 0, "the board's thickness"); }

    void layer(const XmlLayer& xml, bool isCopper, LayerFacts& facts) {
        take(xml.thicknessNm, facts.thicknessNm, isCopper ? kOunceTolerance : 0.01, xml.line,
             "the thickness of layer " + xml.name);
        material(xml, facts.material);
    }

    /// A dielectric without a row in the matrix.
    void below(const XmlLayer& xml, bool isFirst, LayerFacts& copper) {
        const std::optional<double> before = isFirst ? std::nullopt : copper.belowNm;
        copper.belowNm = xml.thicknessNm || before ? std::optional(xml.thicknessNm.value_or(0.0) + before.value_or(0.0))
                                                   : copper.belowNm;
        const std::string name = isFirst ? "" : copper.below.name + " + ";
        material(xml, copper.below);
        copper.below.name = name + xml.material.name;
    }

private:
    void take(std::optional<double> nm, std::optional<double>& into, double tolerance, std::uint32_t line,
              const std::string& what) {
        if (nm && into && *into > 0 && std::abs(*nm - *into) > tolerance * *into) {
            m_diagnostics.report(Severity::Warning, m_path, line,
                                 what + " is not what the attributes say; this file is believed");
        }
        into = nm ? nm : into;
    }

    static void material(const XmlLayer& xml, Material& into) {
        const auto over = [](const auto& value, auto& old) { old = value ? value : old; };
        into.name = xml.material.name.empty() ? into.name : xml.material.name;
        into.type = xml.material.type.empty() ? into.type : xml.material.type;
        over(xml.material.copperOz, into.copperOz);
        over(xml.material.dielectricConstant, into.dielectricConstant);
        over(xml.material.lossTangent, into.lossTangent);
        over(xml.material.resistivity, into.resistivity);
    }

    std::string_view m_path;
    StackupFacts& m_facts;
    Diagnostics& m_diagnostics;
};

}  // namespace

StackupXml parseStackupXml(std::string_view text, std::string_view path, Diagnostics& diagnostics) {
    return XmlReader(text, path, diagnostics).read();
}

void mergeStackupXml(const StackupXml& xml, std::string_view path, const std::vector<Layer>& layers,
                     StackupFacts& facts, Diagnostics& diagnostics) {
    Merger merger(path, facts, diagnostics);
    merger.board(xml.boardNm);
    std::size_t above = layers.size();  // the copper last passed
    bool isFirst = true;
    for (const XmlLayer& layer : xml.layers) {
        const auto found =
            std::ranges::find_if(layers, [&](const Layer& l) { return equalsIgnoringCase(l.name, layer.name); });
        const auto row = static_cast<std::size_t>(found - layers.begin());
        if (row < layers.size()) {
            merger.layer(layer, found->isCopper(), facts.layers[row]);
            above = found->isCopper() ? row : above;
            isFirst = true;
        } else if (layer.isDielectric && above < layers.size()) {
            merger.below(layer, isFirst, facts.layers[above]);
            isFirst = false;
        } else {
            diagnostics.report(Severity::Warning, path, layer.line,
                               "layer " + layer.name + " is not in the matrix; it is left out");
        }
    }
}

}  // namespace model::odb
