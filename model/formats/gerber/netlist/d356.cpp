#include "model/formats/gerber/netlist/d356.h"

#include <cmath>
#include <map>
#include <optional>
#include <unordered_map>

#include "model/base/ascii.h"
#include "model/base/units.h"
#include "model/formats/gerber/text/words.h"

namespace model::gerber {

namespace {

constexpr double kInchUnit = base::kNmPerInch / 10'000;  ///< CUST 0 and CUST 2
constexpr double kMetricUnit = base::kNmPerMm / 1'000;   ///< CUST 1, SI
/// What begins an entry of the table of long names.
constexpr std::string_view kAlias = "NNAME";

bool isRecord(std::string_view line) {
    return line.size() >= 40 && (line[0] == '3' || line[0] == '0') && base::isDigit(line[1]) && line[2] == '7';
}

class Parser {
public:
    Parser(std::string_view path, Diagnostics& diagnostics) : m_path(path), m_diagnostics(diagnostics) {}

    D356 run(std::string_view text) {
        Lines lines(text);
        while (lines.next() && !m_isDone) {
            m_line = lines.number();
            record(lines.line());
        }
        if (!m_isDone) {
            report("the netlist ends without its last record (999): it may be cut off");
        }
        renameNumbered();
        return std::move(m_result);
    }

private:
    void report(std::string_view text) { m_diagnostics.report(Severity::Warning, m_path, m_line, text); }

    void record(std::string_view line) {
        if (trimmed(line).empty() || line[0] == '#') {
            return;
        }
        if (line[0] == 'C') {
            return comment(trimmed(line.substr(1)));
        }
        if (line[0] == 'P') {
            return parameter(line);
        }
        if (line.starts_with("999")) {
            m_isDone = true;
        } else if (isRecord(line)) {
            point(line);
        } else if (line.starts_with("378") || line.starts_with("379") || line.starts_with("389") ||
                   line.starts_with("078") || line.starts_with("079") || line.starts_with("089")) {
            return;  // conductors and the outline: the images draw them
        } else {
            report("a record of the netlist that cannot be read; it was left out");
        }
    }

    void parameter(std::string_view line) {
        if (holds(line, "UNITS")) {
            m_hasUnit = true;
            const bool isMetric = holds(line, "CUST 1") || line.find("SI") != std::string_view::npos;
            m_unit = isMetric ? kMetricUnit : kInchUnit;
        }
        const std::size_t at = line.find(kAlias);
        if (at != std::string_view::npos) {
            alias(line.substr(at), 0);
        }
    }

    /// Allegro: "NNAMEm0004 UNNAMED_3_CN8PA_I15_N3", where nets are called m0004, "Board Thickness(mils):  80.4".
    void comment(std::string_view text) {
        constexpr std::string_view kThickness = "Board Thickness(";
        if (text.starts_with(kAlias)) {
            alias(text, kAlias.size());
        } else if (text.starts_with(kThickness)) {
            thickness(text.substr(kThickness.size()));
        }
    }

    /// An entry of the table of long names; the first `prefix` characters of it are no part of the short name.
    void alias(std::string_view entry, std::size_t prefix) {
        const std::size_t blank = entry.find_first_of(" \t");
        if (blank != std::string_view::npos && blank > prefix) {
            m_aliases[std::string(entry.substr(prefix, blank - prefix))] = std::string(trimmed(entry.substr(blank)));
        }
    }

    /// Altium lists "NNAME1 I2S_DAC_LOOP_D0" and calls the net "1" in records. Where a record has "NNAME1" itself, "1"
    /// is a name like any other.
    void renameNumbered() {
        if (m_hasAliasInRecord) {
            return;
        }
        for (std::string& net : m_result.nets) {
            const auto alias = m_aliases.find(std::string(kAlias) + net);
            if (alias != m_aliases.end() && !m_rows.contains(alias->second)) {
                net = alias->second;
            }
        }
    }

    /// "mils):  80.400000", which is left alone in any other unit, and from a metre on.
    void thickness(std::string_view text) {
        constexpr std::string_view kMils = "mils):";
        const std::optional<double> mils =
            text.starts_with(kMils) ? parseReal(trimmed(text.substr(kMils.size()))) : std::nullopt;
        if (mils && *mils > 0 && *mils < 40'000) {
            m_result.boardNm = *mils * base::kNmPerInch / 1'000;
            m_result.boardLine = m_line;
        }
    }

    static std::string_view field(std::string_view line, std::size_t column, std::size_t length) {
        return column <= line.size() ? trimmed(line.substr(column - 1, length)) : std::string_view();
    }

    /// A letter in this column or near it, with digits behind it: some programs write a column more or less.
    std::optional<double> number(std::string_view line, char letter, std::size_t column, std::size_t digits) const {
        const std::size_t from = column > 2 ? column - 2 : 0;
        const std::size_t at =
            from < line.size() ? line.substr(0, column + 1).find(letter, from) : std::string_view::npos;
        return at == std::string_view::npos ? std::nullopt : parseReal(line.substr(at + 1, digits));
    }

    std::int32_t netRow(std::string_view name) {
        if (name.empty() || name == "N/C") {
            return -1;
        }
        m_hasAliasInRecord |= name.starts_with(kAlias);
        const auto alias = m_aliases.find(name);
        const std::string full(alias == m_aliases.end() ? name : std::string_view(alias->second));
        const auto [found, isNew] = m_rows.try_emplace(full, static_cast<std::int32_t>(m_result.nets.size()));
        if (isNew) {
            m_result.nets.push_back(full);
        }
        return found->second;
    }

    void point(std::string_view line) {
        if (!m_hasUnit) {
            m_hasUnit = true;
            m_diagnostics.report(Severity::Info, m_path, m_line,
                                 "the netlist does not say its unit (P UNITS); taken as 0.0001 inch, the format's own");
        }
        D356Point point;
        point.line = m_line;
        const bool isContinued = line[0] == '0';
        if (isContinued && m_result.points.empty()) {
            return report("a continued record of the netlist without one before it; it was left out");
        }
        if (isContinued) {
            point = m_result.points.back();
            point.line = m_line;
        } else {
            point.net = netRow(field(line, 4, 14));
            point.refdes = field(line, 21, 6);
            point.pin = field(line, 28, 4);
            point.isEnd = line.size() < 32 || line[31] != 'M';
            point.isVia = point.refdes == "VIA";
        }
        const std::optional<double> x = number(line, 'X', 42, 7);
        const std::optional<double> y = number(line, 'Y', 50, 7);
        const auto nx = toNm(x.value_or(1e30) * m_unit);
        const auto ny = toNm(y.value_or(1e30) * m_unit);
        if (!nx || !ny) {
            return report("a record of the netlist without a place; it was left out");
        }
        point.position = {*nx, *ny};
        if (const std::optional<double> hole = number(line, 'D', 33, 4)) {
            point.hole = toNm(*hole * m_unit).value_or(0);
            point.isPlated = field(line, 38, 1) != "U" && line[1] != '6';
        }
        if (const std::optional<double> access = number(line, 'A', 39, 2)) {
            point.access = static_cast<int>(*access);
        }
        point.width = toNm(number(line, 'X', 58, 4).value_or(0.0) * m_unit).value_or(0);
        point.height = toNm(number(line, 'Y', 63, 4).value_or(0.0) * m_unit).value_or(0);
        point.exposure = exposure(line);
        m_result.points.push_back(std::move(point));
    }

    static Exposure exposure(std::string_view line) {
        const std::size_t at = line.size() > 70 ? line.find('S', 70) : std::string_view::npos;
        const char code = at == std::string_view::npos || at + 1 >= line.size() ? ' ' : line[at + 1];
        return code == '0'   ? Exposure::Exposed
               : code == '1' ? Exposure::CoveredOnTop
               : code == '2' ? Exposure::CoveredOnBottom
               : code == '3' ? Exposure::Covered
                             : Exposure::NotSaid;
    }

    std::string_view m_path;
    Diagnostics& m_diagnostics;
    D356 m_result;
    std::map<std::string, std::string, std::less<>> m_aliases;
    std::unordered_map<std::string, std::int32_t> m_rows;
    std::uint32_t m_line = 0;
    double m_unit = kInchUnit;
    bool m_hasUnit = false;
    bool m_hasAliasInRecord = false;
    bool m_isDone = false;
};

}  // namespace

bool looksLikeD356(std::string_view head) {
    Lines lines(head);
    int records = 0;
    while (lines.next()) {
        // Allegro fills lines with blanks, also those with nothing else on them, and lists the padstacks of a large
        // board in hundreds of comments before the first record.
        const std::string_view line = lines.line();
        if (trimmed(line).empty() || line[0] == 'C' || line[0] == 'P' || line[0] == '#') {
            if (line.starts_with("P") && holds(line, "UNITS") && (holds(line, "CUST") || holds(line, " SI"))) {
                return true;
            }
            continue;
        }
        const bool isOne = isRecord(line) && line.find('X', 38) != std::string_view::npos;
        if (!isOne) {
            return false;
        }
        if (++records == 3) {
            return true;
        }
    }
    return false;
}

D356 parseD356(std::string_view text, std::string_view path, Diagnostics& diagnostics) {
    return Parser(path, diagnostics).run(text);
}

}  // namespace model::gerber
