#include "model/section/laid_film.h"

#include <algorithm>

namespace model {

namespace {

/// The farther out of two heights.
Nm outerOf(const BoardFace& face, Nm a, Nm b) {
    return face.isTop ? std::max(a, b) : std::min(a, b);
}

void addBetween(const SectionPiece& like, const Intervals& where, Nm a, Nm b, std::vector<SectionPiece>& out) {
    for (const Interval& interval : where) {
        if (a != b) {
            out.push_back(like);
            out.back().from = interval.from;
            out.back().to = interval.to;
            out.back().bottom = std::min(a, b);
            out.back().top = std::max(a, b);
        }
    }
}

}  // namespace

LaidFilm filmOver(const BoardFace& face, const SectionPiece& piece, Nm thickness, bool flows, const Intervals& raised,
                  const std::vector<LaidPart>& laid) {
    Nm under = face.copper;
    for (const LaidPart& part : laid) {
        if (part.where.from < piece.to && part.where.to > piece.from) {
            under = outerOf(face, under, part.outer);
        }
    }
    LaidFilm film{{}, {{piece.from, piece.to}, under + face.outwards() * thickness}};
    Intervals rest = {film.part.where};
    if (!flows) {
        addBetween(piece, rest, under, film.part.outer, film.pieces);
        return film;
    }
    // What was laid last lies on what was laid before.
    for (auto part = laid.rbegin(); part != laid.rend(); ++part) {
        addBetween(piece, clipped(rest, part->where.from, part->where.to), part->outer, film.part.outer, film.pieces);
        rest = subtracted(rest, {part->where});
    }
    const Intervals beside = subtracted(rest, raised);
    addBetween(piece, subtracted(rest, beside), face.copper, film.part.outer, film.pieces);
    addBetween(piece, beside, face.substrate, film.part.outer, film.pieces);
    return film;
}

std::vector<LaidPart> laidMask(const BoardFace& face, const Intervals& masked, const Intervals& raised) {
    std::vector<LaidPart> parts;
    for (const Interval& where : subtracted(masked, raised)) {
        parts.push_back({where, face.besideCopper()});
    }
    for (const Interval& where : common(masked, raised)) {
        parts.push_back({where, face.onCopper()});
    }
    return parts;
}

}  // namespace model
