#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <vector>

#include "model/base/progress.h"
#include "model/figures/figures.h"
#include "model/geometry/box_index.h"
#include "model/geometry/edges.h"

namespace model {

/// What lies in one plane and keeps its distance there: figures, and where they are.
class LayerGeometry {
public:
    LayerGeometry() = default;
    explicit LayerGeometry(FigureTable figures)
        : m_figures(std::move(figures)), m_index(std::make_shared<const BoxIndex>(m_figures.outerBoxes())) {}

    [[nodiscard]] std::size_t size() const { return m_figures.size(); }
    [[nodiscard]] const FigureTable& figures() const { return m_figures; }
    [[nodiscard]] ElementId elementOf(std::size_t row) const { return m_figures[row].element; }
    [[nodiscard]] Box extent() const;
    /// Calls `visit(row)` for figures whose boxes come within `reach` (nm) of a box.
    void visitNear(const Box& box, double reach, const std::function<void(std::uint32_t)>& visit) const;

private:
    FigureTable m_figures;
    std::shared_ptr<const BoxIndex> m_index;
};

/// Which elements take part.
using ElementFilter = std::function<bool(ElementId)>;
[[nodiscard]] bool isAnyElement(ElementId element);

/// The copper of a layer, and the walls of plated holes that reach it after back-drilling (Document::platedSpanOf).
[[nodiscard]] LayerGeometry copperGeometry(const Document& document, LayerId layer,
                                           const ElementFilter& isWanted = isAnyElement);
/// Drilled and routed holes through a copper layer, plated or not, as wide as drilled.
[[nodiscard]] LayerGeometry holeGeometry(const Document& document, LayerId layer);
/// Everything on one layer.
[[nodiscard]] LayerGeometry layerGeometry(const Document& document, LayerId layer,
                                          const ElementFilter& isWanted = isAnyElement);
/// The outline of the board (Document::profile) with its cut-outs, as lines.
[[nodiscard]] LayerGeometry edgeGeometry(const Document& document);

/// Holes smaller than this have no size that a drill could have: some jobs write a few nanometres for "unknown".
inline constexpr Nm kLeastHole = 1'000;
/// Has a hole no size, or none that can be?
[[nodiscard]] bool hasNoSize(const Document& document, ElementId hole);
/// Has an element no width, so that no figure comes of it?
[[nodiscard]] bool coversNothing(const Document& document, ElementId element);

/// Two figures and the shortest distance between them, from the first one to the second.
struct FigurePair {
    std::uint32_t a = 0;  ///< rows of their layer geometry
    std::uint32_t b = 0;
    Spacing spacing;
};

[[nodiscard]] inline bool isAnyPair(std::uint32_t, std::uint32_t) {
    return true;
}

/// By rows of the first and of the second layer geometry.
struct PairRequest {
    double reach = 0.0;  ///< spacings up to this, nm
    /// Does this pair count?
    std::function<bool(std::uint32_t a, std::uint32_t b)> isWanted = isAnyPair;
    /// May a spacing of 0 be the result? Called for pairs that touch or overlap.
    std::function<bool(std::uint32_t a, std::uint32_t b)> mayTouch = isAnyPair;
    /// Of pairs with the same number the closest is the result; nothing: one for each pair of elements.
    std::function<std::uint64_t(std::uint32_t a, std::uint32_t b)> groupOf{};
    /// Only pairs whose smallest spacing has an end in here.
    std::optional<Box> within{};
};

/// The closest pair of every group, in rising order of width, then rows. With the same layer geometry twice every pair
/// is visited once, the lower row first. Over all cores, the same with any number of threads; partial once `progress`
/// is cancelled.
[[nodiscard]] std::vector<FigurePair> closestPairs(const LayerGeometry& a, const LayerGeometry& b,
                                                   const PairRequest& request, base::Progress& progress);

}  // namespace model
