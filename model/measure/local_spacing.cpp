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

/// The spacing of the two nearest of `hits`, which come nearest first.
std::optional<LocalSpacing> nearestSpacing(const BoardIndex& index, PointD location, std::span<const Hit> hits) {
    if (hits.size() < 2) {
        return std::nullopt;
    }
    FigureTable dot;
    dot.addTrack(location, location, 0.0);
    const Pieces near = piecesOf(index, std::array{hits[0].at});
    for (const Hit& hit : hits.subspan(1)) {
        if (isOneNet(index, hits[0].at, hit.at)) {
            continue;
        }
        const Pieces far = piecesOf(index, std::array{hit.at});
        if (const auto apart = spacingBetween(near.figures, far.figures); !apart || apart->distance <= kTouchNm) {
            continue;
        }
        FigureTable end;
        const PointD onFar = spacingBetween(dot, far.figures)->to;
        end.addTrack(onFar, onFar, 0.0);
        return LocalSpacing{*spacingBetween(end, near.figures), hit.at, hits[0].at, hit.layer};
    }
    return std::nullopt;
}

}  // namespace

std::optional<LocalSpacing> spacingAt(Picker& picker, PointD location, std::span<const PickLayer> layers) {
    const BoardIndex& index = picker.index();
    std::optional<LocalSpacing> best;
    double reach = kFirstReach;
    for (; !best && reach <= 2 * kLocalReach; reach *= 2) {
        double least = std::numeric_limits<double>::infinity();
        for (std::size_t row = 0; row < layers.size(); ++row) {
            if (!layers[row].isVisible || !index.board->layers[row].isCopper()) {
                continue;
            }
            std::vector<PickLayer> only(layers.size());
            only[row] = layers[row];
            std::vector<Hit> hits = picker.at(location, std::min(reach, kLocalReach), only, false);
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
