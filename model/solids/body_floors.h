#pragma once

#include <map>
#include <optional>
#include <vector>

#include "model/board/local_stack.h"
#include "model/geometry/discretise.h"

/// On what the bodies of components stand: on the outermost copper or dielectric of their side, which on a rigid-flex
/// board is another one in a zone that lacks layers.
namespace model {

/// What bodies of one side stand on.
struct BodyFloor {
    LayerSide side = LayerSide::Top;
    LayerId on;  ///< none: what is outermost where all layers are

    bool operator==(const BodyFloor&) const = default;
};

/// The floors that a board may have, both sides of it where all layers are first. They follow from the layers only
/// (Layer::outlineGroup), so that all steps of a panel have the same ones: a layer is one if there can be a location
/// that has it and nothing outside of it.
[[nodiscard]] std::vector<BodyFloor> bodyFloorsOf(const Document& document);

/// Where bodies on a floor begin: at its outer face, with the solder mask or coverlay that lies on it there. Not for
/// the floor where all layers are.
[[nodiscard]] Nm heightOf(const Document& document, const BodyFloor& floor);

/// Finds on which of the floors of a document something stands. Not thread-safe.
class FloorFinder {
public:
    explicit FloorFinder(const Document& document);

    /// Is there but the one floor of each side?
    [[nodiscard]] bool isEven() const { return m_floors.size() == 2; }
    /// Below or above the first of these locations that is on the board; where none is, the floor where all layers are.
    [[nodiscard]] BodyFloor at(LayerSide side, const std::vector<Point>& locations);

private:
    [[nodiscard]] bool isWithin(ShapeId shape, Point location);
    [[nodiscard]] std::optional<BodyFloor> floorAt(LayerSide side, Point location);

    const Document& m_document;
    std::vector<BodyFloor> m_floors;
    std::map<ShapeId, PolygonSet> m_outlines;
};

}  // namespace model
