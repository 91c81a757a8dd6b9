#include "model/design_rules/unchecked_drills.h"

#include <algorithm>
#include <array>
#include <functional>
#include <map>
#include <string>

#include "model/clearance/layer_geometry.h"
#include "model/design_rules/hole_depths.h"

namespace model {

namespace {

constexpr std::array kKinds = {RuleKind::HoleSize, RuleKind::SlotWidth, RuleKind::AspectRatio};

class DrillCollector {
public:
    DrillCollector(const Document& document, const RuleChoice& choice)
        : m_document(document), m_choice(choice), m_classes(holeClassesOf(document)) {}

    std::vector<Unchecked> run() {
        for (const RuleKind kind : kKinds) {
            add(
                kind, [this](ElementId hole) { return hasNoSize(m_document, hole); }, "the job gives them no size");
        }
        add(
            RuleKind::SlotWidth, [this](ElementId hole) { return isArea(hole); },
            "drawn as areas, whose width is not measured");
        if (!m_choice.rowsOf(RuleKind::AspectRatio).empty()) {
            addDepths();
        }
        return std::move(m_items);
    }

private:
    using Test = std::function<bool(ElementId)>;

    void add(RuleKind kind, const Test& isWanted, const std::string& why) {
        std::map<std::size_t, std::size_t> counts;  // by rule
        for (std::uint32_t i = 0; i < m_classes.size(); ++i) {
            const ElementId hole{i};
            const bool isMet = m_classes[i] != HoleClass::Any && isHoleFor(m_document, kind, hole);
            const auto rule = isMet ? m_choice.of(kind, {}, {m_document.elements.net[i], m_classes[i]}) : std::nullopt;
            if (rule && isWanted(hole)) {
                ++counts[*rule];
            }
        }
        for (const auto& [rule, count] : counts) {
            m_items.push_back({rule, count, count == 1 ? "hole" : "holes", why});
        }
    }

    void addDepths() {
        for (const Layer& layer : m_document.layers) {
            if (!hasSpan(layer) && layer.elements.count > 0) {
                add(
                    RuleKind::AspectRatio, [&](ElementId hole) { return &layerOf(hole) == &layer; },
                    "layer " + layer.name + " does not say which copper layers it passes");
            }
        }
        HoleDepths depths(m_document);
        const auto isOfNoDepth = [&](ElementId hole) {
            return hasSpan(layerOf(hole)) && !hasNoSize(m_document, hole) && !depths.of(hole);
        };
        add(RuleKind::AspectRatio, isOfNoDepth, "the job does not say how thick the dielectrics are that they pass");
    }

    [[nodiscard]] static bool hasSpan(const Layer& layer) {
        return layer.spanTop.isValid() && layer.spanBottom.isValid();
    }
    [[nodiscard]] bool isArea(ElementId hole) const {
        return m_document.elements.kind[hole.row()] == ElementKind::Area;
    }
    [[nodiscard]] const Layer& layerOf(ElementId hole) const {
        return m_document.layer(m_document.elements.layer[hole.row()]);
    }

    const Document& m_document;
    const RuleChoice& m_choice;
    std::vector<HoleClass> m_classes;  ///< by element
    std::vector<Unchecked> m_items;
};

}  // namespace

std::vector<Unchecked> uncheckedDrills(const Document& document, const RuleChoice& choice) {
    const bool isAsked = std::ranges::any_of(kKinds, [&](RuleKind kind) { return !choice.rowsOf(kind).empty(); });
    return isAsked ? DrillCollector(document, choice).run() : std::vector<Unchecked>();
}

}  // namespace model
