#include "model/section/mask_shape.h"

#include <algorithm>
#include <cmath>

namespace model {

namespace {

/// A piece between two heights, in whichever order they come.
SectionPiece between(SectionPiece piece, const Interval& where, Nm a, Nm b) {
    piece.from = where.from;
    piece.to = where.to;
    piece.bottom = std::min(a, b);
    piece.top = std::max(a, b);
    return piece;
}

/// How far a shoulder reaches from an end of what is raised into the spacing beside it.
double shoulderIn(const BoardFace& face, double room, bool isBetweenTwo) {
    return std::min<double>(face.mask, isBetweenTwo ? room / 2 : room);
}

/// The shoulders at both ends of a spacing, of which either may be the end of the mask instead of something raised.
void addShoulders(const BoardFace& face, const SectionPiece& piece, const Interval& spacing, bool isRaisedBefore,
                  bool isRaisedBehind, std::vector<SectionPiece>& out) {
    const double wide = shoulderIn(face, spacing.to - spacing.from, isRaisedBefore && isRaisedBehind);
    const auto add = [&](double from, double to, bool isBefore) {
        SectionPiece shoulder = between(piece, {from, to}, face.besideCopper(), face.onCopper());
        // It is widest where it lies on the mask beside it.
        double& lean = isBefore ? shoulder.leanTo : shoulder.leanFrom;
        lean = isBefore ? -wide : wide;
        if (!face.isTop) {
            (isBefore ? shoulder.to : shoulder.from) += lean;
            lean = -lean;
        }
        out.push_back(shoulder);
    };
    if (isRaisedBefore) {
        add(spacing.from, spacing.from + wide, true);
    }
    if (isRaisedBehind) {
        add(spacing.to - wide, spacing.to, false);
    }
}

bool endsAt(const Intervals& intervals, double at) {
    return std::ranges::any_of(intervals, [at](const Interval& i) { return i.from == at || i.to == at; });
}

/// The parts of a piece's interval that are free of shoulders.
Intervals withoutShoulders(const BoardFace& face, const Intervals& spacings, const Intervals& raised) {
    Intervals level;
    for (Interval spacing : spacings) {
        const bool isBefore = endsAt(raised, spacing.from);
        const bool isBehind = endsAt(raised, spacing.to);
        const double wide = shoulderIn(face, spacing.to - spacing.from, isBefore && isBehind);
        spacing.from += isBefore ? wide : 0.0;
        spacing.to -= isBehind ? wide : 0.0;
        if (spacing.from < spacing.to) {
            level.push_back(spacing);
        }
    }
    return level;
}

}  // namespace

std::vector<SectionPiece> maskOver(const BoardFace& face, const SectionPiece& piece, const Intervals& raised) {
    std::vector<SectionPiece> out;
    const Intervals on = clipped(raised, piece.from, piece.to);
    for (const Interval& where : on) {
        out.push_back(between(piece, where, face.copper, face.onCopper()));
    }
    for (const Interval& where : subtracted({{piece.from, piece.to}}, on)) {
        out.push_back(between(piece, where, face.substrate, face.besideCopper()));
        if (face.besideCopper() != face.onCopper()) {
            addShoulders(face, piece, where, endsAt(on, where.from), endsAt(on, where.to), out);
        }
    }
    return out;
}

std::vector<SectionPiece> inkOver(const BoardFace& face, const SectionPiece& piece, const Intervals& raised,
                                  const Intervals& masked) {
    std::vector<SectionPiece> out;
    const Nm thick = face.outwards() * (piece.top - piece.bottom);
    const Intervals all = {{piece.from, piece.to}};
    const auto add = [&](const Intervals& where, Nm height) {
        for (const Interval& interval : where) {
            out.push_back(between(piece, interval, height, height + thick));
        }
    };
    const Intervals spacings = subtracted(masked, raised);
    add(common(all, common(masked, raised)), face.onCopper());
    add(common(all, withoutShoulders(face, spacings, common(masked, raised))), face.besideCopper());
    const Intervals open = subtracted(all, masked);
    add(common(open, raised), face.copper);
    add(subtracted(open, raised), face.substrate);
    return out;
}

}  // namespace model
