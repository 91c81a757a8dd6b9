#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "model/base/ascii.h"
#include "model/base/point.h"
#include "model/board/diagnostics.h"

namespace model::odb {

/// The unit of a file or of one symbol.
enum class Unit : std::uint8_t { Inch, Millimetre };

/// Nanometres per coordinate unit; whole numbers, so that lengths can be read exactly.
constexpr std::int64_t coordinateNm(Unit unit) {
    return unit == Unit::Inch ? 25'400'000 : 1'000'000;
}
/// Nanometres per symbol unit: symbols and tools are in thousandths, mil or µm (odb-notes, Units).
constexpr std::int64_t symbolNm(Unit unit) {
    return coordinateNm(unit) / 1000;
}

/// "MM" or "INCH" in any case; nothing for other texts, empty ones included.
[[nodiscard]] std::optional<Unit> parseUnit(std::string_view text);
/// Takes a line `UNITS=MM` or `U MM`; a unit that is neither changes nothing.
[[nodiscard]] bool readUnit(std::string_view line, std::int64_t& nmPerUnit);

/// Walks a text line by line: no copies, LF or CRLF, blank lines and `#` comments skipped. Lines are numbered from 1 as
/// an editor shows them.
class LineReader {
public:
    explicit LineReader(std::string_view text) : m_rest(text) {
        if (m_rest.starts_with("\xef\xbb\xbf")) {
            m_rest.remove_prefix(3);  // a byte order mark
        }
    }

    /// Moves to the next line that is neither empty nor a comment. False at the end.
    bool next();
    [[nodiscard]] std::string_view line() const { return m_line; }
    [[nodiscard]] std::uint32_t number() const { return m_number; }

private:
    std::string_view m_rest;
    std::string_view m_line;
    std::uint32_t m_number = 0;
};

/// Where a parser is in a file of records, and in which unit: what it reports carries file and line.
struct FileCursor {
    std::string_view path;
    Diagnostics& diagnostics;
    std::int64_t nm = 0;  ///< per unit of coordinates
    std::uint32_t line = 0;

    void report(Severity severity, std::string_view text) const { diagnostics.report(severity, path, line, text); }
    /// Calls `record(text)` for each line of LineReader, with `line` set.
    template <class Record>
    void forEachLine(std::string_view text, Record record) {
        LineReader lines(text);
        while (lines.next()) {
            line = lines.number();
            record(lines.line());
        }
    }
};

/// Takes a line record apart from left to right: fields separated by blanks, ending at the first `;` (attributes and ID
/// follow it). Every read that fails leaves `failed()` set, so a record is checked once at its end.
class Fields {
public:
    explicit Fields(std::string_view line) : m_at(line.data()), m_end(line.data() + line.size()) {}

    /// The next field; empty (and failed) when there is none.
    std::string_view word();
    /// Like `word`, but its absence is no failure.
    std::string_view optionalWord();
    /// A length in units of `nmPerUnit`, rounded to 1 nm exactly (half away from zero). Fails outside ±kMaxCoordinate.
    base::Nm length(std::int64_t nmPerUnit);
    base::Point point(std::int64_t nmPerUnit);
    std::int32_t integer();
    double real();

    /// A text in single quotes, which may hold quotes and `;` itself: it ends at the first quote behind which only a
    /// number, attributes or nothing follow.
    std::string_view quoted();

    [[nodiscard]] bool failed() const { return m_failed; }
    [[nodiscard]] bool atEnd();
    /// Everything from here to the end of the line, the part after `;` included.
    [[nodiscard]] std::string_view rest() const { return {m_at, static_cast<std::size_t>(m_end - m_at)}; }
    /// What follows the first `;`; empty if there is none.
    [[nodiscard]] std::string_view tail() const;

private:
    void skipBlanks();

    const char* m_at;
    const char* m_end;
    bool m_failed = false;
};

[[nodiscard]] std::string_view trimmed(std::string_view text);
/// A whole text as a number; nothing when anything else is in it or it is not finite.
[[nodiscard]] std::optional<double> parseReal(std::string_view text);
[[nodiscard]] std::optional<std::int32_t> parseInteger(std::string_view text);
/// A number of the job as nanometres; nothing outside ±kMaxCoordinate.
[[nodiscard]] std::optional<base::Nm> toLength(double value, std::int64_t nmPerUnit);
using base::equalsIgnoringCase;
/// UTF-8 text from bytes that are UTF-8 or else Latin-1 (odb-notes, Container).
[[nodiscard]] std::string toUtf8(std::string_view bytes);

}  // namespace model::odb
