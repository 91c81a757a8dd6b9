#include "model/formats/gerber/drill_fitting.h"

#include <algorithm>
#include <span>
#include <vector>

#include "model/base/units.h"
#include "model/formats/common/shift.h"
#include "model/formats/gerber/text/words.h"

namespace model::gerber {

namespace {

constexpr Nm kReach = 30'000;
constexpr Nm kMargin = 2'000'000;
constexpr std::size_t kMostHits = 2'000;
constexpr double kProven = 0.6;        ///< share of the holes that lie in the middle of pads: the format is right
constexpr double kPlausible = 0.3;     ///< a format that the file denies may be right; of its holes many need no pads
constexpr double kMostlyOnPads = 0.7;  ///< holes of a format that is told: they are moved onto pads
constexpr double kNearlyAllOnPads = 0.9;    ///< the same of a format that is assumed
constexpr std::size_t kFewestToMove = 5;    ///< holes that can tell where a file counts from
constexpr std::size_t kFewestAssumed = 20;  ///< the same of a format that is assumed
constexpr Nm kSameHole = 20'000;  ///< of places that two files round, and may count from origins that are rounded

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

/// Unit and digits: a file that says both may count from another origin, but is hardly written in another format.
bool isFormatTold(const DrillHead& head) {
    return head.isInch && (head.areAllWithPoint || head.decimals);
}

/// Another format is taken for good reasons only: holes that would lie beside the board come onto it, and onto pads if
/// the file says its format, or, of a file that is silent about its unit, far more holes meet pads and they do not
/// shrink to a corner.
bool isBetter(const Fit& fit, const Fit& than, const DrillHead& head) {
    const bool isUnitTold = head.isInch.has_value();
    const bool isOnBoard = fit.inside > 0.9 && than.inside < 0.5 && (!isFormatTold(head) || fit.onPads >= kPlausible);
    const bool isOnPads = !isUnitTold && fit.onPads > than.onPads + 0.5 && fit.spread > 0.2;
    return (isOnBoard && fit.spread > 0.02) || isOnPads ||
           (fit.inside >= than.inside && than.inside > 0.9 && than.isFound && fit.onPads > than.onPads + 0.1 &&
            fit.spread >= than.spread);
}

/// Of slots, whose ends files may write in either order.
Point middleOf(const formats::DrawnFeature& feature) {
    Box box;
    box.include(feature.a);
    box.include(feature.kind == formats::DrawnKind::Line ? feature.b : feature.a);
    return box.middle();
}

/// Reads the file in all other ways; false if none is better than `best`.
bool readOtherwise(ReadFile& drills, const PadIndex& pads, const Box& copper, Fit& best) {
    bool isFound = false;
    const std::vector<CoordinateFormat> formats = likelyFormats(drills.head);  // it was read in the first of them
    for (CoordinateFormat format : std::span(formats).subspan(1)) {
        format.shift = drills.format.shift;
        Image other = parseDrills(drills.bytes.view(), drills.path, format);
        const Fit fit = fitOf(other, pads, copper);
        if (other.features.size() >= drills.image.features.size() && isBetter(fit, best, drills.head)) {
            best = fit;
            best.isFound = isFound = true;
            drills.image = std::move(other);
            drills.format = format;
        }
    }
    return isFound;
}

void move(Image& image, Point shift) {
    for (formats::DrawnFeature& feature : image.features) {
        for (Point* const p : {&feature.a, &feature.b, &feature.centre}) {
            *p = formats::moved(*p, shift);
        }
    }
}

void reportUnit(ReadFile& drills, bool isProven) {
    if (!drills.head.isInch) {
        drills.diagnostics.report(isProven ? Severity::Info : Severity::Warning, drills.path, 0,
                                  "the drill file does not say its unit; taken as " + describe(drills.format));
    }
}

/// What a file drills that others do not.
std::vector<formats::DrawnFeature> ownHoles(std::span<const Image* const> others, const Image& image) {
    std::vector<IndexedPad> places;
    for (const Image* other : others) {
        for (const formats::DrawnFeature& feature : other->features) {
            places.push_back({middleOf(feature), 0, 0});
        }
    }
    const PadIndex index(std::move(places));
    std::vector<formats::DrawnFeature> own;
    std::ranges::copy_if(image.features, std::back_inserter(own), [&](const formats::DrawnFeature& feature) {
        return !index.has(middleOf(feature), kSameHole);
    });
    return own;
}

}  // namespace

std::optional<Point> originShift(const ReadFile& drills, const PadIndex& pads, const Box& copper) {
    const bool isTold = isFormatTold(drills.head);
    const std::size_t count = drills.image.features.size();
    if (drills.kind != ReadFile::Kind::Drills || count < (isTold ? kFewestToMove : kFewestAssumed) ||
        copper.isEmpty() || fitOf(drills.image, pads, copper).inside >= 0.5) {
        return std::nullopt;
    }
    std::vector<Point> places;
    for (const formats::DrawnFeature& feature : drills.image.features) {
        places.push_back(feature.a);
    }
    const std::optional<Point> shift = pads.shiftOf(places, kReach);
    if (!shift) {
        return std::nullopt;
    }
    Image image = drills.image;
    move(image, *shift);
    const double onPads = fitOf(image, pads, copper).onPads;
    return onPads >= (isTold ? kMostlyOnPads : kNearlyAllOnPads) ? shift : std::nullopt;
}

bool moveHoles(ReadFile& drills, Point shift, const Box& copper) {
    if (drills.kind != ReadFile::Kind::Drills || drills.image.features.empty() ||
        fitOf(drills.image, {}, copper).inside >= 0.5) {
        return false;
    }
    Image image = drills.image;
    move(image, shift);
    if (fitOf(image, {}, copper).inside < 0.5) {
        return false;
    }
    drills.image = std::move(image);
    drills.diagnostics.report(
        Severity::Warning, drills.path, 0,
        "the holes lie beside the copper, as if they counted from another origin than the images; "
        "they were moved by " +
            shortNumber(base::toMm(shift.x)) + ", " + shortNumber(base::toMm(shift.y)) +
            " mm, which lays them on pads");
    return true;
}

bool fitToCopper(ReadFile& drills, const PadIndex& pads, const Box& copper) {
    // Of a file that is read too large by far, no hole is within what a board can be.
    const bool hasHoles = !drills.image.features.empty() || drills.head.hasHits;
    if (drills.kind != ReadFile::Kind::Drills || !hasHoles) {
        return true;
    }
    if (copper.isEmpty()) {
        reportUnit(drills, false);
        return true;
    }
    Fit best = fitOf(drills.image, pads, copper);
    const bool isOnPads = best.onPads > kProven;
    if (isOnPads || (best.inside > 0.5 && drills.head.isInch)) {
        reportUnit(drills, isOnPads);
        return true;
    }
    const CoordinateFormat stated = drills.format;
    if (readOtherwise(drills, pads, copper, best)) {
        const bool isTold = drills.head.isInch &&
                            (drills.head.areAllWithPoint || (drills.head.isTrailingOmitted && drills.head.decimals));
        drills.diagnostics.report(isTold ? Severity::Warning : Severity::Info, drills.path, 0,
                                  "read as " + describe(drills.format) +
                                      ", which puts the holes on the copper, not as " + describe(stated) +
                                      (isTold ? ", as the file says" : ""));
        return true;
    }
    return false;
}

void fitAsSibling(ReadFile& drills, const std::optional<CoordinateFormat>& sibling, const Box& copper) {
    const DrillHead& head = drills.head;
    const bool isOtherUnit = sibling && head.isInch && *head.isInch != (sibling->nmPerUnit == base::kNmPerInch);
    const bool areOtherZeros =
        sibling && head.isTrailingOmitted && *head.isTrailingOmitted != sibling->isTrailingOmitted;
    if (sibling && !isFormatTold(head) && !isOtherUnit && !areOtherZeros) {
        Image image = parseDrills(drills.bytes.view(), drills.path, *sibling);
        const bool isMore = image.features.size() >= drills.image.features.size();
        const double inside = fitOf(image, {}, copper).inside;
        const bool isBetter = inside > fitOf(drills.image, {}, copper).inside || (inside >= 0.5 && !head.isInch);
        if (isMore && isBetter) {
            drills.image = std::move(image);
            drills.format = *sibling;
            drills.diagnostics.report(Severity::Info, drills.path, 0,
                                      "read as " + describe(*sibling) + ", like another drill file of the job");
            return;
        }
    }
    reportUnit(drills, false);
    const bool isOnBoard = fitOf(drills.image, {}, copper).inside >= 0.5;
    if (isOnBoard || (sibling && isFormatTold(head) && !isOtherUnit)) {
        return;  // or mounting holes beside all copper, of a program whose other holes lie where they belong
    }
    drills.diagnostics.report(Severity::Warning, drills.path, 0,
                              "most holes lie beside the copper, in whatever format their coordinates are read");
}

std::optional<double> shareOnPads(const Image& image, const PadIndex& pads) {
    std::size_t count = 0;
    std::size_t onPads = 0;
    for (const formats::DrawnFeature& feature : image.features) {
        if (feature.plating != Plating::NonPlated) {
            ++count;
            onPads += pads.has(middleOf(feature), kReach) ? 1 : 0;
        }
    }
    return count < kFewestAssumed ? std::nullopt
                                  : std::optional(static_cast<double>(onPads) / static_cast<double>(count));
}

bool drillOnce(std::span<const Image* const> others, ReadFile& file) {
    std::vector<formats::DrawnFeature>& all = file.image.features;
    std::vector<formats::DrawnFeature> own = ownHoles(others, file.image);
    const std::size_t shared = all.size() - own.size();
    if (shared == 0 || shared * 10 < all.size() * 9) {
        return false;
    }
    if (own.empty()) {
        file.diagnostics.report(Severity::Info, file.path, 0,
                                "another file drills the same holes; this one is shown as a document");
        file.role = FileRole{FileRole::Kind::Document};
        file.role.source = RoleSource::Content;
        return true;
    }
    file.diagnostics.report(Severity::Info, file.path, 0,
                            "another file drills " + std::to_string(shared) + " of the " + std::to_string(all.size()) +
                                " holes, too; they are drilled once");
    all = std::move(own);
    return false;
}

}  // namespace model::gerber
