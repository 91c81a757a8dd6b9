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

/// The box of a body in package coordinates, for facts whose leads point along x (turnedToX). Empty without pins.
[[nodiscard]] Box bodyBox(const PackageFacts& facts, const PinPattern& pattern, PackageFamily family, PartKind kind);

/// A height that is usual for such a body.
[[nodiscard]] Nm usualHeight(const Box& body, const PackageFacts& facts, PackageFamily family, PartKind kind);

/// Is a stated height one a body can have?
[[nodiscard]] constexpr bool isPlausibleHeight(Nm stated) {
    return stated >= kLeastBody && stated <= kMostBody;
}

/// x and y exchanged, so that what is written for leads along x serves both ways.
[[nodiscard]] PackageFacts transposed(const PackageFacts& facts);
[[nodiscard]] PolygonSet transposed(const PolygonSet& polygons);
[[nodiscard]] constexpr Box transposed(const Box& box) {
    return box.isEmpty() ? box : Box{{box.min.y, box.min.x}, {box.max.y, box.max.x}};
}

}  // namespace model
