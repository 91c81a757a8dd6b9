#include "model/formats/gerber/image/expression.h"

#include <charconv>
#include <cmath>
#include <vector>

#include "model/formats/gerber/text/words.h"

namespace model::gerber {

namespace {

/// Two stacks instead of recursion: nesting costs memory of the text's size only.
class Evaluator {
public:
    Evaluator(std::string_view text, const MacroVariables& variables) : m_rest(text), m_variables(variables) {}

    std::optional<double> run() {
        bool wantsValue = true;
        while (!m_rest.empty() && !m_failed) {
            wantsValue = wantsValue ? !takeValue() : takeOperator();
        }
        while (!m_operators.empty() && !m_failed) {
            m_failed = m_operators.back() == '(';
            reduce();
        }
        const bool isGood = !m_failed && !wantsValue && m_values.size() == 1 && std::isfinite(m_values[0]);
        return isGood ? std::optional(m_values[0]) : std::nullopt;
    }

private:
    /// True once a whole value is there.
    bool takeValue() {
        const char c = m_rest.front();
        if (c == '(' || c == '-' || c == '+') {
            m_rest.remove_prefix(1);
            if (c != '+') {
                m_operators.push_back(c == '-' ? '~' : '(');
            }
            return false;
        }
        if (c == '$') {
            m_rest.remove_prefix(1);
            return takeVariable();
        }
        const std::optional<double> value = takeReal(m_rest);
        m_failed = !value.has_value();
        m_values.push_back(value.value_or(0.0));
        return true;
    }

    bool takeVariable() {
        int number = 0;
        const std::from_chars_result result = std::from_chars(m_rest.data(), m_rest.data() + m_rest.size(), number);
        m_failed = result.ec != std::errc();
        m_rest.remove_prefix(static_cast<std::size_t>(result.ptr - m_rest.data()));
        const auto found = m_variables.find(number);
        m_values.push_back(found == m_variables.end() ? 0.0 : found->second);
        return true;
    }

    static int strength(char c) { return c == '~' ? 3 : c == '*' || c == '/' ? 2 : c == '(' ? 0 : 1; }

    /// True if a value must follow.
    bool takeOperator() {
        char c = m_rest.front();
        m_rest.remove_prefix(1);
        c = c == 'x' || c == 'X' ? '*' : c;
        if (c == ')') {
            while (!m_operators.empty() && m_operators.back() != '(' && !m_failed) {
                reduce();
            }
            m_failed = m_failed || m_operators.empty();
            if (!m_failed) {
                m_operators.pop_back();
            }
            return false;
        }
        m_failed = c != '+' && c != '-' && c != '*' && c != '/';
        while (!m_failed && !m_operators.empty() && strength(m_operators.back()) >= strength(c)) {
            reduce();
        }
        m_operators.push_back(c);
        return true;
    }

    void reduce() {
        const char c = m_operators.back();
        m_operators.pop_back();
        const std::size_t needed = c == '~' ? 1 : 2;
        if (m_failed || m_values.size() < needed) {
            m_failed = true;
            return;
        }
        const double b = m_values.back();
        if (c == '~') {
            m_values.back() = -b;
            return;
        }
        m_values.pop_back();
        double& a = m_values.back();
        a = c == '+' ? a + b : c == '-' ? a - b : c == '*' ? a * b : a / b;
    }

    std::string_view m_rest;
    const MacroVariables& m_variables;
    std::vector<double> m_values;
    std::vector<char> m_operators;
    bool m_failed = false;
};

}  // namespace

std::optional<double> evaluate(std::string_view expression, const MacroVariables& variables) {
    return Evaluator(expression, variables).run();
}

}  // namespace model::gerber
