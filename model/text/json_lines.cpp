#include "model/text/json_lines.h"

namespace model {

namespace {

constexpr std::size_t kMostLevels = 16;

class Scanner {
public:
    Scanner(std::string_view text, std::map<std::string, std::size_t>& lines, std::string& duplicate)
        : m_text(text), m_lines(lines), m_duplicate(duplicate) {}

    void value(const std::string& path, std::size_t level) {
        skip();
        if (!m_lines.try_emplace(path, m_line).second && m_duplicate.empty()) {
            m_duplicate = path;
        }
        const char first = peek();
        if (level == kMostLevels) {
            m_at = m_text.size();
        } else if (first == '{' || first == '[') {
            items(path, first == '{', level + 1);
        } else if (first == '"') {
            string();
        } else {
            while (m_at < m_text.size() && std::string_view(",]} \t\r\n/").find(peek()) == std::string_view::npos) {
                ++m_at;
            }
        }
    }

private:
    [[nodiscard]] char peek() const { return m_at < m_text.size() ? m_text[m_at] : '\0'; }
    char take() {
        const char c = peek();
        m_line += c == '\n' ? 1 : 0;
        ++m_at;
        return c;
    }
    [[nodiscard]] bool startsWith(std::string_view what) const { return m_text.substr(m_at).starts_with(what); }

    /// White space and comments.
    void skip() {
        while (m_at < m_text.size()) {
            if (startsWith("//")) {
                skipTo("\n");
            } else if (startsWith("/*")) {
                skipTo("*/");
            } else if (std::string_view(" \t\r\n").find(peek()) != std::string_view::npos) {
                take();
            } else {
                return;
            }
        }
    }
    void skipTo(std::string_view end) {
        while (m_at < m_text.size() && !startsWith(end)) {
            take();
        }
        for (std::size_t i = 0; i < end.size(); ++i) {
            take();
        }
    }

    std::string string() {
        std::string text;
        take();
        while (m_at < m_text.size() && peek() != '"') {
            if (peek() == '\\') {
                text += take();
            }
            text += take();
        }
        take();
        return text;
    }

    void items(const std::string& path, bool isObject, std::size_t level) {
        take();
        for (std::size_t i = 0;; ++i) {
            const std::size_t start = m_at;
            skip();
            if (m_at >= m_text.size() || peek() == '}' || peek() == ']') {
                take();
                return;
            }
            std::string key = std::to_string(i);
            if (isObject) {
                key = string();
                skip();
                take();  // the colon
            }
            value(path + '/' + key, level);
            skip();
            if (peek() == ',' || m_at == start) {  // what is no value, as a lone slash, is passed over
                take();
            }
        }
    }

    std::string_view m_text;
    std::map<std::string, std::size_t>& m_lines;
    std::string& m_duplicate;
    std::size_t m_at = 0;
    std::size_t m_line = 1;
};

}  // namespace

JsonLines::JsonLines(std::string_view text) {
    Scanner(text, m_lines, m_duplicate).value("", 0);
}

std::size_t JsonLines::of(std::string path) const {
    while (!path.empty() && !m_lines.contains(path)) {
        path.resize(path.rfind('/'));
    }
    const auto found = m_lines.find(path);
    return found == m_lines.end() ? 1 : found->second;
}

}  // namespace model
