#include "model/agreement/agreement.h"

#include <algorithm>

#include "model/agreement/hole_agreement.h"
#include "model/agreement/layer_agreement.h"
#include "model/agreement/net_agreement.h"
#include "model/agreement/part_agreement.h"
#include "model/agreement/stackup_agreement.h"
#include "model/geometry/vectors.h"

namespace model {

namespace {

constexpr std::array<const char*, kAspectCount> kAspectNames{"copper",  "solder-mask", "solder-paste", "silkscreen",
                                                             "outline", "holes",       "parts",        "pins",
                                                             "nets",    "net-names",   "stackup"};

/// Where more holes, or pins of boards without holes, lie on those of the first board.
Point shiftBetween(const Document& a, const Document& b, const FlatBoard& ours, const FlatBoard& theirs, Nm reach) {
    if (a.board.isEmpty() || b.board.isEmpty()) {
        return {};
    }
    const Point shift{a.board.min.x - b.board.min.x, a.board.min.y - b.board.min.y};
    const std::vector<Point> fixed = locationsOf(ours);
    const std::vector<Point> moved = locationsOf(theirs);
    return countMatches(fixed, moved, shift, reach) > countMatches(fixed, moved, {}, reach) ? shift : Point{};
}

}  // namespace

const char* toString(Aspect aspect) {
    return kAspectNames[static_cast<std::size_t>(aspect)];
}

std::optional<Aspect> aspectNamed(std::string_view name) {
    const auto* const found = std::ranges::find(kAspectNames, name);
    return found == kAspectNames.end() ? std::nullopt
                                       : std::optional(static_cast<Aspect>(found - kAspectNames.begin()));
}

const char* toString(Accord accord) {
    constexpr const char* kNames[] = {"agree", "differ", "not_compared"};
    return kNames[static_cast<std::size_t>(accord)];
}

void Comparison::add(Difference difference, std::size_t most) {
    accord = Accord::Differ;
    if (differing++ < most) {
        differences.push_back(std::move(difference));
    }
}

void Comparison::measure(Point a, Point b) {
    farthest = std::max(farthest.value_or(0.0), distance(a, b));
}

bool AgreementRequest::wants(Aspect aspect) const {
    return aspects.empty() || std::ranges::find(aspects, aspect) != aspects.end();
}

bool Agreement::isCompared() const {
    return std::ranges::any_of(comparisons, [](const Comparison& c) { return c.accord != Accord::NotCompared; });
}

bool Agreement::isAgreed() const {
    return isCompared() &&
           std::ranges::none_of(comparisons, [](const Comparison& c) { return c.accord == Accord::Differ; });
}

base::Result<Agreement> compareBoards(const Document& a, const Document& b, const AgreementRequest& request,
                                      base::Progress& progress) {
    Agreement agreement;
    progress.beginPhase("Comparing holes, parts and nets");
    const FlatBoard ours = flatten(a, {});
    FlatBoard theirs = flatten(b, {});
    const Nm reach = reachOf(ours, theirs);
    agreement.shift = shiftBetween(a, b, ours, theirs, reach);
    theirs = flatten(b, agreement.shift);
    std::vector<Comparison> tables;
    tables.push_back(compareHoles(ours, theirs, reach, request));
    const MatchedParts matched = compareParts(ours, theirs, reach, request);
    tables.push_back(matched.parts);
    tables.push_back(matched.pins);
    for (Comparison& nets : compareNets(ours, theirs, matched, reach, request)) {
        tables.push_back(std::move(nets));
    }
    tables.push_back(compareStackups(a, b, request));
    progress.beginPhase("Comparing layers");
    ASSIGN_OR_RETURN(agreement.comparisons, compareLayers(a, b, agreement.shift, request, progress));
    std::ranges::move(tables, std::back_inserter(agreement.comparisons));
    std::erase_if(agreement.comparisons, [&](const Comparison& c) { return !request.wants(c.aspect); });
    return agreement;
}

}  // namespace model
