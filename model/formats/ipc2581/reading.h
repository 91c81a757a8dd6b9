#pragma once

#include <cstdint>
#include <set>
#include <string>
#include <string_view>

#include "model/board/diagnostics.h"
#include "model/formats/ipc2581/shapes/turn.h"
#include "model/formats/ipc2581/xml/xml_cursor.h"
#include "model/formats/ipc2581/xml/xml_outline.h"

namespace model::ipc2581 {

/// What the parts of the reader share about one file.
class Reading {
public:
    Reading(const XmlOutline& outline, std::string path, Diagnostics& diagnostics)
        : m_outline(outline), m_path(std::move(path)), m_diagnostics(diagnostics) {}

    [[nodiscard]] const XmlOutline& outline() const { return m_outline; }
    [[nodiscard]] const std::string& path() const { return m_path; }
    /// Nanometres per unit of the Ecad section (CadHeader). Dictionaries have units of their own.
    [[nodiscard]] double unitNm() const { return m_unitNm; }
    void setUnitNm(double nm) { m_unitNm = nm; }

    /// A cursor whose next tag is that of the section.
    [[nodiscard]] XmlCursor at(const XmlSection& section) const {
        return XmlCursor(m_outline.text, section.offset, section.line);
    }

    void report(Severity severity, std::uint32_t line, std::string_view text) {
        m_diagnostics.report(severity, m_path, line, text);
    }
    /// The element whose start tag was read last is of no kind that is known where it stands.
    void reportUnknown(const XmlCursor& at);

    /// A length or coordinate in nanometres; 0, which is reported, where it is missing or no number.
    double length(const XmlCursor& at, std::string_view attribute, double unitNm);
    /// The same where it may be missing.
    double lengthOr(const XmlCursor& at, std::string_view attribute, double unitNm, double otherwise);
    /// Attributes x and y.
    PointD point(const XmlCursor& at, double unitNm) { return {length(at, "x", unitNm), length(at, "y", unitNm)}; }

    /// To whole nanometres; what lies beyond the coordinate range is moved to its edge, which is reported.
    Point rounded(PointD p, std::uint32_t line);

private:
    const XmlOutline& m_outline;
    std::string m_path;
    Diagnostics& m_diagnostics;
    double m_unitNm = base::kNmPerMm;
    std::set<std::string, std::less<>> m_unknown;  ///< names of elements that were reported
};

/// Nanometres per unit of that name: MILLIMETER, MICRON, INCH and what else writers call them; 0 if it is none.
[[nodiscard]] double unitNamed(std::string_view name);

/// Takes in an Xform (rotation, mirror, scale, offsets) or a Location. False if the element is neither.
bool readTurn(Reading& reading, const XmlCursor& at, double unitNm, Turn& turn);

}  // namespace model::ipc2581
