#include "model/text/kicad_condition.h"

#include <algorithm>
#include <utility>

#include "model/base/ascii.h"

namespace model {

namespace {

using Alternatives = std::vector<ConditionTerms>;

bool isOfName(char c) {
    return base::isLetter(c) || base::isDigit(c) || c == '_';
}

/// "A.Type": what is named, and of which side.
struct Name {
    std::size_t side = 0;
    std::string name;
};

/// Reads from the left; a function that finds nothing it knows gives none, which ends it all.
class ConditionReader {
public:
    explicit ConditionReader(std::string_view text) : m_text(text) {}

    std::optional<Alternatives> run() {
        std::optional<Alternatives> all = either();
        skipSpace();
        return m_at == m_text.size() ? std::move(all) : std::nullopt;
    }

private:
    void skipSpace() {
        while (m_at < m_text.size() && base::isBlank(m_text[m_at])) {
            ++m_at;
        }
    }

    bool take(std::string_view word) {
        skipSpace();
        const bool isThere = m_text.substr(m_at).starts_with(word);
        m_at += isThere ? word.size() : 0;
        return isThere;
    }

    /// a || b
    std::optional<Alternatives> either() {
        std::optional<Alternatives> all = both();
        while (all && take("||")) {
            const std::optional<Alternatives> more = both();
            if (!more || all->size() + more->size() > kMostAlternatives) {
                return {};
            }
            all->insert(all->end(), more->begin(), more->end());
        }
        return all;
    }

    /// a && b
    std::optional<Alternatives> both() {
        std::optional<Alternatives> all = one();
        while (all && take("&&")) {
            const std::optional<Alternatives> more = one();
            if (!more || all->size() * more->size() > kMostAlternatives) {
                return {};
            }
            all = product(*all, *more);
        }
        return all;
    }

    static Alternatives product(const Alternatives& first, const Alternatives& second) {
        Alternatives all;
        for (const ConditionTerms& a : first) {
            for (const ConditionTerms& b : second) {
                all.push_back(a);
                all.back().insert(all.back().end(), b.begin(), b.end());
            }
        }
        return all;
    }

    /// A term, or a condition in parentheses.
    std::optional<Alternatives> one() {
        if (!take("(")) {
            std::optional<ConditionTerm> single = term();
            return single ? std::optional(Alternatives{{*std::move(single)}}) : std::nullopt;
        }
        if (++m_depth > kMostConditionDepth) {
            return {};
        }
        std::optional<Alternatives> inner = either();
        --m_depth;
        return take(")") ? std::move(inner) : std::nullopt;
    }

    std::optional<ConditionTerm> term() {
        const bool isNegated = take("!");
        std::optional<Name> left = name();
        if (!left) {
            return {};
        }
        ConditionTerm term{isNegated, left->side, std::move(left->name), {}, {}};
        if (take("(")) {
            return call(std::move(term));
        }
        const bool isUnequal = take("!=");
        return !isNegated && (isUnequal || take("==")) ? compared(std::move(term), isUnequal) : std::nullopt;
    }

    std::optional<ConditionTerm> call(ConditionTerm term) {
        term.name += "()";
        if (std::optional<std::string> given = quoted()) {
            term.text = *std::move(given);
        }
        return take(")") ? std::optional(std::move(term)) : std::nullopt;
    }

    /// With a text, or with the other side.
    std::optional<ConditionTerm> compared(ConditionTerm term, bool isUnequal) {
        term.isNegated = isUnequal;
        if (std::optional<std::string> text = quoted()) {
            term.text = *std::move(text);
            return term;
        }
        std::optional<Name> right = name();
        if (!right || right->side == term.side) {
            return {};
        }
        term.other = std::move(right->name);
        return term;
    }

    std::optional<Name> name() {
        const bool isOfA = take("A.");
        if (!isOfA && !take("B.")) {
            return {};
        }
        const std::size_t begin = m_at;
        while (m_at < m_text.size() && isOfName(m_text[m_at])) {
            ++m_at;
        }
        const std::string_view word = m_text.substr(begin, m_at - begin);
        return word.empty() ? std::nullopt : std::optional(Name{isOfA ? 0U : 1U, std::string(word)});
    }

    /// 'text'
    std::optional<std::string> quoted() {
        if (!take("'")) {
            return {};
        }
        const std::size_t end = m_text.find('\'', m_at);
        if (end == std::string_view::npos) {
            return {};
        }
        std::string text(m_text.substr(m_at, end - m_at));
        m_at = end + 1;
        return text;
    }

    std::string_view m_text;
    std::size_t m_at = 0;
    int m_depth = 0;
};

}  // namespace

std::optional<std::vector<ConditionTerms>> parseKicadCondition(std::string_view text) {
    return ConditionReader(text).run();
}

}  // namespace model
