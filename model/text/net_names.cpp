#include "model/text/net_names.h"

#include <algorithm>
#include <utility>

#include "model/text/utf8.h"

namespace model {

namespace {

constexpr std::pair<std::string_view, std::string_view> kSpellings[] = {
    {"slash", "/"}, {"backslash", "\\"}, {"space", " "}, {"colon", ":"},     {"comma", ","}, {"bar", "|"},
    {"lt", "<"},    {"gt", ">"},         {"quote", "'"}, {"dblquote", "\""}, {"brace", "{"},
};

constexpr std::string_view kBar = "\xcc\x85";  // U+0305, over the character before it

/// Reads a name from its beginning to its end.
class Reader {
public:
    Reader(std::string_view name, bool hasBars) : m_rest(name), m_hasBars(hasBars) {}

    [[nodiscard]] std::string run() {
        while (!m_rest.empty()) {
            if (!takeSpelling() && !takeBarred()) {
                takeCharacter();
            }
        }
        return std::move(m_out);
    }

private:
    bool takeSpelling() {
        for (const auto& [word, character] : kSpellings) {
            const bool isIt = m_rest.front() == '{' && m_rest.size() >= word.size() + 2 &&
                              m_rest.substr(1, word.size()) == word && m_rest[word.size() + 1] == '}';
            if (isIt) {
                m_out += character;
                addBar();
                m_rest.remove_prefix(word.size() + 2);
                return true;
            }
        }
        return false;
    }

    /// "~{" begins a part with bars, up to its brace; parts within it have them already.
    bool takeBarred() {
        if (m_isBarred || !m_rest.starts_with("~{")) {
            return false;
        }
        const std::size_t end = closingBrace();
        if (end == std::string_view::npos) {
            return false;
        }
        Reader within(m_rest.substr(2, end - 2), m_hasBars);
        within.m_isBarred = true;
        m_out += within.run();
        m_rest.remove_prefix(end + 1);
        return true;
    }

    [[nodiscard]] std::size_t closingBrace() const {
        int depth = 0;
        for (std::size_t at = 1; at < m_rest.size(); ++at) {
            depth += m_rest[at] == '{' ? 1 : m_rest[at] == '}' ? -1 : 0;
            if (depth == 0) {
                return at;
            }
        }
        return std::string_view::npos;
    }

    void takeCharacter() {
        std::size_t size = 1;
        while (size < m_rest.size() && !beginsCharacter(m_rest[size])) {
            ++size;
        }
        m_out += m_rest.substr(0, size);
        addBar();
        m_rest.remove_prefix(size);
    }

    void addBar() {
        if (m_isBarred && m_hasBars) {
            m_out += kBar;
        }
    }

    std::string_view m_rest;
    bool m_hasBars;
    bool m_isBarred = false;
    std::string m_out;
};

}  // namespace

bool hasBraces(std::string_view name) {
    return name.find('{') != std::string_view::npos;
}

std::string readableName(std::string_view name) {
    return hasBraces(name) ? Reader(name, true).run() : std::string(name);
}

std::string typedName(std::string_view name) {
    return hasBraces(name) ? Reader(name, false).run() : std::string(name);
}

std::optional<Backslash> backslashIn(std::string_view name) {
    if (name.ends_with('\\')) {
        return Backslash::Overbar;
    }
    std::optional<Backslash> meant;
    const std::size_t first = name.find('\\');
    for (std::size_t from = first, to; from < name.size() && (to = name.find('\\', from + 1)) < name.size();
         from = to) {
        if (std::ranges::count_if(name.substr(from + 1, to - from - 1), beginsCharacter) != 1) {
            return Backslash::EndsSheet;
        }
        meant = Backslash::Overbar;
    }
    return meant;
}

std::string_view sheetOf(std::string_view name, Backslash backslash) {
    const bool isRooted = name.starts_with('/');
    if (name.size() < 2 || (!isRooted && backslash == Backslash::Overbar)) {
        return {};
    }
    const std::size_t last = name.rfind(isRooted ? '/' : '\\', name.size() - 2);  // one at the end belongs to the name
    return last == std::string_view::npos ? std::string_view() : name.substr(0, last + 1);
}

}  // namespace model
