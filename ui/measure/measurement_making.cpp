#include "ui/measure/measurement_making.h"

#include <cmath>
#include <utility>

#include "model/board/single_element.h"
#include "model/index/joined_pads.h"
#include "model/measure/separation.h"

namespace ui {

using model::BoardElement;
using model::BoardIndex;
using model::Measurement;
using model::MeasurementKind;
using model::SnapKind;

namespace {

base::Error noNumber(std::string why) {
    return {base::ErrorCode::BadUsage, std::move(why)};
}

Measurement measurementOf(const BoardIndex& index, MeasurementKind kind, const Caught& from, const Caught& to) {
    Measurement measurement;
    measurement.kind = kind;
    measurement.from = endOf(index, from);
    measurement.to = endOf(index, to);
    return measurement;
}

/// Between two elements, which the ends name: their nets may be nearer to each other elsewhere.
Measurement betweenElements(const BoardIndex& index, MeasurementKind kind, const Caught& from, const Caught& to) {
    Measurement measurement = measurementOf(index, kind, from, to);
    const auto itemOf = [&](const Caught& caught) {
        const bool isElement = caught.element && caught.element->element.isValid();
        return isElement         ? model::kindOf(index, *caught.element)
               : caught.isOnEdge ? std::string(model::kBoardEdgeItem)
                                 : std::string();
    };
    measurement.from.item = itemOf(from);
    measurement.to.item = itemOf(to);
    return measurement;
}

Caught edgeOf(base::PointD at, model::LayerId layer, BoardElement element) {
    return {at, SnapKind::Edge, layer, element};
}

std::string layerName(const BoardIndex& index, model::LayerId layer) {
    return layer.isValid() ? index.board->layer(layer).name : "";
}

/// What measuring to all copper of a net costs.
std::size_t nodesOf(const BoardIndex& index, const model::NetOfCopy& net) {
    std::size_t nodes = 0;
    for (const model::ElementId element : index.stepOf(net.copy).elementsOf(net.net)) {
        nodes += model::nodeCountOf(index.stepOf(net.copy), element);
    }
    return nodes;
}

/// Of the two that lie nearest: a hole lies on many.
std::string copperNameOf(const BoardIndex& index, const model::PieceDistance& nearest) {
    for (const model::LayerId layer : {nearest.from.layer, nearest.to.layer}) {
        if (layer.isValid() && index.board->layer(layer).isCopper()) {
            return layerName(index, layer);
        }
    }
    return {};
}

/// Legs on one layer, one after the other, are a run.
model::MeasuredPath pathOf(const BoardIndex& index, const model::NetPath& path) {
    model::MeasuredPath measured{{}, path.holeCount, path.holeHeight};
    bool isBroken = true;
    for (const model::PathLeg& leg : path.legs) {
        if (leg.kind == model::PathLeg::Kind::Hole) {
            isBroken = true;
            continue;
        }
        if (isBroken) {
            measured.runs.push_back({layerName(index, leg.layer), 0.0, {}});
            isBroken = false;
        }
        std::vector<base::PointD>& line = measured.runs.back().line;
        const std::vector<base::PointD> course = model::courseOf(index, leg);
        line.insert(line.end(), course.begin() + (line.empty() ? 0 : 1), course.end());
        measured.runs.back().length += leg.length;
    }
    return measured;
}

/// Of two pads of holes without a common layer, others of the same holes may have one: which of them was clicked, only
/// the current layer has decided. The nearest of those on one layer.
std::optional<model::Separation> separationOfJoinedPads(const BoardIndex& index, BoardElement a, BoardElement b) {
    std::optional<model::Separation> nearest;
    const std::vector<BoardElement> others = model::joinedPads(index, b);
    for (const BoardElement& from : model::joinedPads(index, a)) {
        for (const BoardElement& to : others) {
            if (model::layerOf(index, from) != model::layerOf(index, to)) {
                continue;
            }
            base::Progress progress;
            auto separation = model::separationOf(index, from, to, progress, model::Depths::OfMain);
            const bool isNearer = separation && separation->onLayer &&
                                  (!nearest || separation->onLayer->distance < nearest->onLayer->distance);
            if (isNearer) {
                nearest = std::move(*separation);
            }
        }
    }
    return nearest;
}

/// On the layer of the copper. Its width is the value, which needs no note.
Measurement ringOf(const BoardIndex& index, const model::Separation& separation, Caught from, Caught to) {
    const bool isCopperFirst = from.layer.isValid() && index.board->layer(from.layer).isCopper();
    (isCopperFirst ? to.layer : from.layer) = isCopperFirst ? from.layer : to.layer;
    from.at = separation.annularRing->from;
    to.at = separation.annularRing->to;
    Measurement measurement = betweenElements(index, MeasurementKind::Ring, from, to);
    measurement.notes = separation.notes;
    std::erase_if(measurement.notes, [](const std::string& note) { return note.starts_with(model::kAnnularRing); });
    return measurement;
}

base::Result<model::Separation> separationOf(const BoardIndex& index, const Caught& a, const Caught& b) {
    const auto itemOf = [](const Caught& caught) {
        return caught.isOnEdge ? model::MeasureItem(model::BoardEdge{}) : model::MeasureItem(*caught.element);
    };
    base::Progress progress;
    ASSIGN_OR_RETURN(model::Separation separation,
                     model::separationOf(index, itemOf(a), itemOf(b), progress, model::Depths::OfMain));
    const bool areApart = separation.inPlane && !separation.onLayer && !a.isOnEdge && !b.isOnEdge;
    if (auto joined = areApart ? separationOfJoinedPads(index, *a.element, *b.element) : std::nullopt) {
        return std::move(*joined);
    }
    return separation;
}

}  // namespace

model::MeasuredEnd endOf(const BoardIndex& index, const Caught& caught) {
    model::MeasuredEnd end{caught.at.x, caught.at.y, layerName(index, caught.layer), {}, toString(caught.kind)};
    if (caught.element && caught.element->element.isValid()) {
        const model::NetId net = model::netOf(index, *caught.element);
        const model::Document& step = *index.tree.steps[index.tree.copies[caught.element->copy].step];
        end.net = net.isValid() ? step.nets[net.row()].name : "";
    }
    if (caught.isOnEdge) {
        end.item = model::kBoardEdgeItem;
    }
    return end;
}

Measurement pointToPoint(const BoardIndex& index, const Caught& from, const Caught& to) {
    Measurement measurement = measurementOf(index, MeasurementKind::Points, from, to);
    measurement.isPlanar = from.isInPlan && to.isInPlan;
    measurement.dz = model::heightBetween(*index.board, from.layer, to.layer).value_or(0.0);
    if (const std::string note = model::noteOnHeight(*index.board, from.layer, to.layer); !note.empty()) {
        measurement.notes.push_back(note);
    }
    return measurement;
}

base::Result<Measurement> edgeToEdge(const BoardIndex& index, const Caught& a, const Caught& b) {
    ASSIGN_OR_RETURN(const model::Separation separation, separationOf(index, a, b));
    const model::PieceDistance* nearest = separation.main();
    if (nearest == nullptr) {
        return noNumber(separation.notes.front());
    }
    Caught from = edgeOf(nearest->spacing.from, nearest->from.layer, nearest->from.at);
    Caught to = edgeOf(nearest->spacing.to, nearest->to.layer, nearest->to.at);
    from.isOnEdge = !nearest->from.at.element.isValid();
    to.isOnEdge = !nearest->to.at.element.isValid();
    if (separation.annularRing) {
        return ringOf(index, separation, std::move(from), std::move(to));
    }
    Measurement measurement = betweenElements(index, MeasurementKind::Clearance, from, to);
    measurement.dz = nearest->dz;
    measurement.overlap = nearest->relation == model::Relation::Overlapping ? nearest->overlap : 0.0;
    measurement.notes = separation.notes;
    return measurement;
}

std::optional<CloserNets> netsCloserThan(const BoardIndex& index, double distance, BoardElement a, BoardElement b) {
    constexpr std::size_t kMostNodes = 50'000;  // a click is answered at once
    constexpr double kLeastNm = 1.0;            // closer by less is rounding
    const model::NetOfCopy netA{a.copy, model::netOf(index, a)};
    const model::NetOfCopy netB{b.copy, model::netOf(index, b)};
    const bool isOneNet = netA.copy == netB.copy && netA.net == netB.net;
    if (distance < kLeastNm || !netA.net.isValid() || !netB.net.isValid() || isOneNet ||
        nodesOf(index, netA) + nodesOf(index, netB) > kMostNodes) {
        return std::nullopt;
    }
    base::Progress progress;
    const auto nearest = model::closestOnLayer(index, netA, netB, progress);
    if (!nearest || nearest->distance > distance - kLeastNm) {
        return std::nullopt;
    }
    return CloserNets{copperNameOf(index, *nearest), nearest->distance};
}

Measurement spacingOn(const BoardIndex& index, const ShownSpacing& spacing) {
    Measurement measurement =
        betweenElements(index, MeasurementKind::Spacing, edgeOf(spacing.spacing.from, spacing.fromLayer, spacing.from),
                        edgeOf(spacing.spacing.to, spacing.toLayer, spacing.to));
    measurement.dz = spacing.height;
    return measurement;
}

Measurement angleAt(const BoardIndex& index, const Caught& corner, const Caught& from, const Caught& to) {
    Measurement measurement = measurementOf(index, MeasurementKind::Angle, from, to);
    measurement.corner = endOf(index, corner);
    return measurement;
}

base::Result<Measurement> angleOfLines(const BoardIndex& index, const Caught& a, const Caught& b) {
    const std::optional<base::PointD> crossing = model::linesCross(*a.line, *b.line);
    if (!crossing) {
        return noNumber("both lines are parallel, so they cross nowhere");
    }
    return angleAt(index, {*crossing, SnapKind::Crossing, a.layer, std::nullopt, {}, {}}, a, b);
}

Measurement radiusOf(const BoardIndex& index, const Caught& caught) {
    Caught centre = caught;
    centre.at = caught.round->centre;
    centre.kind = SnapKind::Centre;
    return measurementOf(index, MeasurementKind::Radius, centre, caught);
}

base::Result<Measurement> lengthAlong(const BoardIndex& index, const Caught& from, const Caught& to,
                                      const model::NetPath& path) {
    if (path.legs.empty()) {
        return noNumber("there is no path to measure: both ends are in one location");
    }
    Measurement measurement = measurementOf(index, MeasurementKind::Length, from, to);
    measurement.path = pathOf(index, path);
    measurement.notes = path.notes;
    return measurement;
}

std::vector<std::pair<base::PointD, std::string>> locationsOf(const Measurement& measurement) {
    std::vector<std::pair<base::PointD, std::string>> locations;
    const auto add = [&](const model::MeasuredEnd& end) { locations.push_back({{end.x, end.y}, end.layer}); };
    add(measurement.from);
    add(measurement.to);
    if (measurement.corner) {
        add(*measurement.corner);
    }
    if (measurement.kind == MeasurementKind::Radius) {  // the whole circle
        const double radius = std::hypot(measurement.dx(), measurement.dy());
        locations.push_back({{measurement.from.x - radius, measurement.from.y - radius}, measurement.from.layer});
        locations.push_back({{measurement.from.x + radius, measurement.from.y + radius}, measurement.from.layer});
    }
    for (std::size_t run = 0; measurement.path && run < measurement.path->runs.size(); ++run) {
        for (const base::PointD& corner : measurement.path->runs[run].line) {
            locations.push_back({corner, measurement.path->runs[run].layer});
        }
    }
    return locations;
}

model::MeasureItem pathEndOf(const BoardIndex& index, const Caught& caught) {
    const BoardElement at = *caught.element;
    const model::Document& step = *index.tree.steps[index.tree.copies[at.copy].step];
    const std::size_t row = at.element.row();
    const bool isHub = (step.elements.flags[row] & (model::kPad | model::kHole)) != 0 ||
                       step.elements.kind[row] == model::ElementKind::Circle;
    return isHub ? model::MeasureItem(at) : model::MeasureItem(model::Location{caught.at, caught.layer});
}

}  // namespace ui
