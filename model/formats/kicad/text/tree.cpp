#include "model/formats/kicad/text/tree.h"

#include <algorithm>
#include <array>
#include <limits>

namespace model::kicad {

namespace {

/// What lies right below (kicad_pcb …) and nowhere else.
constexpr std::array<std::string_view, 4> kBoardItems = {"footprint", "module", "segment", "via"};

enum class Sort : std::uint8_t { Word, Blank, Open, Close, Quote };

/// What each character begins or ends.
constexpr std::array<Sort, 256> kSorts = [] {
    std::array<Sort, 256> sorts{};
    for (const char c : {' ', '\t', '\r', '\n'}) {
        sorts[static_cast<unsigned char>(c)] = Sort::Blank;
    }
    sorts['('] = Sort::Open;
    sorts[')'] = Sort::Close;
    sorts['"'] = Sort::Quote;
    return sorts;
}();

Sort sortOf(char c) {
    return kSorts[static_cast<unsigned char>(c)];
}

/// Only a blank or a parenthesis ends a word: KiCad 4 and 5 write 0.062" without quotes around it.
bool isInWord(char c) {
    const Sort sort = sortOf(c);
    return sort == Sort::Word || sort == Sort::Quote;
}

const char* endOfWord(const char* at, const char* end) {
    while (at < end && isInWord(*at)) {
        ++at;
    }
    return at;
}

std::string_view wordAt(std::string_view text, std::size_t at) {
    const char* begin = text.data() + std::min(at, text.size());
    return {begin, static_cast<std::size_t>(endOfWord(begin, text.data() + text.size()) - begin)};
}

std::size_t behindBlanks(std::string_view text, std::size_t at) {
    while (at < text.size() && sortOf(text[at]) == Sort::Blank) {
        ++at;
    }
    return at;
}

}  // namespace

// ---- items ----

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
    : m_file(file),
      m_diagnostics(diagnostics),
      m_begin(text.data()),
      m_end(text.data() + text.size()),
      m_at(m_begin),
      m_lineBegin(m_begin),
      m_isBoard(looksLikeBoard(text)) {
    if (m_isBoard) {
        // Growing step by step copies the fill of a large zone several times, and touches memory for each copy.
        constexpr std::size_t kBytesPerNode = 4;
        constexpr std::size_t kMostReserved = 1'000'000;
        m_nodes.reserve(std::min(text.size() / kBytesPerNode, kMostReserved));
        constexpr std::string_view kHead = "kicad_pcb";
        const std::size_t at = text.find(kHead) + kHead.size();
        m_at += at;
        m_line += static_cast<std::uint32_t>(std::ranges::count(text.substr(0, at), '\n'));
        const std::size_t newLine = text.substr(0, at).rfind('\n');
        m_lineBegin += newLine == std::string_view::npos ? 0 : newLine + 1;
    }
}

float BoardItems::fractionRead() const {
    return m_begin == m_end ? 1.0F : static_cast<float>(m_at - m_begin) / static_cast<float>(m_end - m_begin);
}

void BoardItems::report(Severity severity, std::uint32_t line, std::string_view text) {
    m_diagnostics.report(severity, m_file, line, text);
}

void BoardItems::skipBlanks() {
    for (; m_at < m_end; ++m_at) {
        const char c = *m_at;
        if (c == '\n') {
            ++m_line;
            m_lineBegin = m_at + 1;
        } else if (c == '#' && std::all_of(m_lineBegin, m_at, [](char b) { return b == ' ' || b == '\t'; })) {
            m_at = std::find(m_at, m_end, '\n') - 1;
        } else if (sortOf(c) != Sort::Blank) {
            return;
        }
    }
}

bool BoardItems::next(Item& item) {
    while (m_isBoard) {
        skipBlanks();
        if (m_at >= m_end) {
            if (!m_isClosed) {
                report(Severity::Error, m_line, "the file ends before the board does; it was cut off");
                m_isClosed = true;
            }
            return false;
        }
        if (*m_at == '(') {
            if (m_isClosed) {
                report(Severity::Warning, m_line, "a parenthesis too many closes the board here; reading goes on");
                m_isClosed = false;
            }
            readItem();
            item = Item(m_nodes.data());
            return true;
        }
        if (*m_at == ')') {
            m_isClosed = true;
            ++m_at;
            continue;
        }
        report(Severity::Warning, m_line, "a word between the items of the board was passed over");
        m_nodes.clear();
        m_open.clear();
        *m_at == '"' ? readText() : readWord();
    }
    return false;
}

void BoardItems::readItem() {
    m_nodes.clear();
    m_open.clear();
    open(false);
    while (!m_open.empty()) {
        skipBlanks();
        if (m_at >= m_end) {
            return closeAll();  // next() reports it
        }
        switch (sortOf(*m_at)) {
            case Sort::Open:
                if (beginsBoardItem()) {
                    report(Severity::Error, m_nodes[0].line,
                           "an item of the board is not closed; it was ended where the next one begins");
                    return closeAll();
                }
                open(false);
                break;
            case Sort::Close:
                ++m_at;
                close();
                break;
            case Sort::Quote: readText(); break;
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
    const char* word = m_at + 1;
    const bool mayBe = word < m_end && (*word == 'f' || *word == 'm' || *word == 's' || *word == 'v');
    if (!mayBe || m_lineBegin == m_begin ||
        !std::all_of(m_lineBegin, m_at, [](char b) { return b == ' ' || b == '\t'; })) {
        return false;
    }
    const std::string_view head{word, static_cast<std::size_t>(endOfWord(word, m_end) - word)};
    return std::ranges::find(kBoardItems, head) != kBoardItems.end();
}

bool BoardItems::isForgottenList() const {
    const std::size_t list = m_open.back();
    return m_nodes.size() > list + 2 && m_nodes[list + 1].size == 9 && m_nodes[list + 1].source() == "teardrops";
}

Node& BoardItems::add(Node::Kind kind, const char* begin, std::size_t size) {
    return m_nodes.emplace_back(
        Node{begin, static_cast<std::uint32_t>(std::min<std::size_t>(size, std::numeric_limits<std::uint32_t>::max())),
             1, m_line, kind, false});
}

void BoardItems::open(bool isImplicit) {
    m_open.push_back(static_cast<std::uint32_t>(m_nodes.size()));
    add(Node::Kind::List, m_at, 0).isImplicit = isImplicit;
    if (isImplicit) {
        report(Severity::Info, m_line, "an opening parenthesis is missing, as KiCad 9.0 wrote it; it was added");
    } else {
        ++m_at;
    }
}

void BoardItems::close() {
    Node& list = m_nodes[m_open.back()];
    list.span = static_cast<std::uint32_t>(m_nodes.size()) - m_open.back();
    list.size = static_cast<std::uint32_t>(
        std::min<std::ptrdiff_t>(m_at - list.begin, std::numeric_limits<std::uint32_t>::max()));
    m_open.pop_back();
}

void BoardItems::closeAll() {
    while (!m_open.empty()) {
        close();
    }
}

void BoardItems::readText() {
    const char* begin = ++m_at;
    while (m_at < m_end && *m_at != '"' && *m_at != '\n') {
        m_at += *m_at == '\\' && m_at + 1 < m_end && m_at[1] != '\n' ? 2 : 1;
    }
    add(Node::Kind::Text, begin, static_cast<std::size_t>(m_at - begin));
    if (m_at < m_end && *m_at == '"') {
        ++m_at;
    } else {
        report(Severity::Warning, m_line, "a text does not end on its line; it was ended there");
    }
}

void BoardItems::readWord() {
    const char* begin = m_at;
    m_at = std::max(endOfWord(m_at, m_end), begin + 1);
    add(Node::Kind::Word, begin, static_cast<std::size_t>(m_at - begin));
}

}  // namespace model::kicad
