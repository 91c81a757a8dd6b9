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
    return {{at(least - 1.0), at(most + 1.0)}, {}};
}

}  // namespace

base::Result<SectionCut> makeSectionCut(const model::BoardIndex& index, model::Point origin, PointD a, PointD b) {
    const double length = std::hypot(b.x - a.x, b.y - a.y);
    if (!(length > 0.0)) {
        return base::Error{base::ErrorCode::BadUsage, "a section line needs two locations that are apart"};
    }
    const PointD unit = {(b.x - a.x) / length, (b.y - a.y) / length};
    const model::SectionRequest request = throughBox(boxOf(index), a, unit);
    ASSIGN_OR_RETURN(const model::Section section, model::makeSection(index, request));
    SectionCut cut;
    const PointD start = request.line.front();
    cut.plane = {{base::toMm(start.x - origin.x), base::toMm(start.y - origin.y)}, {unit.x, unit.y}};
    for (const model::SectionPiece& piece : model::merged(section.pieces)) {
        const model::Layer& layer = index.board->layer(piece.layer);
        if (piece.bottom >= piece.top || layer.thickness <= 0) {
            continue;
        }
        const auto part = [&](model::Nm z) {
            return static_cast<float>((double{1} * z - layer.z) / static_cast<double>(layer.thickness));
        };
        const bool isSubstrate = layer.type == model::LayerType::Body || layer.type == model::LayerType::Dielectric;
        cut.faces.push_back({piece.layer, base::toMm(piece.from), base::toMm(piece.to), part(piece.bottom),
                             part(piece.top), !isSubstrate});
    }
    return cut;
}

}  // namespace render
