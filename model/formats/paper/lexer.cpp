#include "model/formats/paper/lexer.h"

#include <algorithm>

namespace model::paper {

namespace {

bool isSeparator(char c) {
    return c == ' ' || c == '\t' || c == ',' || c == '\r' || c == '\n';
}

}  // namespace

void Lexer::skipSeparators() {
    while (m_at < m_text.size()) {
        const char c = m_text[m_at];
        if (c == '#') {
            m_at = std::min(m_text.find('\n', m_at), m_text.size());
        } else if (isSeparator(c)) {
            m_lineAt += c == '\n' ? 1U : 0U;
            ++m_at;
        } else {
            return;
        }
    }
}

std::string_view Lexer::next() {
    skipSeparators();
    m_line = m_lineAt;
    const std::size_t first = m_at;
    while (m_at < m_text.size() && !isSeparator(m_text[m_at]) && m_text[m_at] != '#') {
        ++m_at;
    }
    return m_text.substr(first, m_at - first);
}

std::string_view Lexer::peek() {
    const Lexer before = *this;
    const std::string_view token = next();
    *this = before;
    return token;
}

std::string_view Lexer::restOfLine() {
    m_line = m_lineAt;
    const std::size_t end = std::min(m_text.find('\n', m_at), m_text.size());
    std::string_view rest = m_text.substr(m_at, end - m_at);
    m_at = end;
    while (!rest.empty() && isSeparator(rest.front())) {
        rest.remove_prefix(1);
    }
    while (!rest.empty() && isSeparator(rest.back())) {
        rest.remove_suffix(1);
    }
    return rest;
}

float Lexer::fractionRead() const {
    return m_text.empty() ? 1.0F : static_cast<float>(m_at) / static_cast<float>(m_text.size());
}

}  // namespace model::paper
