#include "model/board/stackup_checks.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <map>

#include "model/base/thickness_units.h"
#include "model/board/stackup.h"
#include "model/board/stackup_table.h"

namespace model {

namespace {

constexpr Nm kMostMask = 100'000;
constexpr double kMostMaskRatio = 2.0;
constexpr Nm kThinnestFoil = 5'000;
constexpr Nm kThickestFoil = 480'000;
constexpr Nm kThinnestDielectric = 12'000;
constexpr double kLeastConstant = 1.9;
constexpr double kMostConstant = 13.0;
constexpr double kMostTangent = 0.05;
constexpr double kSymmetryTolerance = 0.1;
/// Of an unsymmetric stackup so many pairs are named; the rest is counted.
constexpr std::size_t kNamedPairs = 3;

std::string numberText(double value) {
    char text[32];
    std::snprintf(text, sizeof text, "%g", value);
    return text;
}

class StackupChecker {
public:
    StackupChecker(const Document& document, const LengthWriter& write)
        : m_document(document), m_rows(document.stackup.rows), m_write(write) {
        for (const StackupRow& row : m_rows) {
            m_kinds.push_back(kindOf(row, document));
        }
    }

    std::vector<StackupFinding> run() {
        checkSum();
        eachRow(&StackupChecker::checkMask);
        checkMaskSides();
        eachRow(&StackupChecker::checkCopper);
        eachRow(&StackupChecker::checkDielectric);
        eachRow(&StackupChecker::checkConstant);
        eachRow(&StackupChecker::checkTangent);
        checkCores();
        for (const Substack& part : substacksOf(m_document)) {
            checkSymmetry(part);
        }
        return std::move(m_findings);
    }

private:
    void eachRow(void (StackupChecker::*check)(std::size_t)) {
        for (std::size_t i = 0; i < m_rows.size(); ++i) {
            (this->*check)(i);
        }
    }

    void add(StackupCheck check, std::string text, std::vector<std::size_t> rows,
             Severity severity = Severity::Warning) {
        text[0] = text[0] >= 'a' && text[0] <= 'z' ? static_cast<char>(text[0] - 32) : text[0];
        m_findings.push_back({check, severity, std::move(text), std::move(rows)});
    }

    [[nodiscard]] std::string textOf(Nm thickness) const {
        return m_write ? m_write(thickness) : thicknessText(thickness);
    }
    [[nodiscard]] std::string nameAndThickness(std::size_t row) const {
        return m_rows[row].name + " " + textOf(m_rows[row].thickness);
    }
    [[nodiscard]] bool isKnown(std::size_t row) const { return m_rows[row].source != Source::Assumed; }
    [[nodiscard]] bool isStated(std::size_t row) const {
        return m_rows[row].source == Source::Job || m_rows[row].source == Source::Session;
    }
    [[nodiscard]] bool isCopper(std::size_t row) const { return m_kinds[row] == StackupKind::Copper; }

    /// Copper and what lies between, of a part of the board.
    [[nodiscard]] std::vector<std::size_t> coreRows(const std::vector<bool>& has) const {
        std::vector<std::size_t> rows;
        std::size_t used = 0;  // up to the last copper
        for (std::size_t i = 0; i < m_rows.size(); ++i) {
            if (has[i] && (isCopper(i) || (isDielectric(m_kinds[i]) && !rows.empty()))) {
                rows.push_back(i);
                used = isCopper(i) ? rows.size() : used;
            }
        }
        rows.resize(used);
        return rows;
    }

    void checkSum() {
        const std::vector<std::size_t> rows = coreRows(std::vector<bool>(m_rows.size(), true));
        const std::optional<double> stated = statedBoard();
        if (!stated || rows.size() < 2 ||
            !std::ranges::all_of(rows, [this](std::size_t row) { return isStated(row); })) {
            return;
        }
        double copper = 0;
        for (const std::size_t row : rows) {
            copper += isCopper(row) ? m_rows[row].thickness : 0;
        }
        const double core = thicknessOf(rows);
        const double all = core + thicknessOf(outerDielectrics(rows));
        const double sum = std::abs(all - *stated) < std::abs(core - *stated) ? all : core;
        const double off = std::abs(sum - *stated);
        if (off > kOunceTolerance * copper) {
            add(StackupCheck::Sum,
                "copper and dielectrics add up to " + textOf(static_cast<Nm>(sum)) +
                    ", but by the job's thickness of the board they would be " + textOf(static_cast<Nm>(*stated)) +
                    withMasks(*stated) + "; the layers are used",
                {}, off > 0.1 * *stated ? Severity::Warning : Severity::Info);
        }
    }

    /// The job's, unless it is absurd: that is a message of its own.
    [[nodiscard]] std::optional<double> statedBoard() const {
        const std::optional<double>& board = m_document.stackup.facts.boardNm;
        return board && *board >= kLeastThickness && *board <= kMostDielectric ? board : std::nullopt;
    }

    /// Films and the like that lie on the outer copper, as far as the job states them.
    [[nodiscard]] std::vector<std::size_t> outerDielectrics(const std::vector<std::size_t>& core) const {
        std::vector<std::size_t> outer;
        for (std::size_t i = 0; i < m_rows.size(); ++i) {
            const bool isOutside = i < core.front() || i > core.back();
            if (isOutside && isDielectric(m_kinds[i]) && isStated(i)) {
                outer.push_back(i);
            }
        }
        return outer;
    }

    /// Some formats count the masks: what their readers have taken off is named, so that the job's number is there.
    [[nodiscard]] std::string withMasks(double board) const {
        const std::vector<LayerFacts>& facts = m_document.stackup.facts.layers;
        double masks = 0;
        for (std::size_t row = 0; row < std::min(facts.size(), m_document.layers.size()); ++row) {
            const bool isMask = m_document.layers[row].type == LayerType::SolderMask;
            masks += isMask ? facts[row].thicknessNm.value_or(0.0) : 0.0;
        }
        return masks > 0 ? ", with its solder masks " + textOf(static_cast<Nm>(std::llround(board + masks))) : "";
    }

    void checkMask(std::size_t row) {
        if (m_kinds[row] == StackupKind::SolderMask && isKnown(row) && m_rows[row].thickness > kMostMask) {
            add(StackupCheck::MaskThickness,
                "solder mask " + nameAndThickness(row) + ": no solder mask is thicker than " + textOf(kMostMask),
                {row});
        }
    }

    void checkMaskSides() {
        std::vector<std::size_t> masks;
        for (std::size_t i = 0; i < m_rows.size(); ++i) {
            if (m_kinds[i] == StackupKind::SolderMask && isKnown(i)) {
                masks.push_back(i);
            }
        }
        if (masks.size() != 2) {
            return;  // which two would belong together is not known
        }
        const auto [thin, thick] = std::minmax(m_rows[masks[0]].thickness, m_rows[masks[1]].thickness);
        if (thick > kMostMaskRatio * thin) {
            add(StackupCheck::MaskSides,
                "the solder masks differ: " + nameAndThickness(masks[0]) + ", " + nameAndThickness(masks[1]), masks);
        }
    }

    void checkCopper(std::size_t row) {
        const Nm thickness = m_rows[row].thickness;
        if (isCopper(row) && isKnown(row) && (thickness < kThinnestFoil || thickness > kThickestFoil)) {
            add(StackupCheck::CopperThickness,
                "copper " + nameAndThickness(row) + ": foils are " + textOf(kThinnestFoil) + " to " +
                    textOf(kThickestFoil) + " thick",
                {row});
        }
    }

    void checkDielectric(std::size_t row) {
        if (isDielectric(m_kinds[row]) && isKnown(row) && m_rows[row].thickness < kThinnestDielectric) {
            add(StackupCheck::DielectricThickness,
                "dielectric " + nameAndThickness(row) + ": none is made that is thinner than " +
                    textOf(kThinnestDielectric),
                {row});
        }
    }

    void checkConstant(std::size_t row) {
        const std::optional<double>& constant = m_rows[row].material.dielectricConstant;
        if (constant && !isCopper(row) && (*constant < kLeastConstant || *constant > kMostConstant)) {
            add(StackupCheck::DielectricConstant,
                m_rows[row].name + ": a Dk of " + numberText(*constant) + "; materials have " +
                    numberText(kLeastConstant) + " to " + numberText(kMostConstant),
                {row});
        }
    }

    void checkTangent(std::size_t row) {
        const std::optional<double>& tangent = m_rows[row].material.lossTangent;
        if (tangent && !isCopper(row) && *tangent > kMostTangent) {
            add(StackupCheck::LossTangent,
                m_rows[row].name + ": a Df of " + numberText(*tangent) + "; materials have up to " +
                    numberText(kMostTangent),
                {row});
        }
    }

    /// One finding for all: writers call every dielectric a core.
    void checkCores() {
        std::vector<std::size_t> between;
        std::string names;
        for (std::size_t row = 1; row + 1 < m_rows.size(); ++row) {
            if (isCopper(row) && m_kinds[row - 1] == StackupKind::Core && m_kinds[row + 1] == StackupKind::Core) {
                between.push_back(row);
                names += (names.empty() ? "" : ", ") + m_rows[row].name;
            }
        }
        if (!between.empty()) {
            add(StackupCheck::CoreOnCore, "copper between two cores, which only prepreg can bond: " + names,
                std::move(between));
        }
    }

    /// A copper, or all dielectrics between two of them: how a writer splits one into rows makes no difference.
    using Level = std::vector<std::size_t>;

    [[nodiscard]] std::vector<Level> levelsOf(const std::vector<std::size_t>& rows) const {
        std::vector<Level> levels;
        for (const std::size_t row : rows) {
            if (levels.empty() || isCopper(row) || isCopper(levels.back().front())) {
                levels.emplace_back();
            }
            levels.back().push_back(row);
        }
        return levels;
    }

    [[nodiscard]] double thicknessOf(const Level& level) const {
        double sum = 0.0;
        for (const std::size_t row : level) {
            sum += m_rows[row].thickness;
        }
        return sum;
    }

    /// "D1 200 µm", "D1 and D2 together 300 µm"
    [[nodiscard]] std::string textOf(const Level& level) const {
        if (level.size() == 1) {
            return nameAndThickness(level.front());
        }
        std::string names;
        for (std::size_t i = 0; i < level.size(); ++i) {
            names += (i == 0 ? "" : i + 1 < level.size() ? ", " : " and ") + m_rows[level[i]].name;
        }
        return names + " together " + textOf(static_cast<Nm>(thicknessOf(level)));
    }

    /// How thick the dielectrics of each material are; empty where the material of one is not stated.
    [[nodiscard]] std::map<std::string, double> materialsOf(const Level& level) const {
        std::map<std::string, double> materials;
        for (const std::size_t row : level) {
            if (m_rows[row].material.name.empty() || isCopper(row)) {
                return {};
            }
            materials[m_rows[row].material.name] += m_rows[row].thickness;
        }
        return materials;
    }

    static bool areNear(double a, double b) {
        const auto [thin, thick] = std::minmax(a, b);
        return thick - thin <= kSymmetryTolerance * thick;
    }

    /// Of dielectrics made of several materials each one counts: a core and a prepreg differ in how they shrink. One
    /// material against one is left alone, as writers give the same one many names.
    [[nodiscard]] bool areOfLikeMaterials(const Level& a, const Level& b) const {
        const std::map<std::string, double> first = materialsOf(a);
        const std::map<std::string, double> second = materialsOf(b);
        const bool isTold = !first.empty() && !second.empty() && (first.size() > 1 || second.size() > 1);
        return !isTold || std::ranges::equal(first, second, [](const auto& left, const auto& right) {
            return left.first == right.first && areNear(left.second, right.second);
        });
    }

    /// Are these, as far from the one side as from the other, alike?
    [[nodiscard]] bool areAlike(const Level& a, const Level& b) const {
        const auto areKnown = [this](const Level& level) {
            return std::ranges::all_of(level, [this](std::size_t row) { return isKnown(row); });
        };
        const bool isSameKind = isCopper(a.front()) == isCopper(b.front());
        return isSameKind &&
               (!areKnown(a) || !areKnown(b) || (areNear(thicknessOf(a), thicknessOf(b)) && areOfLikeMaterials(a, b)));
    }

    void checkSymmetry(const Substack& part) {
        const std::vector<Level> levels = levelsOf(coreRows(part.has));
        std::vector<std::size_t> differing;
        std::size_t pairs = 0;
        std::string texts;
        for (std::size_t i = 0; i < levels.size() / 2; ++i) {
            const Level& level = levels[i];
            const Level& other = levels[levels.size() - 1 - i];
            if (areAlike(level, other)) {
                continue;
            }
            if (pairs++ < kNamedPairs) {
                texts += (texts.empty() ? "" : "; ") + textOf(level) + " and " + textOf(other);
            }
            differing.insert(differing.end(), level.begin(), level.end());
            differing.insert(differing.end(), other.begin(), other.end());
        }
        if (!differing.empty()) {
            const std::size_t more = pairs - std::min(pairs, kNamedPairs);
            add(StackupCheck::Symmetry,
                "the stackup" + (part.name.empty() ? "" : " of zone " + part.name) +
                    " is not symmetric about its middle: " + texts +
                    (more > 0 ? " and " + std::to_string(more) + " more pairs" : ""),
                differing, Severity::Info);
        }
    }

    const Document& m_document;
    const std::vector<StackupRow>& m_rows;
    const LengthWriter& m_write;
    std::vector<StackupKind> m_kinds;
    std::vector<StackupFinding> m_findings;
};

}  // namespace

const char* toString(StackupCheck check) {
    constexpr const char* kNames[] = {"sum",
                                      "mask_thickness",
                                      "mask_sides",
                                      "copper_thickness",
                                      "dielectric_thickness",
                                      "dielectric_constant",
                                      "loss_tangent",
                                      "core_on_core",
                                      "symmetry"};
    return kNames[static_cast<std::size_t>(check)];
}

std::vector<StackupFinding> checkStackup(const Document& document, const LengthWriter& write) {
    return StackupChecker(document, write).run();
}

void reportStackup(const Document& document, Diagnostics& diagnostics) {
    for (const StackupFinding& finding : checkStackup(document)) {
        diagnostics.report(finding.severity, "", 0, finding.text);
    }
}

}  // namespace model
