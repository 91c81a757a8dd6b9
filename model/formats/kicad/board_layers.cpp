#include "model/formats/kicad/board_layers.h"

#include <algorithm>
#include <array>
#include <optional>
#include <utility>

#include "model/formats/kicad/text/values.h"

namespace model::kicad {

namespace {

using formats::DrawnJob;
using formats::DrawnLayer;
using formats::kNoRow;

constexpr int kInnermost = 30;
constexpr int kOldBottom = 31;
constexpr std::array<std::string_view, 3> kOutsideTop = {"F.SilkS", "F.Paste", "F.Mask"};
constexpr std::array<std::string_view, 3> kOutsideBottom = {"B.Mask", "B.Paste", "B.SilkS"};

/// 0 for F.Cu, n for In<n>.Cu, large for B.Cu; none for what is no copper.
std::optional<int> copperOrder(std::string_view name) {
    if (name == "F.Cu") {
        return 0;
    }
    if (name == "B.Cu") {
        return 1'000;
    }
    if (!name.starts_with("In") || !name.ends_with(".Cu") || name.size() > 8) {
        return {};
    }
    const std::optional<double> number = numberOf(name.substr(2, name.size() - 5));
    return number && *number >= 1 && *number < 1'000 ? std::optional(static_cast<int>(*number)) : std::nullopt;
}

LayerSide sideOf(std::string_view name) {
    return name.starts_with("F.")   ? LayerSide::Top
           : name.starts_with("B.") ? LayerSide::Bottom
           : copperOrder(name)      ? LayerSide::Inner
                                    : LayerSide::None;
}

LayerType typeOf(std::string_view name, std::string_view type) {
    if (copperOrder(name)) {
        return type == "power" ? LayerType::PowerGround : type == "mixed" ? LayerType::Mixed : LayerType::Signal;
    }
    return name.ends_with(".SilkS")   ? LayerType::SilkScreen
           : name.ends_with(".Mask")  ? LayerType::SolderMask
           : name.ends_with(".Paste") ? LayerType::SolderPaste
                                      : LayerType::Document;
}

/// The facts that begin at an item of a row of the stackup and end with the row or its next sub-layer.
LayerFacts factsOf(const Item& row, bool isDielectric, int sublayer) {
    LayerFacts facts;
    std::string colour;
    int at = 0;
    for (const Item item : row) {
        at += !item.isList() && item.source() == "addsublayer" ? 1 : 0;
        const std::string_view head = item.head();
        if (head.empty() || (at != sublayer && head != "type")) {
            continue;
        }
        const std::optional<double> value = numberOf(item.word(1));
        if (head == "thickness" && value && *value > 0.0) {
            facts.thicknessNm = *value * base::kNmPerMm;
        } else if (head == "material") {
            facts.material.name = item.text(1);
        } else if (head == "color" && !isDielectric && !item.text(1).empty()) {
            colour = item.text(1);
        } else if (head == "epsilon_r" && value && *value > 0.0) {
            facts.material.dielectricConstant = value;
        } else if (head == "loss_tangent" && value) {
            facts.material.lossTangent = value;
        } else if (head == "type" && isDielectric) {
            facts.material.type = item.text(1);
            std::ranges::transform(facts.material.type, facts.material.type.begin(),
                                   [](char c) { return c >= 'a' && c <= 'z' ? static_cast<char>(c - 'a' + 'A') : c; });
        }
    }
    if (!colour.empty()) {  // as other formats say it, "Liquid Ink, Green"
        facts.material.name += (facts.material.name.empty() ? "" : ", ") + colour;
    }
    return facts;
}

int sublayersOf(const Item& row) {
    int count = 0;
    for (const Item item : row) {
        count += !item.isList() && item.source() == "addsublayer" ? 1 : 0;
    }
    return count;
}

Item rowOf(const Item& stackup, std::string_view name) {
    for (const Item row : stackup) {
        if (row.head() == "layer" && row.word(1) == name) {
            return row;
        }
    }
    return {};
}

}  // namespace

std::vector<BoardLayers::Named> BoardLayers::named(const Item& layers, bool isOld) const {
    std::vector<Named> all;
    for (const Item layer : layers) {
        if (!layer.isList()) {
            continue;
        }
        Named named{layer.text(1), layer.text(3), std::string(layer.word(2))};
        const std::optional<double> number = numberOf(layer.word(0));
        const bool isCopper = number && *number >= 0 && *number <= kOldBottom && named.type != "user";
        if (isOld && isCopper && !copperOrder(named.name)) {
            const int order = static_cast<int>(*number);
            named.userName = named.name;
            named.name = order == 0 ? "F.Cu" : order > kInnermost ? "B.Cu" : "In" + std::to_string(order) + ".Cu";
        }
        if (named.userName.empty() || named.userName == "hide") {
            named.userName = named.name;
        }
        all.push_back(std::move(named));
    }
    return all;
}

void BoardLayers::add(const Named& layer, DrawnJob& job, std::string_view file) {
    const auto row = static_cast<std::int32_t>(job.layers.size());
    if (!m_rows.try_emplace(layer.name, row).second) {
        return;
    }
    m_rows.try_emplace(layer.userName, row);
    DrawnLayer drawn;
    drawn.name = layer.userName;
    drawn.file = file;
    drawn.type = typeOf(layer.name, layer.type);
    drawn.context = drawn.type == LayerType::Document ? LayerContext::Misc : LayerContext::Board;
    drawn.side = sideOf(layer.name);
    if (drawn.type == LayerType::Signal || drawn.type == LayerType::PowerGround || drawn.type == LayerType::Mixed) {
        m_copper.push_back(row);
    }
    job.layers.push_back(std::move(drawn));
    m_names.resize(job.layers.size());
    m_names.back() = layer.name;
}

void BoardLayers::addDielectrics(const Item& row, DrawnJob& job, std::string_view file) {
    const int sublayers = sublayersOf(row);
    for (int i = 0; i <= sublayers; ++i) {
        DrawnLayer layer;
        layer.name = row.text(1) + (i == 0 ? "" : " (" + std::to_string(i + 1) + ")");
        layer.file = file;
        layer.type = LayerType::Dielectric;
        layer.side = LayerSide::Inner;
        layer.facts = factsOf(row, true, i);
        job.layers.push_back(std::move(layer));
        m_names.resize(job.layers.size());
    }
}

void BoardLayers::addPhysical(const std::vector<Named>& layers, const Item& stackup, DrawnJob& job,
                              std::string_view file) {
    const auto addNamed = [&](std::string_view name) {
        const auto found = std::ranges::find(layers, name, &Named::name);
        if (found != layers.end()) {
            const std::size_t before = job.layers.size();
            add(*found, job, file);
            if (job.layers.size() > before) {
                job.layers.back().facts = factsOf(rowOf(stackup, name), false, 0);
            }
        }
    };
    std::ranges::for_each(kOutsideTop, addNamed);
    std::vector<std::pair<int, std::string_view>> copper;
    for (const Named& layer : layers) {
        if (const std::optional<int> order = copperOrder(layer.name)) {
            copper.emplace_back(*order, layer.name);
        }
    }
    std::ranges::sort(copper);
    for (const auto& [order, name] : copper) {
        addNamed(name);
        bool isBelow = false;
        for (const Item row : stackup) {
            if (row.head() != "layer") {
                continue;
            }
            if (isBelow && (copperOrder(row.word(1)) || row.word(1).starts_with("B."))) {
                break;
            }
            if (isBelow) {
                addDielectrics(row, job, file);
            }
            isBelow = isBelow || row.word(1) == name;
        }
    }
    std::ranges::for_each(kOutsideBottom, addNamed);
}

void BoardLayers::read(const Item& layers, const Item& stackup, bool isOld, DrawnJob& job, std::string_view file) {
    m_hasStackup = rowOf(stackup, "F.Cu").isThere() || rowOf(stackup, "B.Cu").isThere();
    const std::vector<Named> all = named(layers, isOld);
    addPhysical(all, m_hasStackup ? stackup : Item(), job, file);
    for (const Named& layer : all) {
        add(layer, job, file);
    }
}

std::int32_t BoardLayers::row(std::string_view name) const {
    const auto found = m_rows.find(name);
    return found == m_rows.end() ? kNoRow : found->second;
}

std::vector<std::int32_t> BoardLayers::rows(const Item& names) const {
    std::vector<std::int32_t> rows;
    bool isHead = true;
    for (const Item item : names) {
        const std::string_view name = item.source();
        if (!std::exchange(isHead, false) && !item.isList()) {
            const bool isAll = name.starts_with("*.");
            const bool isBoth = name.starts_with("F&B.");
            const std::string_view kind = name.substr(isAll ? 1 : isBoth ? 3 : 0);
            for (std::size_t i = 0; i < m_names.size() && (isAll || isBoth); ++i) {
                const bool isOuter = m_names[i].starts_with("F.") || m_names[i].starts_with("B.");
                if (m_names[i].ends_with(kind) && (isAll || isOuter)) {
                    rows.push_back(static_cast<std::int32_t>(i));
                }
            }
            if (!isAll && !isBoth && row(name) != kNoRow) {
                rows.push_back(row(name));
            }
        }
    }
    std::ranges::sort(rows);
    rows.erase(std::unique(rows.begin(), rows.end()), rows.end());
    return rows;
}

const std::string& BoardLayers::nameOf(std::int32_t row) const {
    static const std::string kNone;
    return row >= 0 && static_cast<std::size_t>(row) < m_names.size() ? m_names[static_cast<std::size_t>(row)] : kNone;
}

bool BoardLayers::isCopper(std::int32_t row) const {
    return std::ranges::find(m_copper, row) != m_copper.end();
}

std::vector<std::int32_t> BoardLayers::span(std::int32_t from, std::int32_t to) const {
    const auto a = std::ranges::find(m_copper, from);
    const auto b = std::ranges::find(m_copper, to);
    if (a == m_copper.end() || b == m_copper.end()) {
        return m_copper;
    }
    return {std::min(a, b), std::max(a, b) + 1};
}

std::int32_t BoardLayers::drills(std::int32_t from, std::int32_t to, bool isPlated, DrawnJob& job) {
    return drillRow(from, to, isPlated ? DrillKind::Plated : DrillKind::NonPlated, job);
}

std::int32_t BoardLayers::backDrills(std::int32_t from, std::int32_t to, DrawnJob& job) {
    return drillRow(from, to, DrillKind::BackDrill, job);
}

std::int32_t BoardLayers::wideDrills(std::int32_t from, std::int32_t to, DrawnJob& job) {
    return drillRow(from, to, DrillKind::Wide, job);
}

std::int32_t BoardLayers::drillRow(std::int32_t from, std::int32_t to, DrillKind kind, DrawnJob& job) {
    const std::vector<std::int32_t> passed = span(from, to);
    if (passed.empty()) {
        return kNoRow;
    }
    const auto [found, isNew] = m_drills.try_emplace({passed.front(), passed.back(), kind}, 0);
    if (isNew) {
        found->second = static_cast<std::int32_t>(job.layers.size());
        DrawnLayer layer;
        constexpr std::array<const char*, 4> kNames = {"drill_plated_", "drill_non-plated_", "back_drill_",
                                                       "wide_drill_"};
        layer.name = std::string(kNames[static_cast<std::size_t>(kind)]) +
                     job.layers[static_cast<std::size_t>(passed.front())].name + "-" +
                     job.layers[static_cast<std::size_t>(passed.back())].name;
        layer.file = job.layers[static_cast<std::size_t>(passed.front())].file;
        layer.type = LayerType::Drill;
        layer.side = LayerSide::Through;
        layer.use = kind == DrillKind::BackDrill ? LayerUse::Backdrill
                    : kind == DrillKind::Wide    ? LayerUse::DualDiameter
                                                 : LayerUse::Plain;
        layer.spanTop = passed.front();
        layer.spanBottom = passed.back();
        job.layers.push_back(std::move(layer));
        m_names.resize(job.layers.size());
    }
    return found->second;
}

}  // namespace model::kicad
