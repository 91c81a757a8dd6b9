#include "model/formats/odb/features/features.h"

#include <optional>

#include "model/formats/odb/features/surface_parser.h"
#include "model/formats/odb/text/records.h"

namespace model::odb {

namespace {

/// Numbers in `$n` and `@n` lines may skip, but a table of a million is no table.
constexpr std::int32_t kMaxTableNumber = 1'000'000;

/// What follows the orientation; `font` has been read before it. Fails like any other field.
TextRecord readText(Fields& fields, std::int64_t nmPerUnit, std::string_view font) {
    TextRecord record;
    record.font = toUtf8(font);
    record.line.xSize = fields.length(nmPerUnit);
    record.line.ySize = fields.length(nmPerUnit);
    record.line.widthFactor = fields.real();
    record.line.text = toUtf8(fields.quoted());
    return record;
}

BarcodeRecord readBarcode(Fields& fields, std::int64_t nmPerUnit, std::string_view code, std::string_view font) {
    const auto flag = [&fields] {
        const std::string_view letter = fields.word();
        return letter == "Y" || letter == "y";
    };
    BarcodeRecord record;
    record.code = toUtf8(code);
    record.font = toUtf8(font);
    fields.word();  // E, a constant
    record.elementWidth = fields.length(nmPerUnit);
    record.height = fields.length(nmPerUnit);
    record.isFullAscii = flag();
    record.hasChecksum = flag();
    record.isInverted = flag();
    record.hasString = flag();
    const std::string_view location = fields.word();
    record.isStringAbove = location == "T" || location == "t";
    record.text = toUtf8(fields.quoted());
    return record;
}

class FeatureParser {
public:
    FeatureParser(std::string_view path, Unit defaultUnit, Diagnostics& diagnostics)
        : m_at{path, diagnostics}, m_surface(m_file.surfaces, m_at) {
        setUnit(defaultUnit);
    }

    FeatureFile parse(std::string_view text) {
        // Short records are about 30 bytes; too much reserve is given back with the file.
        m_file.features.reserve(text.size() / 40);
        m_at.forEachLine(text, [this](std::string_view line) { record(line); });
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
        m_at.nm = coordinateNm(unit);
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
            m_at.report(Severity::Error, "the unit is neither MM nor INCH; the job's default unit is used");
        }
    }

    void countRecord(std::string_view line) {
        const std::optional<std::int32_t> count = parseInteger(trimmed(line.substr(1)));
        if (!count) {
            return otherRecord(line);
        }
        m_expected = *count;
        m_expectedLine = m_at.line;
    }

    void otherRecord(std::string_view line) {
        if (!line.starts_with("ID=")) {
            m_at.report(Severity::Warning, "unknown kind of record; it was left out");
        }
    }

    void symbolEntry(std::string_view line) {
        Fields fields(line.substr(1));
        const std::int32_t number = fields.integer();
        const std::string_view name = fields.word();
        const std::string_view unit = fields.optionalWord();
        if (fields.failed() || number < 0 || number > kMaxTableNumber) {
            return m_at.report(Severity::Error, "the symbol line is not '$number name'; it was left out");
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
            m_at.report(Severity::Warning,
                        "the attribute line is not '@number name' or '&number text'; it was left out");
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

    /// P or N. False if it is neither.
    static bool readPolarity(Fields& fields, Feature& feature) {
        const std::string_view letter = fields.word();
        feature.isNegative = letter == "N";
        return letter == "P" || letter == "N";
    }

    /// How a pad, text or barcode lies, with the angle that follows codes 8 and 9 (odb-notes, Features).
    static void readOrientation(Fields& fields, Feature& feature) {
        if (fields.atEnd()) {
            return;  // old writers leave it away
        }
        const std::int32_t code = fields.integer();
        const bool hasAngle = code == 8 || code == 9;
        feature.clockwiseDeg = hasAngle ? fields.real() : static_cast<double>(code & 3) * 90.0;
        feature.isMirrored = hasAngle ? code == 9 : (code & 4) != 0;
    }

    /// Every record with an ordinal ends here, readable or not.
    void addFeature(Feature feature, bool isGood) {
        feature.line = m_at.line;
        if (!isGood) {
            feature.kind = FeatureKind::Bad;
            m_at.report(Severity::Error,
                        m_hasBadSymbol ? "the record uses a symbol number that the file does not list; it was left out"
                                       : "the record is incomplete or holds an unreadable number; it was left out");
        }
        m_hasBadSymbol = false;
        m_file.hasNegatives = m_file.hasNegatives || (isGood && feature.isNegative);
        m_file.features.push_back(feature);
    }

    void trackRecord(std::string_view line, FeatureKind kind) {
        Fields fields(line.substr(1));
        Feature feature;
        feature.kind = kind;
        feature.a = fields.point(m_at.nm);
        feature.b = fields.point(m_at.nm);
        feature.centre = kind == FeatureKind::Arc ? fields.point(m_at.nm) : Point{};
        feature.index = symbolRow(fields);
        const bool isValid = readPolarity(fields, feature);
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
        feature.kind = FeatureKind::Pad;
        feature.a = fields.point(m_at.nm);
        Fields ahead = fields;
        const bool isResized = ahead.integer() == -1;
        fields = isResized ? ahead : fields;
        feature.index = symbolRow(fields);
        if (isResized && feature.index != kNone) {
            feature.index = resizedSymbol(feature.index, fields.length(symbolNm(m_file.unit)));
        }
        const bool isValid = readPolarity(fields, feature);
        fields.optionalWord();  // dcode
        readOrientation(fields, feature);
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
        const bool isValid = readPolarity(fields, feature);
        readOrientation(fields, feature);
        feature.index = static_cast<std::uint32_t>(m_file.texts.size());
        m_file.texts.push_back(readText(fields, m_at.nm, font));
        takeAttributes(fields, feature);
        addFeature(feature, isValid && !fields.failed());
    }

    void barcodeRecord(std::string_view line) {
        Fields fields(line.substr(1));
        Feature feature = placedRecord(fields, FeatureKind::Barcode);
        const std::string_view code = fields.word();
        const std::string_view font = fields.word();
        const bool isValid = readPolarity(fields, feature);
        readOrientation(fields, feature);
        feature.index = static_cast<std::uint32_t>(m_file.barcodes.size());
        m_file.barcodes.push_back(readBarcode(fields, m_at.nm, code, font));
        takeAttributes(fields, feature);
        addFeature(feature, isValid && !fields.failed());
    }

    Feature placedRecord(Fields& fields, FeatureKind kind) const {
        Feature feature;
        feature.kind = kind;
        feature.a = feature.b = fields.point(m_at.nm);
        return feature;
    }

    void beginSurface(std::string_view line) {
        Fields fields(line.substr(1));
        m_pending = {};
        m_pending.kind = FeatureKind::Surface;
        m_isPendingGood = readPolarity(fields, m_pending);
        takeAttributes(fields, m_pending);
        m_pendingLine = m_at.line;
        m_isInSurface = true;
        m_surface.beginSurface();
    }

    void surfaceRecord(std::string_view line) {
        if (m_surface.record(line)) {
            return;
        }
        if (line.starts_with("SE")) {
            return endSurface();
        }
        m_at.report(Severity::Warning, "a surface is not ended by SE");
        const std::uint32_t number = m_at.line;
        endSurface();
        m_at.line = number;
        record(line);
    }

    void endSurface() {
        m_pending.index = m_surface.endSurface();
        m_file.surfaceEnds.push_back(m_at.line);
        m_isInSurface = false;
        m_at.line = m_pendingLine;
        addFeature(m_pending, m_isPendingGood);
    }

    void finish() {
        if (m_isInSurface) {
            m_at.report(Severity::Error, "the file ends inside a surface");
            endSurface();
        }
        if (m_expected >= 0 && static_cast<std::size_t>(m_expected) != m_file.features.size()) {
            m_at.line = m_expectedLine;
            m_at.report(Severity::Warning, "the file holds " + std::to_string(m_file.features.size()) +
                                               " features, its F line says " + std::to_string(m_expected));
        }
        m_file.features.shrink_to_fit();
    }

    static constexpr std::uint32_t kNone = 0xffffffffU;

    FeatureFile m_file;
    AttributeCollector m_attributes{m_file.attributes};
    FileCursor m_at;
    SurfaceParser m_surface;
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
