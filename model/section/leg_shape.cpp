#include "model/section/leg_shape.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>
#include <utility>

#include "model/board/board_heights.h"
#include "model/board/holes.h"
#include "model/section/inner_copper.h"
#include "model/section/standing_parts.h"

namespace model {

namespace {

/// Rounding of areas and of circles goes apart by less.
constexpr double kTouch = 1'000.0;

bool isOnBoard(const Layer& layer) {
    return layer.context == LayerContext::Board;
}

Intervals intervalsOf(const std::vector<SectionPiece>& pieces, auto isMeant) {
    std::vector<Interval> list;
    for (const SectionPiece& piece : pieces) {
        if (isMeant(piece)) {
            list.push_back({piece.from, piece.to});
        }
    }
    return united(std::move(list));
}

/// With the mask that lies right on the copper. As the 3D view draws it a coverlay is one too.
BoardFace faceOf(const Document& board, bool isTop, bool isFlat) {
    BoardFace face;
    face.isTop = isTop;
    face.isFlat = isFlat;
    face.copper = isTop ? boardHeights(board).top : boardHeights(board).bottom;
    face.substrate = isTop ? substrateHeights(board).top : substrateHeights(board).bottom;
    for (std::size_t row = 0; row < board.layers.size(); ++row) {
        const Layer& layer = board.layers[row];
        const Nm inner = isTop ? layer.z : layer.z + layer.thickness;
        if (layer.type == LayerType::SolderMask && layer.isSynthetic && layer.thickness > 0 && inner == face.copper &&
            layer.side == (isTop ? LayerSide::Top : LayerSide::Bottom) &&
            (isFlat || materialOf(board, LayerId{row}) == SectionMaterial::SolderMask)) {
            face.mask = layer.thickness;
            face.maskLayer = LayerId{row};
        }
    }
    return face;
}

/// Nothing reaches beyond the leg; what leans is cut off upright.
void keepWithin(SectionPiece& piece, double from, double to) {
    const double upperFrom = std::clamp(piece.upperFrom(), from, to);
    const double upperTo = std::clamp(piece.upperTo(), from, to);
    piece.from = std::clamp(piece.from, from, to);
    piece.to = std::clamp(piece.to, from, to);
    piece.leanFrom = upperFrom - piece.from;
    piece.leanTo = upperTo - piece.to;
}

bool isEmpty(const SectionPiece& piece) {
    return piece.to <= piece.from && piece.upperTo() <= piece.upperFrom();
}

/// The part of a piece between two heights.
SectionPiece between(SectionPiece piece, Nm bottom, Nm top) {
    const double height = double{1} * piece.top - piece.bottom;
    const auto at = [&](Nm z, double lean) { return lean * (double{1} * z - piece.bottom) / height; };
    const double lowerFrom = piece.from + at(bottom, piece.leanFrom);
    const double lowerTo = piece.to + at(bottom, piece.leanTo);
    piece.leanFrom = piece.from + at(top, piece.leanFrom) - lowerFrom;
    piece.leanTo = piece.to + at(top, piece.leanTo) - lowerTo;
    piece.from = lowerFrom;
    piece.to = lowerTo;
    piece.bottom = bottom;
    piece.top = top;
    return piece;
}

bool isSubstrate(const Document& board, const SectionPiece& piece) {
    return board.layer(piece.layer).type == LayerType::Body;
}

/// Pieces of the substrate beside a via, one per layer.
std::vector<SectionPiece> substratesAround(const Document& board, const LandingVia& via, const LegCut& leg) {
    std::vector<SectionPiece> found;
    std::set<LayerId> layers;
    for (const SectionPiece& piece : leg.pieces) {
        const bool isThere =
            piece.from <= via.middle + via.radius + kTouch && piece.to >= via.middle - via.radius - kTouch;
        if (isThere && isSubstrate(board, piece) && layers.insert(piece.layer).second) {
            found.push_back(piece);
        }
    }
    return found;
}

/// What the drill, which does not come so far, has taken out of the substrate beside the target pad.
std::optional<SectionPiece> behindTarget(const LandingVia& via, SectionPiece like, Nm far) {
    const double half = std::sqrt(std::max(0.0, (via.radius - via.beside) * (via.radius + via.beside)));
    like.from = via.middle - half;
    like.to = via.middle + half;
    like.bottom = std::max(like.bottom, std::min(via.target, far));
    like.top = std::min(like.top, std::max(via.target, far));
    return like.bottom < like.top ? std::optional(like) : std::nullopt;
}

/// The far face of the copper that a via lands on.
Nm farFace(const Document& board, const LandingVia& via) {
    const bool isFromTop = via.entry > via.target;
    for (const Layer& layer : board.layers) {
        if (layer.isCopper() && isOnBoard(layer) && (isFromTop ? layer.z + layer.thickness : layer.z) == via.target) {
            return isFromTop ? layer.z : layer.z + layer.thickness;
        }
    }
    return via.target;
}

double middleOf(const StandingPart& part) {
    double from = part.pieces.front().from;
    double to = from;
    for (const SectionPiece& piece : part.pieces) {
        from = std::min(from, piece.from);
        to = std::max(to, piece.to);
    }
    return (from + to) / 2;
}

LayerSide sideOf(const BoardFace& face) {
    return face.isTop ? LayerSide::Top : LayerSide::Bottom;
}

/// By its layer, whatever its height.
LayerSide sideOf(const Document& board, const SectionPiece& piece) {
    const LayerSide side = board.layer(piece.layer).side;
    if (!piece.isMirrored || (side != LayerSide::Top && side != LayerSide::Bottom)) {
        return side;
    }
    return side == LayerSide::Top ? LayerSide::Bottom : LayerSide::Top;
}

/// Does a piece lie on the side of a face? Where layers may be missing, heights do not say so.
bool isOn(const Document& board, const Stretch& stretch, const BoardFace& face, const SectionPiece& piece) {
    return stretch.isBounded ? sideOf(board, piece) == sideOf(face)
           : face.isTop      ? piece.bottom >= face.copper
                             : piece.top <= face.copper;
}

/// The mask that flipped copies have on a face if it has no counterpart: that of the other one.
LayerId mirroredMask(const Stretch& stretch, const BoardFace& face) {
    const auto other = std::ranges::find(stretch.faces, !face.isTop, &BoardFace::isTop);
    return other != stretch.faces.end() ? other->maskLayer : LayerId{};
}

/// Is a piece of the mask that lies on a face?
bool isMaskOf(const Stretch& stretch, const BoardFace& face, const SectionPiece& piece) {
    return piece.layer == (piece.isMirrored ? mirroredMask(stretch, face) : face.maskLayer);
}

/// Solder from the copper of a face to a piece of a part that stands higher.
void addSolder(const BoardFace& face, Nm seat, SectionPiece piece, const Intervals& where,
               std::vector<SectionPiece>& out) {
    piece.bottom = std::min(face.copper, seat);
    piece.top = std::max(face.copper, seat);
    piece.material = SectionMaterial::Solder;
    for (const Interval& joint : clipped(where, piece.from, piece.to)) {
        piece.from = joint.from;
        piece.to = joint.to;
        out.push_back(piece);
    }
}

/// Copper that ends on a face.
Intervals copperOf(const BoardFace& face, const LegCut& leg) {
    return intervalsOf(leg.pieces, [&](const SectionPiece& piece) {
        return piece.material == SectionMaterial::Copper && (face.isTop ? piece.top : piece.bottom) == face.copper;
    });
}

/// Holes that come out on a face.
Intervals boresOf(const BoardFace& face, const LegCut& leg) {
    std::vector<Interval> bores;
    for (const SectionPiece& bore : leg.bores) {
        if ((face.isTop ? bore.top : bore.bottom) == face.copper) {
            bores.push_back({bore.from, bore.to});
        }
    }
    return united(std::move(bores));
}

/// Copper and tented holes.
Intervals raisedOf(const BoardFace& face, const LegCut& leg) {
    Intervals raised = copperOf(face, leg);
    std::ranges::copy(boresOf(face, leg), std::back_inserter(raised));
    return united(std::move(raised));
}

/// Every piece for which `shaped` has something else becomes that.
void replace(std::vector<SectionPiece>& pieces, auto isMeant, auto shaped) {
    std::vector<SectionPiece> out;
    for (const SectionPiece& piece : pieces) {
        if (isMeant(piece)) {
            const std::vector<SectionPiece> list = shaped(piece);
            out.insert(out.end(), list.begin(), list.end());
        } else {
            out.push_back(piece);
        }
    }
    pieces = std::move(out);
}

/// What of a piece lies beside these.
std::vector<SectionPiece> beside(const Intervals& taken, const SectionPiece& piece) {
    std::vector<SectionPiece> rest;
    for (const Interval& where : subtracted({{piece.from, piece.to}}, taken)) {
        rest.push_back(piece);
        rest.back().from = where.from;
        rest.back().to = where.to;
    }
    return rest;
}

/// Ink on films, and else on the mask or what is without it.
std::vector<SectionPiece> inkOn(const BoardFace& face, const SectionPiece& piece, const Intervals& raised,
                                const Intervals& masked, const std::vector<LaidPart>& films) {
    std::vector<SectionPiece> out;
    Intervals rest = {{piece.from, piece.to}};
    SectionPiece part = piece;
    for (auto film = films.rbegin(); film != films.rend(); ++film) {
        const Nm outer = film->outer + face.outwards() * (piece.top - piece.bottom);
        part.bottom = std::min(film->outer, outer);
        part.top = std::max(film->outer, outer);
        for (const Interval& where : clipped(rest, film->where.from, film->where.to)) {
            part.from = where.from;
            part.to = where.to;
            out.push_back(part);
        }
        rest = subtracted(rest, {film->where});
    }
    for (const Interval& where : rest) {
        part = piece;
        part.from = where.from;
        part.to = where.to;
        const std::vector<SectionPiece> more = inkOver(face, part, raised, masked);
        out.insert(out.end(), more.begin(), more.end());
    }
    return out;
}

}  // namespace

LegShaper::LegShaper(const Document& board, bool isAsSolid) : m_board(board), m_isAsSolid(isAsSolid) {
    if (std::ranges::any_of(board.layers, [](const Layer& layer) { return layer.isCopper() && isOnBoard(layer); })) {
        m_faces = {faceOf(board, true, isAsSolid), faceOf(board, false, isAsSolid)};
    }
    for (std::size_t i = 0; i < board.stackup.rows.size(); ++i) {
        const StackupRow& row = board.stackup.rows[i];
        if (row.layer.isValid() && row.type == LayerType::Dielectric) {
            m_rows[row.layer] = i;
        }
    }
}

std::vector<SectionPiece> LegShaper::shape(LegCut leg) const {
    const std::vector<Stretch> stretches =
        stretchesBetween(m_board, leg.from, leg.to, leg.ranges, m_faces, m_isAsSolid);
    fitHoles(stretches, leg.pieces,
             [](const SectionPiece& piece) { return piece.material == SectionMaterial::Plating; });
    fitHoles(stretches, leg.bores, [](const SectionPiece&) { return true; });
    addVias(leg);
    shapeSurfaces(stretches, leg);
    splitDielectrics(stretches, leg.pieces);
    if (!m_isAsSolid) {
        takeCopperOut(leg);
    }
    for (SectionPiece& piece : leg.pieces) {
        keepWithin(piece, leg.from, leg.to);
    }
    std::erase_if(leg.pieces, isEmpty);
    return std::move(leg.pieces);
}

void LegShaper::addVias(LegCut& leg) const {
    std::vector<SectionPiece> more;
    const auto add = [&more](const std::vector<SectionPiece>& list) {
        more.insert(more.end(), list.begin(), list.end());
    };
    for (const auto& [via, like] : leg.vias) {
        add(platingOf(via, like));
        for (const SectionPiece& substrate : substratesAround(m_board, via, leg)) {
            add(besideVia(via, substrate));
            if (const auto behind = behindTarget(via, substrate, farFace(m_board, via))) {
                more.push_back(*behind);
            }
        }
    }
    leg.pieces.insert(leg.pieces.end(), more.begin(), more.end());
}

bool LegShaper::isSurface(const SectionPiece& piece) const {
    const Layer& layer = m_board.layer(piece.layer);
    return !layer.isCopper() && !isHoles(layer.type) && layer.type != LayerType::Body &&
           layer.type != LayerType::Dielectric && layer.type != LayerType::ComponentBody;
}

bool LegShaper::isFilm(const SectionPiece& piece) const {
    return isSurface(piece) && isLaidOn(m_board.layer(drawnBy(m_board, piece.layer)));
}

/// The outer face of what a part stands on in the 3D view (model/solids/body_floors.h).
std::optional<Nm> LegShaper::floorOf(const StandingPart& part) const {
    const LayerId on = m_board.layer(part.pieces.front().layer).spanTop;
    if (on.isValid()) {
        return m_board.layer(on).z + (part.isTop ? m_board.layer(on).thickness : 0);
    }
    const auto whole = std::ranges::find(m_faces, part.isTop, &BoardFace::isTop);
    return whole != m_faces.end() ? std::optional(whole->copper) : std::nullopt;
}

/// Of the stretches that a part reaches into and that have the face it stands on, the one nearest to its middle; where
/// none has it, the one around its middle.
const Stretch& LegShaper::standingIn(const std::vector<Stretch>& stretches, const StandingPart& part) const {
    const std::optional<Nm> floor = floorOf(part);
    const double middle = middleOf(part);
    return *std::ranges::min_element(stretches, {}, [&](const Stretch& stretch) {
        const bool isReached = std::ranges::any_of(
            part.pieces, [&](const SectionPiece& piece) { return piece.from < stretch.to && piece.to > stretch.from; });
        const bool hasFloor = std::ranges::any_of(
            stretch.faces, [&](const BoardFace& face) { return face.isTop == part.isTop && face.copper == floor; });
        return std::pair(isReached && hasFloor ? 0 : 1, std::max({stretch.from - middle, middle - stretch.to, 0.0}));
    });
}

/// What lies on the board lies on what each stretch has.
void LegShaper::shapeSurfaces(const std::vector<Stretch>& stretches, LegCut& leg) const {
    if (stretches.size() == 1) {
        shapeStretch(stretches.front(), leg);
        return;
    }
    std::vector<SectionPiece> out;
    for (const Stretch& stretch : stretches) {
        LegCut part;
        const auto take = [&](const std::vector<SectionPiece>& from, std::vector<SectionPiece>& to, auto isMeant) {
            for (const SectionPiece& piece : from) {
                if (const auto own = alongPart(piece, stretch.from, stretch.to); own && isMeant(piece)) {
                    to.push_back(*own);
                }
            }
        };
        take(leg.pieces, part.pieces, [this](const SectionPiece& piece) {
            return isSurface(piece) || piece.material == SectionMaterial::Copper;
        });
        take(leg.bores, part.bores, [](const SectionPiece&) { return true; });
        std::ranges::copy_if(leg.parts, std::back_inserter(part.parts), [&](const StandingPart& standing) {
            return &standingIn(stretches, standing) == &stretch;
        });
        shapeStretch(stretch, part);
        std::ranges::copy_if(part.pieces, std::back_inserter(out),
                             [](const SectionPiece& piece) { return piece.material != SectionMaterial::Copper; });
    }
    std::erase_if(leg.pieces, [this](const SectionPiece& piece) { return isSurface(piece); });
    leg.pieces.insert(leg.pieces.end(), out.begin(), out.end());
}

void LegShaper::shapeStretch(const Stretch& stretch, LegCut& leg) const {
    std::vector<LayerId> drawn;
    for (const SectionPiece& piece : leg.pieces) {
        if (isFilm(piece)) {
            drawn.push_back(drawnBy(m_board, piece.layer));
        }
    }
    std::ranges::sort(drawn);
    std::vector<LaidStack> stacks = m_isAsSolid ? std::vector<LaidStack>{} : stretch.stack.laidStacks(drawn);
    for (const BoardFace& face : stretch.faces) {
        if (!face.isFlat) {
            movePaste(face, leg);
            addParts(stretch, face, leg);
        }
        shapeFace(stretch, face, stacks, leg);
    }
    for (const LaidStack& stack : stacks) {
        std::vector<LaidPart> laid;
        shapeFilms(stack, raisedOf(stack.face, leg), laid, leg);
    }
}

/// Mask, films and ink, of which none lies over a hole that is open here; the stacks of this face are taken out of
/// `stacks`.
void LegShaper::shapeFace(const Stretch& stretch, const BoardFace& face, std::vector<LaidStack>& stacks,
                          LegCut& leg) const {
    // What is mirrored stays level.
    const auto isMask = [&](const SectionPiece& piece) { return !piece.isMirrored && isMaskOf(stretch, face, piece); };
    const auto isInk = [&](const SectionPiece& piece) {
        return !face.isFlat && piece.material == SectionMaterial::Silkscreen && isOn(m_board, stretch, face, piece);
    };
    const Intervals under = raisedOf(face, leg);
    const Intervals masked = intervalsOf(leg.pieces, isMask);
    replace(leg.pieces, isMask, [&](const SectionPiece& piece) { return maskOver(face, piece, under); });
    std::vector<LaidPart> laid = laidMask(face, masked, under);
    const std::size_t masks = laid.size();
    std::erase_if(stacks, [&](const LaidStack& stack) {
        const bool isOn = stack.face.copper == face.copper && stack.face.isTop == face.isTop;
        if (isOn) {
            shapeFilms(stack, under, laid, leg);
        }
        return isOn;
    });
    const std::vector<LaidPart> films(laid.begin() + static_cast<std::ptrdiff_t>(masks), laid.end());
    const Intervals open = subtracted(boresOf(face, leg), masked);
    replace(leg.pieces, isInk, [&](const SectionPiece& piece) {
        std::vector<SectionPiece> ink;
        for (const Interval& where : subtracted({{piece.from, piece.to}}, open)) {
            SectionPiece part = piece;
            part.from = where.from;
            part.to = where.to;
            std::ranges::move(inkOn(face, part, under, masked, films), std::back_inserter(ink));
        }
        return ink;
    });
}

void LegShaper::shapeFilms(const LaidStack& stack, const Intervals& raised, std::vector<LaidPart>& laid,
                           LegCut& leg) const {
    for (const std::size_t row : stack.rows) {
        const StackupRow& own = m_board.stackup.rows[row];
        const bool flows = m_board.layer(own.layer).use != LayerUse::Stiffener;
        const std::vector<LaidPart> before = laid;
        replace(
            leg.pieces,
            [&](const SectionPiece& piece) { return isFilm(piece) && drawnBy(m_board, piece.layer) == own.layer; },
            [&](const SectionPiece& piece) {
                LaidFilm film = filmOver(stack.face, piece, own.thickness, flows, raised, before);
                laid.push_back(film.part);
                return std::move(film.pieces);
            });
    }
}

/// Paste lies on the copper that is here.
void LegShaper::movePaste(const BoardFace& face, LegCut& leg) const {
    const auto whole = std::ranges::find(m_faces, face.isTop, &BoardFace::isTop);
    for (SectionPiece& piece : leg.pieces) {
        const bool isThisSide = sideOf(m_board, piece) == sideOf(face);
        if (whole != m_faces.end() && piece.material == SectionMaterial::Paste && isThisSide) {
            piece.bottom += face.copper - whole->copper;
            piece.top += face.copper - whole->copper;
        }
    }
}

/// How high the mask is that copies of one way up have on the copper of a face: in flipped ones a mask without a
/// counterpart lies on the other side, level.
Nm LegShaper::maskOn(const Stretch& stretch, const BoardFace& face, bool isFlipped) const {
    if (face.mask > 0 && !isMirroredInCopy(m_board, face.maskLayer, isFlipped)) {
        return face.outwards() * (face.onCopper() - face.copper);
    }
    const LayerId other = mirroredMask(stretch, face);
    return isFlipped && other.isValid() && isMirroredInCopy(m_board, other, isFlipped) ? m_board.layer(other).thickness
                                                                                       : 0;
}

/// Parts stand on the highest of what may lie under them.
Nm LegShaper::seatOf(const Stretch& stretch, const BoardFace& face, bool isFlipped) const {
    Nm ink = 0;
    for (const Layer& layer : m_board.layers) {
        const bool isThisSide = layer.side == sideOf(face);
        if (layer.type == LayerType::SilkScreen && isOnBoard(layer) && isThisSide && layer.elements.count > 0) {
            ink = std::max(ink, layer.thickness);
        }
    }
    const Nm film = stretch.stack.coverlayOn(face);
    return face.copper + face.outwards() * (std::max(maskOn(stretch, face, isFlipped), film) + ink);
}

void LegShaper::addParts(const Stretch& stretch, const BoardFace& face, LegCut& leg) const {
    const auto isPaste = [&](const SectionPiece& piece) {
        return piece.material == SectionMaterial::Paste && isOn(m_board, stretch, face, piece);
    };
    const Intervals masked =
        intervalsOf(leg.pieces, [&](const SectionPiece& piece) { return isMaskOf(stretch, face, piece); });
    const Intervals bare = subtracted(copperOf(face, leg), masked);
    const Intervals pasted = common(bare, intervalsOf(leg.pieces, isPaste));
    std::vector<SectionPiece> standing;
    std::vector<Interval> covered;
    for (StandingPart& part : leg.parts) {
        if (part.isTop != face.isTop) {
            continue;
        }
        const Nm seat = seatOf(stretch, face, part.isFlipped);
        for (const SectionPiece& piece : part.pieces) {
            if (piece.bottom == 0 && seat != face.copper) {
                addSolder(face, seat, piece, piece.material == SectionMaterial::Terminal ? bare : pasted, standing);
            }
        }
        stand(part.pieces, seat, face.isTop);
        standing.insert(standing.end(), part.pieces.begin(), part.pieces.end());
        std::ranges::copy(
            intervalsOf(part.pieces,
                        [&](const SectionPiece& piece) { return (face.isTop ? piece.bottom : piece.top) == seat; }),
            std::back_inserter(covered));
    }
    const Intervals taken = united(std::move(covered));
    replace(leg.pieces, isPaste, [&](const SectionPiece& piece) { return beside(taken, piece); });
    leg.pieces.insert(leg.pieces.end(), standing.begin(), standing.end());
}

/// The substrate by its dielectrics; where layers may be missing, without what none fills.
void LegShaper::splitDielectrics(const std::vector<Stretch>& stretches, std::vector<SectionPiece>& pieces) const {
    const auto addBands = [&](const SectionPiece& piece, const Stretch& stretch, std::vector<SectionPiece>& out) {
        const std::vector<DielectricBand>& bands = stretch.bands;
        const bool isFilled = m_isAsSolid || !stretch.isBounded;
        for (std::size_t i = 0; i < bands.size(); ++i) {
            const Nm top = i == 0 && isFilled ? piece.top : std::min(piece.top, bands[i].top);
            const Nm lower = i + 1 == bands.size() ? piece.bottom : bands[i + 1].top;
            const Nm bottom = std::max(piece.bottom, isFilled ? lower : bands[i].bottom);
            if (bottom < top) {
                out.push_back(between(piece, bottom, top));
                out.back().material = bands[i].material;
                out.back().stackupRow = bands[i].row;
            }
        }
        if (bands.empty() && isFilled) {
            out.push_back(piece);
        }
    };
    std::vector<SectionPiece> out;
    for (SectionPiece& piece : pieces) {
        if (const auto row = m_rows.find(piece.layer); row != m_rows.end()) {
            piece.material = materialOf(m_board, m_board.stackup.rows[row->second]);
            piece.stackupRow = row->second;
        }
        if (!isSubstrate(m_board, piece)) {
            out.push_back(piece);
            continue;
        }
        std::vector<SectionPiece> parts;
        const double middle = std::clamp((piece.from + piece.to) / 2, stretches.front().from, stretches.back().to);
        for (const Stretch& stretch : stretches) {
            const bool isLast = &stretch == &stretches.back();
            if (piece.leans()) {
                if (middle >= stretch.from && (middle < stretch.to || isLast) && parts.empty()) {
                    addBands(piece, stretch, parts);
                }
            } else if (const auto part = alongPart(piece, stretch.from, stretch.to)) {
                addBands(*part, stretch, parts);
            }
        }
        joinAlong(parts);
        out.insert(out.end(), parts.begin(), parts.end());
    }
    pieces = std::move(out);
}

/// What leans lies beside laser vias, and has no copper in it.
void LegShaper::takeCopperOut(LegCut& leg) const {
    std::vector<SectionPiece> all = leg.pieces;
    all.insert(all.end(), leg.leftCopper.begin(), leg.leftCopper.end());
    const InnerCopper copper(all);
    const auto isMeant = [this](const SectionPiece& piece) {
        return !piece.leans() && (isSubstrate(m_board, piece) || m_rows.contains(piece.layer));
    };
    replace(leg.pieces, isMeant, [&](const SectionPiece& piece) { return copper.leftOf(piece); });
}

}  // namespace model
