#include "model/agreement/flat_board.h"

#include <algorithm>
#include <cmath>

#include "model/agreement/point_matcher.h"
#include "model/board/copies.h"
#include "model/board/holes.h"

namespace model {

namespace {

double turned(double degrees) {
    const double rest = std::fmod(degrees, 360.0);
    return rest < 0 ? rest + 360.0 : rest;
}

class Flattener {
public:
    Flattener(const Document& board, Point shift) : m_board(board), m_shift{shift, 0.0, false} {
        m_ordinal.assign(board.layers.size(), -1);
        for (const LayerId layer : boardCopper(board)) {
            m_ordinal[layer.row()] = m_copper++;
        }
    }

    FlatBoard run() {
        const StepTree tree = unfoldCopies(m_board);
        for (const StepCopy& copy : tree.copies) {
            m_placement = m_shift.after(copy.placement);
            m_isFlipped = copy.isFlipped;
            add(*tree.steps[copy.step]);
        }
        return std::move(m_flat);
    }

private:
    void add(const Document& step) {
        m_firstNet = static_cast<std::int32_t>(m_flat.nets.size());
        for (const Net& net : step.nets) {
            m_flat.nets.push_back(net.name);
        }
        for (const Layer& layer : step.layers) {
            const LayerId on =
                m_board.layerOfCopy(LayerId{static_cast<std::size_t>(&layer - step.layers.data())}, m_isFlipped);
            for (std::uint32_t i = 0; i < layer.elements.count && !layer.isSynthetic; ++i) {
                addElement(step, ElementId{std::size_t{layer.elements.first} + i}, on);
            }
        }
        for (const Component& component : step.components) {
            addPart(step, component);
        }
    }

    [[nodiscard]] std::int32_t netOf(NetId net) const {
        return net.isValid() ? m_firstNet + static_cast<std::int32_t>(net.row()) : FlatBoard::kNoNet;
    }

    /// Of the copper of the board, for a layer of the board.
    [[nodiscard]] std::int32_t ordinalOf(LayerId layer) const {
        return layer.isValid() && layer.row() < m_ordinal.size() ? m_ordinal[layer.row()] : -1;
    }

    void addElement(const Document& step, ElementId id, LayerId on) {
        const std::uint8_t flags = step.elements.flags[id.row()];
        const Box box = m_placement.boxOf(step.boxOf(id));
        if ((flags & kHole) != 0 && isHoles(m_board.layer(on).type)) {
            FlatBoard::Hole hole{box.middle(), static_cast<Nm>(box.width()), static_cast<Nm>(box.height()),
                                 isPlatedHole(flags)};
            hole.top = ordinalOf(m_board.layer(on).spanTop);
            hole.bottom = ordinalOf(m_board.layer(on).spanBottom);
            m_flat.holes.push_back(hole);
        } else if ((flags & kPad) != 0 && ordinalOf(on) >= 0) {
            m_flat.pads.push_back({box.middle(), ordinalOf(on), netOf(step.elements.net[id.row()])});
        }
    }

    void addPart(const Document& step, const Component& component) {
        const Placement placed = m_placement.after(component.placement);
        FlatBoard::Part part;
        part.refdes = component.refdes;
        part.position = placed.origin;
        part.clockwiseDeg = turned(placed.clockwiseDeg);
        part.isBottom = (component.side == LayerSide::Bottom) != m_isFlipped;
        part.isPlaced = component.isPlaced;
        part.hasSide = component.isPlaced || (component.mount != MountType::ThroughHole && component.pinCount > 0);
        part.firstPin = static_cast<std::uint32_t>(m_flat.pins.size());
        part.pinCount = component.pinCount;
        for (const Pin& pin : step.pinsOf(component)) {
            m_flat.pins.push_back({step.text(pin.name), m_placement.apply(pin.position), netOf(pin.net)});
        }
        m_flat.parts.push_back(part);
    }

    const Document& m_board;
    Placement m_shift;
    std::vector<std::int32_t> m_ordinal;  ///< by layer of the board
    std::int32_t m_copper = 0;
    FlatBoard m_flat;
    Placement m_placement;  ///< of the copy that is added
    bool m_isFlipped = false;
    std::int32_t m_firstNet = 0;
};

/// Two decimals of a millimetre.
constexpr Nm kCoarse = 10'000;

/// Do all locations lie at whole steps?
bool isCoarse(const FlatBoard& board) {
    std::vector<Point> locations;
    for (const FlatBoard::Hole& hole : board.holes) {
        if (hole.width == hole.height) {
            locations.push_back(hole.middle);
        }
    }
    for (const FlatBoard::PinAt& pin : board.pins) {
        locations.push_back(pin.position);
    }
    return std::ranges::all_of(locations, [](Point point) { return point.x % kCoarse == 0 && point.y % kCoarse == 0; });
}

}  // namespace

Nm reachOf(const FlatBoard& a, const FlatBoard& b) {
    return kSamePlace + (isCoarse(a) != isCoarse(b) ? kCoarse / 2 : 0);
}

bool isSamePlace(Point a, Point b, Nm reach) {
    return std::abs(std::int64_t{a.x} - b.x) <= reach && std::abs(std::int64_t{a.y} - b.y) <= reach;
}

FlatBoard flatten(const Document& board, Point shift) {
    return Flattener(board, shift).run();
}

std::vector<LayerId> boardCopper(const Document& board) {
    std::vector<LayerId> copper;
    for (std::size_t row = 0; row < board.layers.size(); ++row) {
        if (board.layers[row].isBoardCopper()) {
            copper.emplace_back(row);
        }
    }
    return copper;
}

std::vector<Point> locationsOf(const FlatBoard& board) {
    std::vector<Point> locations;
    for (const FlatBoard::Hole& hole : board.holes) {
        locations.push_back(hole.middle);
    }
    for (std::size_t i = 0; i < board.pins.size() && board.holes.empty(); ++i) {
        locations.push_back(board.pins[i].position);
    }
    return locations;
}

std::size_t countMatches(const std::vector<Point>& fixed, const std::vector<Point>& moved, Point shift, Nm reach) {
    PointMatcher matcher(fixed);
    return static_cast<std::size_t>(std::ranges::count_if(moved, [&](Point point) {
        const Point there{point.x + shift.x, point.y + shift.y};
        return matcher.take(there, reach, [](std::size_t) { return 0; }).has_value();
    }));
}

}  // namespace model
