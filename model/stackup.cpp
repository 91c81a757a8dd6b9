#include "model/stackup.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "model/base/assert.h"

namespace model {

namespace {

/// How far above and below the outermost surface layer the planes of all other layers lie.
constexpr Nm kPlaneGap = 100'000;

/// A part of the stack between the outer copper faces: a layer, or a dielectric that the job has no row for.
struct Part {
    std::size_t layer = 0;  ///< of a dielectric without a row: the copper above it
    bool hasRow = true;
    bool isCopper = false;
    Nm thickness = 0;
    Source source = Source::Job;
    bool isKnown = false;
};

class StackBuilder {
public:
    StackBuilder(std::vector<Layer>& layers, std::span<const ThicknessHint> hints, std::optional<double> boardNm,
                 Diagnostics& diagnostics)
        : m_layers(layers),
          m_hints(hints),
          m_boardNm(boardNm),
          m_diagnostics(diagnostics),
          // Together the layers must stay within the coordinate range.
          m_most(base::kMaxCoordinate / 2.0 / static_cast<double>(layers.size() + 1)) {}

    Nm build() {
        findCopper();
        collectParts();
        fillUnknown();
        const Nm top = placeParts();
        layLaminateBelow();
        placeSurfaceLayers(top);
        placeHoles(top);
        placePlanes(top);
        return m_floor < 0 ? -m_floor : top;
    }

private:
    static bool isSurface(const Layer& layer) {
        switch (layer.type) {
            case LayerType::SolderMask:
            case LayerType::SolderPaste:
            case LayerType::SilkScreen:
            case LayerType::ConductivePaste:
            case LayerType::Mask: return layer.context == LayerContext::Board;
            default: return false;
        }
    }
    static bool isBoardCopper(const Layer& layer) { return layer.isCopper() && layer.context == LayerContext::Board; }
    static bool isBoardDielectric(const Layer& layer) {
        return layer.type == LayerType::Dielectric && layer.context == LayerContext::Board;
    }

    void report(Severity severity, const std::string& text) { m_diagnostics.report(severity, "", 0, text); }

    void findCopper() {
        m_first = m_last = m_layers.size();
        for (std::size_t i = 0; i < m_layers.size(); ++i) {
            if (isBoardCopper(m_layers[i])) {
                m_first = std::min(m_first, i);
                m_last = i;
                m_layers[i].side = LayerSide::Inner;
            }
        }
        if (m_first < m_layers.size()) {
            m_layers[m_last].side = LayerSide::Bottom;
            m_layers[m_first].side = LayerSide::Top;
        }
    }

    /// A value of the job within its bounds; one outside is replaced by the bound and reported.
    std::optional<Nm> checked(const Layer& layer, std::optional<double> value, double most) {
        if (!value || *value == 0.0) {
            return std::nullopt;
        }
        const double inside = std::clamp(*value, kLeastThickness, most);
        if (inside != *value) {
            report(Severity::Warning, "layer " + layer.name + ": the job's thickness of " + inUm(*value) +
                                          " is absurd; taken as " + inUm(inside));
        }
        return static_cast<Nm>(std::llround(inside));
    }

    static std::string inUm(double nm) {
        const double um = nm / base::kNmPerUm;
        std::string text = std::to_string(std::round(um * 10) / 10.0);
        text.erase(text.find_last_not_of('0') + 1);
        return text + (text.ends_with('.') ? "0 µm" : " µm");
    }

    void collectParts() {
        for (std::size_t i = m_first; i < m_layers.size() && i <= m_last; ++i) {
            if (isBoardCopper(m_layers[i])) {
                addGapBefore();
                addPart(i, true, checked(m_layers[i], m_hints[i].copperNm, std::min(m_most, kMostCopper)));
            } else if (isBoardDielectric(m_layers[i])) {
                addPart(i, false, checked(m_layers[i], m_hints[i].dielectricNm, std::min(m_most, kMostDielectric)));
            }
        }
    }

    void addPart(std::size_t layer, bool isCopper, std::optional<Nm> thickness) {
        m_parts.push_back({layer, true, isCopper, thickness.value_or(0), Source::Job, thickness.has_value()});
        if (isCopper && !thickness) {
            m_parts.back().thickness = kDefaultCopper;
            m_parts.back().source = Source::Assumed;
            m_parts.back().isKnown = true;
            ++m_assumedCopper;
        }
    }

    /// Two copper layers without a row between them: the dielectric is only known from the upper one, if at all.
    void addGapBefore() {
        if (m_parts.empty() || !m_parts.back().isCopper) {
            return;
        }
        const std::size_t above = m_parts.back().layer;
        const std::optional<Nm> thickness =
            checked(m_layers[above], m_hints[above].dielectricBelowNm, std::min(m_most, kMostDielectric));
        m_parts.push_back({above, false, false, thickness.value_or(0), Source::Job, thickness.has_value()});
    }

    /// Shares what is left of the board's thickness evenly among the dielectrics nothing is known about.
    void fillUnknown() {
        std::int64_t known = 0;
        std::int64_t unknown = 0;
        for (const Part& part : m_parts) {
            known += part.thickness;
            unknown += part.isKnown ? 0 : 1;
        }
        if (m_assumedCopper > 0) {
            report(Severity::Info, "the job gives no thickness for " + std::to_string(m_assumedCopper) +
                                       " copper layer(s); taken as " + inUm(kDefaultCopper));
        }
        if (unknown == 0) {
            return m_parts.size() > 1 ? compareWithBoard(known) : void();
        }
        const std::optional<Nm> board = boardThickness();
        const std::int64_t left = board.value_or(kDefaultBoard) - known;
        const bool hasRoom = left >= unknown * kLeastDielectric;
        const std::int64_t share = hasRoom ? left / unknown : kLeastDielectric;
        for (Part& part : m_parts) {
            if (!part.isKnown) {
                part.thickness = static_cast<Nm>(share);
                part.source = board && hasRoom ? Source::Derived : Source::Assumed;
            }
        }
        reportShare(board, hasRoom, unknown, static_cast<double>(share));
    }

    std::optional<Nm> boardThickness() {
        Layer board;
        board.name = "(board)";
        return checked(board, m_boardNm, kMostDielectric);
    }

    void reportShare(std::optional<Nm> board, bool hasRoom, std::int64_t unknown, double share) {
        const std::string gaps = std::to_string(unknown) + " dielectric(s) without a thickness in the job: taken as " +
                                 inUm(share) + " each, ";
        if (!hasRoom) {
            report(Severity::Warning, gaps + "because the board's thickness leaves no room for them");
        } else if (board) {
            report(Severity::Info, gaps + "an even share of the board's " + inUm(*board));
        } else {
            report(Severity::Info, gaps + "an even share of an assumed board of " + inUm(kDefaultBoard));
        }
    }

    void compareWithBoard(std::int64_t sum) {
        const std::optional<Nm> board = boardThickness();
        // Job thicknesses often count the solder mask; a tenth is more than any mask.
        if (board && std::abs(static_cast<double>(sum) - *board) > 0.1 * *board) {
            report(Severity::Warning, "the layers add up to " + inUm(static_cast<double>(sum)) +
                                          ", but the job says the board is " + inUm(*board) +
                                          " thick; the layers are used");
        }
    }

    /// Bottom up from z = 0. Returns the upper face of the highest part.
    Nm placeParts() {
        Nm z = 0;
        for (auto part = m_parts.rbegin(); part != m_parts.rend(); ++part) {
            if (part->hasRow) {
                Layer& layer = m_layers[part->layer];
                layer.z = z;
                layer.thickness = part->thickness;
                layer.thicknessSource = part->source;
                layer.side = part->isCopper ? layer.side : LayerSide::Inner;
            }
            z += part->thickness;
        }
        return z;
    }

    /// A board of one copper layer has its laminate below it.
    void layLaminateBelow() {
        if (m_parts.size() != 1) {
            return;
        }
        const std::optional<Nm> board = boardThickness();
        m_floor = -board.value_or(kDefaultBoard);
        report(Severity::Info, "there is one copper layer; below it lies a laminate of " + inUm(-m_floor) +
                                   (board ? ", the board's thickness" : ", which is assumed"));
    }

    static Nm surfaceThickness(LayerType type) {
        switch (type) {
            case LayerType::SolderPaste:
            case LayerType::ConductivePaste: return kDefaultPaste;
            case LayerType::SilkScreen: return kDefaultSilk;
            default: return kDefaultMask;
        }
    }

    /// Masks and paste lie on the copper, silk on the mask. Layers of one kind lie side by side.
    void placeSurfaceLayers(Nm top) {
        bool isAny = false;
        for (std::size_t i = 0; i < m_layers.size(); ++i) {
            Layer& layer = m_layers[i];
            if (!isSurface(layer) && !(isBoardDielectric(layer) && (i < m_first || i > m_last))) {
                continue;
            }
            isAny = true;
            const bool isTop = i < m_last || m_parts.empty();
            layer.side = isTop ? LayerSide::Top : LayerSide::Bottom;
            const std::optional<Nm> known = checked(layer, m_hints[i].dielectricNm, std::min(m_most, kMostDielectric));
            layer.thickness = known.value_or(surfaceThickness(layer.type));
            layer.thicknessSource = known ? Source::Job : Source::Assumed;
            const Nm lift = layer.type == LayerType::SilkScreen ? kDefaultMask : 0;
            layer.z = isTop ? top + lift : m_floor - lift - layer.thickness;
        }
        if (isAny) {
            report(Severity::Info, "thickness of surface layers is assumed: solder mask " + inUm(kDefaultMask) +
                                       ", paste " + inUm(kDefaultPaste) + ", silk screen " + inUm(kDefaultSilk));
        }
    }

    void placeHoles(Nm top) {
        for (Layer& layer : m_layers) {
            if (layer.type != LayerType::Drill && layer.type != LayerType::Rout) {
                continue;
            }
            layer.side = LayerSide::Through;
            layer.thicknessSource = Source::Derived;
            layer.z = m_floor < 0 || !layer.spanBottom.isValid() ? m_floor : m_layers[layer.spanBottom.row()].z;
            const Nm upper = layer.spanTop.isValid() ? upperFace(m_layers[layer.spanTop.row()]) : top;
            layer.thickness = upper - layer.z;
        }
    }

    static Nm upperFace(const Layer& layer) { return layer.z + layer.thickness; }

    static bool namesBottom(const Layer& layer) {
        std::string name = layer.name;
        std::ranges::transform(name, name.begin(),
                               [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c + 32) : c; });
        return name.find("bot") != std::string::npos || name.starts_with("b.");
    }

    void placePlanes(Nm top) {
        for (Layer& layer : m_layers) {
            const bool isPlaced = isBoardCopper(layer) || isBoardDielectric(layer) || isSurface(layer) ||
                                  layer.type == LayerType::Drill || layer.type == LayerType::Rout;
            if (isPlaced) {
                continue;
            }
            const bool isBottom = namesBottom(layer);
            layer.side =
                layer.type == LayerType::Component ? (isBottom ? LayerSide::Bottom : LayerSide::Top) : LayerSide::None;
            layer.z = isBottom ? m_floor - kDefaultPaste - kPlaneGap : top + kDefaultPaste + kPlaneGap;
            layer.thickness = 0;
            layer.thicknessSource = Source::Assumed;
        }
    }

    std::vector<Layer>& m_layers;
    std::span<const ThicknessHint> m_hints;
    std::optional<double> m_boardNm;
    Diagnostics& m_diagnostics;
    double m_most;
    std::vector<Part> m_parts;  ///< from the top
    std::size_t m_first = 0;
    std::size_t m_last = 0;
    Nm m_floor = 0;  ///< lower face of the board
    int m_assumedCopper = 0;
};

}  // namespace

Nm buildStackup(std::vector<Layer>& layers, std::span<const ThicknessHint> hints, std::optional<double> boardNm,
                Diagnostics& diagnostics) {
    ASSERT(hints.size() == layers.size());
    return StackBuilder(layers, hints, boardNm, diagnostics).build();
}

}  // namespace model
