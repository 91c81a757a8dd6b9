#include "model/formats/odb/components/eda.h"

#include <algorithm>

#include "model/formats/odb/components/package_outlines.h"
#include "model/formats/odb/text/records.h"

namespace model::odb {

namespace {

/// Everything up to the attributes, without blanks around it.
std::string_view nameOf(std::string_view text) {
    return trimmed(text.substr(0, text.find(';')));
}

/// The longest name that `text` begins with, whole words only; its length, or 0.
std::size_t knownPrefix(std::string_view text, const std::vector<std::string>& names) {
    std::size_t longest = 0;
    for (const std::string& name : names) {
        const bool fits = text.size() >= name.size() && equalsIgnoringCase(text.substr(0, name.size()), name) &&
                          (text.size() == name.size() || text[name.size()] == ' ' || text[name.size()] == '\t');
        longest = fits ? std::max(longest, name.size()) : longest;
    }
    return longest;
}

std::vector<std::string> splitLayers(std::string_view text, const std::vector<std::string>& names) {
    std::vector<std::string> layers;
    for (text = trimmed(text); !text.empty(); text = trimmed(text)) {
        std::size_t length = knownPrefix(text, names);
        length = length > 0 ? length : std::min(text.find_first_of(" \t"), text.size());
        layers.emplace_back(text.substr(0, length));
        text.remove_prefix(length);
    }
    return layers;
}

PinKind pinKindOf(std::string_view letter) {
    return letter == "T" ? PinKind::Through : letter == "B" ? PinKind::Blind : PinKind::Surface;
}

PlaneFill fillOf(std::string_view word) {
    return word == "S"   ? PlaneFill::Solid
           : word == "H" ? PlaneFill::Hatched
           : word == "O" ? PlaneFill::Outline
                         : PlaneFill::NotSaid;
}

PlaneCutout cutoutOf(std::string_view word) {
    return word == "C"   ? PlaneCutout::Circle
           : word == "R" ? PlaneCutout::Rectangle
           : word == "O" ? PlaneCutout::Octagon
           : word == "E" ? PlaneCutout::Exact
                         : PlaneCutout::NotSaid;
}

class EdaParser {
public:
    EdaParser(std::string_view path, Unit unit, const std::vector<std::string>& layerNames, const AttributeTypes& types,
              Diagnostics& diagnostics)
        : m_at{path, diagnostics, coordinateNm(unit)}, m_layerNames(layerNames), m_types(types), m_outlines(m_at) {}

    EdaData parse(std::string_view text) {
        readNamesInComments(text);
        m_at.forEachLine(text, [this](std::string_view line) { record(line); });
        closeSubnet();
        return std::move(m_data);
    }

private:
    /// What the records that follow belong to.
    enum class Part { None, Net, Package, Pin, Group };

    /// Most writers put the attribute names of eda/data behind a `#`.
    void readNamesInComments(std::string_view text) {
        for (const std::string_view mark : {"#@", "#&"}) {
            for (std::size_t at = text.find(mark); at != std::string_view::npos; at = text.find(mark, at + 1)) {
                if (at == 0 || text[at - 1] == '\n') {
                    m_attributes.record(text.substr(at + 1, text.find('\n', at) - at - 1));
                }
            }
        }
    }

    void record(std::string_view line) {
        if (m_properties.record(line, propertiesHere())) {
            return m_part == Part::None ? warn("a property that belongs to nothing was left out") : void();
        }
        if (m_attributes.record(line) || readUnit(line, m_at.nm)) {
            return;
        }
        const std::string_view word = line.substr(0, line.find_first_of(" \t;"));
        using Handler = void (EdaParser::*)(std::string_view);
        static constexpr std::pair<std::string_view, Handler> kHandlers[] = {
            {"FID", &EdaParser::feature}, {"SNT", &EdaParser::subnet},  {"NET", &EdaParser::net},
            {"PIN", &EdaParser::pin},     {"PKG", &EdaParser::package}, {"FGR", &EdaParser::group},
            {"LYR", &EdaParser::layers},  {"HDR", &EdaParser::header}};
        for (const auto& [kind, handler] : kHandlers) {
            if (word == kind) {
                return (this->*handler)(line.substr(word.size()));
            }
        }
        if (!m_outlines.record(line, outlineHere()) && !line.starts_with("ID=")) {
            warn("a record of an unknown kind was left out");
        }
    }

    std::vector<TextProperty>& propertiesHere() {
        switch (m_part) {
            case Part::Net: return m_data.nets.back().properties;
            case Part::Package:
            case Part::Pin: return m_data.packages.back().properties;
            case Part::Group: return m_data.groups.back().properties;
            case Part::None: break;
        }
        return m_nobodys;
    }

    ShapeSketch* outlineHere() {
        return m_part == Part::Package ? &m_data.packages.back().outline
               : m_part == Part::Pin   ? &m_data.packages.back().pins.back().outline
                                       : nullptr;
    }

    std::vector<TextProperty> attributesOf(std::string_view line) {
        return m_attributes.resolve(Fields(line).tail(), m_types, m_at);
    }

    void warn(std::string_view text) { m_at.report(Severity::Warning, text); }

    void header(std::string_view line) { m_data.generator = toUtf8(trimmed(line)); }

    void layers(std::string_view line) {
        if (!m_data.layers.empty()) {
            return warn("a second LYR line was left out; FID records count the layers of the first");
        }
        m_data.layers = splitLayers(toUtf8(line), m_layerNames);
    }

    void net(std::string_view line) {
        closeSubnet();
        m_part = Part::Net;
        m_hasSubnet = false;
        m_data.nets.push_back({toUtf8(nameOf(line)), attributesOf(line)});
    }

    void subnet(std::string_view line) {
        closeSubnet();
        if (m_part != Part::Net) {
            return warn("a subnet outside of a net was left out");
        }
        EdaSubnet subnet;
        Fields fields(line);
        const std::string_view kind = fields.word();
        if (kind == "TOP") {
            subnet.kind = SubnetKind::PinPads;
            subnet.side = fields.word() == "B" ? LayerSide::Bottom : LayerSide::Top;
            subnet.component = fields.integer();
            subnet.toeprint = fields.integer();
        } else if (kind == "PLN") {
            subnet.kind = SubnetKind::Plane;
            subnet.planeFill = fillOf(fields.word());
            subnet.planeCutout = cutoutOf(fields.word());
            subnet.planeCutoutSize = fields.atEnd() ? 0 : fields.length(m_at.nm);
        } else if (kind == "VIA" || kind == "TRC") {
            subnet.kind = kind == "VIA" ? SubnetKind::Via : SubnetKind::Trace;
        }
        if (fields.failed() || subnet.kind == SubnetKind::Other) {
            warn("a subnet that cannot be read; its features stay in their net");
            subnet = {};
        }
        openSubnet(subnet);
    }

    void openSubnet(EdaSubnet subnet) {
        subnet.net = static_cast<std::uint32_t>(m_data.nets.size() - 1);
        subnet.firstFeature = static_cast<std::uint32_t>(m_data.features.size());
        m_data.subnets.push_back(subnet);
        m_hasSubnet = true;
    }

    void closeSubnet() {
        if (m_hasSubnet && m_part == Part::Net) {
            EdaSubnet& last = m_data.subnets.back();
            last.featureCount = static_cast<std::uint32_t>(m_data.features.size()) - last.firstFeature;
        }
    }

    void feature(std::string_view line) {
        Fields fields(line);
        fields.word();  // C, L or H: not reliable (odb-notes, Nets and parts)
        const std::int32_t layer = fields.integer();
        const std::int32_t number = fields.integer();
        if (fields.failed() || layer < 0 || number < 0 || static_cast<std::size_t>(layer) >= m_data.layers.size()) {
            return warn("the FID record is unreadable or names no layer of the LYR line; it was left out");
        }
        if (m_part != Part::Net && m_part != Part::Group) {
            return warn("a FID record outside of nets and groups was left out");
        }
        if (m_part == Part::Net && !m_hasSubnet) {
            openSubnet({});
        }
        m_data.features.push_back({static_cast<std::uint32_t>(layer), static_cast<std::uint32_t>(number), m_at.line});
        if (m_part == Part::Group) {
            ++m_data.groups.back().featureCount;
        }
    }

    void group(std::string_view line) {
        closeSubnet();
        m_part = Part::Group;
        m_data.groups.push_back({toUtf8(nameOf(line)), {}, static_cast<std::uint32_t>(m_data.features.size()), 0});
    }

    void package(std::string_view line) {
        closeSubnet();
        m_part = Part::Package;
        Fields fields(line);
        EdaPackage package;
        package.name = toUtf8(fields.optionalWord());
        package.properties = attributesOf(line);
        if (!fields.atEnd()) {
            package.pitch = toLength(fields.real(), m_at.nm).value_or(0);  // Altium writes 99.999 for "none"
            package.box.include(fields.point(m_at.nm));
            package.box.include(fields.point(m_at.nm));
        }
        if (fields.failed()) {
            warn("the size of a package cannot be read");
            package.box = {};
        }
        m_data.packages.push_back(std::move(package));
    }

    void pin(std::string_view line) {
        if (m_part != Part::Package && m_part != Part::Pin) {
            return warn("a PIN record outside of a package was left out");
        }
        m_part = Part::Pin;
        Fields fields(line);
        EdaPin pin;
        pin.name = toUtf8(fields.optionalWord());
        pin.kind = pinKindOf(fields.optionalWord());
        pin.position = fields.point(m_at.nm);
        if (fields.failed()) {
            warn("the position of a package's pin cannot be read");
            pin.position = {};
        }
        m_data.packages.back().pins.push_back(std::move(pin));
    }

    EdaData m_data;
    FileCursor m_at;
    const std::vector<std::string>& m_layerNames;
    const AttributeTypes& m_types;
    PackageOutlines m_outlines;
    RecordAttributes m_attributes;
    PropertyReader m_properties;
    std::vector<TextProperty> m_nobodys;
    Part m_part = Part::None;
    bool m_hasSubnet = false;
};

}  // namespace

EdaData parseEda(std::string_view text, std::string_view path, Unit defaultUnit,
                 const std::vector<std::string>& layerNames, const AttributeTypes& types, Diagnostics& diagnostics) {
    return EdaParser(path, defaultUnit, layerNames, types, diagnostics).parse(text);
}

}  // namespace model::odb
