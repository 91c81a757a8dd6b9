#include "model/formats/ipc2581/xml/xml_cursor.h"

#include <algorithm>

#include "model/base/ascii.h"

namespace model::ipc2581 {

namespace {

/// More attributes than any element of the standard has; the rest is not kept.
constexpr std::size_t kMostAttributes = 64;

constexpr bool endsName(char c) {
    return base::isBlank(c) || c == '>' || c == '/' || c == '=' || c == '<' || c == '"' || c == '\'';
}

std::string_view localName(std::string_view name) {
    const std::size_t colon = name.rfind(':');
    return colon == std::string_view::npos ? name : name.substr(colon + 1);
}

}  // namespace

XmlCursor::Token XmlCursor::next() {
    while (true) {
        m_start = std::min(m_text.find('<', m_next), m_text.size());
        if (m_start == m_text.size()) {
            return m_depth > 0 ? broken("the file ends before its elements do") : Token::Finished;
        }
        const char kind = m_start + 1 < m_text.size() ? m_text[m_start + 1] : '\0';
        if (kind == '/') {
            return readEnd();
        }
        if (kind != '!' && kind != '?') {
            return readStart();
        }
        if (const Token token = passDeclaration(); token == Token::Broken) {
            return token;
        }
    }
}

XmlCursor::Token XmlCursor::passDeclaration() {
    const std::string_view rest = m_text.substr(m_start);
    if (rest.starts_with("<?")) {
        return passUntil("?>", 2, "a processing instruction does not end");
    }
    if (rest.starts_with("<!--")) {
        return passUntil("-->", 4, "a comment does not end");
    }
    if (rest.starts_with("<![CDATA[")) {
        return passUntil("]]>", 9, "a CDATA section does not end");
    }
    return broken("the file has a document type (DOCTYPE), which can make a small file endless; it is not read");
}

XmlCursor::Token XmlCursor::passUntil(std::string_view end, std::size_t from, const char* problem) {
    const std::size_t found = m_text.find(end, m_start + from);
    if (found == std::string_view::npos) {
        return broken(problem);
    }
    m_next = found + end.size();
    return Token::End;
}

XmlCursor::Token XmlCursor::readEnd() {
    const std::size_t close = m_text.find('>', m_start);
    if (close == std::string_view::npos || m_depth == 0) {
        return broken(m_depth == 0 ? "an end tag without its start tag" : "the file ends in the middle of a tag");
    }
    m_name = localName(m_text.substr(m_start + 2, endOfName(m_start + 2) - m_start - 2));
    m_next = close + 1;
    m_isEmpty = false;
    m_attributes.clear();
    --m_depth;
    return Token::End;
}

XmlCursor::Token XmlCursor::readStart() {
    std::size_t at = endOfName(m_start + 1);
    m_name = localName(m_text.substr(m_start + 1, at - m_start - 1));
    m_attributes.clear();
    if (m_name.empty()) {
        return broken("a tag without a name");
    }
    while (true) {
        while (at < m_text.size() && base::isBlank(m_text[at])) {
            ++at;
        }
        if (at == m_text.size()) {
            return broken("the file ends in the middle of a tag");
        }
        if (m_text[at] == '>' || m_text.substr(at, 2) == "/>") {
            break;
        }
        if (!readAttribute(at)) {
            return broken("an attribute is not written as name=\"value\"");
        }
    }
    m_isEmpty = m_text[at] == '/';
    m_next = at + (m_isEmpty ? 2 : 1);
    m_depth += m_isEmpty ? 0 : 1;
    return Token::Start;
}

bool XmlCursor::readAttribute(std::size_t& at) {
    const std::size_t nameEnd = endOfName(at);
    std::size_t quote = nameEnd;
    bool hasEqual = false;
    while (quote < m_text.size() && (base::isBlank(m_text[quote]) || (m_text[quote] == '=' && !hasEqual))) {
        hasEqual = hasEqual || m_text[quote] == '=';
        ++quote;
    }
    if (nameEnd == at || !hasEqual || quote == m_text.size() || (m_text[quote] != '"' && m_text[quote] != '\'')) {
        return false;
    }
    const std::size_t end = m_text.find(m_text[quote], quote + 1);
    if (end == std::string_view::npos) {
        return false;
    }
    if (m_attributes.size() < kMostAttributes) {
        m_attributes.push_back({localName(m_text.substr(at, nameEnd - at)), m_text.substr(quote + 1, end - quote - 1)});
    }
    at = end + 1;
    return true;
}

XmlCursor::Token XmlCursor::broken(const char* problem) {
    m_problem = problem;
    m_next = m_text.size();
    m_depth = 0;
    m_isEmpty = true;
    m_attributes.clear();
    return Token::Broken;
}

std::size_t XmlCursor::endOfName(std::size_t from) const {
    while (from < m_text.size() && !endsName(m_text[from])) {
        ++from;
    }
    return std::min(from, m_text.size());
}

std::uint32_t XmlCursor::line() const {
    if (m_start > m_counted) {
        const std::string_view passed = m_text.substr(m_counted, m_start - m_counted);
        m_line += static_cast<std::uint32_t>(std::ranges::count(passed, '\n'));
        m_counted = m_start;
    }
    return m_line;
}

std::string_view XmlCursor::value(std::string_view attribute) const {
    for (const Attribute& entry : m_attributes) {
        if (entry.name == attribute) {
            return entry.value;
        }
    }
    return {};
}

}  // namespace model::ipc2581
