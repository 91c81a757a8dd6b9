#include "model/formats/kicad/text/tree.h"

#include <algorithm>
#include <array>
#include <cstring>

namespace model::kicad {

namespace {

constexpr Node kNothing;

/// What lies right below (kicad_pcb …) and nowhere else.
constexpr std::array<std::string_view, 4> kBoardItems = {"footprint", "module", "segment", "via"};

bool isBlank(char c) {
    return c == ' ' || c == '\t' || c == '\r' || c == '\n';
}

/// 1: ends a word.
constexpr std::array<bool, 256> kEndsWord = [] {
    std::array<bool, 256> ends{};
    for (const char c : {' ', '\t', '\r', '\n', '(', ')', '"'}) {
        ends[static_cast<unsigned char>(c)] = true;
    }
    return ends;
}();

std::string_view wordAt(std::string_view text, std::size_t at) {
    std::size_t end = at;
    while (end < text.size() && !kEndsWord[static_cast<unsigned char>(text[end])]) {
        ++end;
    }
    return text.substr(at, end - at);
}

std::size_t behindBlanks(std::string_view text, std::size_t at) {
    while (at < text.size() && isBlank(text[at])) {
        ++at;
    }
    return at;
}

}  // namespace

// ---- items ----

Item::Item() : m_node(&kNothing) {}

bool Item::isThere() const {
    return m_node != &kNothing;
}

std::string_view Item::head() const {
    return m_node->kind == Node::Kind::List && m_node->span > 1 && m_node[1].kind != Node::Kind::List
               ? m_node[1].source
               : std::string_view();
}

Item Item::at(std::size_t place) const {
    for (const Item item : *this) {
        if (place-- == 0) {
            return item;
        }
    }
    return {};
}

std::string_view Item::word(std::size_t place) const {
    const Item item = at(place);
    return item.isList() ? std::string_view() : item.source();
}

std::string Item::text(std::size_t place) const {
    const Item item = at(place);
    return item.isList() ? std::string() : item.isQuoted() ? unescaped(item.source()) : std::string(item.source());
}

Item Item::find(std::string_view head) const {
    for (const Item item : *this) {
        if (item.isList() && item.head() == head) {
            return item;
        }
    }
    return {};
}

bool Item::hasWord(std::string_view word) const {
    bool isHead = true;
    for (const Item item : *this) {
        if (!isHead && !item.isList() && item.source() == word) {
            return true;
        }
        isHead = false;
    }
    return false;
}

bool Item::isSet(std::string_view flag) const {
    const Item list = find(flag);
    if (list.isThere()) {
        const std::string_view value = list.word(1);
        return value != "no" && value != "false";
    }
    bool isHead = true;
    for (const Item item : *this) {
        if (!isHead && item.m_node->kind == Node::Kind::Word && item.source() == flag) {
            return true;
        }
        isHead = false;
    }
    return false;
}

std::string unescaped(std::string_view source) {
    std::string text;
    text.reserve(source.size());
    for (std::size_t i = 0; i < source.size(); ++i) {
        const bool isEscape = source[i] == '\\' && i + 1 < source.size();
        const char c = isEscape ? source[++i] : source[i];
        text += isEscape && c == 'n' ? '\n' : isEscape && c == 't' ? '\t' : isEscape && c == 'r' ? '\r' : c;
    }
    return text;
}

bool looksLikeBoard(std::string_view head) {
    const std::size_t begin = behindBlanks(head, head.starts_with("\xef\xbb\xbf") ? 3 : 0);
    if (begin >= head.size() || head[begin] != '(') {
        return false;
    }
    return wordAt(head, behindBlanks(head, begin + 1)) == "kicad_pcb";
}

// ---- the text ----

BoardItems::BoardItems(std::string_view text, std::string_view file, Diagnostics& diagnostics)
    : m_text(text), m_file(file), m_diagnostics(diagnostics), m_isBoard(looksLikeBoard(text)) {
    if (m_isBoard) {
        m_at = m_text.find("kicad_pcb") + std::string_view("kicad_pcb").size();
        m_line += static_cast<std::uint32_t>(std::ranges::count(m_text.substr(0, m_at), '\n'));
    }
}

float BoardItems::fractionRead() const {
    return m_text.empty() ? 1.0F : static_cast<float>(m_at) / static_cast<float>(m_text.size());
}

void BoardItems::report(Severity severity, std::uint32_t line, std::string_view text) {
    m_diagnostics.report(severity, m_file, line, text);
}

void BoardItems::skipBlanks() {
    while (m_at < m_text.size()) {
        const char c = m_text[m_at];
        if (c == '\n') {
            ++m_line;
        } else if (c == '#') {
            std::size_t before = m_at;
            while (before > 0 && (m_text[before - 1] == ' ' || m_text[before - 1] == '\t')) {
                --before;
            }
            if (before > 0 && m_text[before - 1] != '\n') {
                return;
            }
            m_at = std::min(m_text.find('\n', m_at), m_text.size());
            continue;
        } else if (!isBlank(c)) {
            return;
        }
        ++m_at;
    }
}

bool BoardItems::next(Item& item) {
    while (m_isBoard) {
        skipBlanks();
        if (m_at >= m_text.size()) {
            if (!m_isClosed) {
                report(Severity::Error, m_line, "the file ends before the board does; it was cut off");
                m_isClosed = true;
            }
            return false;
        }
        const char c = m_text[m_at];
        if (c == '(') {
            if (m_isClosed) {
                report(Severity::Warning, m_line, "a parenthesis too many closes the board here; reading goes on");
                m_isClosed = false;
            }
            readItem();
            item = Item(m_nodes.data());
            return true;
        }
        if (c == ')') {
            m_isClosed = true;
            ++m_at;
            continue;
        }
        report(Severity::Warning, m_line, "a word between the items of the board was passed over");
        m_nodes.clear();
        m_open.clear();
        c == '"' ? readText() : readWord();
    }
    return false;
}

void BoardItems::readItem() {
    m_nodes.clear();
    m_open.clear();
    open(false);
    while (!m_open.empty()) {
        skipBlanks();
        if (m_at >= m_text.size()) {
            while (!m_open.empty()) {
                close();
            }
            return;  // next() reports it
        }
        switch (m_text[m_at]) {
            case '(':
                if (beginsBoardItem()) {
                    report(Severity::Error, m_nodes[0].line,
                           "an item of the board is not closed; it was ended where the next one begins");
                    while (!m_open.empty()) {
                        close();
                    }
                    return;
                }
                open(false);
                break;
            case ')':
                ++m_at;
                close();
                break;
            case '"': readText(); break;
            default:
                if (isForgottenList()) {
                    open(true);
                }
                readWord();
        }
    }
}

/// KiCad begins a line with each of them. How far it is indented says nothing: KiCad 9.0 counts its own parentheses,
/// and those that it forgets shift all that follows.
bool BoardItems::beginsBoardItem() const {
    std::size_t before = m_at;
    while (before > 0 && (m_text[before - 1] == ' ' || m_text[before - 1] == '\t')) {
        --before;
    }
    const bool beginsLine = before > 0 && m_text[before - 1] == '\n';
    return beginsLine && std::ranges::find(kBoardItems, wordAt(m_text, m_at + 1)) != kBoardItems.end();
}

bool BoardItems::isForgottenList() const {
    const Node& list = m_nodes[m_open.back()];
    const bool isTeardrops =
        Item(&list).isThere() && m_nodes.size() > m_open.back() + 1 && m_nodes[m_open.back() + 1].source == "teardrops";
    return isTeardrops && m_nodes.size() > m_open.back() + 2;
}

void BoardItems::open(bool isImplicit) {
    m_open.push_back(static_cast<std::uint32_t>(m_nodes.size()));
    m_nodes.push_back({m_text.substr(m_at, 0), 1, m_line, Node::Kind::List, isImplicit});
    if (isImplicit) {
        report(Severity::Info, m_line, "an opening parenthesis is missing, as KiCad 9.0 wrote it; it was added");
    } else {
        ++m_at;
    }
}

void BoardItems::close() {
    Node& list = m_nodes[m_open.back()];
    list.span = static_cast<std::uint32_t>(m_nodes.size()) - m_open.back();
    list.source = {list.source.data(), static_cast<std::size_t>(m_text.data() + m_at - list.source.data())};
    m_open.pop_back();
}

void BoardItems::readText() {
    const std::size_t begin = ++m_at;
    while (m_at < m_text.size() && m_text[m_at] != '"' && m_text[m_at] != '\n') {
        m_at += m_text[m_at] == '\\' && m_at + 1 < m_text.size() && m_text[m_at + 1] != '\n' ? 2 : 1;
    }
    m_at = std::min(m_at, m_text.size());
    m_nodes.push_back({m_text.substr(begin, m_at - begin), 1, m_line, Node::Kind::Text, false});
    if (m_at < m_text.size() && m_text[m_at] == '"') {
        ++m_at;
    } else {
        report(Severity::Warning, m_line, "a text does not end on its line; it was ended there");
    }
}

void BoardItems::readWord() {
    const std::string_view word = wordAt(m_text, m_at);
    m_nodes.push_back({word, 1, m_line, Node::Kind::Word, false});
    m_at += std::max<std::size_t>(word.size(), 1);
}

}  // namespace model::kicad
