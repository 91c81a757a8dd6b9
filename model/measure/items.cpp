#include "model/measure/items.h"

#include <algorithm>

#include "model/figures/distance.h"
#include "model/figures/severed_tracks.h"
#include "model/geometry/vectors.h"
#include "model/index/copper_kind.h"
#include "model/index/pin_names.h"
#include "model/text/formatting.h"

namespace model {

namespace {

/// What touches others electrically.
bool isConductor(const Document& step, ElementId element) {
    return step.layer(step.elements.layer[element.row()]).isCopper() ||
           isPlatedHole(step.elements.flags[element.row()]);
}

/// The conductors among elements of one copy, rising.
std::vector<BoardElement> conductorsOf(const BoardIndex& index, std::uint32_t copy,
                                       std::span<const ElementId> elements) {
    std::vector<BoardElement> conductors;
    for (const ElementId element : elements) {
        if (isConductor(index.stepOf(copy), element)) {
            conductors.push_back({copy, element});
        }
    }
    std::ranges::sort(conductors);
    conductors.erase(std::unique(conductors.begin(), conductors.end()), conductors.end());
    return conductors;
}

/// Of all components of that name.
std::vector<PinId> allPinsNamedAs(const Document& step, PinId id) {
    const Pin& pin = step.pins[id.row()];
    std::vector<PinId> pins = pinsNamedAs(step, id);
    if (!pin.component.isValid()) {
        return pins;
    }
    for (const ComponentId part : componentsNamedAs(step, pin.component)) {
        const Component& other = step.components[part.row()];
        for (std::size_t row = other.firstPin; part != pin.component && row < other.firstPin + other.pinCount; ++row) {
            if (pinName(step, PinId{row}) == pinName(step, id)) {
                pins.emplace_back(row);
            }
        }
    }
    return pins;
}

/// Is the layer at a height of its own, or just a drawing?
bool isInStackup(const Layer& layer) {
    switch (layer.type) {
        case LayerType::Signal:
        case LayerType::PowerGround:
        case LayerType::Mixed:
        case LayerType::Dielectric:
        case LayerType::SolderMask:
        case LayerType::SolderPaste:
        case LayerType::SilkScreen:
        case LayerType::ConductivePaste:
        case LayerType::Drill:
        case LayerType::Rout:
        case LayerType::Body:
        case LayerType::ComponentBody: return layer.context == LayerContext::Board;
        default: return false;
    }
}

/// The layers a hole joins, or passes if it is not plated; of the step, top one first.
PlatedSpan spanOf(const Document& step, ElementId element) {
    const std::uint8_t flags = step.elements.flags[element.row()];
    const LayerId own = step.elements.layer[element.row()];
    if (isPlatedHole(flags)) {
        return step.platedSpanOf(element);
    }
    const Layer& layer = step.layer(own);
    const bool isHole = (flags & kHole) != 0 && layer.spanTop.isValid() && layer.spanBottom.isValid();
    return isHole ? PlatedSpan{element, layer.spanTop, layer.spanBottom} : PlatedSpan{element, own, own};
}

Piece pieceOf(const BoardIndex& index, BoardElement at) {
    const StepCopy& copy = index.tree.copies[at.copy];
    const Document& step = *index.tree.steps[copy.step];
    const LayerId own = step.elements.layer[at.element.row()];
    Piece piece;
    piece.at = at;
    piece.layer = step.layerOfCopy(own, copy.isFlipped);
    const PlatedSpan span = spanOf(step, at.element);
    piece.top = span.top.isValid() ? step.layerOfCopy(span.top, copy.isFlipped) : LayerId{};
    piece.bottom = span.bottom.isValid() ? step.layerOfCopy(span.bottom, copy.isFlipped) : LayerId{};
    if (piece.bottom < piece.top) {
        std::swap(piece.top, piece.bottom);
    }
    piece.hasHeights = isInStackup(index.board->layer(piece.layer));
    const bool isPlated = isPlatedHole(step.elements.flags[at.element.row()]);
    if (piece.hasHeights && (isPlated || (step.elements.flags[at.element.row()] & kHole) == 0)) {
        piece.isMirrored = isMirroredInCopy(step, span.top.isValid() ? span.top : own, copy.isFlipped);
    }
    if (isPlated && span.top.isValid()) {
        piece.z = heightsInCopy(step, span.top, span.bottom, copy.isFlipped);
    } else {
        piece.z = heightsInCopy(step, at.element, copy.isFlipped);
    }
    return piece;
}

std::string nameOfPin(const Document& step, PinId id) {
    const Pin& pin = step.pins[id.row()];
    const std::string part = pin.component.isValid() ? step.components[pin.component.row()].refdes + "." : "";
    return "pin " + part + step.text(pin.name);
}

/// Says what an item is called.
struct Namer {
    const BoardIndex& index;

    std::string operator()(BoardElement at) const {
        const Layer& layer = index.board->layer(layerOf(index, at));
        return "element " + std::to_string(at.element.value) + " (" + layer.name + ")";
    }
    std::string operator()(NetOfCopy at) const { return "net " + index.stepOf(at.copy).nets[at.net.row()].name; }
    std::string operator()(PartOfCopy at) const { return index.stepOf(at.copy).components[at.component.row()].refdes; }
    std::string operator()(PinOfCopy at) const { return nameOfPin(index.stepOf(at.copy), at.pin); }
    std::string operator()(BoardEdge) const { return "the board's edge"; }
    std::string operator()(const Location&) const { return "the location"; }
};

/// Collects the elements of an item.
struct Collector {
    const BoardIndex& index;

    std::vector<BoardElement> operator()(BoardElement at) const { return {at}; }
    std::vector<BoardElement> operator()(NetOfCopy at) const {
        return conductorsOf(index, at.copy, index.stepOf(at.copy).elementsOf(at.net));
    }
    std::vector<BoardElement> operator()(PartOfCopy at) const {
        std::vector<ElementId> elements;
        for (const ComponentId part : componentsNamedAs(index.stepOf(at.copy), at.component)) {
            std::ranges::copy(index.pinsOf(at.copy).elementsOf(part), std::back_inserter(elements));
        }
        return conductorsOf(index, at.copy, elements);
    }
    std::vector<BoardElement> operator()(PinOfCopy at) const {
        std::vector<ElementId> elements;
        for (const PinId pin : allPinsNamedAs(index.stepOf(at.copy), at.pin)) {
            std::ranges::copy(index.pinsOf(at.copy).elementsOf(pin), std::back_inserter(elements));
        }
        return conductorsOf(index, at.copy, elements);
    }
    std::vector<BoardElement> operator()(BoardEdge) const { return {}; }
    std::vector<BoardElement> operator()(const Location&) const { return {}; }
};

/// "10, -10 mm; 15, -10 mm and 3 more"
std::string placesText(const BoardIndex& index, std::uint32_t copy, std::span<const Point> places) {
    constexpr std::size_t kMost = 4;
    std::string text;
    for (std::size_t i = 0; i < std::min(places.size(), kMost); ++i) {
        const PointD at = index.tree.copies[copy].placement.apply(base::toDouble(places[i]));
        text += (i == 0 ? "" : "; ") + formatted("%.7g, %.7g mm", base::toMm(at.x), base::toMm(at.y));
    }
    return places.size() <= kMost ? text : text + " and " + std::to_string(places.size() - kMost) + " more";
}

/// Says for how many of its kind the name of an item stands.
struct NameNoter {
    const BoardIndex& index;

    std::string operator()(PartOfCopy at) const {
        const Document& step = index.stepOf(at.copy);
        std::vector<Point> places;
        for (const ComponentId part : componentsNamedAs(step, at.component)) {
            places.push_back(step.components[part.row()].placement.origin);
        }
        return places.size() < 2 ? ""
                                 : std::to_string(places.size()) + " components are called " +
                                       step.components[at.component.row()].refdes + " (" +
                                       placesText(index, at.copy, places) + "): the nearest is taken";
    }
    std::string operator()(PinOfCopy at) const {
        const Document& step = index.stepOf(at.copy);
        std::vector<Point> places;
        for (const PinId pin : allPinsNamedAs(step, at.pin)) {
            const std::vector<ElementId> elements = index.pinsOf(at.copy).elementsOf(pin);
            if (std::ranges::any_of(elements, [&](ElementId element) { return isConductor(step, element); })) {
                places.push_back(step.pins[pin.row()].position);
            }
        }
        const ComponentId part = step.pins[at.pin.row()].component;
        const std::string ofParts = part.isValid() ? (*this)(PartOfCopy{at.copy, part}) : "";
        return !ofParts.empty() || places.size() < 2
                   ? ofParts
                   : nameOfPin(step, at.pin) + " has " + std::to_string(places.size()) + " pads (" +
                         placesText(index, at.copy, places) + "): the nearest is taken";
    }
    template <class Other>
    std::string operator()(const Other&) const {
        return {};
    }
};

void addEdge(const BoardIndex& index, Pieces& pieces) {
    pieces.figures = boardEdgeOf(*index.board);
    Piece edge;
    edge.hasHeights = true;
    edge.z = {base::kMaxCoordinate * -1, base::kMaxCoordinate};
    pieces.pieces.resize(pieces.figures.size(), edge);
}

void addLocation(const BoardIndex& index, const Location& location, Pieces& pieces) {
    pieces.figures.addTrack(location.at, location.at, 0.0);
    Piece piece;
    if (location.layer.isValid()) {
        const Layer& layer = index.board->layer(location.layer);
        piece.layer = piece.top = piece.bottom = location.layer;
        piece.hasHeights = isInStackup(layer);
        piece.z = {layer.z, layer.z + layer.thickness};
    }
    pieces.pieces.push_back(piece);
}

/// Calls `add(figures, copy, element)` for each element to have its figures.
template <class Add>
Pieces gathered(const BoardIndex& index, std::span<const BoardElement> elements, const Add& add) {
    Pieces pieces;
    pieces.elements.assign(elements.begin(), elements.end());
    for (const BoardElement at : elements) {
        const std::size_t before = pieces.figures.size();
        add(pieces.figures, index.tree.copies[at.copy], at.element);
        if (pieces.figures.size() == before) {
            pieces.empty.push_back(at);
        } else {
            pieces.pieces.resize(pieces.figures.size(), pieceOf(index, at));
        }
    }
    return pieces;
}

}  // namespace

std::vector<BoardElement> elementsOf(const BoardIndex& index, const MeasureItem& item) {
    return std::visit(Collector{index}, item);
}

std::optional<double> heightBetween(const Document& board, LayerId a, LayerId b) {
    if (!a.isValid() || !b.isValid() || !isInStackup(board.layer(a)) || !isInStackup(board.layer(b))) {
        return std::nullopt;
    }
    const auto above = [](const Layer& upper, const Layer& lower) {
        return static_cast<double>(upper.z) - lower.z - lower.thickness;
    };
    return std::max({0.0, above(board.layer(a), board.layer(b)), above(board.layer(b), board.layer(a))});
}

NetId netOf(const BoardIndex& index, BoardElement at) {
    return at.element.isValid() ? index.stepOf(at.copy).elements.net[at.element.row()] : NetId{};
}

LayerId layerOf(const BoardIndex& index, BoardElement at) {
    const Document& step = index.stepOf(at.copy);
    return step.layerOfCopy(step.elements.layer[at.element.row()], index.tree.copies[at.copy].isFlipped);
}

std::string nameOf(const BoardIndex& index, const MeasureItem& item) {
    return std::visit(Namer{index}, item);
}

std::string noteOnName(const BoardIndex& index, const MeasureItem& item) {
    return std::visit(NameNoter{index}, item);
}

std::string kindOf(const BoardIndex& index, BoardElement at) {
    const Document& step = index.stepOf(at.copy);
    if (const Body* body = step.bodyOf(at.element)) {
        return body->component.isValid() ? "body of " + step.components[body->component.row()].refdes : "body";
    }
    const ElementKind kind = step.elements.kind[at.element.row()];
    const bool isHole = (step.elements.flags[at.element.row()] & kHole) != 0;
    if (!isHole && !step.layer(step.elements.layer[at.element.row()]).isCopper()) {
        return kind == ElementKind::Trail ? "line" : toString(kind);
    }
    const PinId pin = pinOf(step, index.pinsOf(at.copy), at.element);
    return copperKind(step, at.element) + (pin.isValid() ? " " + fullPinName(step, pin) : "");
}

FigureTable boardEdgeOf(const Document& board) {
    FigureTable edge;
    if (board.profile.isValid()) {
        edge.addOutline(board.shapes, board.profile);
    }
    return edge;
}

std::optional<PointD> nearestOnEdge(const FigureTable& boardEdge, PointD location, double reach) {
    std::optional<PointD> nearest;
    for (std::size_t row = 0; row < boardEdge.size(); ++row) {
        visitEdges(boardEdge, row, boxAround(location, reach), [&](const Edge& edge) {
            const PointD on = nearestOn(edge, location);
            if (const double beside = distance(on, location); beside <= reach) {
                nearest = on;
                reach = beside;
            }
        });
    }
    return nearest;
}

Pieces piecesOf(const BoardIndex& index, std::span<const BoardElement> elements) {
    return gathered(index, elements, [&](FigureTable& figures, const StepCopy& copy, ElementId element) {
        figures.add(*index.tree.steps[copy.step], element, copy.placement);
    });
}

Pieces connectedPiecesOf(const BoardIndex& index, NetOfCopy net) {
    const SeveringHoles holes(index.stepOf(net.copy));
    return gathered(index, elementsOf(index, net), [&](FigureTable& figures, const StepCopy& copy, ElementId element) {
        holes.addTo(figures, element, copy.placement);
    });
}

Pieces piecesOf(const BoardIndex& index, const MeasureItem& item) {
    Pieces pieces = piecesOf(index, elementsOf(index, item));
    if (std::holds_alternative<BoardEdge>(item)) {
        addEdge(index, pieces);
    } else if (const Location* location = std::get_if<Location>(&item)) {
        addLocation(index, *location, pieces);
    }
    return pieces;
}

}  // namespace model
