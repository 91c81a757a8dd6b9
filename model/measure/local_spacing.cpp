#include "model/measure/local_spacing.h"

#include <array>

#include "model/figures/distance.h"

namespace model {

namespace {

constexpr double kFirstReach = 0.1e6;

bool isOneNet(const BoardIndex& index, BoardElement a, BoardElement b) {
    const NetId net = netOf(index, a);
    return a.copy == b.copy && net.isValid() && net == netOf(index, b);
}

FigureTable dotAt(PointD location) {
    FigureTable dot;
    dot.addTrack(location, location, 0.0);
    return dot;
}

/// From the point of one figure that is nearest to the location, to and fro until both ends stay where they are.
Spacing leastAround(PointD location, const FigureTable& from, const FigureTable& to) {
    constexpr int kMostRounds = 64;
    constexpr double kSettledNm = 1e-6;
    Spacing spacing = *spacingBetween(dotAt(spacingBetween(dotAt(location), from)->to), to);
    for (int round = 0; round < kMostRounds; ++round) {
        const PointD start = spacingBetween(dotAt(spacing.to), from)->to;
        const Spacing next = *spacingBetween(dotAt(start), to);
        const bool isSettled = spacing.distance - next.distance < kSettledNm;
        spacing = next.distance < spacing.distance ? next : spacing;
        if (isSettled) {
            break;
        }
    }
    return spacing;
}

/// The spacing of the two nearest of `hits`, which come nearest first.
std::optional<LocalSpacing> nearestSpacing(const BoardIndex& index, PointD location, std::span<const Hit> hits) {
    if (hits.size() < 2) {
        return std::nullopt;
    }
    const Pieces near = piecesOf(index, std::array{hits[0].at});
    for (const Hit& hit : hits.subspan(1)) {
        if (isOneNet(index, hits[0].at, hit.at)) {
            continue;
        }
        const Pieces far = piecesOf(index, std::array{hit.at});
        if (const auto apart = spacingBetween(near.figures, far.figures); !apart || apart->distance <= kTouchNm) {
            continue;
        }
        return LocalSpacing{leastAround(location, far.figures, near.figures), hit.at, hits[0].at, hit.layer};
    }
    return std::nullopt;
}

/// Those drawn as areas too.
bool isPad(const BoardIndex& index, const Hit& hit) {
    const Document& step = index.stepOf(hit.at.copy);
    const SubnetId subnet = step.elements.subnet[hit.at.element.row()];
    return hit.isPad || (subnet.isValid() && step.subnets[subnet.row()].kind == SubnetKind::PinPads);
}

/// From the pad that a hit says the location is on to the copper of the layer nearest to it.
std::optional<LocalSpacing> spacingOfPad(Picker& picker, PointD location, const Hit& pad,
                                         std::span<const PickLayer> layer) {
    const BoardIndex& index = picker.index();
    const Pieces own = piecesOf(index, std::array{pad.at});
    std::optional<LocalSpacing> best;
    for (double reach = kFirstReach; !best && reach <= 2 * kLocalReach; reach *= 2) {
        double limit = std::min(reach, kLocalReach);
        // What is within reach of the pad lies no farther from any point of it than that.
        for (const Hit& hit : picker.at(location, pad.size + limit, layer, false)) {
            if (hit.at == pad.at || isOneNet(index, pad.at, hit.at)) {
                continue;
            }
            const Pieces other = piecesOf(index, std::array{hit.at});
            const auto spacing = spacingBetween(other.figures, own.figures, limit);
            if (spacing && spacing->distance > kTouchNm) {
                best = LocalSpacing{*spacing, hit.at, pad.at, hit.layer};
                limit = spacing->distance;
            }
        }
    }
    return best;
}

/// The visible copper layers, each as a list in which it alone is visible.
std::vector<std::vector<PickLayer>> copperAlone(const Document& board, std::span<const PickLayer> layers) {
    std::vector<std::vector<PickLayer>> alone;
    for (std::size_t row = 0; row < layers.size(); ++row) {
        if (layers[row].isVisible && board.layers[row].isCopper()) {
            alone.emplace_back(layers.size())[row] = layers[row];
        }
    }
    return alone;
}

/// Of all pads that cover the location, a via in an exposed pad too, the least.
std::optional<LocalSpacing> spacingOfPads(Picker& picker, PointD location,
                                          const std::vector<std::vector<PickLayer>>& layers) {
    std::optional<LocalSpacing> best;
    for (const std::vector<PickLayer>& layer : layers) {
        for (const Hit& hit : picker.at(location, 0.0, layer, false)) {
            const auto found = isPad(picker.index(), hit) ? spacingOfPad(picker, location, hit, layer) : std::nullopt;
            if (found && (!best || found->spacing.distance < best->spacing.distance)) {
                best = found;
            }
        }
    }
    return best;
}

}  // namespace

std::optional<LocalSpacing> spacingAt(Picker& picker, PointD location, std::span<const PickLayer> layers) {
    const BoardIndex& index = picker.index();
    const std::vector<std::vector<PickLayer>> alone = copperAlone(*index.board, layers);
    std::optional<LocalSpacing> best = spacingOfPads(picker, location, alone);
    for (double reach = kFirstReach; !best && reach <= 2 * kLocalReach; reach *= 2) {
        double least = std::numeric_limits<double>::infinity();
        for (const std::vector<PickLayer>& layer : alone) {
            std::vector<Hit> hits = picker.at(location, std::min(reach, kLocalReach), layer, false);
            std::ranges::stable_sort(hits, {}, &Hit::missedBy);
            const auto found = nearestSpacing(index, location, hits);
            const auto farther =
                std::ranges::find_if(hits, [&](const Hit& hit) { return found && hit.at == found->from; });
            if (found && farther->missedBy < least) {
                least = farther->missedBy;
                best = found;
            }
        }
    }
    return best;
}

}  // namespace model
