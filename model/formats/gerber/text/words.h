#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "model/base/ascii.h"
#include "model/base/point.h"

/// Small helpers for the texts of a Gerber job: its files come in many dialects, but all are lines of ASCII.
namespace model::gerber {

[[nodiscard]] std::string_view trimmed(std::string_view text);
/// A whole text as a number, blanks around it and a leading + allowed; nothing when anything else is in it or it is not
/// finite.
[[nodiscard]] std::optional<double> parseReal(std::string_view text);
[[nodiscard]] std::optional<int> parseInteger(std::string_view text);
/// The number that a text begins with, which is taken off it.
[[nodiscard]] std::optional<double> takeReal(std::string_view& text);
/// The parts between separators, blanks around them gone; a text without separators is one part.
[[nodiscard]] std::vector<std::string_view> split(std::string_view text, char separator);
/// Does the text hold the words, in any case?
[[nodiscard]] bool holds(std::string_view text, std::string_view words);
using base::equalsIgnoringCase;
using base::upperCase;
/// A length as nanometres; nothing outside ±kMaxCoordinate.
[[nodiscard]] std::optional<base::Nm> toNm(double nanometres);
/// A short form for names: "0.65".
[[nodiscard]] std::string shortNumber(double value);

/// Takes a text apart line by line: LF, CRLF or CR, numbered from 1.
class Lines {
public:
    explicit Lines(std::string_view text) : m_rest(text) {}

    /// Moves to the next line. False at the end.
    bool next();
    [[nodiscard]] std::string_view line() const { return m_line; }
    [[nodiscard]] std::uint32_t number() const { return m_number; }

private:
    std::string_view m_rest;
    std::string_view m_line;
    std::uint32_t m_number = 0;
};

}  // namespace model::gerber
