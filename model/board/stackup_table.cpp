#include "model/board/stackup_table.h"

#include <algorithm>
#include <string_view>

#include "model/base/ascii.h"
#include "model/board/stackup.h"

namespace model {

namespace {

bool isCore(const StackupRow& row) {
    return isCopper(row) || row.type == LayerType::Dielectric;
}

StackupKind dielectricKind(const Material& material) {
    const std::string type = base::lowerCase(material.type);
    return type == "core" ? StackupKind::Core : type == "prepreg" ? StackupKind::Prepreg : StackupKind::Dielectric;
}

StackupKind kindOfUse(LayerUse use, StackupKind otherwise) {
    switch (use) {
        case LayerUse::Coverlay: return StackupKind::Coverlay;
        case LayerUse::Adhesive: return StackupKind::Adhesive;
        case LayerUse::Stiffener: return StackupKind::Stiffener;
        default: return otherwise;
    }
}

bool counts(StackupKind kind) {
    return kind <= StackupKind::Stiffener;
}

/// Rows from the first to the last copper of a part; the same twice behind the rows if it has none.
struct CopperRange {
    std::size_t first;
    std::size_t last;
};

CopperRange copperOf(const std::vector<StackupRow>& rows, const std::vector<bool>& has) {
    CopperRange range{rows.size(), rows.size()};
    for (std::size_t i = 0; i < rows.size(); ++i) {
        if (has[i] && isCopper(rows[i])) {
            range.first = std::min(range.first, i);
            range.last = i;
        }
    }
    return range;
}

/// Does a zone have the row's layer, or what decides for it?
bool isIn(const Zone& zone, const std::vector<StackupRow>& rows, std::size_t row) {
    if (rows[row].layer.isValid()) {
        return zone.has(rows[row].layer);
    }
    const auto below = std::find_if(rows.begin() + static_cast<std::ptrdiff_t>(row), rows.end(), isCopper);
    const auto above = std::find_if(rows.rend() - static_cast<std::ptrdiff_t>(row), rows.rend(), isCopper);
    return above != rows.rend() && zone.has(above->layer) && (below == rows.end() || zone.has(below->layer));
}

void addThicknesses(const Document& document, Substack& part) {
    const std::vector<StackupRow>& rows = document.stackup.rows;
    const CopperRange copper = copperOf(rows, part.has);
    const bool isSingle = copper.first == copper.last;
    for (std::size_t i = 0; i < rows.size(); ++i) {
        const bool isBetween = i >= copper.first && i <= copper.last;
        const bool isCounted = part.has[i] && counts(kindOf(rows[i], document)) && (!isBetween || isCore(rows[i]));
        part.overall += isCounted ? rows[i].thickness : 0;
        part.cumulative.push_back(isCounted ? std::optional(part.overall) : std::nullopt);
        // The substrate of a single copper layer counts for itself.
        const bool isBoard = isSingle ? substrateOf(rows, copper.first).has(i) : isBetween && isCore(rows[i]);
        part.copperToCopper += part.has[i] && isBoard ? rows[i].thickness : 0;
    }
}

}  // namespace

const char* toString(StackupKind kind) {
    constexpr const char* kNames[] = {"copper",   "core",       "prepreg",   "dielectric", "solder_mask",
                                      "coverlay", "adhesive",   "stiffener", "finish",     "conductive_paste",
                                      "paste",    "silkscreen", "other_mask"};
    return kNames[static_cast<std::size_t>(kind)];
}

StackupKind kindOf(const StackupRow& row, const Document& document) {
    const LayerUse use = row.layer.isValid() ? document.layer(row.layer).use : LayerUse::Plain;
    const bool isFinish = base::lowerCase(row.name).find("finish") != std::string::npos;
    switch (row.type) {
        case LayerType::Signal:
        case LayerType::PowerGround:
        case LayerType::Mixed: return StackupKind::Copper;
        case LayerType::Dielectric: return dielectricKind(row.material);
        case LayerType::SolderMask: return kindOfUse(use, StackupKind::SolderMask);
        case LayerType::SolderPaste: return StackupKind::Paste;
        case LayerType::SilkScreen: return StackupKind::Silkscreen;
        case LayerType::ConductivePaste: return isFinish ? StackupKind::Finish : StackupKind::ConductivePaste;
        default: return kindOfUse(use, isFinish ? StackupKind::Finish : StackupKind::OtherMask);
    }
}

std::vector<Substack> substacksOf(const Document& document) {
    const std::vector<StackupRow>& rows = document.stackup.rows;
    std::vector<Substack> parts;
    if (rows.empty()) {
        return parts;
    }
    for (const Zone& zone : document.zones) {
        Substack& part = parts.emplace_back();
        part.name = zone.name;
        for (std::size_t i = 0; i < rows.size(); ++i) {
            const auto has = [&](const Zone& any) { return isIn(any, rows, i); };
            part.has.push_back(has(zone) || std::ranges::none_of(document.zones, has));
        }
    }
    if (parts.empty()) {
        parts.emplace_back().has.assign(rows.size(), true);
    }
    for (Substack& part : parts) {
        addThicknesses(document, part);
    }
    return parts;
}

}  // namespace model
