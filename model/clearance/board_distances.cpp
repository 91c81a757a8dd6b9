#include "model/clearance/board_distances.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <optional>

namespace model {

namespace {

constexpr double kEndless = std::numeric_limits<double>::infinity();

/// From the board's coordinates to those of a copy.
class Unplaced {
public:
    explicit Unplaced(const Placement& placement) : m_origin(toDouble(placement.origin)) {
        Placement turn = placement;
        turn.origin = {};
        m_right = turn.apply(PointD{1.0, 0.0});
        m_up = turn.apply(PointD{0.0, 1.0});
    }
    [[nodiscard]] PointD operator()(PointD p) const {
        const PointD d{p.x - m_origin.x, p.y - m_origin.y};
        return {d.x * m_right.x + d.y * m_right.y, d.x * m_up.x + d.y * m_up.y};
    }

private:
    PointD m_origin;
    PointD m_right;
    PointD m_up;
};

/// Columns and rows of a frame that lie over a box.
struct Part {
    std::uint32_t column = 0;
    std::uint32_t row = 0;
    std::uint32_t width = 0;
    std::uint32_t height = 0;
};

std::optional<Part> partOver(const MapFrame& frame, const Box& box) {
    const auto cells = [&](double from, std::uint32_t most) {
        return static_cast<std::uint32_t>(std::clamp(from / frame.cell, 0.0, 1.0 * most));
    };
    const std::uint32_t left = cells(box.min.x - frame.corner.x, frame.width);
    const std::uint32_t low = cells(box.min.y - frame.corner.y, frame.height);
    const std::uint32_t right = cells(std::ceil((box.max.x - frame.corner.x) / frame.cell) * frame.cell, frame.width);
    const std::uint32_t high = cells(std::ceil((box.max.y - frame.corner.y) / frame.cell) * frame.cell, frame.height);
    if (left >= right || low >= high) {
        return std::nullopt;
    }
    return Part{left, low, right - left, high - low};
}

/// The cells of a copy that lie under a part of the board's.
MapFrame frameUnder(const MapFrame& frame, const Part& part, const Unplaced& unplaced) {
    PointD min{kEndless, kEndless};
    PointD max{-kEndless, -kEndless};
    for (const auto& [x, y] : {std::pair(0U, 0U), std::pair(1U, 0U), std::pair(0U, 1U), std::pair(1U, 1U)}) {
        const PointD at = unplaced({frame.corner.x + (part.column + x * part.width) * frame.cell,
                                    frame.corner.y + (part.row + y * part.height) * frame.cell});
        min = {std::min(min.x, at.x), std::min(min.y, at.y)};
        max = {std::max(max.x, at.x), std::max(max.y, at.y)};
    }
    constexpr double kRounding = 1e-6;  // of a cell
    const auto cells = [&](double length) {
        return static_cast<std::uint32_t>(std::ceil(length / frame.cell - kRounding));
    };
    return {min, frame.cell, cells(max.x - min.x), cells(max.y - min.y)};
}

std::size_t cellAt(const MapFrame& frame, PointD at) {
    const auto index = [&](double from, std::uint32_t count) {
        return static_cast<std::size_t>(std::clamp(std::floor(from / frame.cell), 0.0, count - 1.0));
    };
    return index(at.y - frame.corner.y, frame.height) * frame.width + index(at.x - frame.corner.x, frame.width);
}

bool isInside(const Box& box, PointD at) {
    return box.min.x <= at.x && at.x <= box.max.x && box.min.y <= at.y && at.y <= box.max.y;
}

Box outlineOf(const Document& step, const DistanceField& field) {
    return step.board.isEmpty() ? field.extent() : step.board;
}

}  // namespace

/// `makeField` gets a row of StepTree::copies and a layer of its step. The error is that of the first copy.
template <class MakeField>
base::Result<BoardDistances> BoardDistances::make(const Document& board, LayerId layer, const MakeField& makeField) {
    BoardDistances made;
    made.m_layer = layer;
    std::optional<base::Error> error;
    const StepTree tree = unfoldCopies(board);
    for (std::uint32_t row = 0; row < tree.copies.size(); ++row) {
        const StepCopy& copy = tree.copies[row];
        const Document& step = *tree.steps[copy.step];
        auto field = makeField(row, step.layerOfCopy(layer, copy.isFlipped));
        if (!field && field.error().code != base::ErrorCode::BadUsage) {
            return field.error();
        }
        if (!field) {
            error = error ? error : field.error();
            continue;
        }
        made.m_kind = (*field)->kind();
        made.m_placed.push_back({*field, row, copy.placement, copy.placement.boxOf(outlineOf(step, **field))});
        made.m_extent.include(made.m_placed.back().box);
    }
    if (made.m_placed.empty()) {
        return *error;
    }
    return made;
}

base::Result<BoardDistances> BoardDistances::betweenNets(const Document& board, LayerId layer,
                                                         base::Progress& progress) {
    using Field = base::Result<std::shared_ptr<const DistanceField>>;
    const StepTree tree = unfoldCopies(board);
    std::map<std::pair<std::uint32_t, LayerId>, Field> made;
    return make(board, layer, [&](std::uint32_t row, LayerId own) {
        const std::uint32_t step = tree.copies[row].step;
        const auto known = made.find({step, own});
        if (known != made.end()) {
            return known->second;
        }
        auto field = DistanceField::betweenNets(*tree.steps[step], own, progress);
        const auto shared = [&] { return Field(std::make_shared<const DistanceField>(std::move(*field))); };
        return made.emplace(std::pair(step, own), field ? shared() : Field(field.error())).first->second;
    });
}

base::Result<BoardDistances> BoardDistances::toTargets(const Document& board, LayerId layer,
                                                       std::span<const BoardElement> targets) {
    using Field = base::Result<std::shared_ptr<const DistanceField>>;
    const StepTree tree = unfoldCopies(board);
    std::map<std::uint32_t, std::vector<ElementId>> byCopy;
    for (const BoardElement& target : targets) {
        byCopy[target.copy].push_back(target.element);
    }
    return make(board, layer, [&](std::uint32_t row, LayerId own) {
        if (!byCopy.contains(row)) {
            return Field(
                base::Error{base::ErrorCode::BadUsage, "the selection has no copper on " + board.layer(layer).name});
        }
        auto field = DistanceField::toTargets(*tree.steps[tree.copies[row].step], own, byCopy[row]);
        return field ? Field(std::make_shared<const DistanceField>(std::move(*field))) : Field(field.error());
    });
}

std::string BoardDistances::note() const {
    const bool isPlaced = m_placed.size() > 1 || m_placed.front().copy != 0;
    return isPlaced ? "clearances across copies of steps are not measured" : "";
}

base::Status BoardDistances::mapCopy(const Placed& placed, double reach, base::Progress& progress, MapDetail detail,
                                     ClearanceMap& map) const {
    const std::optional<Part> part = partOver(map.frame, placed.box);
    if (!part) {
        return base::Done{};
    }
    const Unplaced unplaced(placed.placement);
    const MapFrame under = frameUnder(map.frame, *part, unplaced);
    ASSIGN_OR_RETURN(const ClearanceMap own, placed.field->map(under, reach, progress, detail));
    for (std::uint32_t row = part->row; row < part->row + part->height; ++row) {
        for (std::uint32_t column = part->column; column < part->column + part->width; ++column) {
            const PointD middle = map.frame.centreOf(column, row);
            const std::size_t from = cellAt(under, unplaced(middle));
            const std::size_t to = std::size_t{row} * map.frame.width + column;
            if (own.nm[from] < map.nm[to] && isInside(placed.box, middle)) {
                map.nm[to] = own.nm[from];
                if (detail == MapDetail::Nets) {
                    map.nets[to] = {placed.copy, own.nets[from].nearest, own.nets[from].other};
                }
            }
        }
    }
    return base::Done{};
}

base::Result<ClearanceMap> BoardDistances::map(const MapFrame& frame, double reach, base::Progress& progress,
                                               MapDetail detail) const {
    if (m_placed.size() == 1 && isIdentity(m_placed.front().placement)) {
        return m_placed.front().field->map(frame, reach, progress, detail);
    }
    RETURN_IF_ERROR(checkFrame(frame));
    ClearanceMap map{frame, std::vector<float>(frame.size(), std::numeric_limits<float>::infinity()),
                     std::vector<MapNets>(detail == MapDetail::Nets ? frame.size() : 0)};
    for (const Placed& placed : m_placed) {
        RETURN_IF_ERROR(mapCopy(placed, reach, progress, detail, map));
    }
    return map;
}

double BoardDistances::at(PointD location, double reach) const {
    double least = kEndless;
    const bool isAlone = m_placed.size() == 1 && isIdentity(m_placed.front().placement);
    for (const Placed& placed : m_placed) {
        if (isAlone || isInside(placed.box, location)) {
            least = std::min(least, placed.field->at(Unplaced(placed.placement)(location), reach));
        }
    }
    return least;
}

}  // namespace model
