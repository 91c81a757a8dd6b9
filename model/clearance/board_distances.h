#pragma once

#include <memory>
#include <span>
#include <vector>

#include "model/board/copies.h"
#include "model/clearance/clearance_map.h"

namespace model {

/// The distance fields of one layer of a whole board: of the board itself and of every copy of a step that it places.
/// On a layer of the panel lies what a flipped copy has on the opposite one. Each copy is measured by itself, once for
/// all copies of a step that lie the same way up; spacings between copies are not measured. Where copies lie on each
/// other, the smaller value counts.
class BoardDistances {
public:
    /// Errors: those of DistanceField::betweenNets, if no copy
    /// has two nets on the layer.
    [[nodiscard]] static base::Result<BoardDistances> betweenNets(const Document& board, LayerId layer,
                                                                  base::Progress& progress);
    /// Distances to targets, within the copies that hold some. Errors: those of DistanceField::toTargets, if none is
    /// copper of the layer.
    [[nodiscard]] static base::Result<BoardDistances> toTargets(const Document& board, LayerId layer,
                                                                std::span<const BoardElement> targets);

    [[nodiscard]] DistanceField::Kind kind() const { return m_kind; }
    /// Of the board.
    [[nodiscard]] LayerId layer() const { return m_layer; }
    /// What is mapped: the outlines of what holds copper, or where there are none the copper.
    [[nodiscard]] Box extent() const { return m_extent; }
    /// How many documents are mapped, the board itself and copies.
    [[nodiscard]] std::size_t copyCount() const { return m_placed.size(); }
    /// What the map leaves out: "clearances across copies of steps are not measured"; empty if nothing.
    [[nodiscard]] std::string note() const;

    /// As DistanceField::map, in coordinates of the board; MapNets say of which copy they are. Copies that are rotated
    /// by other than quarter turns take the value of the nearest cell of their own.
    [[nodiscard]] base::Result<ClearanceMap> map(const MapFrame& frame, double reach, base::Progress& progress,
                                                 MapDetail detail = MapDetail::Distances) const;
    /// As DistanceField::at.
    [[nodiscard]] double at(PointD location, double reach) const;

private:
    struct Placed {
        std::shared_ptr<const DistanceField> field;
        std::uint32_t copy = 0;  ///< row of StepTree::copies
        Placement placement;
        Box box;  ///< on the board
    };

    template <class MakeField>
    static base::Result<BoardDistances> make(const Document& board, LayerId layer, const MakeField& makeField);
    base::Status mapCopy(const Placed& placed, double reach, base::Progress& progress, MapDetail detail,
                         ClearanceMap& map) const;

    DistanceField::Kind m_kind = DistanceField::Kind::BetweenNets;
    LayerId m_layer;
    Box m_extent;
    std::vector<Placed> m_placed;
};

}  // namespace model
