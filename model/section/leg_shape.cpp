#include "model/section/leg_shape.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>

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

Intervals both(const Intervals& a, const Intervals& b) {
    return subtracted(a, subtracted(a, b));
}

/// The outermost copper on one side.
const Layer* outerCopper(const Document& board, bool isTop) {
    const Layer* outer = nullptr;
    for (const Layer& layer : board.layers) {
        if (layer.isCopper() && isOnBoard(layer) && layer.thickness > 0 &&
            (outer == nullptr || (isTop ? layer.z > outer->z : layer.z < outer->z))) {
            outer = &layer;
        }
    }
    return outer;
}

/// Without the mask, which lies right on the copper.
BoardFace faceOf(const Document& board, const Layer& copper, bool isTop, bool isFlat) {
    BoardFace face;
    face.isTop = isTop;
    face.isFlat = isFlat;
    face.copper = isTop ? copper.z + copper.thickness : copper.z;
    face.substrate = isTop ? copper.z : copper.z + copper.thickness;
    for (std::size_t row = 0; row < board.layers.size(); ++row) {
        const Layer& layer = board.layers[row];
        const Nm inner = isTop ? layer.z : layer.z + layer.thickness;
        if (layer.type == LayerType::SolderMask && layer.isSynthetic && layer.thickness > 0 && inner == face.copper &&
            layer.side == (isTop ? LayerSide::Top : LayerSide::Bottom)) {
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

}  // namespace

LegShaper::LegShaper(const Document& board, bool isAsSolid) : m_board(board) {
    for (const bool isTop : {true, false}) {
        if (const Layer* copper = outerCopper(board, isTop)) {
            m_faces.push_back(faceOf(board, *copper, isTop, isAsSolid));
        }
    }
    if (!isAsSolid) {
        m_bands = dielectricBandsOf(board);
        for (const StackupRow& row : board.stackup.rows) {
            if (row.layer.isValid() && row.type == LayerType::Dielectric) {
                m_rows[row.layer] = materialOf(board, row);
            }
        }
    }
}

std::vector<SectionPiece> LegShaper::shape(LegCut leg) const {
    addVias(leg);
    for (const BoardFace& face : m_faces) {
        if (!face.isFlat) {
            addParts(face, leg);
        }
        shapeFace(face, leg);
    }
    splitDielectrics(leg.pieces);
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

Intervals LegShaper::copperOf(const BoardFace& face, const LegCut& leg) const {
    return intervalsOf(leg.pieces, [&](const SectionPiece& piece) {
        return piece.material == SectionMaterial::Copper && (face.isTop ? piece.top : piece.bottom) == face.copper;
    });
}

void LegShaper::shapeFace(const BoardFace& face, LegCut& leg) const {
    const auto isMask = [&](const SectionPiece& piece) {
        return face.maskLayer.isValid() && piece.layer == face.maskLayer;
    };
    const auto isInk = [&](const SectionPiece& piece) {
        const bool isThisSide = face.isTop ? piece.bottom >= face.copper : piece.top <= face.copper;
        return !face.isFlat && piece.material == SectionMaterial::Silkscreen && isThisSide;
    };
    const Intervals copper = copperOf(face, leg);
    std::vector<Interval> raised(copper.begin(), copper.end());
    for (const SectionPiece& bore : leg.bores) {
        if ((face.isTop ? bore.top : bore.bottom) == face.copper) {
            raised.push_back({bore.from, bore.to});
        }
    }
    const Intervals under = united(std::move(raised));
    const Intervals masked = intervalsOf(leg.pieces, isMask);
    std::vector<SectionPiece> pieces;
    for (const SectionPiece& piece : leg.pieces) {
        const std::vector<SectionPiece> shaped = isMask(piece)  ? maskOver(face, piece, under)
                                                 : isInk(piece) ? inkOver(face, piece, under, masked)
                                                                : std::vector{piece};
        pieces.insert(pieces.end(), shaped.begin(), shaped.end());
    }
    leg.pieces = std::move(pieces);
}

/// Parts stand on the highest of what may lie under them.
Nm LegShaper::seatOf(const BoardFace& face) const {
    Nm ink = 0;
    for (const Layer& layer : m_board.layers) {
        const bool isThisSide = layer.side == (face.isTop ? LayerSide::Top : LayerSide::Bottom);
        if (layer.type == LayerType::SilkScreen && isOnBoard(layer) && isThisSide && layer.elements.count > 0) {
            ink = std::max(ink, layer.thickness);
        }
    }
    return (face.mask > 0 ? face.onCopper() : face.copper) + face.outwards() * ink;
}

void LegShaper::addParts(const BoardFace& face, LegCut& leg) const {
    const auto isPaste = [&](const SectionPiece& piece) {
        return piece.material == SectionMaterial::Paste &&
               (face.isTop ? piece.bottom >= face.copper : piece.top <= face.copper);
    };
    const Intervals masked =
        intervalsOf(leg.pieces, [&](const SectionPiece& piece) { return piece.layer == face.maskLayer; });
    const Intervals bare = subtracted(copperOf(face, leg), masked);
    const Intervals pasted = both(bare, intervalsOf(leg.pieces, isPaste));
    const Nm seat = seatOf(face);
    std::vector<SectionPiece> standing;
    for (StandingPart& part : leg.parts) {
        if (part.isTop != face.isTop) {
            continue;
        }
        for (SectionPiece piece : part.pieces) {
            const bool isTerminal = piece.material == SectionMaterial::Terminal;
            const Intervals soldered = clipped(isTerminal ? bare : pasted, piece.from, piece.to);
            for (const Interval& joint : piece.bottom == 0 && seat != face.copper ? soldered : Intervals{}) {
                piece.from = joint.from;
                piece.to = joint.to;
                piece.bottom = std::min(face.copper, seat);
                piece.top = std::max(face.copper, seat);
                piece.material = SectionMaterial::Solder;
                standing.push_back(piece);
            }
        }
        stand(part.pieces, seat, face.isTop);
        standing.insert(standing.end(), part.pieces.begin(), part.pieces.end());
    }
    const Intervals taken = intervalsOf(
        standing, [&](const SectionPiece& piece) { return (face.isTop ? piece.bottom : piece.top) == seat; });
    std::vector<SectionPiece> pieces;
    for (const SectionPiece& piece : leg.pieces) {
        for (const Interval& rest :
             isPaste(piece) ? subtracted({{piece.from, piece.to}}, taken) : Intervals{{piece.from, piece.to}}) {
            pieces.push_back(piece);
            if (isPaste(piece)) {
                pieces.back().from = rest.from;
                pieces.back().to = rest.to;
            }
        }
    }
    leg.pieces = std::move(pieces);
    leg.pieces.insert(leg.pieces.end(), standing.begin(), standing.end());
}

void LegShaper::splitDielectrics(std::vector<SectionPiece>& pieces) const {
    std::vector<SectionPiece> out;
    for (SectionPiece& piece : pieces) {
        if (const auto row = m_rows.find(piece.layer); row != m_rows.end()) {
            piece.material = row->second;
        }
        if (m_bands.empty() || !isSubstrate(m_board, piece)) {
            out.push_back(piece);
            continue;
        }
        for (std::size_t i = 0; i < m_bands.size(); ++i) {
            const Nm top = i == 0 ? piece.top : std::min(piece.top, m_bands[i].top);
            const Nm bottom = i + 1 == m_bands.size() ? piece.bottom : std::max(piece.bottom, m_bands[i].bottom);
            if (bottom < top) {
                out.push_back(between(piece, bottom, top));
                out.back().material = m_bands[i].material;
            }
        }
    }
    pieces = std::move(out);
}

}  // namespace model
