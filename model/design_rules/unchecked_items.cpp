#include "model/design_rules/unchecked_items.h"

#include <algorithm>
#include <array>
#include <functional>
#include <iterator>
#include <map>
#include <set>
#include <utility>

#include "model/board/copies.h"
#include "model/board/diagnostic_facts.h"
#include "model/board/layers.h"
#include "model/clearance/layer_geometry.h"
#include "model/design_rules/rule_context.h"
#include "model/design_rules/unchecked_drills.h"
#include "model/geometry/box_index.h"

namespace model {

namespace {

using ElementTest = std::function<bool(std::uint32_t)>;

bool isCopperLayer(const Layer& layer) {
    return layer.isCopper();
}

/// Elements of layers.
std::size_t countOf(const Document& document, const std::function<bool(const Layer&)>& isWantedLayer,
                    const ElementTest& isWanted) {
    std::size_t count = 0;
    for (const Layer& layer : document.layers) {
        const Range range = isWantedLayer(layer) ? layer.elements : Range{};
        for (std::uint32_t i = range.first; i < range.first + range.count; ++i) {
            count += isWanted(i) ? 1 : 0;
        }
    }
    return count;
}

Box placed(const Box& box, const Placement& placement) {
    Box out;
    if (!box.isEmpty()) {
        for (const Point corner : {box.min, box.max, Point{box.min.x, box.max.y}, Point{box.max.x, box.min.y}}) {
            out.include(placement.apply(corner));
        }
    }
    return out;
}

bool keepsClearance(const Document& document, std::uint32_t element) {
    return document.layer(document.elements.layer[element]).isCopper() ||
           (document.elements.flags[element] & kHole) != 0;
}

/// Around the copper and holes of a step and of the copies on it.
Box copperExtent(const Document& step) {
    Box extent;
    for (std::uint32_t i = 0; i < step.elements.size(); ++i) {
        extent.include(keepsClearance(step, i) ? step.boxOf(ElementId{i}) : Box{});
    }
    for (const StepInstance& copy : step.instances) {
        extent.include(placed(copperExtent(*step.steps[copy.step]), copy.placement));
    }
    return extent;
}

bool hasWildcard(const std::string& pattern) {
    return pattern.find_first_of("*?") != std::string::npos;
}

std::string textOf(const RuleChoice::Stray& stray) {
    return "no net fits " + stray.pattern + " of the net class " + stray.netClass;
}

class Collector {
public:
    Collector(const Document& document, const RuleTable& table, const RuleChoice& choice)
        : m_document(document), m_table(table), m_choice(choice) {}

    std::vector<Unchecked> run() {
        addWhatIsMissing();
        addCopperWithoutNets();
        addNamesOfNothing();
        addEdges();
        addMask();
        addSilkscreen();
        addHoles();
        addCopies();
        std::ranges::stable_sort(m_items, {}, &Unchecked::rule);
        return std::move(m_items);
    }

private:
    using Names = std::vector<std::string>;

    /// "the net class power", "the name CLK*"
    static std::string wordsOf(const std::string& name) {
        return name.starts_with(kNetPrefix) ? "the name " + name.substr(kNetPrefix.size()) : "the net class " + name;
    }

    void add(RuleKind kind, std::size_t count, const char* one, const char* many, const std::string& why) {
        if (count > 0) {
            for (const std::size_t rule : m_choice.rowsOf(kind)) {
                m_items.push_back({rule, count, count == 1 ? one : many, why});
            }
        }
    }

    [[nodiscard]] std::size_t copperCount() const {
        return countOf(m_document, isCopperLayer, [](std::uint32_t) { return true; });
    }

    /// What could not be read may break every rule.
    void addWhatIsMissing() {
        const Diagnostic* first = firstError(m_document.diagnostics);
        if (first == nullptr) {
            return;
        }
        const std::size_t errors = m_document.diagnostics.count(Severity::Error);
        const std::string place = first->file.empty() ? "" : placeOf(*first) + ": ";
        const std::string why = "not all of the job could be read: " + place + first->text;
        for (std::size_t rule = 0; rule < m_table.rules.size(); ++rule) {
            if (m_table.rules[rule].isOn) {
                m_items.push_back({rule, errors, errors == 1 ? "error" : "errors", why});
            }
        }
    }

    void addCopperWithoutNets() {
        if (m_document.nets.empty()) {
            for (const RuleKind kind :
                 {RuleKind::CopperToCopper, RuleKind::MaskToForeign, RuleKind::AcuteAngle, RuleKind::Creepage}) {
                add(kind, copperCount(), "copper element", "copper elements", "the board has no nets");
            }
        }
    }

    void addNamesOfNothing() {
        for (std::size_t rule = 0; rule < m_table.rules.size(); ++rule) {
            for (const std::string& name : m_table.rules[rule].isOn ? m_choice.emptyClassesOf(rule) : Names{}) {
                m_items.push_back({rule, 0, "", "no net fits " + wordsOf(name)});
            }
            addStrays(rule);
            const std::string misnamed = m_choice.whyMisnamed(rule);
            if (!misnamed.empty()) {
                m_items.push_back({rule, 0, "", misnamed});
            }
        }
    }

    /// A name that is misspelt leaves its net out of the class, though others are in it. Patterns are notes: they may
    /// be meant for nets that some boards have.
    void addStrays(std::size_t rule) {
        for (const RuleChoice::Stray& stray : m_choice.straysOf(rule)) {
            if (m_table.rules[rule].isOn && !hasWildcard(stray.pattern)) {
                m_items.push_back({rule, 0, "", textOf(stray)});
            }
        }
    }

    void addEdges() {
        const bool hasOutline = m_document.profile.isValid();
        if (!hasOutline || m_document.profileSource == Source::Assumed) {
            const char* why = hasOutline ? "the outline of the board is assumed" : "the board has no outline";
            add(RuleKind::Creepage, copperCount(), "copper element", "copper elements", why);
            add(RuleKind::CopperToEdge, copperCount(), "copper element", "copper elements", why);
        }
        const auto hasOwn = [](const Layer& layer) { return layer.isCopper() && layer.profile.isValid(); };
        add(RuleKind::CopperToEdge, static_cast<std::size_t>(std::ranges::count_if(m_document.layers, hasOwn)),
            "copper layer", "copper layers", "the outline of the layer itself is not held against its copper");
    }

    void addMask() {
        if (std::ranges::none_of(m_document.layers, isMask)) {
            for (const RuleKind kind : {RuleKind::MaskSliver, RuleKind::MaskToCopper, RuleKind::MaskToForeign}) {
                add(kind, copperCount(), "copper element", "copper elements", "the job has no solder mask layer");
            }
        }
    }

    void addSilkscreen() {
        if (std::ranges::count(silkscreenPrints(m_document), true) == 0) {
            add(RuleKind::SilkToPad, copperCount(), "copper element", "copper elements", "the job has no silkscreen");
        }
    }

    void addHoles() {
        const auto& flags = m_document.elements.flags;
        const auto isHole = [&](std::uint32_t i) { return (flags[i] & kHole) != 0; };
        const auto isPlated = [&](std::uint32_t i) { return isPlatedHole(flags[i]); };
        addHolesWithoutSpan(RuleKind::CopperToCopper, isPlated);
        addHolesWithoutSpan(RuleKind::CopperToHole, isHole);
        addHolesWithoutSpan(RuleKind::AnnularRing, isPlated);
        addHolesWithoutSize(RuleKind::CopperToHole, isHole);
        addHolesWithoutSize(RuleKind::HoleToHole, isHole);
        addHolesWithoutSize(RuleKind::AnnularRing, isPlated);
        std::ranges::move(uncheckedDrills(m_document, m_choice), std::back_inserter(m_items));
    }

    void addHolesWithoutSpan(RuleKind kind, const ElementTest& isWanted) {
        for (const Layer& layer : m_document.layers) {
            const bool isThis = !layer.spanTop.isValid() || !layer.spanBottom.isValid();
            const auto isLayer = [&](const Layer& other) { return isThis && &other == &layer; };
            add(kind, countOf(m_document, isLayer, isWanted), "hole", "holes",
                "layer " + layer.name + " does not say which copper layers it passes");
        }
    }

    void addHolesWithoutSize(RuleKind kind, const ElementTest& isWanted) {
        const auto isSizeless = [&](std::uint32_t i) { return isWanted(i) && hasNoSize(m_document, ElementId{i}); };
        add(kind,
            countOf(
                m_document, [](const Layer&) { return true; }, isSizeless),
            "hole", "holes", "the job gives them no size");
    }

    /// Each rule has a limit of its own: what is farther apart than that cannot break it.
    void addCopies() {
        constexpr std::array kKinds = {RuleKind::CopperToCopper, RuleKind::CopperToHole,  RuleKind::HoleToHole,
                                       RuleKind::MaskSliver,     RuleKind::MaskToForeign, RuleKind::Creepage};
        if (m_document.instances.empty()) {
            return;
        }
        const std::vector<Box> boxes = boxesOfCopies();
        const BoxIndex index(boxes);
        const std::vector<HoleClass> holes = holesOfAllSteps();
        std::map<Nm, std::size_t> pairs;  // by limit
        for (const RuleKind kind : kKinds) {
            for (const std::size_t rule : m_choice.rowsOf(kind)) {
                const auto [known, isNew] = pairs.try_emplace(m_table.rules[rule].least, 0);
                known->second = isNew ? pairsOfCopies(boxes, index, known->first) : known->second;
                if (known->second > 0 && m_choice.whyUnused(rule, holes).empty()) {
                    m_items.push_back({rule, known->second, known->second == 1 ? "pair" : "pairs",
                                       "copies of steps, or a copy and an element, may come closer than the limit"});
                }
            }
        }
    }

    /// The kinds of holes of the step and of all copies on it, whatever their depth.
    [[nodiscard]] std::vector<HoleClass> holesOfAllSteps() const {
        std::vector<HoleClass> all;
        for (const Document* step : distinctSteps(m_document)) {
            std::ranges::copy(holeClassesOf(*step), std::back_inserter(all));
        }
        return all;
    }

    /// Around the copper and holes of each copy.
    [[nodiscard]] std::vector<Box> boxesOfCopies() const {
        std::vector<Box> extents;
        for (const auto& step : m_document.steps) {
            extents.push_back(copperExtent(*step));
        }
        std::vector<Box> boxes;
        for (const StepInstance& copy : m_document.instances) {
            boxes.push_back(placed(extents[copy.step], copy.placement));
        }
        return boxes;
    }

    /// Copies whose boxes come within reach of each other, and elements within reach of a copy.
    [[nodiscard]] std::size_t pairsOfCopies(const std::vector<Box>& boxes, const BoxIndex& index, Nm reach) const {
        std::size_t pairs = 0;
        for (std::uint32_t i = 0; i < boxes.size(); ++i) {
            index.visit(boxes[i].grownBy(reach), [&](std::uint32_t other) { pairs += other > i ? 1 : 0; });
        }
        for (std::uint32_t i = 0; i < m_document.elements.size(); ++i) {
            if (keepsClearance(m_document, i)) {
                index.visit(m_document.boxOf(ElementId{i}).grownBy(reach), [&](std::uint32_t) { ++pairs; });
            }
        }
        return pairs;
    }

    const Document& m_document;
    const RuleTable& m_table;
    const RuleChoice& m_choice;
    std::vector<Unchecked> m_items;
};

}  // namespace

std::vector<std::string> patternsOfNothing(const RuleTable& table, const RuleChoice& choice) {
    std::set<std::string> texts;
    for (std::size_t rule = 0; rule < table.rules.size(); ++rule) {
        for (const RuleChoice::Stray& stray : choice.straysOf(rule)) {
            if (table.rules[rule].isOn && hasWildcard(stray.pattern)) {
                texts.insert(textOf(stray));
            }
        }
    }
    return {texts.begin(), texts.end()};
}

std::vector<Unchecked> uncheckedItems(const Document& document, const RuleTable& table, const RuleChoice& choice) {
    return Collector(document, table, choice).run();
}

}  // namespace model
