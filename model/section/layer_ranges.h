#pragma once

#include <map>
#include <vector>

#include "model/geometry/discretise.h"
#include "model/index/board_index.h"
#include "model/section/intervals.h"

namespace model {

/// Where along a straight line the layers are that have outlines of their own (rigid-flex: Layer::profile). All other
/// layers are all along and have no entry.
using LayerRanges = std::map<LayerId, Intervals>;

/// The outlines of a board's layers, ready to be cut by many lines. Steps beside those that have outlines for a layer
/// (the frame of a panel) have all of it, but none of the films that are laid on a board.
class LayerOutlines {
public:
    /// `index` lives as long as this does.
    explicit LayerOutlines(const BoardIndex& index);

    /// Between two locations of the board, in nm from `a`.
    [[nodiscard]] LayerRanges between(PointD a, PointD b) const;

private:
    void addShape(std::size_t step, ShapeId shape);
    [[nodiscard]] const PolygonSet& outline(std::size_t step, ShapeId shape) const;

    const BoardIndex& m_index;
    std::vector<std::size_t> m_rows;  ///< of layers with an outline in any step
    std::map<std::pair<std::size_t, ShapeId>, PolygonSet> m_shapes;
};

}  // namespace model
