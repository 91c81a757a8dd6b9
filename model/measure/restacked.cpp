#include "model/measure/restacked.h"

#include <algorithm>
#include <cmath>

#include "model/measure/items.h"
#include "model/measure/net_path.h"
#include "model/measure/separation.h"

namespace model {

namespace {

/// Other kinds lie on one layer, or are of the plane.
bool isThroughStackup(const Measurement& measurement) {
    return measurement.kind == MeasurementKind::Points || measurement.kind == MeasurementKind::Clearance;
}

double heightOf(const Document& board, const Measurement& measurement) {
    return heightBetween(board, board.findLayer(measurement.from.layer), board.findLayer(measurement.to.layer))
        .value_or(0.0);
}

/// From the middle of the copper of one layer on the path to that of the next.
double holeHeightOf(const Document& board, const Measurement& measurement) {
    std::vector<double> middles;
    const auto add = [&](const std::string& name) {
        const LayerId id = board.findLayer(name);
        if (id.isValid() && board.layer(id).isCopper()) {  // a path may begin at a hole, on any of its layers
            middles.push_back(board.layer(id).z + board.layer(id).thickness / 2.0);
        }
    };
    add(measurement.from.layer);
    std::ranges::for_each(measurement.path->runs, add, &MeasuredRun::layer);
    add(measurement.to.layer);
    double sum = 0.0;
    for (std::size_t i = 0; i + 1 < middles.size(); ++i) {
        sum += std::abs(middles[i + 1] - middles[i]);
    }
    return sum;
}

/// What bodies and holes have beyond the heights of their layers stays as it was.
double moved(double value, double before, double now) {
    constexpr double kSameNm = 0.5;
    return std::abs(value - now) < kSameNm ? value : std::max(0.0, value + (now - before));
}

/// In the place of the one that begins alike; an empty note takes it away.
void setNote(std::vector<std::string>& notes, const std::string& beginning, const std::string& note) {
    const auto at = std::ranges::find_if(notes, [&](const std::string& each) { return each.starts_with(beginning); });
    if (note.empty()) {
        notes.erase(at, at == notes.end() ? at : at + 1);
    } else if (at != notes.end()) {
        *at = note;
    } else {
        notes.push_back(note);
    }
}

}  // namespace

Measurement restacked(const Document& before, const Document& now, Measurement measurement) {
    if (isThroughStackup(measurement)) {
        measurement.dz = moved(measurement.dz, heightOf(before, measurement), heightOf(now, measurement));
        const bool hasHeight = measurement.dz > 0;
        setNote(measurement.notes, kHeightIsAssumed,
                hasHeight
                    ? noteOnHeight(now, now.findLayer(measurement.from.layer), now.findLayer(measurement.to.layer))
                    : std::string());
    }
    if (measurement.path && measurement.path->holeCount > 0) {
        double& height = measurement.path->holeHeight;
        height = moved(height, holeHeightOf(before, measurement), holeHeightOf(now, measurement));
        setNote(measurement.notes, kHolesAreAssumed, noteOnHoles(now));
    }
    return measurement;
}

}  // namespace model
