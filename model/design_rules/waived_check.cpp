#include "model/design_rules/waived_check.h"

#include <algorithm>
#include <cmath>
#include <set>

#include "model/base/units.h"
#include "model/figures/distance.h"
#include "model/text/formatting.h"

namespace model {

namespace {

using State = WaiverNote::State;

bool areNear(Point a, PointD b) {
    return std::hypot(a.x - b.x, a.y - b.y) <= static_cast<double>(kWaiverReach);
}

bool areNear(const Waiver& waiver, const Spacing& s) {
    return (areNear(waiver.from, s.from) && areNear(waiver.to, s.to)) ||
           (areNear(waiver.from, s.to) && areNear(waiver.to, s.from));
}

/// An element that locations may lie on; its figures are made when they are needed.
class Passing {
public:
    Passing(const Document& step, ElementId element)
        : m_step(step), m_element(element), m_box(step.boxOf(element).grownBy(kWaiverReach)) {}

    [[nodiscard]] bool comesNear(Point p) {
        if (!m_box.holds(p)) {
            return false;
        }
        if (m_figures.size() == 0) {
            m_figures.add(m_step, m_element);
        }
        FigureTable point;
        point.addDisc(p, 0.0);
        return spacingBetween(m_figures, point, static_cast<double>(kWaiverReach)).has_value();
    }

private:
    const Document& m_step;
    ElementId m_element;
    Box m_box;
    FigureTable m_figures;
};

/// Do both elements of a finding pass the location of a waiver?
class PassingPair {
public:
    PassingPair(const Document& step, const RuleFinding& finding) {
        if (finding.reason == FindingReason::TooClose && finding.a.isValid() && finding.b.isValid()) {
            m_sides.emplace_back(step, finding.a);
            m_sides.emplace_back(step, finding.b);
        }
    }
    [[nodiscard]] bool passes(const Waiver& waiver) {
        return !m_sides.empty() && (passes(waiver.from, waiver.to) || passes(waiver.to, waiver.from));
    }

private:
    [[nodiscard]] bool passes(Point a, Point b) { return m_sides[0].comesNear(a) && m_sides[1].comesNear(b); }

    std::vector<Passing> m_sides;
};

/// Pairs of nets that waivers of a step name; none for "(no net)".
std::set<std::pair<NetId, NetId>> netsOf(const Document& step, std::span<const Waiver> waivers) {
    std::set<std::pair<NetId, NetId>> pairs;
    for (const Waiver& waiver : waivers) {
        if (waiver.kind == RuleKind::CopperToCopper && waiver.step == step.job.step) {
            const auto [low, high] =
                std::minmax({step.findNet(waiver.sides[0].net), step.findNet(waiver.sides[1].net)});
            pairs.insert({low, high});
        }
    }
    return pairs;
}

/// Sorts the findings of a report into those that are waived and the others, and says what is to be said.
class Sorter {
public:
    Sorter(const Document& step, const RuleTable& table, std::span<const Waiver> waivers, const RuleScope& scope,
           const base::Progress& progress)
        : m_step(step),
          m_table(table),
          m_waivers(waivers),
          m_scope(scope),
          m_progress(progress),
          m_match(step, table, waivers) {}

    /// Not all of it once the progress is cancelled.
    void sort(RuleReport& report) {
        std::vector<RuleFinding> left;
        for (const RuleFinding& finding : report.findings) {
            if (m_progress.isCancelled()) {
                return;
            }
            const std::size_t holder = m_match.holderOf(finding);
            if (holder < m_waivers.size()) {
                report.waived.push_back({finding, holder, reasonOf(m_waivers[holder])});
                --report.counts[finding.rule];
            } else {
                left.push_back(finding);
            }
        }
        report.findings = std::move(left);
        note(report);
    }

private:
    /// What there is at the location of a waiver: the first finding that counts, else the first that does not.
    struct Met {
        const RuleFinding* worse = nullptr;
        const RuleFinding* held = nullptr;
    };

    void note(RuleReport& report) {
        std::vector<Met> met(m_waivers.size());
        for (const WaivedFinding& waived : report.waived) {
            met[waived.waiver].held = &waived.found;
        }
        for (std::size_t row = 0; row < m_waivers.size() && !m_progress.isCancelled(); ++row) {
            if (m_waivers[row].step == m_step.job.step) {
                look(row, report, met[row]);
                note(row, met[row], report);
            }
        }
    }

    void look(std::size_t row, const RuleReport& report, Met& met) const {
        const auto at = [&](const RuleFinding& finding) { return m_match.isAt(row, finding); };
        const auto worse = std::ranges::find_if(report.findings, at);
        met.worse = worse == report.findings.end() ? nullptr : &*worse;
        if (met.held == nullptr && met.worse == nullptr) {  // another waiver may hold there
            const auto held = std::ranges::find_if(report.waived, at, &WaivedFinding::found);
            met.held = held == report.waived.end() ? nullptr : &held->found;
        }
    }

    void note(std::size_t row, const Met& met, RuleReport& report) {
        const Waiver& waiver = m_waivers[row];
        const auto say = [&](State state, const std::string& what) {
            report.waiverNotes.push_back({row, state, "waiver of " + placeOf(waiver) + ": " + what});
        };
        if (met.worse != nullptr) {
            say(State::Worse, leftOf(*met.worse) + ", so it does not hold");
        } else if (met.held != nullptr) {
            if (const std::string nets = otherNames(waiver, *met.held); !nets.empty()) {
                say(State::Renamed, "it holds, but the nets are " + nets + " now");
            }
        } else if (const std::string missing = whyUnknown(waiver); !missing.empty()) {
            say(State::Unknown, "not looked at: " + missing);
        } else if (isInScope(waiver)) {
            say(State::Gone, "no finding there any more");
        }
    }

    static std::string leftOf(const RuleFinding& found) {
        return found.reason == FindingReason::TooDeep
                   ? "it is " + reasonOf(found) + " now"
                   : formatted("only %.3f um are left", found.spacing.distance / base::kNmPerUm);
    }

    /// "GND and VCC" if the waiver has other names.
    [[nodiscard]] std::string otherNames(const Waiver& waiver, const RuleFinding& found) const {
        std::string now[] = {sideOf(m_step, found.a), secondSideOf(m_step, found)};
        std::string then[] = {waiver.sides[0].net, waiver.sides[1].net};
        std::ranges::sort(now);
        std::ranges::sort(then);
        return std::ranges::equal(now, then) ? "" : now[0] + " and " + now[1];
    }

    [[nodiscard]] std::string whyUnknown(const Waiver& waiver) const {
        if (!m_step.findLayer(waiver.layer).isValid()) {
            return "the step has no layer " + waiver.layer;
        }
        const bool isOn =
            std::ranges::any_of(m_table.rules, [&](const Rule& rule) { return rule.isOn && rule.kind == waiver.kind; });
        return isOn ? "" : std::string("no rule of the kind ") + nameOf(waiver.kind) + " is on";
    }

    /// Would a finding be there if its fault were?
    [[nodiscard]] bool isInScope(const Waiver& waiver) const {
        const bool isOfAllNets = m_scope.between == std::pair<NetId, NetId>();
        return isOfAllNets && (!m_scope.layer.isValid() || m_step.layer(m_scope.layer).name == waiver.layer);
    }

    const Document& m_step;
    const RuleTable& m_table;
    std::span<const Waiver> m_waivers;
    const RuleScope& m_scope;
    const base::Progress& m_progress;
    WaiverMatch m_match;
};

}  // namespace

WaiverMatch::WaiverMatch(const Document& step, const RuleTable& table, std::span<const Waiver> waivers)
    : m_step(step), m_table(table), m_waivers(waivers) {
    for (std::size_t row = 0; row < waivers.size(); ++row) {
        const Waiver& waiver = waivers[row];
        m_layers.push_back(step.findLayer(waiver.layer));
        if (waiver.step == step.job.step) {
            m_rows[{waiver.kind, waiver.fault, m_layers.back()}].push_back(row);
        }
    }
}

LayerId WaiverMatch::otherLayerOf(const RuleFinding& finding) const {
    const bool isOfTwoHoles = m_table.rules[finding.rule].kind == RuleKind::HoleToHole && finding.b.isValid();
    return isOfTwoHoles ? m_step.elements.layer[finding.b.row()] : finding.layer;
}

WaiverMatch::Rows WaiverMatch::rowsFor(const RuleFinding& finding) const {
    Rows all;
    for (const LayerId layer : std::set{finding.layer, otherLayerOf(finding)}) {
        const auto rows = m_rows.find({m_table.rules[finding.rule].kind, finding.reason, layer});
        if (rows != m_rows.end()) {
            all.insert(all.end(), rows->second.begin(), rows->second.end());
        }
    }
    return all;
}

bool WaiverMatch::isAt(std::size_t waiver, const RuleFinding& finding) const {
    const Waiver& w = m_waivers[waiver];
    const LayerId layer = m_layers[waiver];
    return w.kind == m_table.rules[finding.rule].kind && w.fault == finding.reason && w.step == m_step.job.step &&
           (layer == finding.layer || layer == otherLayerOf(finding)) &&
           (areNear(w, finding.spacing) || PassingPair(m_step, finding).passes(w));
}

bool WaiverMatch::isWorse(std::size_t waiver, const RuleFinding& finding) const {
    constexpr double kRounding = 0.1;  // waivers hold tenths of nanometres
    const Waiver& own = m_waivers[waiver];
    const double waived = own.depth > 0 ? own.distance * finding.depth / own.depth : own.distance;
    return finding.spacing.distance < waived - static_cast<double>(m_table.tolerance) - kRounding;
}

std::size_t WaiverMatch::holderOf(const RuleFinding& finding) const {
    const Rows rows = rowsFor(finding);
    PassingPair sides(m_step, finding);
    const auto holds = [&](std::size_t row, bool isAt) { return isAt && !isWorse(row, finding); };
    auto holder = std::ranges::find_if(
        rows, [&](std::size_t row) { return holds(row, areNear(m_waivers[row], finding.spacing)); });
    if (holder == rows.end()) {
        holder = std::ranges::find_if(rows, [&](std::size_t row) { return holds(row, sides.passes(m_waivers[row])); });
    }
    return holder == rows.end() ? m_waivers.size() : *holder;
}

base::Result<RuleReport> checkRules(const Document& step, const RuleTable& table, std::span<const Waiver> waivers,
                                    base::Progress& progress, RuleScope scope) {
    const WaiverMatch match(step, table, waivers);
    const auto named = netsOf(step, waivers);
    if (!waivers.empty()) {
        scope.isAccepted = [&, before = scope.isAccepted](const RuleFinding& finding) {
            return (before && before(finding)) || match.holderOf(finding) < waivers.size();
        };
        scope.mayBeAccepted = [&](NetId a, NetId b) { return named.contains(std::minmax(a, b)); };
    }
    ASSIGN_OR_RETURN(RuleReport report, checkRules(step, table, progress, scope));
    if (!waivers.empty()) {
        progress.beginPhase("Comparing with waivers");
    }
    Sorter(step, table, waivers, scope, progress).sort(report);
    if (progress.isCancelled()) {
        return base::Error{base::ErrorCode::Cancelled, "cancelled"};
    }
    return report;
}

std::vector<WaiverNote> waiversElsewhere(std::span<const Waiver> waivers, std::span<const Document* const> steps) {
    std::vector<WaiverNote> notes;
    for (std::size_t row = 0; row < waivers.size(); ++row) {
        const bool isHere =
            std::ranges::any_of(steps, [&](const Document* step) { return step->job.step == waivers[row].step; });
        if (!isHere) {
            notes.push_back({row, State::Unknown,
                             "waiver of " + placeOf(waivers[row]) + ": not looked at: step " + waivers[row].step +
                                 " is not among those that were checked"});
        }
    }
    return notes;
}

}  // namespace model
