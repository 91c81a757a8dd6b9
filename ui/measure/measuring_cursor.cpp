#include "ui/measure/measuring_cursor.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "model/index/joined_pads.h"

namespace ui {

using model::SnapKind;

namespace {

/// The step of directions that held keys request, in degrees; none: any.
std::optional<double> lockOf(Qt::KeyboardModifiers modifiers) {
    return modifiers.testFlag(Qt::ShiftModifier)     ? std::optional(90.0)
           : modifiers.testFlag(Qt::ControlModifier) ? std::optional(45.0)
                                                     : std::nullopt;
}

/// Has a section plane taken what is there? Nothing of it is seen, so nothing is measured there.
bool isCutAway(const BoardView& view, base::PointD location) {
    const std::optional<model::CutSide> cut = Probing::cutSideOf(view);
    return cut && (location.x - cut->at.x) * cut->outward.x + (location.y - cut->at.y) * cut->outward.y > 0.0;
}

bool isOfPoints(Catch what) {
    return what == Catch::Points || what == Catch::Copper;
}

}  // namespace

void MeasuringCursor::setBoard(std::shared_ptr<const model::BoardIndex> index) {
    m_index = std::move(index);
    m_snapper.reset();
    m_picker.reset();
    m_boardEdge = m_index ? model::boardEdgeOf(*m_index->board) : model::FigureTable();
    if (m_index) {
        m_snapper.emplace(m_index);
        m_picker.emplace(m_index);
    }
}

std::optional<Caught> MeasuringCursor::at(const BoardView& view, QPointF position, Catch what,
                                          Qt::KeyboardModifiers modifiers, const Caught* first) {
    if (!m_index) {
        return std::nullopt;
    }
    if (std::exchange(m_last, position) != position) {
        m_skip = 0;
    }
    if (what == Catch::Elements) {
        const auto found = elementsAt(view, position, modifiers.testFlag(Qt::AltModifier), first);
        return found.empty() ? std::nullopt : std::optional(found[m_skip % found.size()]);
    }
    const std::optional<Pointed> pointed = pointedAt(view, position, what);
    if (!pointed) {
        return std::nullopt;
    }
    if (!isOfPoints(what)) {
        return pointed->hit ? std::optional(elementAt(*pointed, reachIn(view), what)) : std::nullopt;
    }
    std::optional<Caught> caught = pointAt(view, *pointed, what, !modifiers.testFlag(Qt::AltModifier));
    if (caught && caught->kind == SnapKind::Free && !caught->element) {
        findCopper(view, position, *caught);
    }
    const std::optional<double> lock = first != nullptr ? lockOf(modifiers) : std::nullopt;
    if (caught && lock) {
        const base::PointD straight = model::straightened(first->at, caught->at, *lock);
        if (std::hypot(straight.x - caught->at.x, straight.y - caught->at.y) > 1.0) {
            caught->kind = SnapKind::Free;  // beside what was snapped to
        }
        caught->at = straight;
    }
    if (caught) {
        caught->isInPlan = view.kind() == BoardView::Kind::Flat;
    }
    return caught;
}

std::vector<Caught> MeasuringCursor::elementsAt(const BoardView& view, QPointF position, bool takesHoles,
                                                const Caught* first) {
    const std::vector<model::Hit> hits = m_probing.hitsAt(view, position);
    const std::optional<Pointed> pointed =
        hits.empty() ? pointedAt(view, position, Catch::Elements)
                     : std::optional(Pointed{seenAt(view, position, hits.front()), hits.front()});
    std::vector<Caught> found;
    if (!pointed) {
        return found;
    }
    const auto add = [&](const model::Hit& hit, base::PointD at) {
        if (std::ranges::find(found, hit.at, &Caught::element) == found.end()) {
            found.push_back(elementAt({at, hit}, 0.0, Catch::Elements));
        }
    };
    const auto itemOf = [&](const model::Hit& hit) {
        return (takesHoles ? holeIn(hit, hits) : padAround(hit, hits)).value_or(hit);
    };
    if (std::optional<Caught> edge = edgeAt(view, *pointed)) {
        found.push_back(*edge);
    } else if (pointed->hit && first != nullptr && first->element == itemOf(*pointed->hit).at) {
        add(beneath(hits, itemOf(*pointed->hit)), pointed->location);
    }
    for (const model::Hit& hit : hits) {
        const base::PointD at = seenAt(view, position, hit);
        add(itemOf(hit), at);
        add(hit, at);
    }
    return found;
}

std::optional<Caught> MeasuringCursor::edgeAt(const BoardView& view, const Pointed& pointed) const {
    if (view.kind() != BoardView::Kind::Flat) {
        return std::nullopt;
    }
    const auto on = model::nearestOnEdge(m_boardEdge, pointed.location, reachIn(view));
    const auto isDrawing = [&](const model::Hit& hit) {
        return !model::heightBetween(*m_index->board, hit.layer, hit.layer).has_value();
    };
    const bool isFarther =
        on && pointed.hit &&
        pointed.hit->missedBy <= std::hypot(on->x - pointed.location.x, on->y - pointed.location.y) &&
        !isDrawing(*pointed.hit);
    if (!on || isFarther) {
        return std::nullopt;
    }
    return Caught{.at = *on, .kind = SnapKind::Edge, .layer = {}, .element = std::nullopt, .isOnEdge = true};
}

std::optional<model::Hit> MeasuringCursor::padAround(const model::Hit& hole, std::span<const model::Hit> hits) const {
    const auto flagsOf = [this](const model::BoardElement& at) {
        return m_index->stepOf(at.copy).elements.flags[at.element.row()];
    };
    if (!model::isPlatedHole(flagsOf(hole.at))) {
        return std::nullopt;
    }
    const model::NetId net = model::netOf(*m_index, hole.at);
    const auto pad = std::ranges::find_if(hits, [&](const model::Hit& hit) {
        return hit.missedBy == 0.0 && (flagsOf(hit.at) & model::kPad) != 0 && hit.at.copy == hole.at.copy &&
               m_index->board->layer(hit.layer).isCopper() && model::netOf(*m_index, hit.at) == net;
    });
    return pad == hits.end() ? std::nullopt : std::optional(*pad);
}

std::optional<model::Hit> MeasuringCursor::holeIn(const model::Hit& pad, std::span<const model::Hit> hits) const {
    const auto hole = std::ranges::find_if(hits, [&](const model::Hit& hit) {
        const std::optional<model::Hit> around = padAround(hit, hits);
        return hit.missedBy == 0.0 && around && around->at == pad.at;
    });
    return hole == hits.end() ? std::nullopt : std::optional(*hole);
}

model::Hit MeasuringCursor::beneath(std::span<const model::Hit> hits, const model::Hit& seen) const {
    const std::vector<model::BoardElement> joined = model::joinedPads(*m_index, seen.at);
    const auto isSamePiece = [&](const model::Hit& hit) {
        const bool isOfNet =
            hit.at.copy == seen.at.copy && model::netOf(*m_index, hit.at) == model::netOf(*m_index, seen.at);
        const bool isOnLayer = hit.layer == seen.layer || isHole(hit.at) || isHole(seen.at);
        return (isOfNet && isOnLayer) || std::ranges::count(joined, hit.at) > 0;
    };
    for (const model::Hit& hit : hits) {
        const model::Hit item = padAround(hit, hits).value_or(hit);
        const bool isCopper = m_index->board->layer(item.layer).isCopper() || isHole(item.at);
        if (isCopper && hit.missedBy == 0.0 && !isSamePiece(item)) {
            return item;
        }
    }
    return seen;
}

bool MeasuringCursor::isHole(const model::BoardElement& at) const {
    return (m_index->stepOf(at.copy).elements.flags[at.element.row()] & model::kHole) != 0;
}

void MeasuringCursor::step(int by) {
    m_skip = by > 0 ? m_skip + 1 : std::max<std::size_t>(m_skip, 1) - 1;
}

void MeasuringCursor::findCopper(const BoardView& view, QPointF position, Caught& caught) {
    if (view.kind() != BoardView::Kind::Flat) {
        return;
    }
    for (const model::Hit& hit : m_probing.hitsAt(view, position)) {
        if (hit.missedBy == 0.0 && m_index->board->layer(hit.layer).isCopper()) {
            caught.element = hit.at;
            caught.layer = hit.layer;
            return;
        }
    }
}

base::PointD MeasuringCursor::seenAt(const BoardView& view, QPointF position, const model::Hit& hit) {
    const auto [origin, direction] = view.controller().rayAt(position);
    const bool isFlat = view.kind() == BoardView::Kind::Flat;
    // The picker counts its steps in millimetres.
    return view.position().toJob(isFlat ? origin : origin + glm::normalize(direction) * static_cast<float>(hit.depth));
}

std::optional<MeasuringCursor::Pointed> MeasuringCursor::pointedAt(const BoardView& view, QPointF position,
                                                                   Catch what) {
    const auto [origin, direction] = view.controller().rayAt(position);
    const BoardPosition& location = view.position();
    const bool isFlat = view.kind() == BoardView::Kind::Flat;
    Pointed pointed{location.toJob(origin), std::nullopt, direction.z > 0.0F};
    if (isFlat && what == Catch::Points) {
        return pointed;  // everything there is a candidate, nothing need be searched
    }
    for (const model::Hit& hit : m_probing.hitsAt(view, position)) {
        const base::PointD seen = seenAt(view, position, hit);
        if (isWanted(hit, seen, reachIn(view), what)) {
            pointed.location = seen;
            pointed.hit = hit;
            return pointed;
        }
    }
    const std::optional<glm::vec3> face = view.controller().boardPointAt(position);
    if (!isFlat && !face) {
        return std::nullopt;
    }
    pointed.location = isFlat ? pointed.location : location.toJob(*face);
    const bool isGone = !isFlat && isCutAway(view, pointed.location);
    return isGone ? std::nullopt : std::optional(pointed);
}

bool MeasuringCursor::isWanted(const model::Hit& hit, base::PointD location, double reach, Catch what) {
    switch (what) {
        case Catch::Copper: return isNetCopper(hit.at);
        case Catch::Straight: return model::straightAt(*m_index, hit.at, location, reach).has_value();
        case Catch::Round: return model::roundAt(*m_index, hit.at, location, reach).has_value();
        default: return true;
    }
}

bool MeasuringCursor::isNetCopper(model::BoardElement at) const {
    const model::Document& step = *m_index->tree.steps[m_index->tree.copies[at.copy].step];
    const std::size_t row = at.element.row();
    return model::netOf(*m_index, at).isValid() &&
           (step.layer(step.elements.layer[row]).isCopper() || model::isPlatedHole(step.elements.flags[row]));
}

bool MeasuringCursor::isArea(model::BoardElement at) const {
    const model::Document& step = *m_index->tree.steps[m_index->tree.copies[at.copy].step];
    return step.elements.kind[at.element.row()] == model::ElementKind::Area;
}

std::vector<model::PickLayer> MeasuringCursor::layersFor(const BoardView& view, const Pointed& pointed,
                                                         Catch what) const {
    std::vector<model::PickLayer> layers = m_probing.layersOf(view);
    const bool isSolid = view.kind() == BoardView::Kind::Solid;
    for (std::size_t row = 0; row < layers.size(); ++row) {
        const model::Layer& layer = m_index->board->layers[row];
        const bool isCopper = layer.isCopper() || layer.type == model::LayerType::Drill;
        const bool isSeen = !isSolid || (pointed.hit && pointed.hit->layer == model::LayerId{row});
        layers[row].isVisible = layers[row].isVisible && isSeen && (what != Catch::Copper || isCopper);
    }
    return layers;
}

std::optional<Caught> MeasuringCursor::pointAt(const BoardView& view, const Pointed& pointed, Catch what,
                                               bool isSnapping) {
    if (!view.hasScene()) {
        return std::nullopt;
    }
    const std::vector<model::PickLayer> layers = layersFor(view, pointed, what);
    if (isSnapping) {
        const model::SnapPoint snap =
            m_snapper->at(pointed.location, reachIn(view), layers, pointed.isFromBelow, m_skip);
        const bool isOfBoard = snap.kind != SnapKind::Free && !snap.element.element.isValid();
        if (isOfBoard && what != Catch::Copper) {
            return Caught{.at = snap.at, .kind = snap.kind, .layer = {}, .element = std::nullopt, .isOnEdge = true};
        }
        if (snap.kind != SnapKind::Free && !isOfBoard && (what != Catch::Copper || isNetCopper(snap.element))) {
            return Caught{.at = snap.at, .kind = snap.kind, .layer = snap.layer, .element = snap.element};
        }
    }
    if (what == Catch::Copper) {
        return pointed.hit ? std::optional(elementAt(pointed, 0.0, Catch::Elements)) : std::nullopt;
    }
    return Caught{pointed.location, SnapKind::Free, pointed.hit ? pointed.hit->layer : model::LayerId{}, {}};
}

Caught MeasuringCursor::elementAt(const Pointed& pointed, double reach, Catch what) {
    const model::Hit& hit = *pointed.hit;
    Caught caught{pointed.location, SnapKind::Free, hit.layer, hit.at};
    if (what == Catch::Straight) {
        caught.line = model::straightAt(*m_index, hit.at, pointed.location, reach);
        caught.at = model::nearestOn(*caught.line, pointed.location);
        caught.kind = SnapKind::Edge;
    } else if (what == Catch::Round) {
        caught.round = model::roundAt(*m_index, hit.at, pointed.location, reach);
        caught.at = caught.round->on;
        caught.kind = SnapKind::Edge;
    }
    return caught;
}

std::optional<model::BoardElement> MeasuringCursor::emptyAt(const BoardView& view, QPointF position) {
    if (!m_snapper || view.kind() != BoardView::Kind::Flat) {
        return std::nullopt;
    }
    return m_snapper->emptyAt(view.locationAt(position), reachIn(view), m_probing.layersOf(view));
}

std::optional<model::LocalSpacing> MeasuringCursor::spacingAt(const BoardView& view, QPointF position) {
    const std::optional<Pointed> pointed = m_index ? pointedAt(view, position, Catch::Points) : std::nullopt;
    if (!pointed) {
        return std::nullopt;
    }
    std::vector<model::PickLayer> layers = m_probing.layersOf(view);
    const std::vector<model::Hit> hits = m_probing.hitsAt(view, position);
    const auto copper = std::ranges::find_if(hits, [&](const model::Hit& hit) {
        return hit.missedBy == 0.0 && m_index->board->layer(hit.layer).isCopper();
    });
    if (copper != hits.end() && !isArea(copper->at)) {
        for (std::size_t row = 0; row < layers.size(); ++row) {
            layers[row].isVisible = model::LayerId{row} == copper->layer;
        }
    }
    return model::spacingAt(*m_picker, pointed->location, layers);
}

double MeasuringCursor::reachIn(const BoardView& view) const {
    return kCatchPixels * view.controller().nmPerPixel();
}

}  // namespace ui
