#pragma once

#include <cstdint>
#include <string_view>

namespace model::paper {

/// Cuts the text into tokens at blanks, commas and line ends; '#' starts a comment. Views into the text, no copies.
class Lexer {
public:
    explicit Lexer(std::string_view text) : m_text(text) {}

    /// The next token, empty at the end.
    std::string_view next();
    /// The next token without taking it.
    std::string_view peek();
    /// The rest of the current line without a leading comma: layer types are names that no token rule fits.
    std::string_view restOfLine();
    /// 1-based line of the token last returned by `next` or `restOfLine`.
    [[nodiscard]] std::uint32_t line() const { return m_line; }
    [[nodiscard]] float fractionRead() const;

private:
    void skipSeparators();

    std::string_view m_text;
    std::size_t m_at = 0;
    std::uint32_t m_lineAt = 1;  ///< line of m_at
    std::uint32_t m_line = 1;
};

}  // namespace model::paper
