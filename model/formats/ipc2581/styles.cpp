#include "model/formats/ipc2581/styles.h"

#include <algorithm>
#include <cmath>

#include "model/formats/ipc2581/xml/xml_values.h"

namespace model::ipc2581 {

Dictionaries::Dictionaries(Reading& reading) : m_reading(reading) {
    double unitNm = base::kNmPerMm;
    for (const XmlSection& section : reading.outline().sections) {
        if (section.name.starts_with("Dictionary")) {
            XmlCursor at = reading.at(section);
            at.next();
            const std::string_view units = at.value("units");
            const double named = unitNamed(units);
            if (named == 0.0 && (!units.empty() || section.name != "DictionaryColor")) {
                reading.report(Severity::Warning, section.line,
                               "the dictionary names no units that are known; millimetres are used");
            }
            unitNm = named > 0.0 ? named : base::kNmPerMm;
        } else if (section.name.starts_with("Entry")) {
            readEntry(section, unitNm);
        }
    }
}

void Dictionaries::readEntry(const XmlSection& section, double unitNm) {
    XmlCursor at = m_reading.at(section);
    at.next();
    const std::string_view id = at.value("id");
    if (section.name == "EntryStandard" || section.name == "EntryUser") {
        Table<DictionaryEntry>& table = section.name == "EntryUser" ? m_user : m_standard;
        if (!table.try_emplace(id, DictionaryEntry{section, unitNm}).second) {
            m_reading.report(Severity::Warning, section.line,
                             "a dictionary has two entries of one id; the first one is used");
        }
    } else if (section.name == "EntryLineDesc") {
        forEachChild(at, [&] { m_lines.try_emplace(id, lineStyle(at, unitNm)); });
    } else if (section.name == "EntryFillDesc") {
        forEachChild(at, [&] { m_fills.try_emplace(id, fillStyle(at, unitNm)); });
    } else if (section.name == "EntryFont") {
        m_reading.report(Severity::Info, section.line,
                         "fonts of the file are not read; a plain font stands in for them");
    }
}

namespace {

constexpr std::string_view kFillProperties[] = {"FILL", "HOLLOW", "HATCH", "MESH", "VOID"};

LineProperty propertyNamed(std::string_view name) {
    return name.empty() || name == "SOLID" ? LineProperty::Solid
           : name == "ERASE"               ? LineProperty::Erasing
                                           : LineProperty::Broken;
}

}  // namespace

LineStyle Dictionaries::lineStyle(const XmlCursor& at, double unitNm) const {
    LineStyle style;
    style.width = std::abs(m_reading.lengthOr(at, "lineWidth", unitNm, 0.0));
    const std::string_view end = at.value("lineEnd");
    style.end = end == "SQUARE" ? LineEnd::Square : end == "NONE" ? LineEnd::None : LineEnd::Round;
    style.property = propertyNamed(at.value("lineProperty"));
    return style;
}

FillStyle Dictionaries::fillStyle(const XmlCursor& at, double unitNm) const {
    const std::string_view kind = at.value("fillProperty");
    FillStyle style;
    if (!kind.empty() && std::ranges::find(kFillProperties, kind) == std::end(kFillProperties)) {
        m_reading.report(Severity::Warning, at.line(), "a fillProperty that is not known; the shape is filled");
    }
    style.kind = kind == "HOLLOW"                    ? FillKind::Hollow
                 : kind == "HATCH" || kind == "MESH" ? FillKind::Hatch
                 : kind == "VOID"                    ? FillKind::Void
                                                     : FillKind::Fill;
    style.lineWidth = std::abs(m_reading.lengthOr(at, "lineWidth", unitNm, 0.0));
    style.pitch1 = std::abs(m_reading.lengthOr(at, "pitch1", unitNm, 0.0));
    style.pitch2 = std::abs(m_reading.lengthOr(at, "pitch2", unitNm, kind == "MESH" ? style.pitch1 : 0.0));
    style.angle1 = m_reading.lengthOr(at, "angle1", 1.0, 0.0);
    style.angle2 = m_reading.lengthOr(at, "angle2", 1.0, style.angle1 + 90.0);
    return style;
}

template <class Value>
void Dictionaries::refer(const Table<Value>& table, const XmlCursor& at, Value& value) const {
    if (const Value* const found = find(table, at.value("id"))) {
        value = *found;
    } else {
        m_reading.report(Severity::Warning, at.line(),
                         "a " + std::string(at.name()) + " refers to an entry that no dictionary has");
    }
}

bool Dictionaries::readStyle(const XmlCursor& at, double unitNm, LineStyle& line, FillStyle& fill) const {
    const std::string_view name = at.name();
    if (name == "LineDesc") {
        line = lineStyle(at, unitNm);
    } else if (name == "FillDesc") {
        fill = fillStyle(at, unitNm);
    } else if (name == "LineDescRef") {
        refer(m_lines, at, line);
    } else if (name == "FillDescRef") {
        refer(m_fills, at, fill);
    } else {
        return name.starts_with("Color");
    }
    return true;
}

}  // namespace model::ipc2581
