#include "model/formats/ipc2581/step_reader.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "model/base/limits.h"
#include "model/formats/ipc2581/xml/xml_values.h"
#include "model/geometry/outlines.h"

namespace model::ipc2581 {

namespace {

using formats::DrawnNetlist;
using formats::NetlistPoint;

int countOf(Reading& reading, const XmlCursor& at, const char* attribute) {
    const double count = reading.lengthOr(at, attribute, 1.0, 1.0);
    if (count >= 1.0 && count <= static_cast<double>(base::kMostCopies)) {
        return static_cast<int>(count);
    }
    reading.report(Severity::Warning, at.line(),
                   "a StepRepeat counts none or " + base::moreThan(base::kMostCopies, "copies") + "; 1 is used");
    return 1;
}

Exposure exposureNamed(std::string_view name) {
    return name == "EXPOSED"             ? Exposure::Exposed
           : name == "COVERED"           ? Exposure::Covered
           : name == "COVERED_PRIMARY"   ? Exposure::CoveredOnTop
           : name == "COVERED_SECONDARY" ? Exposure::CoveredOnBottom
                                         : Exposure::NotSaid;
}

class StepReader {
public:
    StepReader(const StepSurroundings& file, std::string_view name)
        : m_file(file),
          m_reading(file.reading),
          m_canvas(file.reading, m_step.drawn),
          m_shapes(file.reading, file.dictionaries, m_canvas),
          m_nets(m_step.drawn),
          m_parts(file.reading, file.layers, file.bom, m_shapes, m_nets, m_step.drawn),
          m_features(file.reading, file.dictionaries, file.specs, file.layers, m_canvas, m_nets, m_parts,
                     m_step.drawn) {
        m_step.name = name;
        m_step.drawn.name = textOf(name);
        for (std::string* path : {&m_step.drawn.profileFile, &m_step.drawn.componentsFile, &m_step.drawn.copiesFile}) {
            *path = m_reading.path();
        }
    }

    SourceStep read(std::span<const XmlSection> sections) {
        struct Rule {
            std::string_view element;
            void (StepReader::*read)(XmlCursor&);
        };
        // In this order: what is read later refers to what is read before.
        static constexpr std::array<Rule, 12> kRules = {{{"Datum", &StepReader::readDatum},
                                                         {"Profile", &StepReader::readProfile},
                                                         {"StepRepeat", &StepReader::readRepeat},
                                                         {"StackupZone", &StepReader::readZone},
                                                         {"Package", &StepReader::readPackage},
                                                         {"Component", &StepReader::readComponent},
                                                         {"LogicalNet", &StepReader::readNet},
                                                         {"PadStackDef", &StepReader::readPadStackDef},
                                                         {"PadstackDef", &StepReader::readPadStackDef},
                                                         {"PadStack", &StepReader::readPadStack},
                                                         {"LayerFeature", &StepReader::readLayerFeature},
                                                         {"PhyNetGroup", &StepReader::readPhyNets}}};
        for (const Rule& rule : kRules) {
            for (const XmlSection& section : sections) {
                if (section.name == rule.element && !m_file.progress.isCancelled()) {
                    XmlCursor at = m_reading.at(section);
                    at.next();
                    (this->*rule.read)(at);
                }
            }
        }
        reportOthers(sections, kRules);
        m_features.finish();
        m_parts.finish();
        m_step.drawsItself = std::ranges::any_of(m_step.drawn.features, [](const auto& of) { return !of.empty(); });
        return std::move(m_step);
    }

private:
    template <class Rules>
    void reportOthers(std::span<const XmlSection> sections, const Rules& rules) {
        for (const XmlSection& section : sections) {
            const bool isKnown =
                std::ranges::any_of(rules, [&](const auto& rule) { return rule.element == section.name; });
            if (section.name == "BendArea") {
                m_reading.report(Severity::Info, section.line, "bend areas are not read; nothing is drawn bent");
            } else if (!isKnown) {
                XmlCursor at = m_reading.at(section);
                at.next();
                m_reading.reportUnknown(at);
            }
        }
    }

    void readDatum(XmlCursor& at) { m_step.datum = m_reading.point(at, m_reading.unitNm()); }
    void readPackage(XmlCursor& at) { m_parts.addPackage(at); }
    void readComponent(XmlCursor& at) { m_parts.addComponent(at); }
    void readNet(XmlCursor& at) { m_parts.addNet(at); }
    void readPadStackDef(XmlCursor& at) { m_features.addPadStackDef(at); }
    void readPadStack(XmlCursor& at) { m_features.readPadStack(at); }
    void readLayerFeature(XmlCursor& at) { m_features.readLayerFeature(at); }

    void readProfile(XmlCursor& at) {
        m_canvas.setLine(at.line());
        const ShapeSketch sketch = m_shapes.sketch(at, {}, m_reading.unitNm());
        m_step.drawn.profile.append(sketch, {});
    }

    void readRepeat(XmlCursor& at) {
        const double unit = m_reading.unitNm();
        SourceRepeat repeat;
        repeat.step = at.value("stepRef");
        repeat.first = m_reading.point(at, unit);
        repeat.columns = countOf(m_reading, at, "nx");
        repeat.rows = countOf(m_reading, at, "ny");
        repeat.pitch = {m_reading.lengthOr(at, "dx", unit, 0.0), m_reading.lengthOr(at, "dy", unit, 0.0)};
        repeat.ccwDeg = normalDegrees(m_reading.lengthOr(at, "angle", 1.0, 0.0));
        repeat.isMirrored = isTrue(at.value("mirror"));
        repeat.line = at.line();
        m_step.repeats.push_back(repeat);
    }

    void readZone(XmlCursor& at) {
        formats::DrawnZone zone;
        zone.name = textOf(at.value("name"));
        const std::string_view reference = at.value("stackupRef");
        const auto stack = std::ranges::find(m_file.stackups.stacks, reference, &Stack::name);
        if (stack == m_file.stackups.stacks.end()) {
            m_reading.report(Severity::Warning, at.line(),
                             "a zone names a stackup that the file does not have; it was left out");
            return;
        }
        for (const std::size_t row : stack->layers) {
            zone.layers.push_back(static_cast<std::int32_t>(row));
        }
        m_canvas.setLine(at.line());
        forEachChild(at, [&] {
            if (at.name() == "Profile") {
                zone.shape = m_shapes.sketch(at, {}, m_reading.unitNm());
            } else {
                m_reading.reportUnknown(at);
            }
        });
        m_step.drawn.zones.push_back(std::move(zone));
    }

    void readPhyNets(XmlCursor& at) {
        DrawnNetlist netlist;
        netlist.kind = NetlistKind::Reference;
        netlist.file = m_reading.path();
        forEachChild(at, [&] {
            if (at.name() != "PhyNet") {
                return m_reading.reportUnknown(at);
            }
            const auto number = static_cast<std::int32_t>(netlist.netlist.names.size());
            netlist.netlist.names.push_back(textOf(at.value("name")));
            forEachChild(at, [&] {
                if (at.name() == "PhyNetPoint") {
                    netlist.netlist.points.push_back(pointAt(at, number));
                } else {
                    m_reading.reportUnknown(at);
                }
            });
        });
        m_step.drawn.netlists.push_back(std::move(netlist));
    }

    NetlistPoint pointAt(XmlCursor& at, std::int32_t number) {
        NetlistPoint point;
        point.number = number;
        point.line = at.line();
        point.position = m_reading.rounded(m_reading.point(at, m_reading.unitNm()), point.line);
        point.exposure = exposureNamed(at.value("exposure"));
        point.isVia = isTrue(at.value("via"));
        point.isEnd = at.value("netNode") != "MIDDLE";
        const int layer = m_file.layers.find(at.value("layerRef"));
        point.side = layer < 0 ? LayerSide::None : m_file.layers[static_cast<std::size_t>(layer)].drawn.side;
        forEachChild(at, [&] {
            const Box box = boxAround(at);
            if (!box.isEmpty()) {
                point.width = static_cast<Nm>(std::min<std::int64_t>(box.width(), base::kMaxCoordinate));
                point.height = static_cast<Nm>(std::min<std::int64_t>(box.height(), base::kMaxCoordinate));
            }
        });
        return point;
    }

    /// Around a shape; those of dictionaries are measured once.
    Box boxAround(XmlCursor& at) {
        if (at.name() != "StandardPrimitiveRef") {
            return {};
        }
        const auto [found, isNew] = m_boxes.try_emplace(at.value("id"));
        if (isNew) {
            found->second = boxOf(m_shapes.sketch(at, {}, m_reading.unitNm()));
        }
        return found->second;
    }

    SourceStep m_step;
    const StepSurroundings& m_file;
    Reading& m_reading;
    Canvas m_canvas;
    ShapeReader m_shapes;
    NetTable m_nets;
    PartTable m_parts;
    FeatureReader m_features;
    std::unordered_map<std::string_view, Box> m_boxes;
};

}  // namespace

SourceStep readStep(const StepSurroundings& file, std::string_view name, std::span<const XmlSection> sections) {
    return StepReader(file, name).read(sections);
}

}  // namespace model::ipc2581
