#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "model/board/document.h"
#include "model/clearance/design_rules.h"

namespace model {

/// The class of every element that is a hole, by element; Any for what is none.
[[nodiscard]] std::vector<HoleClass> holeClassesOf(const Document& document);

/// Is a hole one that rules of this kind are for? Of hole-size round ones, of slot-width all others, of aspect-ratio
/// round plated ones, each without back-drills and counterbores, which go into a hole that is there. Of other kinds
/// any.
[[nodiscard]] bool isHoleFor(const Document& document, RuleKind kind, ElementId hole);
/// Classes of holes by element, with Any in place of those that rules of this kind are not for.
[[nodiscard]] std::vector<HoleClass> holeClassesFor(const Document& document, RuleKind kind,
                                                    std::vector<HoleClass> classes);

/// What layers rules of a kind are held against.
enum class RulePlane : std::uint8_t { Copper, SolderMask, Silkscreen };
[[nodiscard]] RulePlane planeOf(RuleKind kind);
/// By layer: what is checked there. Nothing on drawings, on paste, and on assembly drawings that are called silkscreen.
[[nodiscard]] std::vector<std::optional<RulePlane>> rulePlanesOf(const Document& document);

/// What lies on one side of a rule; what does not matter to a kind may be left out.
struct RuleParty {
    NetId net;
    HoleClass hole = HoleClass::Any;
    CopperObject object = CopperObject::Any;
};

/// Which rule of a table holds for what, on one document: of those that are on and fit, the last one. Document and
/// table must outlive it.
class RuleChoice {
public:
    RuleChoice(const Document& document, const RuleTable& table);

    /// None if no rule fits. `layer` may be none for kinds without one; sides are those of sidesOf(kind). Copper of one
    /// net on both sides fits rules within a net alone.
    [[nodiscard]] std::optional<std::size_t> of(RuleKind kind, LayerId layer, const RuleParty& a,
                                                const RuleParty& b = {}) const;
    /// Does a rule of the kind hold on a layer, for anything?
    [[nodiscard]] bool isOn(RuleKind kind, LayerId layer) const;
    /// The largest least value of a kind, nm; 0: there is no such rule.
    [[nodiscard]] double reachOf(RuleKind kind) const;
    /// Rows of the rules of a kind that are on.
    [[nodiscard]] std::vector<std::size_t> rowsOf(RuleKind kind) const;
    /// Why no item of a step can meet a rule that is on: there are none of `holes` (holeClassesFor) that it is for, or
    /// a later rule holds for all it is for. Empty if some can.
    [[nodiscard]] std::string whyUnused(std::size_t rule, const std::vector<HoleClass>& holes) const;
    /// Classes that a rule names and that no net of the document fits.
    [[nodiscard]] std::vector<std::string> emptyClassesOf(std::size_t rule) const;
    /// A name or pattern of a net class that no net of the document fits.
    struct Stray {
        std::string pattern;
        std::string netClass;
    };
    /// Of the classes that a rule names, those of which some other pattern fits a net.
    [[nodiscard]] std::vector<Stray> straysOf(std::size_t rule) const;
    /// Does the rule name a layer that the document does not have, or none that its kind is held against ("F.MASK" for
    /// tracks)?
    [[nodiscard]] bool hasNoLayer(std::size_t rule) const;
    /// Why a rule has no layer to hold on: the board has none there ("inner", "bottom"), or it is not for `only`, the
    /// one layer that is checked (if any is named). Empty if it has one, and where the rule or the job may be wrong:
    /// names that no layer has (whyMisnamed), and jobs without any layer of the kind.
    [[nodiscard]] std::string whyWithoutLayer(const Document& document, std::size_t rule, LayerId only) const;
    /// "no solder mask fits F.CU": a name that no layer of the rule's kind has. Empty for words for faces ("inner").
    [[nodiscard]] std::string whyMisnamed(std::size_t rule) const;

private:
    /// Of a rule that is on.
    struct Fit {
        std::size_t row;
        std::array<std::uint64_t, 2> classes;  ///< by side
        std::vector<bool> layers;
    };

    void addClasses(const Document& document);
    [[nodiscard]] Fit fitOf(const Document& document, std::size_t row) const;
    void addClass(const Document& document, std::size_t row);
    [[nodiscard]] std::uint64_t maskOf(const std::string& name) const;
    [[nodiscard]] std::uint64_t classesOf(NetId net) const;
    [[nodiscard]] bool fitsSide(const Fit& fit, std::size_t side, const RuleParty& party) const;
    [[nodiscard]] bool fits(const Fit& fit, LayerId layer, const RuleParty& a, const RuleParty& b) const;

    const RuleTable& m_table;
    std::vector<std::optional<RulePlane>> m_planes;  ///< by layer
    std::vector<NetClass> m_classes;                 ///< of the table, then one for each "net:"
    std::vector<std::uint64_t> m_classesOf;          ///< by net
    std::vector<Stray> m_strays;                     ///< of all classes
    std::array<std::vector<Fit>, kRuleKindCount> m_rules;
};

}  // namespace model
