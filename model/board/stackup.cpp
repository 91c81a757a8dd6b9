#include "model/board/stackup.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <unordered_map>

#include "model/base/ascii.h"
#include "model/base/assert.h"
#include "model/board/holes.h"
#include "model/board/local_stack.h"

namespace model {

namespace {

/// How far above and below the outermost surface layer the planes of all other layers lie.
constexpr Nm kPasteDistance = 100'000;
/// Copper that takes an even share of the board may be this thick; beyond it the share is no copper thickness.
constexpr double kLeastCopperShare = 5'000;
constexpr double kMostCopperShare = 210'000;
/// Solder mask is thicker than this; Altium writes 2.54 µm where nothing is known.
constexpr double kLeastMask = 5'000;

struct Part {
    StackupRow row;
    bool isCopper = false;
    bool isCore = false;  ///< between the outer copper faces
    bool isKnown = false;
    std::optional<Nm> stated{};  ///< by the job
};

std::string inUm(double nm) {
    std::string text = std::to_string(std::round(nm / base::kNmPerUm * 10) / 10.0);
    text.erase(text.find_last_not_of('0') + 1);
    return text + (text.ends_with('.') ? "0 µm" : " µm");
}

bool isSurface(const Layer& layer) {
    switch (layer.type) {
        case LayerType::SolderMask:
        case LayerType::SolderPaste:
        case LayerType::SilkScreen:
        case LayerType::ConductivePaste:
        case LayerType::Mask: return layer.context == LayerContext::Board;
        default: return false;
    }
}

bool isBoardDielectric(const Layer& layer) {
    return layer.type == LayerType::Dielectric && layer.context == LayerContext::Board;
}

bool isPhysical(const Layer& layer) {
    return layer.isBoardCopper() || isBoardDielectric(layer) || isSurface(layer);
}

bool namesBottom(const Layer& layer) {
    const std::string name = base::lowerCase(layer.name);
    return name.find("bot") != std::string::npos || name.starts_with("b.");
}

struct SurfaceDefault {
    const char* kind;
    Nm thickness;
};

SurfaceDefault surfaceDefault(const Layer& layer) {
    switch (layer.use) {
        case LayerUse::Coverlay: return {"coverlay", kDefaultCoverlay};
        case LayerUse::Adhesive: return {"adhesive", kDefaultAdhesive};
        case LayerUse::Stiffener: return {"stiffener", kDefaultStiffener};
        default: break;
    }
    switch (layer.type) {
        case LayerType::SolderPaste:
        case LayerType::ConductivePaste: return {"paste", kDefaultPaste};
        case LayerType::SilkScreen: return {"silk screen", kDefaultSilk};
        case LayerType::SolderMask: return {"solder mask", kDefaultMask};
        default: return {"other mask", kDefaultMask};
    }
}

class StackupBuilder {
public:
    StackupBuilder(std::vector<Layer>& layers, const StackupFacts& facts, Diagnostics& diagnostics)
        : m_layers(layers),
          m_facts(facts),
          m_diagnostics(diagnostics),
          // Together the layers must stay within the coordinate range.
          m_most(std::min(kMostDielectric, base::kMaxCoordinate / 2.0 / static_cast<double>(layers.size() + 1))) {}

    std::vector<StackupRow> build() {
        m_board = checked("(board)", m_facts.boardNm, kMostDielectric);
        m_isBoardReplaced = m_board && isReplaced(*m_facts.boardNm, *m_board);
        findCopper();
        collectParts();
        fillUnknown();
        const Nm top = placeCore();
        placeSurfaceLayers(top);
        placeHoles(top);
        placePlanes(top);
        std::vector<StackupRow> rows;
        for (Part& part : m_parts) {
            rows.push_back(std::move(part.row));
        }
        return rows;
    }

private:
    void report(Severity severity, const std::string& text) { m_diagnostics.report(severity, "", 0, text); }

    void findCopper() {
        m_first = m_last = m_layers.size();
        for (std::size_t i = 0; i < m_layers.size(); ++i) {
            if (m_layers[i].isBoardCopper()) {
                m_first = std::min(m_first, i);
                m_last = i;
            }
        }
        m_isAlone = m_first < m_layers.size() && m_first == m_last;
        m_isBottomAlone = m_isAlone && isBottom(m_layers[m_first]);
        for (std::size_t i = m_first; i < m_layers.size(); ++i) {
            if (m_layers[i].isBoardCopper()) {
                m_layers[i].side = sideOfCopper(i);
            }
        }
    }

    /// Is the one copper layer the bottom one? By the job's word, by where its dielectrics are, or else by the name.
    [[nodiscard]] bool isBottom(const Layer& copper) const {
        const bool isUnder = hasDielectric(0, m_first);
        const bool isNamed = namesBottom(copper) && base::lowerCase(copper.name).find("top") == std::string::npos;
        const bool isAtBottom = isUnder != hasDielectric(m_first, m_layers.size()) ? isUnder : isNamed;
        return copper.side == LayerSide::Bottom || (copper.side != LayerSide::Top && isAtBottom);
    }

    [[nodiscard]] bool hasDielectric(std::size_t first, std::size_t end) const {
        while (first < end && !(isBoardDielectric(m_layers[first]) && isRow(first))) {
            ++first;
        }
        return first < end;
    }

    [[nodiscard]] LayerSide sideOfCopper(std::size_t i) const {
        const bool isTop = i == m_first && !m_isBottomAlone;
        return isTop ? LayerSide::Top : i == m_last ? LayerSide::Bottom : LayerSide::Inner;
    }

    /// A value of the job within its bounds; one outside is replaced by the bound and reported.
    std::optional<Nm> checked(const std::string& name, std::optional<double> value, double most) {
        if (!value || *value == 0.0) {
            return std::nullopt;
        }
        const double inside = std::clamp(*value, kLeastThickness, most);
        if (inside != *value) {
            report(Severity::Warning, "layer " + name + ": the job's thickness of " + inUm(*value) +
                                          " is absurd; taken as " + inUm(inside));
        }
        return static_cast<Nm>(std::llround(inside));
    }

    static bool isReplaced(double stated, Nm used) { return std::abs(stated - used) >= 1.0; }

    // ---- rows and what is known of them ----

    [[nodiscard]] bool isRow(std::size_t i) const { return isPhysical(m_layers[i]) && m_facts.layers[i].hasMaterial; }

    void collectParts() {
        for (std::size_t i = 0; i < m_layers.size(); ++i) {
            if (m_layers[i].isBoardCopper()) {
                addDielectricBefore();
                addLayer(i, kMostCopper);
            } else if (isRow(i)) {
                addLayer(i, m_most);
            }
        }
        if (m_isAlone && std::ranges::count_if(m_parts, &Part::isCore) == 1) {
            addSubstrate();
        }
    }

    void addLayer(std::size_t i, double most) {
        const Layer& layer = m_layers[i];
        const bool isCopper = layer.isBoardCopper();
        const bool isCore = isCopper || (isBoardDielectric(layer) && isWithin(i));
        const Source source = m_facts.layers[i].isAssumed ? Source::Assumed : Source::Job;
        StackupRow row{layer.name, LayerId{i}, layer.type, 0, 0, source, m_facts.layers[i].material};
        addPart({std::move(row), isCopper, isCore, false}, statedThickness(i), std::min(most, m_most));
    }

    /// Is a dielectric between copper layers, or what the only one lies on?
    [[nodiscard]] bool isWithin(std::size_t i) const {
        return m_isAlone ? (m_isBottomAlone ? i < m_first : i > m_first) : i > m_first && i < m_last;
    }

    std::optional<double> statedThickness(std::size_t i) {
        const std::optional<double> stated = m_facts.layers[i].thicknessNm;
        const bool isMask = m_layers[i].type == LayerType::SolderMask;
        if (isMask && stated && *stated > 0 && *stated < kLeastMask) {
            report(Severity::Info, "layer " + m_layers[i].name + ": the job's thickness of " + inUm(*stated) +
                                       " is too thin for a solder mask and not used");
            return std::nullopt;
        }
        return stated;
    }

    void addPart(Part part, std::optional<double> stated, double most) {
        part.row.name = uniqueName(part.row.name);
        part.stated = checked(part.row.name, stated, most);
        if (const ThicknessOverride* set = findOverride(part.row.name)) {
            part.row.thickness = set->thickness;
            part.row.source = Source::Session;
            part.isKnown = true;
        } else if (const std::optional<Nm> nm = part.stated) {
            part.row.thickness = *nm;
            part.row.source = isReplaced(*stated, *nm) ? Source::Assumed : part.row.source;
            part.isKnown = true;
        }
        m_parts.push_back(std::move(part));
    }

    /// A dielectric of two plies may be listed twice under one name.
    std::string uniqueName(const std::string& name) {
        std::string unique = name;
        int& count = m_used[base::lowerCase(name)];
        while (++count > 1) {
            unique = name + " (" + std::to_string(count) + ")";
            if (m_used.try_emplace(base::lowerCase(unique), 1).second) {
                break;
            }
        }
        return unique;
    }

    const ThicknessOverride* findOverride(const std::string& name) const {
        const auto found = std::ranges::find_if(
            m_facts.set, [&](const ThicknessOverride& set) { return base::equalsIgnoringCase(set.layer, name); });
        return found == m_facts.set.end() ? nullptr : &*found;
    }

    Part spacingBelow(std::size_t copper) const {
        StackupRow row{"below " + m_layers[copper].name, {}, LayerType::Dielectric, 0, 0, Source::Job, {}};
        row.material = m_facts.layers[copper].below;
        return {std::move(row), false, true, false};
    }

    /// Two copper layers without a dielectric between them: it is only known from the upper one, if at all.
    void addDielectricBefore() {
        const auto last = std::find_if(m_parts.rbegin(), m_parts.rend(), [](const Part& part) { return part.isCore; });
        if (last != m_parts.rend() && last->isCopper) {
            const std::size_t above = last->row.layer.row();
            addPart(spacingBelow(above), m_facts.layers[above].belowNm, m_most);
        }
    }

    /// A board of one copper layer has its substrate below it, or above it where that is the bottom layer.
    void addSubstrate() {
        const std::string where = m_isBottomAlone ? "above" : "below";
        Part part = spacingBelow(m_first);
        part.row.name = where + " " + m_layers[m_first].name;
        const auto copper = std::ranges::find_if(m_parts, &Part::isCopper);
        part.row.name = uniqueName(part.row.name);
        const ThicknessOverride* set = findOverride(part.row.name);
        part.row.thickness = set != nullptr ? set->thickness : m_board.value_or(kDefaultBoard);
        const bool isStated = m_board && !m_isBoardReplaced;
        part.row.source = set != nullptr ? Source::Session : isStated ? Source::Job : Source::Assumed;
        part.isKnown = true;
        report(Severity::Info, "there is one copper layer; " + where + " it lies a dielectric of " +
                                   inUm(part.row.thickness) +
                                   (set != nullptr ? ", set by you"
                                    : m_board      ? ", the board's thickness"
                                                   : ", which is assumed"));
        m_parts.insert(m_isBottomAlone ? copper : copper + 1, std::move(part));
    }

    // ---- what is not known ----

    std::vector<Part*> unknown(bool isCopper) {
        std::vector<Part*> parts;
        for (Part& part : m_parts) {
            if (part.isCore && !part.isKnown && part.isCopper == isCopper) {
                parts.push_back(&part);
            }
        }
        return parts;
    }

    std::int64_t knownSum() const {
        std::int64_t sum = 0;
        for (const Part& part : m_parts) {
            sum += part.isCore ? part.row.thickness : 0;
        }
        return sum;
    }

    /// Of dielectrics, and of copper that the job states: what the user sets leaves other copper alone.
    std::int64_t statedSum() const {
        std::int64_t sum = 0;
        for (const Part& part : m_parts) {
            const Nm unstated = part.isCopper ? 0 : part.row.thickness;
            sum += part.isCore ? part.stated.value_or(unstated) : 0;
        }
        return sum;
    }

    std::int64_t notStatedCopper() const {
        return std::ranges::count_if(m_parts, [](const Part& p) { return p.isCore && p.isCopper && !p.stated; });
    }

    static void setAll(const std::vector<Part*>& parts, std::int64_t nm, Source source) {
        for (Part* part : parts) {
            part->row.thickness = static_cast<Nm>(nm);
            part->row.source = source;
            part->isKnown = true;
        }
    }

    void fillUnknown() {
        const std::vector<Part*> dielectrics = unknown(false);
        fillCopper(dielectrics.empty());
        if (!dielectrics.empty()) {
            fillDielectrics(dielectrics);
        }
        for (const Part& part : m_parts) {
            m_floor -= m_isAlone && !m_isBottomAlone && part.isCore && !part.isCopper ? part.row.thickness : 0;
        }
    }

    /// Where all dielectrics are known, the copper is what is left of the board.
    void fillCopper(bool areDielectricsKnown) {
        const std::vector<Part*> copper = unknown(true);
        if (copper.empty()) {
            return;
        }
        const auto count = static_cast<std::int64_t>(copper.size());
        const std::int64_t share = m_board ? (*m_board - statedSum()) / notStatedCopper() : 0;
        const std::string layers = "the job gives no thickness for " + std::to_string(count) + " copper layer(s); ";
        const auto nm = static_cast<double>(share);
        if (areDielectricsKnown && !m_isAlone && nm >= kLeastCopperShare && nm <= kMostCopperShare) {
            setAll(copper, share, m_isBoardReplaced ? Source::Assumed : Source::Derived);
            report(Severity::Info, layers + "taken as " + inUm(nm) +
                                       " each, an even share of what the dielectrics leave of the board's " +
                                       inUm(*m_board));
        } else {
            setAll(copper, kDefaultCopper, Source::Assumed);
            report(Severity::Info, layers + "taken as " + inUm(kDefaultCopper));
        }
    }

    /// Shares what is left of the board's thickness evenly among the dielectrics nothing is known about.
    void fillDielectrics(const std::vector<Part*>& parts) {
        const auto count = static_cast<std::int64_t>(parts.size());
        const std::int64_t left = m_board.value_or(kDefaultBoard) - knownSum();
        const bool hasRoom = left >= count * kLeastDielectric;
        const std::int64_t share = hasRoom ? left / count : kLeastDielectric;
        setAll(parts, share, m_board && !m_isBoardReplaced && hasRoom ? Source::Derived : Source::Assumed);
        const std::string unknown = std::to_string(count) + " dielectric(s) without a thickness in the job: taken as " +
                                    inUm(static_cast<double>(share)) + " each, ";
        if (!hasRoom) {
            report(Severity::Warning, unknown + "because the board's thickness leaves no room for them");
        } else if (m_board) {
            report(Severity::Info, unknown + "an even share of the board's " + inUm(*m_board));
        } else {
            report(Severity::Warning, unknown + "an even share of an assumed board of " + inUm(kDefaultBoard));
        }
    }

    // ---- heights ----

    void settle(Part& part, Nm z) {
        part.row.z = z;
        if (part.row.layer.isValid()) {
            Layer& layer = m_layers[part.row.layer.row()];
            layer.z = z;
            layer.thickness = part.row.thickness;
            layer.thicknessSource = part.row.source;
            layer.side = isBoardDielectric(layer) ? LayerSide::Inner : layer.side;
        }
    }

    /// Bottom up from z = 0, or from the lower face of a single copper layer's substrate. Returns the upper face of the
    /// highest copper.
    Nm placeCore() {
        Nm z = m_floor;
        for (auto part = m_parts.rbegin(); part != m_parts.rend(); ++part) {
            if (part->isCore) {
                settle(*part, z);
                z += part->row.thickness;
            }
        }
        return z;
    }

    /// Masks and paste lie on the copper, silk on the thickest mask of its side (without one on the copper); layers of
    /// one kind lie side by side. What is laid or glued on (rigid-flex) lies one on the other, from the board outwards.
    void placeSurfaceLayers(Nm top) {
        assumeSurfaces();
        Nm laid = 0;
        const Nm maskAbove = thickestMask(true);
        const Nm maskBelow = thickestMask(false);
        for (auto part = m_parts.rbegin(); part != m_parts.rend(); ++part) {
            if (!part->isCore && isAbove(*part)) {
                settle(*part, top + liftOf(*part, maskAbove, laid));
                layerOf(*part).side = LayerSide::Top;
            }
        }
        laid = 0;
        for (Part& part : m_parts) {
            if (!part.isCore && isBelow(part)) {
                settle(part, m_floor - liftOf(part, maskBelow, laid) - part.row.thickness);
                layerOf(part).side = LayerSide::Bottom;
            } else if (!part.isCore && !isAbove(part)) {
                settleWithin(part);
            }
        }
    }

    Layer& layerOf(const Part& part) { return m_layers[part.row.layer.row()]; }
    [[nodiscard]] bool isAbove(const Part& part) const {
        return m_first == m_layers.size() || part.row.layer.row() < m_first;
    }
    [[nodiscard]] bool isBelow(const Part& part) const { return !isAbove(part) && part.row.layer.row() > m_last; }

    /// Of solder masks, coverlays that are drawn as one too. Once all thicknesses are known.
    Nm thickestMask(bool isTop) {
        Nm thickest = 0;
        for (const Part& part : m_parts) {
            const bool isMask = !part.isCore && part.row.type == LayerType::SolderMask;
            if (isMask && (isTop ? isAbove(part) : isBelow(part))) {
                thickest = std::max(thickest, part.row.thickness);
            }
        }
        return thickest;
    }

    /// Distance from the copper's face; `laid` is how thick what is laid on it is so far.
    Nm liftOf(const Part& part, Nm mask, Nm& laid) {
        if (isLaidOn(layerOf(part))) {
            const Nm lift = laid;
            laid += part.row.thickness;
            return lift;
        }
        return part.row.type == LayerType::SilkScreen ? mask : 0;
    }

    /// A coverlay between the copper layers of a rigid-flex board: on the flexible copper below it or else under the
    /// one above it. Where the board is rigid that is within the dielectric.
    void settleWithin(Part& part) {
        const std::size_t row = part.row.layer.row();
        std::size_t above = row;
        std::size_t below = row;
        while (!m_layers[above].isBoardCopper()) {
            --above;
        }
        while (!m_layers[below].isBoardCopper()) {
            ++below;
        }
        const bool isOnLower = m_layers[below].use == LayerUse::Flex || m_layers[above].use != LayerUse::Flex;
        settle(part, isOnLower ? upperFace(m_layers[below]) : m_layers[above].z - part.row.thickness);
        layerOf(part).side = LayerSide::Inner;
        report(Severity::Info, "layer " + part.row.name + " lies between copper layers: it is taken to lie on " +
                                   m_layers[isOnLower ? below : above].name);
    }

    void assumeSurfaces() {
        std::string surfaces;
        std::string laidOn;
        for (Part& part : m_parts) {
            if (part.isCore || part.isKnown) {
                continue;
            }
            const SurfaceDefault assumed = surfaceDefault(layerOf(part));
            part.row.thickness = assumed.thickness;
            part.row.source = Source::Assumed;
            std::string& kinds = isLaidOn(layerOf(part)) ? laidOn : surfaces;
            const std::string kind = std::string(assumed.kind) + " " + inUm(static_cast<double>(assumed.thickness));
            if (kinds.find(kind) == std::string::npos) {
                kinds += (kinds.empty() ? "" : ", ") + kind;
            }
        }
        if (!surfaces.empty()) {
            report(Severity::Info, "thickness of surface layers is assumed: " + surfaces);
        }
        if (!laidOn.empty()) {
            report(Severity::Info, "thickness of what is laid on the board is assumed: " + laidOn);
        }
    }

    void placeHoles(Nm top) {
        for (Layer& layer : m_layers) {
            if (!isHoles(layer.type)) {
                continue;
            }
            layer.side = LayerSide::Through;
            layer.thicknessSource = Source::Derived;
            layer.z = m_isAlone || !layer.spanBottom.isValid() ? m_floor : m_layers[layer.spanBottom.row()].z;
            const Nm upper = m_isAlone || !layer.spanTop.isValid() ? top : upperFace(m_layers[layer.spanTop.row()]);
            layer.thickness = upper - layer.z;
        }
    }

    static Nm upperFace(const Layer& layer) { return layer.z + layer.thickness; }

    void placePlanes(Nm top) {
        for (std::size_t i = 0; i < m_layers.size(); ++i) {
            Layer& layer = m_layers[i];
            if (isRow(i) || isHoles(layer.type)) {
                continue;
            }
            const bool isBottom = namesBottom(layer);
            layer.side =
                layer.type == LayerType::Component ? (isBottom ? LayerSide::Bottom : LayerSide::Top) : LayerSide::None;
            layer.z = isBottom ? m_floor - kDefaultPaste - kPasteDistance : top + kDefaultPaste + kPasteDistance;
            layer.thickness = 0;
            layer.thicknessSource = Source::Assumed;
        }
    }

    std::vector<Layer>& m_layers;
    const StackupFacts& m_facts;
    Diagnostics& m_diagnostics;
    double m_most;
    std::optional<Nm> m_board;                    ///< the job's, within bounds
    bool m_isBoardReplaced = false;               ///< the job's own is absurd
    std::vector<Part> m_parts;                    ///< from the top
    std::unordered_map<std::string, int> m_used;  ///< how often a name was requested, in lower case
    std::size_t m_first = 0;
    std::size_t m_last = 0;
    bool m_isAlone = false;        ///< there is one copper layer
    bool m_isBottomAlone = false;  ///< and it is the bottom one
    Nm m_floor = 0;                ///< lower face of the board
};

}  // namespace

Stackup buildStackup(std::vector<Layer>& layers, StackupFacts facts, Diagnostics& diagnostics) {
    ASSERT(facts.layers.size() == layers.size());
    Stackup stackup;
    stackup.rows = StackupBuilder(layers, facts, diagnostics).build();
    stackup.facts = std::move(facts);
    return stackup;
}

bool isCopper(const StackupRow& row) {
    return row.type == LayerType::Signal || row.type == LayerType::PowerGround || row.type == LayerType::Mixed;
}

Nm thicknessOf(const Stackup& stackup) {
    const auto first = std::ranges::find_if(stackup.rows, isCopper);
    const auto last = std::ranges::find_if(stackup.rows.rbegin(), stackup.rows.rend(), isCopper);
    if (first == stackup.rows.end()) {
        return 0;
    }
    if (&*first != &*last) {
        return first->z + first->thickness - last->z;
    }
    const SubstrateRows substrate = substrateOf(stackup.rows, static_cast<std::size_t>(first - stackup.rows.begin()));
    Nm thickness = 0;
    for (std::size_t row = substrate.first; row < substrate.end; ++row) {
        thickness += stackup.rows[row].thickness;
    }
    return thickness;
}

SubstrateRows substrateOf(const std::vector<StackupRow>& rows, std::size_t copper) {
    const auto isDielectric = [](const StackupRow& row) { return row.type == LayerType::Dielectric; };
    const auto at = rows.begin() + static_cast<std::ptrdiff_t>(copper);
    const auto end = std::find_if_not(at + 1, rows.end(), isDielectric);
    const auto first = std::find_if_not(std::make_reverse_iterator(at), rows.rend(), isDielectric).base();
    const auto rowOf = [&](auto row) { return static_cast<std::size_t>(row - rows.begin()); };
    return end != at + 1 ? SubstrateRows{copper + 1, rowOf(end)} : SubstrateRows{rowOf(first), copper};
}

const StackupRow* findRow(const Stackup& stackup, std::string_view name) {
    const auto found = std::ranges::find_if(
        stackup.rows, [name](const StackupRow& row) { return base::equalsIgnoringCase(row.name, name); });
    return found == stackup.rows.end() ? nullptr : &*found;
}

std::optional<CopperWeight> copperWeightOf(const StackupRow& row) {
    if (!isCopper(row)) {
        return std::nullopt;
    }
    if (row.material.copperOz && row.source != Source::Session) {
        return CopperWeight{*row.material.copperOz, Source::Job};
    }
    const Source source = row.source == Source::Job ? Source::Derived : row.source;
    return CopperWeight{row.thickness / base::kNmPerOunce, source};
}

}  // namespace model
