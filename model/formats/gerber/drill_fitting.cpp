#include "model/formats/gerber/drill_fitting.h"

#include <algorithm>
#include <span>
#include <tuple>
#include <vector>

namespace model::gerber {

namespace {

constexpr Nm kReach = 30'000;
constexpr Nm kMargin = 2'000'000;
constexpr std::size_t kMostHits = 2'000;
constexpr double kProven = 0.6;  ///< share of the holes that lie in the middle of pads: the format is right

struct Fit {
    double onPads = 0.0;
    double inside = 0.0;
    double spread = 0.0;   ///< of the holes' box, as a share of the board's
    bool isFound = false;  ///< of a format that was already better than the first
};

Fit fitOf(const Image& image, const PadIndex& pads, const Box& copper) {
    const Box board = copper.grownBy(kMargin);
    Fit fit;
    Box box;
    std::size_t count = 0;
    const std::size_t step = image.features.size() / kMostHits + 1;
    for (std::size_t i = 0; i < image.features.size(); i += step) {
        const Point p = image.features[i].a;
        fit.onPads += pads.has(p, kReach) ? 1.0 : 0.0;
        fit.inside += board.holds(p) ? 1.0 : 0.0;
        box.include(p);
        ++count;
    }
    fit.onPads /= static_cast<double>(std::max<std::size_t>(count, 1));
    fit.inside /= static_cast<double>(std::max<std::size_t>(count, 1));
    fit.spread = static_cast<double>(std::max(box.width(), box.height())) /
                 static_cast<double>(std::max<std::int64_t>(std::max(copper.width(), copper.height()), 1));
    return fit;
}

/// Another format is taken for good reasons only: holes that would lie beside the board come onto it, or, of a file
/// that is silent about its unit, far more holes meet pads and they do not shrink to a corner.
bool isBetter(const Fit& fit, const Fit& than, bool isUnitTold) {
    const bool isOnBoard = fit.inside > 0.9 && than.inside < 0.5;
    const bool isOnPads = !isUnitTold && fit.onPads > than.onPads + 0.5 && fit.spread > 0.2;
    return (isOnBoard && fit.spread > 0.02) || isOnPads ||
           (fit.inside >= than.inside && than.inside > 0.9 && than.isFound && fit.onPads > than.onPads + 0.1 &&
            fit.spread >= than.spread);
}

std::vector<std::tuple<Nm, Nm>> placesOf(const Image& image) {
    std::vector<std::tuple<Nm, Nm>> places;
    for (const formats::DrawnFeature& feature : image.features) {
        places.emplace_back((feature.a.x + 5'000) / 10'000, (feature.a.y + 5'000) / 10'000);
    }
    std::ranges::sort(places);
    return places;
}

/// Reads the file in all other ways; false if none is better than `best`.
bool readOtherwise(ReadFile& drills, const PadIndex& pads, const Box& copper, Fit& best) {
    const bool isUnitTold = drills.head.isInch.has_value();
    bool isFound = false;
    const std::vector<CoordinateFormat> formats = likelyFormats(drills.head);  // it was read in the first of them
    for (const CoordinateFormat& format : std::span(formats).subspan(1)) {
        Image other = parseDrills(drills.bytes.view(), drills.path, format);
        const Fit fit = fitOf(other, pads, copper);
        if (other.features.size() >= drills.image.features.size() && isBetter(fit, best, isUnitTold)) {
            best = fit;
            best.isFound = isFound = true;
            drills.image = std::move(other);
            drills.format = format;
        }
    }
    return isFound;
}

void reportUnit(ReadFile& drills, bool isProven) {
    if (!drills.head.isInch) {
        drills.diagnostics.report(isProven ? Severity::Info : Severity::Warning, drills.path, 0,
                                  "the drill file does not say its unit; taken as " + describe(drills.format));
    }
}

}  // namespace

void fitToCopper(ReadFile& drills, const PadIndex& pads, const Box& copper) {
    // Of a file that is read too large by far, no hole is within what a board can be.
    const bool hasHoles = !drills.image.features.empty() || drills.head.hasHits;
    if (drills.kind != ReadFile::Kind::Drills || !hasHoles) {
        return;
    }
    if (copper.isEmpty()) {
        return reportUnit(drills, false);
    }
    Fit best = fitOf(drills.image, pads, copper);
    const bool isOnPads = best.onPads > kProven;
    if (isOnPads || (best.inside > 0.5 && drills.head.isInch)) {
        return reportUnit(drills, isOnPads);
    }
    const CoordinateFormat stated = drills.format;
    if (readOtherwise(drills, pads, copper, best)) {
        const bool isTold = drills.head.isInch &&
                            (drills.head.areAllWithPoint || (drills.head.isTrailingOmitted && drills.head.decimals));
        drills.diagnostics.report(isTold ? Severity::Warning : Severity::Info, drills.path, 0,
                                  "read as " + describe(drills.format) +
                                      ", which puts the holes on the copper, not as " + describe(stated) +
                                      (isTold ? ", as the file says" : ""));
        return;
    }
    reportUnit(drills, false);
    if (best.inside < 0.5) {
        drills.diagnostics.report(Severity::Warning, drills.path, 0,
                                  "most holes lie beside the copper, in whatever format their coordinates are read");
    }
}

bool areSameHoles(const Image& first, const Image& second) {
    const std::vector<std::tuple<Nm, Nm>> a = placesOf(first);
    const std::vector<std::tuple<Nm, Nm>> b = placesOf(second);
    std::vector<std::tuple<Nm, Nm>> both;
    std::ranges::set_intersection(a, b, std::back_inserter(both));
    return !b.empty() && both.size() * 10 >= b.size() * 9;
}

}  // namespace model::gerber
