#include "model/formats/odb/text/records.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>

#include "model/base/ascii.h"
#include "model/text/utf8.h"

namespace model::odb {

namespace {

constexpr bool isSpaceOrTab(char c) {
    return c == ' ' || c == '\t';
}

constexpr bool endsField(char c) {
    return isSpaceOrTab(c) || c == ';';
}

constexpr std::array<std::int64_t, 13> kPowersOfTen = {
    1,          10,          100,           1'000,          10'000,          100'000,          1'000'000,
    10'000'000, 100'000'000, 1'000'000'000, 10'000'000'000, 100'000'000'000, 1'000'000'000'000};

/// Largest mantissa whose product with 25,400,000 nm per inch still fits into 63 bits (9.2e18 / 2.54e7 = 3.6e11).
constexpr std::int64_t kMaxMantissa = 360'000'000'000;

/// A decimal number as written: mantissa / 10^decimals.
struct Decimal {
    std::int64_t mantissa = 0;
    int decimals = 0;
    bool isNegative = false;
    bool isPlain = false;  ///< no exponent, not too long, at least one digit
};

/// Reads digits with at most one point from `at`, which is moved behind them.
Decimal scanDecimal(const char*& at, const char* end) {
    Decimal d;
    d.isNegative = at != end && *at == '-';
    at += (at != end && (*at == '-' || *at == '+')) ? 1 : 0;
    const char* const first = at;
    for (; at != end && base::isDigit(*at) && d.mantissa < kMaxMantissa; ++at) {
        d.mantissa = d.mantissa * 10 + (*at - '0');
    }
    std::ptrdiff_t digits = at - first;
    if (at != end && *at == '.') {
        const char* const point = ++at;
        for (; at != end && base::isDigit(*at) && d.mantissa < kMaxMantissa; ++at) {
            d.mantissa = d.mantissa * 10 + (*at - '0');
        }
        d.decimals = static_cast<int>(at - point);
        digits += d.decimals;
    }
    d.isPlain = digits > 0 && d.mantissa < kMaxMantissa && d.decimals < static_cast<int>(kPowersOfTen.size()) &&
                (at == end || endsField(*at));
    return d;
}

std::int64_t scaled(const Decimal& d, std::int64_t nmPerUnit) {
    const std::int64_t divisor = kPowersOfTen[static_cast<std::size_t>(d.decimals)];
    const std::int64_t rounded = (d.mantissa * nmPerUnit + divisor / 2) / divisor;
    return d.isNegative ? -rounded : rounded;
}

template <class Number>
std::optional<Number> parseNumber(std::string_view text) {
    text = text.starts_with('+') ? text.substr(1) : text;
    Number value{};
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    return error == std::errc() && end == text.data() + text.size() ? std::optional(value) : std::nullopt;
}

}  // namespace

bool LineReader::next() {
    while (!m_rest.empty()) {
        const std::size_t length = std::min(m_rest.find('\n'), m_rest.size());
        m_line = m_rest.substr(0, length);
        m_rest.remove_prefix(std::min(length + 1, m_rest.size()));
        ++m_number;
        if (m_line.ends_with('\r')) {
            m_line.remove_suffix(1);
        }
        while (!m_line.empty() && isSpaceOrTab(m_line.front())) {
            m_line.remove_prefix(1);
        }
        if (!m_line.empty() && m_line.front() != '#') {
            return true;
        }
    }
    return false;
}

void Fields::skipBlanks() {
    while (m_at != m_end && isSpaceOrTab(*m_at)) {
        ++m_at;
    }
}

bool Fields::atEnd() {
    skipBlanks();
    return m_at == m_end || *m_at == ';';
}

std::string_view Fields::optionalWord() {
    skipBlanks();
    const char* const start = m_at;
    while (m_at != m_end && !endsField(*m_at)) {
        ++m_at;
    }
    return {start, static_cast<std::size_t>(m_at - start)};
}

std::string_view Fields::word() {
    const std::string_view found = optionalWord();
    m_failed = m_failed || found.empty();
    return found;
}

base::Nm Fields::length(std::int64_t nmPerUnit) {
    skipBlanks();
    const char* const start = m_at;
    const Decimal decimal = scanDecimal(m_at, m_end);
    if (decimal.isPlain) {
        const std::int64_t nm = scaled(decimal, nmPerUnit);
        m_failed = m_failed || nm > base::kMaxCoordinate || nm < -base::kMaxCoordinate;
        return m_failed ? 0 : static_cast<base::Nm>(nm);
    }
    m_at = start;
    const std::optional<double> value = parseReal(word());
    const std::optional<base::Nm> nm = value ? toLength(*value, nmPerUnit) : std::nullopt;
    m_failed = m_failed || !nm;
    return nm.value_or(0);
}

base::Point Fields::point(std::int64_t nmPerUnit) {
    const base::Nm x = length(nmPerUnit);
    return {x, length(nmPerUnit)};
}

std::int32_t Fields::integer() {
    const std::optional<std::int32_t> value = parseInteger(word());
    m_failed = m_failed || !value;
    return value.value_or(0);
}

double Fields::real() {
    const std::optional<double> value = parseReal(word());
    m_failed = m_failed || !value;
    return value.value_or(0.0);
}

std::string_view Fields::quoted() {
    skipBlanks();
    if (m_at == m_end || *m_at != '\'') {
        m_failed = true;
        return {};
    }
    const char* const start = ++m_at;
    for (const char* at = start; at != m_end; ++at) {
        const char* behind = at + 1;
        while (*at == '\'' && behind != m_end && (isSpaceOrTab(*behind) || base::isDigit(*behind))) {
            ++behind;
        }
        if (*at == '\'' && (behind == m_end || *behind == ';')) {
            m_at = at + 1;
            return {start, static_cast<std::size_t>(at - start)};
        }
    }
    m_failed = true;
    return {};
}

std::string_view Fields::tail() const {
    const std::size_t mark = std::min(rest().find(';'), rest().size());
    return rest().substr(std::min(mark + 1, rest().size()));
}

std::optional<Unit> parseUnit(std::string_view text) {
    if (equalsIgnoringCase(text, "MM")) {
        return Unit::Millimetre;
    }
    return equalsIgnoringCase(text, "INCH") ? std::optional(Unit::Inch) : std::nullopt;
}

bool readUnit(std::string_view line, std::int64_t& nmPerUnit) {
    if (!line.starts_with("UNITS") && !line.starts_with("U ")) {
        return false;
    }
    const std::size_t equals = line.find('=');
    const auto unit = parseUnit(trimmed(line.substr(equals == std::string_view::npos ? 1 : equals + 1)));
    nmPerUnit = unit ? coordinateNm(*unit) : nmPerUnit;
    return true;
}

std::string_view trimmed(std::string_view text) {
    const std::size_t first = text.find_first_not_of(" \t\r\n");
    if (first == std::string_view::npos) {
        return {};
    }
    return text.substr(first, text.find_last_not_of(" \t\r\n") - first + 1);
}

std::optional<double> parseReal(std::string_view text) {
    const std::optional<double> value = parseNumber<double>(text);
    return value && std::isfinite(*value) ? value : std::nullopt;
}

std::optional<std::int32_t> parseInteger(std::string_view text) {
    return parseNumber<std::int32_t>(text);
}

std::optional<base::Nm> toLength(double value, std::int64_t nmPerUnit) {
    const double nm = value * static_cast<double>(nmPerUnit);
    if (!(std::abs(nm) <= static_cast<double>(base::kMaxCoordinate))) {
        return std::nullopt;
    }
    return static_cast<base::Nm>(std::llround(nm));
}

std::string toUtf8(std::string_view bytes) {
    std::string text;
    text.reserve(bytes.size());
    while (!bytes.empty()) {
        moveCharacter(bytes, text);
    }
    return text;
}

}  // namespace model::odb
