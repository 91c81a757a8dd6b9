#include "model/formats/odb/features/features.h"

#include <optional>

#include "model/formats/odb/features/surface_parser.h"
#include "model/formats/odb/text/records.h"

namespace model::odb {

namespace {

/// Numbers in `$n` and `@n` lines may skip, but a table of a million is no table.
constexpr std::int32_t kMaxTableNumber = 1'000'000;

class FeatureParser {
public:
    FeatureParser(std::string_view path, Unit defaultUnit, Diagnostics& diagnostics)
        : m_path(path), m_diagnostics(diagnostics), m_surface(m_file.surfaces, path, diagnostics) {
        setUnit(defaultUnit);
    }

    FeatureFile parse(std::string_view text) {
        // Short records are about 30 bytes; too much reserve is given back with the file.
        m_file.features.reserve(text.size() / 40);
        LineReader lines(text);
        while (lines.next()) {
            m_line = lines.number();
            record(lines.line());
        }
        finish();
        return std::move(m_file);
    }

private:
    void record(std::string_view line) {
        if (m_isInSurface) {
            return surfaceRecord(line);
        }
        const bool isShort = line.size() == 1 || line[1] == ' ' || line[1] == '\t';
        switch (line[0]) {
            case '$': return symbolEntry(line);
            case '@':
            case '&': return attributeEntry(line);
            case 'L': return isShort ? trackRecord(line, FeatureKind::Line) : otherRecord(line);
            case 'A': return isShort ? trackRecord(line, FeatureKind::Arc) : otherRecord(line);
            case 'P': return isShort ? padRecord(line) : otherRecord(line);
            case 'S': return isShort ? beginSurface(line) : otherRecord(line);
            case 'T': return isShort ? textRecord(line) : otherRecord(line);
            case 'B': return isShort ? barcodeRecord(line) : otherRecord(line);
            case 'F': return countRecord(line);
            case 'U': return unitRecord(line);
            default: return otherRecord(line);
        }
    }

    void setUnit(Unit unit) {
        m_file.unit = unit;
        m_nm = coordinateNm(unit);
    }

    void unitRecord(std::string_view line) {
        const std::size_t start = line.starts_with("UNITS") ? line.find('=') : 0;
        if (start == std::string_view::npos || (start == 0 && line.size() > 1 && line[1] != ' ')) {
            return otherRecord(line);
        }
        const std::string_view name = trimmed(line.substr(start + 1));
        const std::optional<Unit> unit = parseUnit(name);
        if (unit) {
            setUnit(*unit);
        } else if (!name.empty()) {
            report(Severity::Error, "the unit is neither MM nor INCH; the job's default unit is used");
        }
    }

    void countRecord(std::string_view line) {
        const std::optional<std::int32_t> count = parseInteger(trimmed(line.substr(1)));
        if (!count) {
            return otherRecord(line);
        }
        m_expected = *count;
        m_expectedLine = m_line;
    }

    void otherRecord(std::string_view line) {
        if (!line.starts_with("ID=")) {
            report(Severity::Warning, "unknown kind of record; it was left out");
        }
    }

    void symbolEntry(std::string_view line) {
        Fields fields(line.substr(1));
        const std::int32_t number = fields.integer();
        const std::string_view name = fields.word();
        const std::string_view unit = fields.optionalWord();
        if (fields.failed() || number < 0 || number > kMaxTableNumber) {
            return report(Severity::Error, "the symbol line is not '$number name'; it was left out");
        }
        const Unit ownUnit = unit == "I" ? Unit::Inch : unit == "M" ? Unit::Millimetre : m_file.unit;
        const auto slot = static_cast<std::size_t>(number);
        if (m_symbolOfNumber.size() <= slot) {
            m_symbolOfNumber.resize(slot + 1, kNone);
        }
        m_symbolOfNumber[slot] = static_cast<std::uint32_t>(m_file.symbols.size());
        m_file.symbols.push_back({toUtf8(name), ownUnit, 0});
    }

    void attributeEntry(std::string_view line) {
        if (!m_attributes.tableLine(line)) {
            report(Severity::Warning, "the attribute line is not '@number name' or '&number text'; it was left out");
        }
    }

    void takeAttributes(const Fields& fields, Feature& feature) {
        feature.attributes = m_attributes.set(fields.tail());
        feature.plating = m_attributes.plating(feature.attributes);
    }

    std::uint32_t symbolRow(Fields& fields) {
        const std::int32_t number = fields.integer();
        const auto slot = static_cast<std::size_t>(number);
        if (number < 0 || slot >= m_symbolOfNumber.size() || m_symbolOfNumber[slot] == kNone) {
            m_hasBadSymbol = !fields.failed();
            return kNone;
        }
        return m_symbolOfNumber[slot];
    }

    /// P or N.
    static bool readNegative(Fields& fields, bool& isValid) {
        const std::string_view letter = fields.word();
        isValid = letter == "P" || letter == "N";
        return letter == "N";
    }

    /// Every record with an ordinal ends here, readable or not.
    void addFeature(Feature feature, bool isGood) {
        feature.line = m_line;
        if (!isGood) {
            feature.kind = FeatureKind::Bad;
            report(Severity::Error, m_hasBadSymbol
                                        ? "the record uses a symbol number that the file does not list; it was left out"
                                        : "the record is incomplete or holds an unreadable number; it was left out");
        }
        m_hasBadSymbol = false;
        m_file.hasNegatives = m_file.hasNegatives || (isGood && feature.isNegative);
        m_file.features.push_back(feature);
    }

    void trackRecord(std::string_view line, FeatureKind kind) {
        Fields fields(line.substr(1));
        Feature feature;
        bool isValid = false;
        feature.kind = kind;
        feature.a = fields.point(m_nm);
        feature.b = fields.point(m_nm);
        feature.centre = kind == FeatureKind::Arc ? fields.point(m_nm) : Point{};
        feature.index = symbolRow(fields);
        feature.isNegative = readNegative(fields, isValid);
        if (kind == FeatureKind::Arc) {
            fields.optionalWord();  // dcode
            const std::string_view clockwise = fields.word();
            feature.isClockwise = clockwise == "Y" || clockwise == "y";
        }
        takeAttributes(fields, feature);
        addFeature(feature, isValid && !fields.failed() && feature.index != kNone);
    }

    void padRecord(std::string_view line) {
        Fields fields(line.substr(1));
        Feature feature;
        bool isValid = false;
        feature.kind = FeatureKind::Pad;
        feature.a = fields.point(m_nm);
        Fields ahead = fields;
        const bool isResized = ahead.integer() == -1;
        fields = isResized ? ahead : fields;
        feature.index = symbolRow(fields);
        if (isResized && feature.index != kNone) {
            feature.index = resizedSymbol(feature.index, fields.length(symbolNm(m_file.unit)));
        }
        feature.isNegative = readNegative(fields, isValid);
        fields.optionalWord();  // dcode
        const Orientation orientation = readOrientation(fields);
        feature.clockwiseDeg = orientation.clockwiseDeg;
        feature.isMirrored = orientation.isMirrored;
        takeAttributes(fields, feature);
        addFeature(feature, isValid && !fields.failed() && feature.index != kNone);
    }

    std::uint32_t resizedSymbol(std::uint32_t row, Nm resize) {
        SymbolRef resized = m_file.symbols[row];
        resized.resize = resize;
        for (std::size_t i = 0; i < m_file.symbols.size(); ++i) {
            if (m_file.symbols[i] == resized) {
                return static_cast<std::uint32_t>(i);
            }
        }
        m_file.symbols.push_back(std::move(resized));
        return static_cast<std::uint32_t>(m_file.symbols.size() - 1);
    }

    void textRecord(std::string_view line) {
        Fields fields(line.substr(1));
        Feature feature = placedRecord(fields, FeatureKind::Text);
        const std::string_view font = fields.word();
        const bool isValid = polarityAndOrientation(fields, feature);
        feature.index = static_cast<std::uint32_t>(m_file.texts.size());
        m_file.texts.push_back(readText(fields, m_nm, font));
        takeAttributes(fields, feature);
        addFeature(feature, isValid && !fields.failed());
    }

    void barcodeRecord(std::string_view line) {
        Fields fields(line.substr(1));
        Feature feature = placedRecord(fields, FeatureKind::Barcode);
        const std::string_view code = fields.word();
        const std::string_view font = fields.word();
        const bool isValid = polarityAndOrientation(fields, feature);
        feature.index = static_cast<std::uint32_t>(m_file.barcodes.size());
        m_file.barcodes.push_back(readBarcode(fields, m_nm, code, font));
        takeAttributes(fields, feature);
        addFeature(feature, isValid && !fields.failed());
    }

    Feature placedRecord(Fields& fields, FeatureKind kind) const {
        Feature feature;
        feature.kind = kind;
        feature.a = feature.b = fields.point(m_nm);
        return feature;
    }

    static bool polarityAndOrientation(Fields& fields, Feature& feature) {
        bool isValid = false;
        feature.isNegative = readNegative(fields, isValid);
        const Orientation orientation = readOrientation(fields);
        feature.clockwiseDeg = orientation.clockwiseDeg;
        feature.isMirrored = orientation.isMirrored;
        return isValid;
    }

    void beginSurface(std::string_view line) {
        Fields fields(line.substr(1));
        bool isValid = false;
        m_pending = {};
        m_pending.kind = FeatureKind::Surface;
        m_pending.isNegative = readNegative(fields, isValid);
        takeAttributes(fields, m_pending);
        m_isPendingGood = isValid;
        m_pendingLine = m_line;
        m_isInSurface = true;
        m_surface.beginSurface(m_line);
    }

    void surfaceRecord(std::string_view line) {
        if (m_surface.record(line, m_line, m_nm)) {
            return;
        }
        if (line.starts_with("SE")) {
            return endSurface();
        }
        report(Severity::Warning, "a surface is not ended by SE");
        const std::uint32_t number = m_line;
        endSurface();
        m_line = number;
        record(line);
    }

    void endSurface() {
        m_pending.index = m_surface.endSurface(m_line);
        m_file.surfaceEnds.push_back(m_line);
        m_isInSurface = false;
        m_line = m_pendingLine;
        addFeature(m_pending, m_isPendingGood);
    }

    void finish() {
        if (m_isInSurface) {
            report(Severity::Warning, "the file ends inside a surface");
            endSurface();
        }
        if (m_expected >= 0 && static_cast<std::size_t>(m_expected) != m_file.features.size()) {
            m_line = m_expectedLine;
            report(Severity::Warning, "the file holds " + std::to_string(m_file.features.size()) +
                                          " features, its F line says " + std::to_string(m_expected));
        }
        m_file.features.shrink_to_fit();
    }

    void report(Severity severity, std::string_view text) { m_diagnostics.report(severity, m_path, m_line, text); }

    static constexpr std::uint32_t kNone = 0xffffffffU;

    FeatureFile m_file;
    AttributeCollector m_attributes{m_file.attributes};
    std::string_view m_path;
    Diagnostics& m_diagnostics;
    SurfaceParser m_surface;
    std::int64_t m_nm = 0;
    std::uint32_t m_line = 0;
    std::vector<std::uint32_t> m_symbolOfNumber;
    Feature m_pending;
    std::uint32_t m_pendingLine = 0;
    std::int32_t m_expected = -1;
    std::uint32_t m_expectedLine = 0;
    bool m_isPendingGood = false;
    bool m_isInSurface = false;
    bool m_hasBadSymbol = false;
};

}  // namespace

std::optional<ShapeSketch> profileOf(const FeatureFile& file) {
    ShapeSketch all;
    for (const Feature& feature : file.features) {
        if (feature.kind == FeatureKind::Surface) {
            all.append(file.surfaces, ShapeId{std::size_t{feature.index}}, {});
        }
    }
    return all.isEmpty() ? std::nullopt : std::optional(std::move(all));
}

FeatureFile parseFeatures(std::string_view text, std::string_view path, Unit defaultUnit, Diagnostics& diagnostics) {
    return FeatureParser(path, defaultUnit, diagnostics).parse(text);
}

}  // namespace model::odb
