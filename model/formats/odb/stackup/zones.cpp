#include "model/formats/odb/stackup/zones.h"

#include "model/formats/odb/features/surface_parser.h"
#include "model/formats/odb/text/records.h"

namespace model::odb {

namespace {

class ZoneParser {
public:
    ZoneParser(std::string_view path, Unit unit, Diagnostics& diagnostics)
        : m_at{path, diagnostics, coordinateNm(unit)}, m_surface(m_file.outlines, m_at) {}

    ZoneFile parse(std::string_view text) {
        m_at.forEachLine(text, [this](std::string_view line) { record(line); });
        endOutline();
        return std::move(m_file);
    }

private:
    void record(std::string_view line) {
        if (m_isInSurface && m_surface.record(line)) {
            return;
        }
        const std::string_view word = line.substr(0, line.find_first_of(" \t;="));
        const std::string_view rest = line.substr(word.size());
        if (word == "ZONE") {
            zone(rest);
        } else if (word == "LYR") {
            layers(rest);
        } else if (word == "S") {
            beginOutline();
        } else if (word == "SE") {
            endOutline();
        } else if (!readUnit(line, m_at.nm) && word != "F" && word != "ID") {
            report("a record of an unknown kind was left out");
        }
    }

    void zone(std::string_view rest) {
        endOutline();
        ZoneRecord zone;
        zone.name = toUtf8(trimmed(rest.substr(0, rest.find(';'))));
        zone.line = m_at.line;
        m_file.zones.push_back(std::move(zone));
    }

    void layers(std::string_view rest) {
        if (m_file.zones.empty()) {
            return report("LYR: there is no zone that it could belong to");
        }
        Fields fields(rest);
        for (std::string_view word = fields.optionalWord(); !word.empty(); word = fields.optionalWord()) {
            m_file.zones.back().layers.push_back(toUtf8(word));
        }
    }

    void beginOutline() {
        endOutline();
        if (m_file.zones.empty()) {
            return report("S: there is no zone that the outline could belong to");
        }
        m_surface.beginSurface();
        m_isInSurface = true;
    }

    /// The outline is also complete where SE is missing.
    void endOutline() {
        if (!m_isInSurface) {
            return;
        }
        m_isInSurface = false;
        const ShapeId outline{std::size_t{m_surface.endSurface()}};
        ZoneRecord& zone = m_file.zones.back();
        if (zone.outline.isValid()) {
            report("a zone with two outlines; the first one is used");
        } else if (m_file.outlines.shapes[outline.row()].contourCount > 0) {
            zone.outline = outline;
        }
    }

    void report(std::string_view text) { m_at.report(Severity::Warning, text); }

    FileCursor m_at;
    ZoneFile m_file;
    SurfaceParser m_surface;
    bool m_isInSurface = false;  ///< between S and SE
};

}  // namespace

ZoneFile parseZones(std::string_view text, std::string_view path, Unit defaultUnit, Diagnostics& diagnostics) {
    return ZoneParser(path, defaultUnit, diagnostics).parse(text);
}

}  // namespace model::odb
