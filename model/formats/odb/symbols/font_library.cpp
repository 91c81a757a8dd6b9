#include "model/formats/odb/symbols/font_library.h"

#include <algorithm>
#include <cmath>

#include "model/formats/common/text_layout.h"
#include "model/formats/odb/text/records.h"

namespace model::odb {

namespace {

class FontParser {
public:
    FontParser(std::string_view path, Diagnostics& diagnostics) : m_at{path, diagnostics} {}

    formats::Font parse(std::string_view text) {
        m_at.forEachLine(text, [this](std::string_view line) { record(line); });
        if (!(m_xSize > 0.0 && m_ySize > 0.0)) {
            report("XSIZE and YSIZE must be above zero; the font is not used");
            return {};
        }
        m_font.setSize(m_xSize, m_ySize, m_offset);
        return std::move(m_font);
    }

private:
    void record(std::string_view line) {
        Fields fields(line);
        const std::string_view key = fields.word();
        if (key == "LINE") {
            return stroke(fields);
        }
        if (key == "CHAR") {
            return character(line.substr(4));
        }
        double* const number = key == "XSIZE"    ? &m_xSize
                               : key == "YSIZE"  ? &m_ySize
                               : key == "OFFSET" ? &m_offset
                                                 : nullptr;
        if (number != nullptr) {
            *number = fields.real();
        }
        if (number == nullptr && key != "ECHAR" && !key.starts_with("UNITS")) {
            report("unknown kind of record in a font; it was left out");
        }
    }

    /// `CHAR ;` and `CHAR  ` name characters that are no fields.
    void character(std::string_view rest) {
        const std::u32string name = formats::codePoints(toUtf8(rest.size() > 1 ? rest.substr(1) : rest));
        m_isKnown = !name.empty();
        m_character = m_isKnown ? name[0] : U' ';
        m_font.addCharacter(m_character);
    }

    void stroke(Fields& fields) {
        formats::FontStroke stroke;
        for (double* value : {&stroke.a.x, &stroke.a.y, &stroke.b.x, &stroke.b.y}) {
            *value = fields.real();
        }
        stroke.isNegative = fields.word() == "N";
        stroke.isSquare = fields.word() == "S";
        stroke.width = fields.real();
        if (fields.failed() || !m_isKnown) {
            return report("a stroke of a character cannot be read; it was left out");
        }
        constexpr double kLargest = 10.0;  // fonts are 0.3 tall
        if (std::max({std::abs(stroke.a.x), std::abs(stroke.a.y), std::abs(stroke.b.x), std::abs(stroke.b.y)}) >
            kLargest) {
            return report("a stroke of a character is far too large; it was left out");
        }
        m_font.addStroke(m_character, stroke);
    }

    void report(std::string_view text) { m_at.report(Severity::Warning, text); }

    formats::Font m_font;
    FileCursor m_at;
    char32_t m_character = 0;
    bool m_isKnown = false;
    double m_xSize = 0.0;
    double m_ySize = 0.0;
    double m_offset = 0.0;
};

}  // namespace

formats::Font parseFont(std::string_view text, std::string_view path, Diagnostics& diagnostics) {
    return FontParser(path, diagnostics).parse(text);
}

const formats::Font& FontLibrary::font(const std::string& name, std::string_view path, std::uint32_t line) {
    const auto [location, isNew] = m_fonts.try_emplace(name);
    if (isNew) {
        if (const auto file = m_job.read("fonts/" + name, m_diagnostics)) {
            location->second = parseFont(file->text(), file->path, m_diagnostics);
        }
    }
    if (!location->second.isEmpty()) {
        return location->second;
    }
    m_diagnostics.report(Severity::Warning, path, line,
                         "the job has no font " + name + "; a plain font stands in for it, so letters look different");
    return formats::standInFont();
}

}  // namespace model::odb
