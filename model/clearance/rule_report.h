#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "model/board/document.h"
#include "model/clearance/design_rules.h"
#include "model/geometry/edges.h"
#include "model/nets/net_ties.h"

/// What a check of rules says: where they are broken, and what they could not check.
namespace model {

/// Why a rule is broken at a location.
enum class FindingReason : std::uint8_t {
    TooClose,    ///< less than the rule's least value
    PadRemoved,  ///< the drill takes the whole pad of a plated hole, on this layer and perhaps on others
    NoPad,       ///< a plated hole has no copper around it on any layer it passes
    TooNarrow,   ///< a track, hole or slot is less wide than the rule's least value
    AcuteAngle,  ///< tracks leave a narrow notch where they meet
    Floating,    ///< copper that nothing joins to a pad or plated hole
    TooDeep      ///< a plated hole is more times as deep as wide than the rule lets pass
};
inline constexpr std::size_t kFindingReasonCount = 7;
/// "the drill removes the whole pad"; empty where the spacing says it all.
[[nodiscard]] const char* toString(FindingReason reason);

/// A location where a rule is broken.
struct RuleFinding {
    std::size_t rule = 0;  ///< row of RuleTable::rules
    LayerId layer;         ///< the first one where this is so
    ElementId a;
    ElementId b;  ///< none for the edge of the board, and for the pad of a hole without one
    /// nm; 0: they touch or overlap. Of a ring: from the hole's edge to the pad's. Of the size of a hole or slot: how
    /// wide it is, both ends in its middle.
    Spacing spacing;
    FindingReason reason = FindingReason::TooClose;
    bool isWithoutPad = false;  ///< of a ring: the layer has no pad there, other copper leaves it
    double depth = 0.0;         ///< nm, TooDeep: of the hole
};
/// Why, in words; empty where the spacing says it all.
[[nodiscard]] std::string reasonOf(const RuleFinding& finding);
/// The least spacing that would pass there, nm: Rule::least, or the drill that a hole as deep as this needs. 0: rules
/// of the kind have no limit.
[[nodiscard]] double requiredOf(const Rule& rule, const RuleFinding& finding);

/// Items that a rule could not be held against, though it should.
struct Unchecked {
    std::size_t rule = 0;   ///< row of RuleTable::rules
    std::size_t count = 0;  ///< of items; 0: they cannot be counted
    std::string what;       ///< those items, in the number they are: "holes"
    std::string why;        ///< "layer drill does not say which copper layers it passes"
};
/// "36 holes: layer drill does not say which copper layers it passes"
[[nodiscard]] std::string textOf(const Unchecked& unchecked);

/// A finding that somebody accepts (model::Waiver).
struct WaivedFinding {
    RuleFinding found;
    std::size_t waiver = 0;  ///< row of the list of waivers
    std::string reason;      ///< "reviewed with the fabricator (A. Meier, 2026-11-23)"
};

/// What is to be said of a waiver.
struct WaiverNote {
    enum class State : std::uint8_t {
        Gone,     ///< there is no finding any more
        Worse,    ///< there is one, and less is left than when it was waived: it counts
        Renamed,  ///< it holds, but the nets there have other names
        Unknown   ///< it was not looked at: the step, its layer or a rule of its kind is missing
    };
    std::size_t waiver = 0;  ///< row of the list of waivers
    State state = State::Gone;
    std::string text;  ///< a sentence that names the waiver
};
/// "gone", "worse", "renamed", "unknown"
[[nodiscard]] const char* toString(WaiverNote::State state);

struct RuleReport {
    std::vector<RuleFinding> findings;      ///< by rule, then smallest first; without those that are waived
    std::vector<std::size_t> counts;        ///< of findings by rule
    std::vector<WaivedFinding> waived{};    ///< as findings
    std::vector<WaiverNote> waiverNotes{};  ///< by waiver
    std::vector<Unchecked> unchecked;       ///< by rule
    std::vector<std::string> unused;        ///< by rule: why nothing on the board can meet it; empty if something can
    std::vector<NetTie> netTies;            ///< which are no shorts; empty if no rule is on between nets
    std::vector<std::string> notes;         ///< what is no fault, but good to know, in plain words
    [[nodiscard]] bool isPassed() const { return findings.empty(); }
    [[nodiscard]] bool isComplete() const { return unchecked.empty(); }
};

/// A rule that is broken somewhere, where nobody waived it, has failed, whatever else it could not check; else it has
/// passed only if it could check everything, and there was something to check.
enum class Verdict : std::uint8_t { Off, Unused, Passed, Incomplete, Failed };
[[nodiscard]] Verdict verdictOf(const RuleTable& table, const RuleReport& report, std::size_t rule);
/// How many findings of a rule are waived.
[[nodiscard]] std::size_t waivedOf(const RuleReport& report, std::size_t rule);
/// "off", "unused", "pass", "incomplete", "FAIL"
[[nodiscard]] const char* toString(Verdict verdict);

/// What lies on one side of a location: the name of its net, "(no net)", or for no element "(board edge)".
[[nodiscard]] std::string sideOf(const Document& step, ElementId element);
/// The same of the second side of a finding, which may be "(no pad)"; empty if it has none.
[[nodiscard]] std::string secondSideOf(const Document& step, const RuleFinding& finding);

}  // namespace model
