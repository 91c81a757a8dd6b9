#pragma once

#include "model/packages/package_family.h"

/// How large a body is. Where a job draws the body itself, that is what is taken; courtyards and outlines around the
/// leads are larger than bodies, so there the pads say more.
namespace model {

/// Heights below this are placeholders: some jobs write a thousandth of an inch for what they do not know.
inline constexpr Nm kLeastBody = 100'000;
/// A height beyond this is taken for a mistake of the job: the tallest parts soldered to boards are capacitors and
/// heat sinks of some 100 mm.
inline constexpr Nm kMostBody = 150'000'000;

/// What a body is and how large.
struct BodySize {
    PackageFamily family = PackageFamily::None;
    PartKind kind = PartKind::Unknown;
    PinPattern pattern;
    Box box;  ///< in package coordinates; empty: there is no body
    Nm height = 0;
    bool isHeightAssumed = true;
};

/// `statedHeight` is the job's; 0 or less: it states none.
[[nodiscard]] BodySize sizeBody(const PackageFacts& facts, Nm statedHeight);

/// Is a stated height one a body can have?
[[nodiscard]] constexpr bool isPlausibleHeight(Nm stated) {
    return stated >= kLeastBody && stated <= kMostBody;
}

/// Is a size the one that the job draws, and not concluded from pads?
[[nodiscard]] bool isAsDrawn(const BodySize& size, const PackageFacts& facts);

/// x and y exchanged, so that what is written for leads along x serves both ways.
[[nodiscard]] PackageFacts transposed(const PackageFacts& facts);
[[nodiscard]] PolygonSet transposed(const PolygonSet& polygons);
[[nodiscard]] constexpr Box transposed(const Box& box) {
    return box.isEmpty() ? box : Box{{box.min.y, box.min.x}, {box.max.y, box.max.x}};
}

}  // namespace model
