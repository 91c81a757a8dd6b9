#include "model/clearance/design_rule_check.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <tuple>

#include "model/clearance/annular_ring.h"
#include "model/clearance/layer_geometry.h"
#include "model/figures/distance.h"

namespace model {

namespace {

constexpr Nm kConcentric = 1000;  ///< holes this near to each other's middle are one hole, drilled twice

bool areConcentric(const Box& a, const Box& b) {
    const auto twice = [](const Box& box) {
        return base::PointD{double{1} * box.min.x + box.max.x, double{1} * box.min.y + box.max.y};
    };
    return std::hypot(twice(a).x - twice(b).x, twice(a).y - twice(b).y) <= 2 * kConcentric;
}

/// Which rule holds between two nets.
class ClassRules {
public:
    ClassRules(const Document& document, const RuleTable& table) : m_table(table), m_classes(document.nets.size()) {
        for (std::size_t row = 0; row < table.classes.size(); ++row) {
            for (std::size_t net = 0; net < m_classes.size(); ++net) {
                const bool isIn = std::ranges::any_of(table.classes[row].nets, [&](const std::string& pattern) {
                    return fitsWildcard(document.nets[net].name, pattern);
                });
                m_classes[net] |= (isIn ? std::uint64_t{1} : 0) << row;
            }
        }
        for (std::size_t row = 0; row < table.rules.size(); ++row) {
            if (table.rules[row].kind == RuleKind::CopperToCopper && table.rules[row].isOn) {
                m_rules.push_back({row, maskOf(table.rules[row].classes[0]), maskOf(table.rules[row].classes[1])});
            }
        }
    }

    /// None if no rule fits.
    [[nodiscard]] std::optional<std::size_t> between(NetId a, NetId b) const {
        const std::uint64_t ofA = classesOf(a);
        const std::uint64_t ofB = classesOf(b);
        std::optional<std::size_t> last;
        for (const Fit& rule : m_rules) {
            const bool fits = ((ofA & rule.first) != 0 && (ofB & rule.second) != 0) ||
                              ((ofA & rule.second) != 0 && (ofB & rule.first) != 0);
            last = fits ? rule.row : last;
        }
        return last;
    }

    [[nodiscard]] double reach() const {
        Nm most = 0;
        for (const Fit& rule : m_rules) {
            most = std::max(most, m_table.rules[rule.row].least);
        }
        return most;
    }

private:
    struct Fit {
        std::size_t row;
        std::uint64_t first;
        std::uint64_t second;
    };

    [[nodiscard]] std::uint64_t maskOf(const std::string& name) const {
        const auto at = std::ranges::find(m_table.classes, name, &NetClass::name);
        return name.empty() ? ~std::uint64_t{0} : std::uint64_t{1} << (at - m_table.classes.begin());
    }
    /// A net of no class, and copper without a net, fit "any" alone; its mask has all bits, theirs must have one.
    [[nodiscard]] std::uint64_t classesOf(NetId net) const {
        constexpr std::uint64_t kAny = std::uint64_t{1} << 63U;
        return kAny | (net.isValid() ? m_classes[net.row()] : 0);
    }

    const RuleTable& m_table;
    std::vector<std::uint64_t> m_classes;  ///< by net
    std::vector<Fit> m_rules;
};

class Check {
public:
    Check(const Document& document, const RuleTable& table, base::Progress& progress)
        : m_document(document), m_table(table), m_classRules(document, table), m_progress(progress) {}

    [[nodiscard]] RuleReport run() {
        m_report.counts.resize(m_table.rules.size());
        for (std::size_t row = 0; row < m_document.layers.size() && !m_progress.isCancelled(); ++row) {
            const LayerId layer{row};
            if (m_document.layers[row].isCopper()) {
                checkCopper(layer);
            } else if (isMask(m_document.layers[row])) {
                checkMask(layer);
            }
            m_progress.setFraction(static_cast<float>(row + 1) / static_cast<float>(m_document.layers.size()));
        }
        checkHoles();
        note();
        std::ranges::sort(m_report.findings, {}, [](const RuleFinding& f) {
            return std::tuple(f.rule, f.spacing.distance, f.layer, f.a, f.b);
        });
        for (const RuleFinding& finding : m_report.findings) {
            ++m_report.counts[finding.rule];
        }
        return std::move(m_report);
    }

private:
    /// As the job has it, with its openings.
    static bool isMask(const Layer& layer) { return layer.type == LayerType::SolderMask && !layer.isSynthetic; }

    [[nodiscard]] NetId netOf(ElementId element) const { return m_document.elements.net[element.row()]; }

    /// The last rule of a kind that is on; none if the table has none.
    [[nodiscard]] std::optional<std::size_t> ruleOf(RuleKind kind) const {
        const auto last = std::find_if(m_table.rules.rbegin(), m_table.rules.rend(),
                                       [kind](const Rule& rule) { return rule.kind == kind && rule.isOn; });
        return last == m_table.rules.rend() ? std::nullopt
                                            : std::optional<std::size_t>(m_table.rules.rend() - last - 1);
    }

    void add(std::size_t rule, LayerId layer, ElementId a, ElementId b, const Spacing& spacing) {
        if (spacing.distance < m_table.rules[rule].least) {
            m_report.findings.push_back({rule, layer, a, b, spacing});
        }
    }

    /// Adds the closest pairs that break a rule.
    void addPairs(std::size_t rule, LayerId layer, const LayerGeometry& a, const LayerGeometry& b,
                  PairRequest request) {
        request.reach = m_table.rules[rule].least;
        for (const FigurePair& pair : closestPairs(a, b, request, m_progress)) {
            add(rule, layer, a.elementOf(pair.a), b.elementOf(pair.b), pair.spacing);
        }
    }

    void checkCopper(LayerId layer) {
        const LayerGeometry copper = copperGeometry(m_document, layer);
        checkNets(layer, copper);
        checkToHoles(layer);
        checkToEdge(layer, copper);
        if (const auto rule = ruleOf(RuleKind::AnnularRing)) {
            for (const AnnularRing& ring : annularRings(m_document, layer, m_table.rules[*rule].least)) {
                add(*rule, layer, ring.hole, ring.pad, ring.width);
            }
        }
    }

    void checkNets(LayerId layer, const LayerGeometry& copper) {
        const auto net = [&](std::uint32_t row) { return netOf(copper.elementOf(row)); };
        PairRequest request = requestByNets(m_document, copper);
        request.reach = m_classRules.reach();
        request.isWanted = [&](std::uint32_t a, std::uint32_t b) {
            return net(a) != net(b) && m_classRules.between(net(a), net(b));
        };
        if (request.reach <= 0) {
            return;
        }
        for (const FigurePair& pair : closestPairs(copper, copper, request, m_progress)) {
            add(*m_classRules.between(net(pair.a), net(pair.b)), layer, copper.elementOf(pair.a),
                copper.elementOf(pair.b), pair.spacing);
        }
    }

    void checkToHoles(LayerId layer) {
        const auto rule = ruleOf(RuleKind::CopperToHole);
        if (!rule) {
            return;
        }
        const LayerGeometry copper = layerGeometry(m_document, layer);
        const LayerGeometry holes = holeGeometry(m_document, layer);
        PairRequest request;
        request.isWanted = [&](std::uint32_t a, std::uint32_t b) {
            const ElementId hole = holes.elementOf(b);
            const bool isPlated = isPlatedHole(m_document.elements.flags[hole.row()]);
            return !isPlated || netOf(copper.elementOf(a)) != netOf(hole);
        };
        addPairs(*rule, layer, copper, holes, request);
    }

    void checkToEdge(LayerId layer, const LayerGeometry& copper) {
        const auto rule = ruleOf(RuleKind::CopperToEdge);
        if (rule && m_document.profile.isValid()) {
            addPairs(*rule, layer, copper, edgeGeometry(m_document), {});
        }
    }

    void checkMask(LayerId layer) {
        const auto rule = ruleOf(RuleKind::MaskSliver);
        if (!rule) {
            return;
        }
        const LayerGeometry openings = layerGeometry(m_document, layer);
        PairRequest request;
        request.reach = m_table.rules[*rule].least;
        request.mayTouch = [](std::uint32_t, std::uint32_t) { return false; };  // they are one opening
        for (const FigurePair& pair : closestPairs(openings, openings, request, m_progress)) {
            if (!isOpenBetween(openings, pair.spacing)) {
                add(*rule, layer, openings.elementOf(pair.a), openings.elementOf(pair.b), pair.spacing);
            }
        }
    }

    /// A third opening may leave nothing of what is between two.
    static bool isOpenBetween(const LayerGeometry& openings, const Spacing& spacing) {
        FigureTable middle;
        middle.addTrack(spacing.from, spacing.to, 0.0);
        FigureTable point;
        const PointD half{(spacing.from.x + spacing.to.x) / 2, (spacing.from.y + spacing.to.y) / 2};
        point.addTrack(half, half, 0.0);
        bool isOpen = false;
        openings.visitNear(middle.box(0), 0.0, [&](std::uint32_t row) {
            isOpen = isOpen || spacingBetween(point, 0, openings.figures(), row, kTouchNm).has_value();
        });
        return isOpen;
    }

    void checkHoles() {
        const auto rule = ruleOf(RuleKind::HoleToHole);
        if (!rule) {
            return;
        }
        FigureTable figures;
        for (const Layer& layer : m_document.layers) {
            for (std::uint32_t i = layer.elements.first; i < layer.elements.first + layer.elements.count; ++i) {
                if ((m_document.elements.flags[i] & kHole) != 0) {
                    figures.add(m_document, ElementId{i});
                }
            }
        }
        const LayerGeometry holes(std::move(figures));
        PairRequest request;
        request.reach = m_table.rules[*rule].least;
        request.isWanted = [&](std::uint32_t a, std::uint32_t b) { return areApart(holes, a, b); };
        for (const FigurePair& pair : closestPairs(holes, holes, request, m_progress)) {
            const ElementId hole = holes.elementOf(pair.a);
            add(*rule, m_document.elements.layer[hole.row()], hole, holes.elementOf(pair.b), pair.spacing);
        }
    }

    /// Two holes, not one that is drilled twice, and both pass some layer.
    [[nodiscard]] bool areApart(const LayerGeometry& holes, std::uint32_t a, std::uint32_t b) const {
        const Layer& layerA = m_document.layer(m_document.elements.layer[holes.elementOf(a).row()]);
        const Layer& layerB = m_document.layer(m_document.elements.layer[holes.elementOf(b).row()]);
        const bool isStacked = layerA.spanTop.isValid() && layerB.spanTop.isValid() &&
                               (layerA.spanBottom < layerB.spanTop || layerB.spanBottom < layerA.spanTop);
        return holes.elementOf(a) != holes.elementOf(b) && !isStacked &&
               !areConcentric(holes.figures().box(a), holes.figures().box(b));
    }

    void note() {
        if (m_document.nets.empty() && m_classRules.reach() > 0) {
            m_report.notes.emplace_back("the board has no nets, so copper was not held against copper");
        }
        if (!m_document.profile.isValid() && ruleOf(RuleKind::CopperToEdge)) {
            m_report.notes.emplace_back("the board has no outline, so copper was not held against its edge");
        }
        if (ruleOf(RuleKind::MaskSliver) && std::ranges::none_of(m_document.layers, isMask)) {
            m_report.notes.emplace_back("the board has no solder mask layer, so slivers are not checked");
        }
        if (ruleOf(RuleKind::AnnularRing)) {
            noteRings();
        }
    }

    void noteRings() {
        const HolesWithoutRings left = holesWithoutRings(m_document);
        const auto note = [&](std::size_t count, const char* why) {
            if (count > 0) {
                m_report.notes.push_back("plated holes whose annular rings were not measured because " +
                                         std::string(why) + ": " + std::to_string(count));
            }
        };
        note(left.notRound, "they are not round");
        note(left.withoutNet, "they have no net");
    }

    const Document& m_document;
    const RuleTable& m_table;
    ClassRules m_classRules;
    base::Progress& m_progress;
    RuleReport m_report;
};

}  // namespace

std::string sideOf(const Document& step, ElementId element) {
    if (!element.isValid()) {
        return "(board edge)";
    }
    const NetId net = step.elements.net[element.row()];
    return net.isValid() ? step.nets[net.row()].name : "(no net)";
}

base::Result<RuleReport> checkRules(const Document& document, const RuleTable& table, base::Progress& progress) {
    progress.beginPhase("Checking rules");
    RuleReport report = Check(document, table, progress).run();
    if (progress.isCancelled()) {
        return base::Error{base::ErrorCode::Cancelled, "cancelled"};
    }
    return report;
}

}  // namespace model
