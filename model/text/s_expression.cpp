#include "model/text/s_expression.h"

#include <algorithm>

#include "model/base/ascii.h"
#include "model/base/limits.h"

namespace model {

namespace {

const std::string kNothing;

class Parser {
public:
    explicit Parser(std::string_view text) : m_text(text) {}

    base::Result<SExpression> run() {
        SExpression all{{}, true, {}, 1};
        m_open.push_back(&all);
        for (skip(); m_at < m_text.size(); skip()) {
            RETURN_IF_ERROR(parseOne());
        }
        if (m_open.size() > 1) {
            return bad("a list is not closed", m_open.back()->line);
        }
        return all;
    }

private:
    static base::Error bad(const std::string& what, std::size_t line) {
        return {base::ErrorCode::BadInput, "line " + std::to_string(line) + ": " + what};
    }

    void step() { m_line += m_text[m_at++] == '\n' ? 1 : 0; }

    void skip() {
        while (m_at < m_text.size() && (base::isBlank(m_text[m_at]) || m_text[m_at] == '#')) {
            const bool isComment = m_text[m_at] == '#';
            while (isComment && m_at < m_text.size() && m_text[m_at] != '\n') {
                step();
            }
            if (!isComment) {
                step();
            }
        }
    }

    base::Status parseOne() {
        const char c = m_text[m_at];
        if (c == '(') {
            return open();
        }
        if (c == ')') {
            step();
            m_open.pop_back();
            return m_open.empty() ? base::Status(bad("a list is closed that was not opened", m_line)) : base::Done{};
        }
        return c == '"' ? parseText() : parseWord();
    }

    base::Status open() {
        if (m_open.size() > base::kMostListDepth) {
            return bad("lists in " + base::moreThan(base::kMostListDepth, "others"), m_line);
        }
        step();
        // The list that holds it does not grow before this one is closed, so the pointer stays good.
        m_open.back()->items.push_back({{}, true, {}, m_line});
        m_open.push_back(&m_open.back()->items.back());
        return base::Done{};
    }

    base::Status parseText() {
        SExpression text{{}, false, {}, m_line};
        for (step(); m_at < m_text.size() && m_text[m_at] != '"'; step()) {
            if (m_text[m_at] == '\\' && m_at + 1 < m_text.size()) {
                step();
            }
            text.atom += m_text[m_at];
        }
        if (m_at == m_text.size()) {
            return bad("a text does not end", text.line);
        }
        step();
        m_open.back()->items.push_back(std::move(text));
        return base::Done{};
    }

    base::Status parseWord() {
        SExpression word{{}, false, {}, m_line};
        while (m_at < m_text.size() && !base::isBlank(m_text[m_at]) && m_text[m_at] != '(' && m_text[m_at] != ')') {
            word.atom += m_text[m_at];
            step();
        }
        m_open.back()->items.push_back(std::move(word));
        return base::Done{};
    }

    std::string_view m_text;
    std::size_t m_at = 0;
    std::size_t m_line = 1;
    std::vector<SExpression*> m_open;
};

}  // namespace

const std::string& SExpression::head() const {
    return at(0);
}

const SExpression* SExpression::find(std::string_view head) const {
    const auto found =
        std::ranges::find_if(items, [&](const SExpression& item) { return item.isList && item.head() == head; });
    return found == items.end() ? nullptr : &*found;
}

const std::string& SExpression::at(std::size_t index) const {
    return index < items.size() && !items[index].isList ? items[index].atom : kNothing;
}

base::Result<SExpression> parseSExpressions(std::string_view text) {
    return Parser(text).run();
}

}  // namespace model
