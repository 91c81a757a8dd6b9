#include "model/solids/body_floors.h"

#include <algorithm>

#include "model/geometry/region.h"
#include "model/solids/region_distance.h"

namespace model {

namespace {

std::uint32_t groupOf(const Document& document, std::size_t row) {
    return document.layer(document.stackup.rows[row].layer).outlineGroup;
}

/// Rows of copper and dielectrics that are layers, from outside on.
std::vector<std::size_t> coreRows(const Document& document, LayerSide side) {
    std::vector<std::size_t> rows;
    for (std::size_t row = 0; row < document.stackup.rows.size(); ++row) {
        const LayerId id = document.stackup.rows[row].layer;
        const bool isCore = id.isValid() && document.stackup.rows[row].thickness > 0 &&
                            (document.layer(id).isCopper() || document.layer(id).type == LayerType::Dielectric);
        if (isCore) {
            rows.push_back(row);
        }
    }
    if (side == LayerSide::Bottom) {
        std::ranges::reverse(rows);
    }
    return rows;
}

/// The stack where a row is the outermost: without what lies outside of it, and without what is nowhere else.
LocalStack stackOf(const Document& document, std::size_t outer, LayerSide side) {
    std::vector<bool> has(document.stackup.rows.size(), true);
    for (const std::size_t missing : coreRows(document, side)) {
        if (missing == outer) {
            break;
        }
        for (std::size_t row = 0; row < has.size(); ++row) {
            const bool isAlike =
                document.stackup.rows[row].layer.isValid() && groupOf(document, row) == groupOf(document, missing);
            // Spacings that are no layers are where the copper beside them is.
            const bool isSpacing =
                !document.stackup.rows[row].layer.isValid() && (side == LayerSide::Bottom ? row > outer : row < outer);
            has[row] = has[row] && row != missing && !isAlike && !isSpacing;
        }
    }
    return {document, std::move(has)};
}

}  // namespace

std::vector<BodyFloor> bodyFloorsOf(const Document& document) {
    std::vector<BodyFloor> floors{{LayerSide::Top, {}}, {LayerSide::Bottom, {}}};
    for (const LayerSide side : {LayerSide::Top, LayerSide::Bottom}) {
        std::vector<std::uint32_t> outside;
        for (const std::size_t row : coreRows(document, side)) {
            const std::uint32_t own = groupOf(document, row);
            if (!outside.empty() && std::ranges::find(outside, own) == outside.end()) {
                floors.push_back({side, document.stackup.rows[row].layer});
            }
            if (own == 0) {
                break;  // it is everywhere, so that nothing further inside is outermost
            }
            outside.push_back(own);
        }
    }
    return floors;
}

Nm heightOf(const Document& document, const BodyFloor& floor) {
    const auto row = std::ranges::find(document.stackup.rows, floor.on, &StackupRow::layer);
    const auto outer = static_cast<std::size_t>(row - document.stackup.rows.begin());
    const LocalStack stack = stackOf(document, outer, floor.side);
    const std::optional<BoardFace> face = stack.outerFace(floor.side != LayerSide::Bottom);
    return face ? face->copper + face->outwards() * std::max(face->mask, stack.coverlayOn(*face)) : 0;
}

FloorFinder::FloorFinder(const Document& document) : m_document(document), m_floors(bodyFloorsOf(document)) {}

bool FloorFinder::isWithin(ShapeId shape, Point location) {
    const auto [outline, isNew] = m_outlines.try_emplace(shape);
    if (isNew) {
        outline->second = discretise(m_document.shapes, shape, kBooleanChords);
    }
    return contains(outline->second, outline->second.polygons, location);
}

std::optional<BodyFloor> FloorFinder::floorAt(LayerSide side, Point location) {
    const bool isOnBoard = !m_document.profile.isValid() || isWithin(m_document.profile, location);
    const LocalStack stack(m_document, rowsWhere(m_document, [&](LayerId id) {
                               const Layer& layer = m_document.layer(id);
                               return layer.profile.isValid()
                                          ? isWithin(layer.profile, location)
                                          : isOnBoard && (layer.outlineGroup == 0 || !isLaidOn(layer));
                           }));
    const std::optional<std::size_t> row = stack.outerRow(side != LayerSide::Bottom);
    if (!row) {
        return std::nullopt;
    }
    const BodyFloor found{side, m_document.stackup.rows[*row].layer};
    return std::ranges::find(m_floors, found) != m_floors.end() ? found : BodyFloor{side, {}};
}

BodyFloor FloorFinder::at(LayerSide side, const std::vector<Point>& locations) {
    for (const Point location : locations) {
        if (const std::optional<BodyFloor> floor = floorAt(side, location)) {
            return *floor;
        }
    }
    return {side, {}};
}

}  // namespace model
