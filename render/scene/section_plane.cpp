#include "render/scene/section_plane.h"

#include <algorithm>
#include <cmath>

#include "model/section/section.h"

namespace render {
namespace {

using model::PointD;

/// The box around all copies.
model::Box boxOf(const model::BoardIndex& index) {
    model::Box box;
    for (const model::StepCopy& copy : index.tree.copies) {
        if (const model::Box& own = index.extents[copy.step]; !own.isEmpty()) {
            box.include(copy.placement.boxOf(own));
        }
    }
    return box;
}

/// The part of a line that may meet a box, and a little more.
model::SectionRequest throughBox(const model::Box& box, PointD start, PointD unit) {
    double least = 0.0;
    double most = 0.0;
    for (const double x : {double(box.min.x), double(box.max.x)}) {
        for (const double y : {double(box.min.y), double(box.max.y)}) {
            const double along = (x - start.x) * unit.x + (y - start.y) * unit.y;
            least = std::min(least, along);
            most = std::max(most, along);
        }
    }
    const auto at = [&](double along) {
        const auto clamped = [](double v) {
            return std::clamp<double>(v, -base::kMaxCoordinate, base::kMaxCoordinate);
        };
        return PointD{clamped(start.x + unit.x * along), clamped(start.y + unit.y * along)};
    };
    return {{at(least - 1.0), at(most + 1.0)}, {}, true};
}

/// Between two heights; `layer` is where its layer lies, or another one.
SectionFace faceAt(const model::SectionPiece& piece, const model::ZRange& layer, const model::ZRange& z,
                   bool isSubstrate = false) {
    const auto part = [&](model::Nm at) {
        return static_cast<float>((double{1} * at - layer.bottom) / (double{1} * layer.top - layer.bottom));
    };
    SectionFace face;
    face.layer = piece.layer;
    face.from = base::toMm(piece.from);
    face.to = base::toMm(piece.to);
    face.leanFrom = base::toMm(piece.leanFrom);
    face.leanTo = base::toMm(piece.leanTo);
    face.bottom = part(z.bottom);
    face.top = part(z.top);
    face.isMirrored = piece.isMirrored;
    face.isInside = !isSubstrate;
    if (isSubstrate) {
        face.colour = model::colourOf(piece.material);
    }
    return face;
}

/// The copper beside which mask lies that reaches out of its layer.
model::LayerId copperBeside(const model::Document& board, const model::SectionPiece& mask) {
    for (std::size_t row = 0; row < board.layers.size(); ++row) {
        const model::Layer& layer = board.layers[row];
        const bool isThere = layer.z == mask.bottom || layer.z + layer.thickness == mask.top;
        if (layer.isBoardCopper() && layer.thickness > 0 && isThere) {
            return model::LayerId{row};
        }
    }
    return {};
}

/// What of a piece lies in its layer, and what of a mask lies beside copper.
void addFaces(const model::Document& board, const model::SectionPiece& piece, std::vector<SectionFace>& faces) {
    const model::LayerType type = board.layer(piece.layer).type;
    const bool isSubstrate = type == model::LayerType::Body || type == model::LayerType::Dielectric;
    const bool isMask = piece.material == model::SectionMaterial::SolderMask;
    const model::ZRange own = model::heightsInCopy(board, piece.layer, piece.isMirrored);
    const model::ZRange z{isMask ? std::max(piece.bottom, own.bottom) : piece.bottom,
                          isMask ? std::min(piece.top, own.top) : piece.top};
    const bool reachesOut = z.bottom != piece.bottom || z.top != piece.top;
    faces.push_back(faceAt(piece, own, z, isSubstrate));
    if (const model::LayerId copper = reachesOut ? copperBeside(board, piece) : model::LayerId{}; copper.isValid()) {
        const model::ZRange beside = model::heightsInCopy(board, copper, false);
        faces.push_back(faceAt(piece, beside, beside));
        faces.back().beside = copper;
    }
}

}  // namespace

base::Result<SectionCut> makeSectionCut(const model::BoardIndex& index, model::Point origin, PointD a, PointD b,
                                        std::vector<std::vector<model::ElementId>> milled) {
    const double length = std::hypot(b.x - a.x, b.y - a.y);
    if (!(length > 0.0)) {
        return base::Error{base::ErrorCode::BadUsage, "a section line needs two locations that are apart"};
    }
    const PointD unit = {(b.x - a.x) / length, (b.y - a.y) / length};
    model::SectionRequest request = throughBox(boxOf(index), a, unit);
    request.milled = std::move(milled);
    ASSIGN_OR_RETURN(const model::Section section, model::makeSection(index, request));
    SectionCut cut;
    const PointD start = request.line.front();
    cut.plane = {{base::toMm(start.x - origin.x), base::toMm(start.y - origin.y)}, {unit.x, unit.y}};
    for (const model::SectionPiece& piece : model::merged(section.pieces)) {
        const model::Layer& layer = index.board->layer(piece.layer);
        if (piece.bottom >= piece.top || layer.thickness <= 0) {
            continue;
        }
        addFaces(*index.board, piece, cut.faces);
    }
    return cut;
}

}  // namespace render
