#include "model/clearance/rule_choice.h"

#include <algorithm>

#include "model/board/holes.h"

namespace model {

namespace {

bool fits(HoleClass wanted, HoleClass hole) {
    return wanted == HoleClass::Any || wanted == hole;
}

/// Is a rule for everything that another one is for?
bool coversAll(const Rule& rule, const Rule& other) {
    const auto isIn = [&](std::size_t a, std::size_t b) {
        const auto hasClass = [&](std::size_t i, std::size_t j) {
            return rule.classes[i].empty() || rule.classes[i] == other.classes[j];
        };
        return hasClass(0, a) && hasClass(1, b) && fits(rule.holes[0], other.holes[a]) &&
               fits(rule.holes[1], other.holes[b]);
    };
    return rule.kind == other.kind && (isIn(0, 1) || isIn(1, 0));
}

}  // namespace

std::vector<HoleClass> holeClassesOf(const Document& document) {
    const std::vector<bool> isMicrovia = microviasOf(document);
    std::vector<HoleClass> classes(document.elements.size());
    for (std::size_t i = 0; i < classes.size(); ++i) {
        const std::uint8_t flags = document.elements.flags[i];
        classes[i] = (flags & kHole) == 0     ? HoleClass::Any
                     : isMicrovia[i]          ? HoleClass::Microvia
                     : (flags & kPlated) != 0 ? HoleClass::Plated
                                              : HoleClass::NonPlated;
    }
    return classes;
}

RuleChoice::RuleChoice(const Document& document, const RuleTable& table)
    : m_table(table), m_classes(document.nets.size()) {
    for (std::size_t row = 0; row < table.classes.size(); ++row) {
        for (std::size_t net = 0; net < m_classes.size(); ++net) {
            const bool isIn = std::ranges::any_of(table.classes[row].nets, [&](const std::string& pattern) {
                return fitsWildcard(document.nets[net].name, pattern);
            });
            m_classes[net] |= (isIn ? std::uint64_t{1} : 0) << row;
        }
    }
    for (const std::size_t row : rowsOf(RuleKind::CopperToCopper)) {
        m_rules.push_back({row, maskOf(table.rules[row].classes[0]), maskOf(table.rules[row].classes[1])});
    }
}

std::optional<std::size_t> RuleChoice::between(NetId a, NetId b) const {
    const std::uint64_t ofA = classesOf(a);
    const std::uint64_t ofB = classesOf(b);
    const auto fits = [&](const Fit& rule) {
        return ((ofA & rule.first) != 0 && (ofB & rule.second) != 0) ||
               ((ofA & rule.second) != 0 && (ofB & rule.first) != 0);
    };
    const auto last = std::find_if(m_rules.rbegin(), m_rules.rend(), fits);
    return last == m_rules.rend() ? std::nullopt : std::optional(last->row);
}

std::optional<std::size_t> RuleChoice::of(RuleKind kind, HoleClass hole) const {
    std::optional<std::size_t> last;
    for (const std::size_t row : rowsOf(kind)) {
        last = fits(m_table.rules[row].holes[0], hole) ? row : last;
    }
    return last;
}

std::optional<std::size_t> RuleChoice::between(HoleClass a, HoleClass b) const {
    std::optional<std::size_t> last;
    for (const std::size_t row : rowsOf(RuleKind::HoleToHole)) {
        const auto& [first, second] = m_table.rules[row].holes;
        const bool isFit = (fits(first, a) && fits(second, b)) || (fits(first, b) && fits(second, a));
        last = isFit ? row : last;
    }
    return last;
}

std::string RuleChoice::whyUnused(std::size_t rule, const std::vector<HoleClass>& holes) const {
    const Rule& own = m_table.rules[rule];
    for (std::size_t side = 0; side < holeSidesOf(own.kind); ++side) {
        if (own.holes[side] != HoleClass::Any && std::ranges::count(holes, own.holes[side]) == 0) {
            return std::string("the board has no holes of the kind ") + nameOf(own.holes[side]);
        }
    }
    for (std::size_t row = rule + 1; row < m_table.rules.size(); ++row) {
        if (m_table.rules[row].isOn && coversAll(m_table.rules[row], own)) {
            return "rule " + std::to_string(row + 1) + " holds instead";
        }
    }
    return {};
}

double RuleChoice::reachOf(RuleKind kind) const {
    Nm most = 0;
    for (const std::size_t row : rowsOf(kind)) {
        most = std::max(most, m_table.rules[row].least);
    }
    return most;
}

std::vector<std::size_t> RuleChoice::rowsOf(RuleKind kind) const {
    std::vector<std::size_t> rows;
    for (std::size_t row = 0; row < m_table.rules.size(); ++row) {
        if (m_table.rules[row].kind == kind && m_table.rules[row].isOn) {
            rows.push_back(row);
        }
    }
    return rows;
}

std::vector<std::size_t> RuleChoice::emptyClassesOf(std::size_t rule) const {
    std::vector<std::size_t> rows;
    for (const std::string& name : m_table.rules[rule].classes) {
        const std::size_t row = classRow(name);
        const auto isIn = [row](std::uint64_t classes) { return (classes >> row & 1U) != 0; };
        if (!name.empty() && std::ranges::none_of(m_classes, isIn)) {
            rows.push_back(row);
        }
    }
    return rows;
}

std::size_t RuleChoice::classRow(const std::string& name) const {
    return static_cast<std::size_t>(std::ranges::find(m_table.classes, name, &NetClass::name) -
                                    m_table.classes.begin());
}

std::uint64_t RuleChoice::maskOf(const std::string& name) const {
    return name.empty() ? ~std::uint64_t{0} : std::uint64_t{1} << classRow(name);
}

/// A net of no class, and copper without a net, fit "any" alone; its mask has all bits, theirs must have one.
std::uint64_t RuleChoice::classesOf(NetId net) const {
    constexpr std::uint64_t kAny = std::uint64_t{1} << 63U;
    return kAny | (net.isValid() ? m_classes[net.row()] : 0);
}

}  // namespace model
