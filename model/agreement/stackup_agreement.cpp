#include "model/agreement/stackup_agreement.h"

#include <algorithm>
#include <cmath>

#include "model/board/stackup.h"
#include "model/text/formatting.h"

namespace model {

namespace {

/// Numbers with four decimals of an inch are rounded by up to 1.27 µm, in one job or in both.
constexpr double kRounding = 2'000.0;

/// A thickness of the stackup.
struct Thickness {
    std::string name;  ///< "copper TOP", "the dielectric below TOP"
    double nm = 0.0;
    double tolerance = kRounding;
    bool isStated = true;  ///< by the job or the user: not assumed, and no share of the board's

    void add(const StackupRow& row) {
        nm += row.thickness;
        isStated = isStated && (row.source == Source::Job || row.source == Source::Session);
    }
    [[nodiscard]] bool isKnown() const { return isStated && nm > 0.0; }
};

/// Copper and what lies between, in turn from the top.
struct Core {
    std::vector<Thickness> parts;
    std::size_t copperLayers = 0;
    double masks = 0.0;  ///< nm of solder mask on both sides
    Thickness board;
    bool isBoardOfParts = true;  ///< else as the job says, which may count the solder mask
};

void addCopper(const StackupRow& row, Core& core) {
    ++core.copperLayers;
    Thickness copper{"copper " + row.name};
    copper.add(row);
    copper.tolerance = std::max(kRounding, kOunceTolerance * copper.nm);
    core.parts.push_back(std::move(copper));
    core.parts.push_back({"the dielectric below " + row.name, 0.0});
}

/// By all of its parts where the job states these, else as a whole.
void setBoard(const Document& document, Core& core) {
    core.board = {"the board", static_cast<double>(thicknessOf(document.stackup)), 0.0};
    for (const Thickness& part : core.parts) {
        core.board.tolerance += part.tolerance;
        core.isBoardOfParts = core.isBoardOfParts && part.isKnown();
    }
    if (!core.isBoardOfParts) {
        core.board.nm = document.stackup.facts.boardNm.value_or(0.0);
    }
}

/// Of a board with one copper layer the substrate is all there is between.
void addSubstrate(const std::vector<StackupRow>& rows, Core& core) {
    const auto copper = std::ranges::find_if(rows, isCopper);
    const SubstrateRows substrate = substrateOf(rows, static_cast<std::size_t>(copper - rows.begin()));
    Thickness part{"the substrate", 0.0};
    for (std::size_t row = substrate.first; row < substrate.end; ++row) {
        part.add(rows[row]);
    }
    core.parts.push_back(std::move(part));
}

Core coreOf(const Document& document) {
    const std::vector<StackupRow>& rows = document.stackup.rows;
    Core core;
    for (const StackupRow& row : rows) {
        if (isCopper(row)) {
            addCopper(row, core);
        } else if (row.type == LayerType::Dielectric && !core.parts.empty()) {
            core.parts.back().add(row);
        }
        core.masks += row.type == LayerType::SolderMask ? row.thickness : 0;
    }
    if (core.copperLayers > 0) {
        core.parts.pop_back();  // below the last copper
    }
    if (core.copperLayers == 1) {
        addSubstrate(rows, core);
    }
    setBoard(document, core);
    return core;
}

std::string inUm(double nm) {
    return fixedText(nm / base::kNmPerUm, 1) + " µm";
}

class StackupComparer {
public:
    StackupComparer(const Document& a, const Document& b, const AgreementRequest& request)
        : m_a(coreOf(a)), m_b(coreOf(b)), m_request(request) {}

    Comparison run() {
        m_found.aspect = Aspect::Stackup;
        m_found.counts = {m_a.copperLayers, m_b.copperLayers};
        m_found.accord = Accord::NotCompared;
        if (m_a.copperLayers == 0 || m_b.copperLayers == 0) {
            m_found.note = std::string(m_a.copperLayers == 0 ? "A" : "B") + " has no stackup";
            return std::move(m_found);
        }
        const bool isSameCount = m_a.copperLayers == m_b.copperLayers;
        for (std::size_t i = 0; isSameCount && i < m_a.parts.size(); ++i) {
            compare(m_a.parts[i], m_b.parts[i]);
        }
        compareBoard();
        m_found.note =
            isSameCount ? noteOnStated() : "the board alone is compared, as the copper layers are not the same";
        return std::move(m_found);
    }

private:
    void compareBoard() {
        if (!m_a.isBoardOfParts || !m_b.isBoardOfParts) {
            m_a.board.tolerance += std::max(m_a.masks, m_b.masks);
        }
        compare(m_a.board, m_b.board);
    }

    void compare(const Thickness& a, const Thickness& b) {
        if (!a.isKnown() || !b.isKnown()) {
            ++m_unstated;
            return;
        }
        m_found.accord = m_found.accord == Accord::NotCompared ? Accord::Agree : m_found.accord;
        if (std::abs(a.nm - b.nm) > std::max(a.tolerance, b.tolerance)) {
            m_found.add({a.name + " is " + inUm(a.nm) + " thick in A, " + inUm(b.nm) + " in B", {}}, m_request.most);
        }
    }

    [[nodiscard]] std::string noteOnStated() const {
        const std::string all = std::to_string(m_a.parts.size() + 1);
        return m_unstated == 0
                   ? ""
                   : std::to_string(m_unstated) + " of " + all + " thicknesses only one job states, or none";
    }

    Core m_a;
    Core m_b;
    const AgreementRequest& m_request;
    std::size_t m_unstated = 0;
    Comparison m_found;
};

}  // namespace

Comparison compareStackups(const Document& a, const Document& b, const AgreementRequest& request) {
    return StackupComparer(a, b, request).run();
}

}  // namespace model
