#include "model/clearance/rule_choice.h"

#include <algorithm>

#include "model/base/ascii.h"
#include "model/board/holes.h"
#include "model/board/layers.h"
#include "model/text/formatting.h"
#include "model/text/wildcard.h"

namespace model {

namespace {

template <class Kind>
bool isOf(Kind wanted, Kind found) {
    return wanted == Kind::Any || wanted == found;
}

/// The kind of holes that a rule names on a side.
HoleClass holesAt(const Rule& rule, std::size_t side) {
    const bool isHole = sidesOf(rule.kind)[side] == RuleSide::Hole;
    return !isHole ? HoleClass::Any : rule.holes[holeSidesOf(rule.kind) == 2 ? side : 0];
}

/// Is a rule for everything that another one is for?
bool coversAll(const Rule& rule, const Rule& other) {
    const auto isSideIn = [&](std::size_t i, std::size_t j) {
        return (rule.classes[i].empty() || rule.classes[i] == other.classes[j]) &&
               isOf(holesAt(rule, i), holesAt(other, j)) && isOf(rule.objects[i], other.objects[j]);
    };
    const bool isAround =
        (isSideIn(0, 0) && isSideIn(1, 1)) || (isSymmetric(rule.kind) && isSideIn(0, 1) && isSideIn(1, 0));
    return rule.kind == other.kind && rule.isSameNet == other.isSameNet && isAround &&
           (rule.layer.empty() || rule.layer == other.layer);
}

/// A word for faces, which a board may lack; a name that no layer has may be misspelt.
bool isFace(const std::string& wanted) {
    return wanted == "outer" || wanted == "inner" || wanted == "top" || wanted == "bottom";
}

/// The words for faces, or a name.
bool fitsLayer(const Document& document, LayerId layer, const std::string& wanted) {
    const LayerSide face = faceOf(document, layer);
    const bool isOuter = face == LayerSide::Top || face == LayerSide::Bottom;
    return wanted == "outer"    ? isOuter
           : wanted == "inner"  ? document.layer(layer).isCopper() && !isOuter
           : wanted == "top"    ? face == LayerSide::Top
           : wanted == "bottom" ? face == LayerSide::Bottom
                                : fitsWildcard(base::lowerCase(document.layer(layer).name), base::lowerCase(wanted));
}

/// "no solder mask fits F.CU"
const char* nameOf(RulePlane plane) {
    constexpr const char* kNames[] = {"copper layer", "solder mask", "silkscreen"};
    return kNames[static_cast<std::size_t>(plane)];
}

/// What holes rules of a kind are for (isHoleFor), in words.
std::string holesOf(RuleKind kind) {
    return kind == RuleKind::SlotWidth                                   ? "slots"
           : kind == RuleKind::HoleSize || kind == RuleKind::AspectRatio ? "round holes"
                                                                         : "holes";
}

/// Why there are no holes that a side of a rule is for; empty if there are some. Only plated holes have rings.
std::string whyWithoutHoles(const Rule& rule, std::size_t side, const std::vector<HoleClass>& holes) {
    const HoleClass wanted = rule.holes[side];
    const auto fits = [&](HoleClass hole) {
        const bool isBare = hole == HoleClass::NonPlated && rule.kind == RuleKind::AnnularRing;
        return hole != HoleClass::Any && !isBare && isOf(wanted, hole);
    };
    if (std::ranges::any_of(holes, fits)) {
        return {};
    }
    const bool isOfPlated = rule.kind == RuleKind::AnnularRing || rule.kind == RuleKind::AspectRatio;
    return wanted != HoleClass::Any ? "the step has no " + holesOf(rule.kind) + " of the kind " + nameOf(wanted)
           : isOfPlated             ? "the step has no plated " + holesOf(rule.kind)
                                    : "the step has no " + holesOf(rule.kind);
}

}  // namespace

RulePlane planeOf(RuleKind kind) {
    switch (kind) {
        case RuleKind::MaskSliver:
        case RuleKind::MaskToCopper:
        case RuleKind::MaskToForeign: return RulePlane::SolderMask;
        case RuleKind::SilkToPad: return RulePlane::Silkscreen;
        default: return RulePlane::Copper;
    }
}

std::vector<std::optional<RulePlane>> rulePlanesOf(const Document& document) {
    const std::vector<bool> isPrint = silkscreenPrints(document);
    std::vector<std::optional<RulePlane>> planes(document.layers.size());
    for (std::size_t row = 0; row < planes.size(); ++row) {
        const Layer& layer = document.layers[row];
        if (layer.isCopper()) {
            planes[row] = RulePlane::Copper;
        } else if (layer.type == LayerType::SolderMask && !layer.isSynthetic) {
            planes[row] = RulePlane::SolderMask;
        } else if (layer.type == LayerType::SilkScreen && isPrint[row]) {
            planes[row] = RulePlane::Silkscreen;
        }
    }
    return planes;
}

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

bool isHoleFor(const Document& document, RuleKind kind, ElementId hole) {
    const bool isRound = document.elements.kind[hole.row()] == ElementKind::Circle;
    const LayerUse use = document.layer(document.elements.layer[hole.row()]).use;
    const bool isOwn = use != LayerUse::Backdrill && use != LayerUse::DualDiameter;
    switch (kind) {
        case RuleKind::HoleSize: return isOwn && isRound;
        case RuleKind::SlotWidth: return isOwn && !isRound;
        case RuleKind::AspectRatio: return isOwn && isRound && isPlatedHole(document.elements.flags[hole.row()]);
        default: return true;
    }
}

std::vector<HoleClass> holeClassesFor(const Document& document, RuleKind kind, std::vector<HoleClass> classes) {
    for (std::size_t i = 0; i < classes.size(); ++i) {
        const bool isMet = classes[i] != HoleClass::Any && isHoleFor(document, kind, ElementId{i});
        classes[i] = isMet ? classes[i] : HoleClass::Any;
    }
    return classes;
}

RuleChoice::RuleChoice(const Document& document, const RuleTable& table)
    : m_table(table), m_planes(rulePlanesOf(document)), m_classes(table.classes), m_classesOf(document.nets.size()) {
    addClasses(document);
    for (std::size_t row = 0; row < table.rules.size(); ++row) {
        if (table.rules[row].isOn) {
            m_rules[static_cast<std::size_t>(table.rules[row].kind)].push_back(fitOf(document, row));
        }
    }
}

/// A name holds for layers that the kind is held against alone: "B*" does not find the mask of a board without the
/// copper that it is meant for.
RuleChoice::Fit RuleChoice::fitOf(const Document& document, std::size_t row) const {
    const Rule& rule = m_table.rules[row];
    Fit fit{row, {maskOf(rule.classes[0]), maskOf(rule.classes[1])}, {}};
    for (std::size_t layer = 0; layer < document.layers.size(); ++layer) {
        const bool isNamed = m_planes[layer] == planeOf(rule.kind) && fitsLayer(document, LayerId{layer}, rule.layer);
        fit.layers.push_back(rule.layer.empty() || isNamed);
    }
    return fit;
}

void RuleChoice::addClasses(const Document& document) {
    for (const Rule& rule : m_table.rules) {
        for (const std::string& name : rule.classes) {
            if (name.starts_with(kNetPrefix) && std::ranges::count(m_classes, name, &NetClass::name) == 0) {
                m_classes.push_back({name, {name.substr(kNetPrefix.size())}});
            }
        }
    }
    for (std::size_t row = 0; row < m_classes.size(); ++row) {
        addClass(document, row);
    }
}

void RuleChoice::addClass(const Document& document, std::size_t row) {
    for (const std::string& pattern : m_classes[row].nets) {
        bool isStray = true;
        for (std::size_t net = 0; net < m_classesOf.size(); ++net) {
            if (fitsWildcard(document.nets[net].name, pattern)) {
                m_classesOf[net] |= std::uint64_t{1} << row;
                isStray = false;
            }
        }
        if (isStray) {
            m_strays.push_back({pattern, m_classes[row].name});
        }
    }
}

bool RuleChoice::fitsSide(const Fit& fit, std::size_t side, const RuleParty& party) const {
    const Rule& rule = m_table.rules[fit.row];
    return (classesOf(party.net) & fit.classes[side]) != 0 && isOf(holesAt(rule, side), party.hole) &&
           isOf(rule.objects[side], party.object);
}

bool RuleChoice::fits(const Fit& fit, LayerId layer, const RuleParty& a, const RuleParty& b) const {
    const Rule& rule = m_table.rules[fit.row];
    const bool isSameNet = rule.kind == RuleKind::CopperToCopper && a.net.isValid() && a.net == b.net;
    return (!layer.isValid() || fit.layers[layer.row()]) && isSameNet == rule.isSameNet &&
           ((fitsSide(fit, 0, a) && fitsSide(fit, 1, b)) ||
            (isSymmetric(rule.kind) && fitsSide(fit, 0, b) && fitsSide(fit, 1, a)));
}

std::optional<std::size_t> RuleChoice::of(RuleKind kind, LayerId layer, const RuleParty& a, const RuleParty& b) const {
    const std::vector<Fit>& rules = m_rules[static_cast<std::size_t>(kind)];
    const auto last =
        std::find_if(rules.rbegin(), rules.rend(), [&](const Fit& fit) { return fits(fit, layer, a, b); });
    return last == rules.rend() ? std::nullopt : std::optional(last->row);
}

bool RuleChoice::isOn(RuleKind kind, LayerId layer) const {
    return std::ranges::any_of(m_rules[static_cast<std::size_t>(kind)],
                               [&](const Fit& fit) { return fit.layers[layer.row()]; });
}

std::string RuleChoice::whyUnused(std::size_t rule, const std::vector<HoleClass>& holes) const {
    const Rule& own = m_table.rules[rule];
    for (std::size_t side = 0; side < holeSidesOf(own.kind); ++side) {
        const std::string why = whyWithoutHoles(own, side, holes);
        if (!why.empty()) {
            return why;
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
    std::ranges::transform(m_rules[static_cast<std::size_t>(kind)], std::back_inserter(rows), &Fit::row);
    return rows;
}

std::vector<std::string> RuleChoice::emptyClassesOf(std::size_t rule) const {
    std::vector<std::string> empty;
    for (const std::string& name : m_table.rules[rule].classes) {
        const std::uint64_t mask = maskOf(name);
        const bool isEmpty =
            std::ranges::none_of(m_classesOf, [&](std::uint64_t classes) { return (classes & mask) != 0; });
        if (!name.empty() && isEmpty) {
            empty.push_back(name);
        }
    }
    return empty;
}

std::vector<RuleChoice::Stray> RuleChoice::straysOf(std::size_t rule) const {
    const auto& classes = m_table.rules[rule].classes;
    const std::vector<std::string> empty = emptyClassesOf(rule);
    std::vector<Stray> strays;
    std::ranges::copy_if(m_strays, std::back_inserter(strays), [&](const Stray& stray) {
        return std::ranges::count(classes, stray.netClass) > 0 && std::ranges::count(empty, stray.netClass) == 0;
    });
    return strays;
}

bool RuleChoice::hasNoLayer(std::size_t rule) const {
    const std::vector<Fit>& rules = m_rules[static_cast<std::size_t>(m_table.rules[rule].kind)];
    const auto fit = std::ranges::find(rules, rule, &Fit::row);
    return !m_table.rules[rule].layer.empty() && fit != rules.end() && std::ranges::count(fit->layers, true) == 0;
}

std::string RuleChoice::whyWithoutLayer(const Document& document, std::size_t rule, LayerId only) const {
    const std::string& wanted = m_table.rules[rule].layer;
    const std::vector<Fit>& rules = m_rules[static_cast<std::size_t>(m_table.rules[rule].kind)];
    const auto fit = std::ranges::find(rules, rule, &Fit::row);
    if (wanted.empty() || fit == rules.end()) {
        return {};
    }
    if (hasNoLayer(rule)) {
        const RulePlane plane = planeOf(m_table.rules[rule].kind);
        const bool isAnywhere = std::ranges::count(m_planes, plane) > 0;
        const std::string what = plane == RulePlane::Copper ? "layer" : nameOf(plane);
        return isFace(wanted) && isAnywhere ? "the step has no " + wanted + ' ' + what : "";
    }
    const bool isBeyond = only.isValid() && !fit->layers[only.row()];
    return !isBeyond ? ""
                     : "it is for " + std::string(isFace(wanted) ? wanted + " layers" : "layer " + wanted) +
                           ", only layer " + document.layer(only).name + " is checked";
}

std::string RuleChoice::whyMisnamed(std::size_t rule) const {
    const Rule& own = m_table.rules[rule];
    const bool isMisnamed = hasNoLayer(rule) && !isFace(own.layer);
    return isMisnamed ? std::string("no ") + nameOf(planeOf(own.kind)) + " fits " + own.layer : "";
}

std::uint64_t RuleChoice::maskOf(const std::string& name) const {
    const auto row = std::ranges::find(m_classes, name, &NetClass::name) - m_classes.begin();
    return name.empty() ? ~std::uint64_t{0} : std::uint64_t{1} << static_cast<unsigned>(row);
}

/// A net of no class, and copper without a net, fit "any" alone; its mask has all bits, theirs must have one.
std::uint64_t RuleChoice::classesOf(NetId net) const {
    constexpr std::uint64_t kAny = std::uint64_t{1} << 63U;
    return kAny | (net.isValid() ? m_classesOf[net.row()] : 0);
}

}  // namespace model
