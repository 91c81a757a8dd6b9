#include "model/board/local_stack.h"

#include <algorithm>
#include <iterator>
#include <map>

namespace model {

namespace {

const Layer* layerOf(const Document& board, std::size_t row) {
    const LayerId layer = board.stackup.rows[row].layer;
    return layer.isValid() ? &board.layer(layer) : nullptr;
}

bool isCopper(const Document& board, std::size_t row) {
    const Layer* layer = layerOf(board, row);
    return layer != nullptr && layer->isCopper();
}

/// The next copper from a row on, itself left out; none where there is no more.
std::optional<std::size_t> copperFrom(const Document& board, std::size_t row, bool isDown) {
    const std::size_t count = board.stackup.rows.size();
    for (std::size_t i = isDown ? row + 1 : row - 1; i < count; i = isDown ? i + 1 : i - 1) {
        if (isCopper(board, i)) {
            return i;
        }
    }
    return std::nullopt;
}

}  // namespace

std::vector<bool> rowsWhere(const Document& board, const std::function<bool(LayerId)>& isHere) {
    const std::vector<StackupRow>& rows = board.stackup.rows;
    const auto isCopper = [&](const StackupRow& row) {
        return row.layer.isValid() && board.layer(row.layer).isCopper();
    };
    std::vector<bool> has;
    for (auto row = rows.begin(); row != rows.end(); ++row) {
        if (row->layer.isValid()) {
            has.push_back(isHere(row->layer));
            continue;
        }
        const auto above = std::find_if(std::make_reverse_iterator(row), rows.rend(), isCopper);
        const auto below = std::find_if(row, rows.end(), isCopper);
        has.push_back((above == rows.rend() || isHere(above->layer)) && (below == rows.end() || isHere(below->layer)));
    }
    return has;
}

bool isLaidOn(LayerUse use) {
    return use == LayerUse::Coverlay || use == LayerUse::Adhesive || use == LayerUse::Stiffener;
}

bool isLaidOn(const Layer& layer) {
    return isLaidOn(layer.use);
}

LayerId drawnBy(const Document& board, LayerId layer) {
    const LayerId openings = board.layer(layer).openings;
    return openings.isValid() ? openings : layer;
}

bool LocalStack::isCore(std::size_t row) const {
    const StackupRow& own = m_board.stackup.rows[row];
    return m_has[row] && own.thickness > 0 && (isCopper(m_board, row) || own.type == LayerType::Dielectric);
}

/// Between copper layers on the flexible copper next to it, as the stackup has it (model/board/stackup.h).
bool LocalStack::liesUpwards(std::size_t row) const {
    const std::optional<std::size_t> above = copperFrom(m_board, row, false);
    const std::optional<std::size_t> below = copperFrom(m_board, row, true);
    if (!above || !below) {
        return !above;
    }
    return layerOf(m_board, *below)->use == LayerUse::Flex || layerOf(m_board, *above)->use != LayerUse::Flex;
}

std::optional<std::size_t> LocalStack::baseOf(std::size_t row, bool isUp) const {
    for (std::size_t i = isUp ? row + 1 : row - 1; i < m_has.size(); i = isUp ? i + 1 : i - 1) {
        if (isCore(i)) {
            return i;
        }
    }
    return std::nullopt;
}

BoardFace LocalStack::faceOf(std::size_t row, bool isTop) const {
    const StackupRow& own = m_board.stackup.rows[row];
    BoardFace face;
    face.isTop = isTop;
    face.copper = isTop ? own.z + own.thickness : own.z;
    face.substrate = isCopper(m_board, row) == isTop ? own.z : own.z + own.thickness;
    return face;
}

/// The one that is listed next to the board.
void LocalStack::addMask(BoardFace& face) const {
    std::optional<std::size_t> nearest;
    for (std::size_t i = 0; i < m_board.layers.size(); ++i) {
        const Layer& mask = m_board.layers[i];
        if (mask.type != LayerType::SolderMask || !mask.isSynthetic || !mask.openings.isValid() ||
            mask.thickness <= 0 || mask.side != (face.isTop ? LayerSide::Top : LayerSide::Bottom) ||
            isLaidOn(m_board.layer(mask.openings))) {
            continue;
        }
        for (std::size_t row = 0; row < m_has.size(); ++row) {
            const bool isNearer = !nearest || (face.isTop ? row > *nearest : row < *nearest);
            if (m_has[row] && m_board.stackup.rows[row].layer == mask.openings && isNearer) {
                nearest = row;
                face.mask = mask.thickness;
                face.maskLayer = LayerId{i};
            }
        }
    }
}

std::optional<std::size_t> LocalStack::outerRow(bool isTop) const {
    for (std::size_t i = 0; i < m_has.size(); ++i) {
        const std::size_t row = isTop ? i : m_has.size() - 1 - i;
        if (isCore(row)) {
            return row;
        }
    }
    return std::nullopt;
}

std::optional<BoardFace> LocalStack::outerFace(bool isTop) const {
    const std::optional<std::size_t> row = outerRow(isTop);
    if (!row) {
        return std::nullopt;
    }
    BoardFace face = faceOf(*row, isTop);
    addMask(face);
    return face;
}

Nm LocalStack::coverlayOn(const BoardFace& face) const {
    Nm thickness = 0;
    for (const LaidStack& stack : laidStacks({})) {
        const bool isOn = stack.face.copper == face.copper && stack.face.isTop == face.isTop;
        for (const std::size_t row : isOn ? stack.rows : std::vector<std::size_t>()) {
            const bool isCoverlay = layerOf(m_board, row)->use == LayerUse::Coverlay;
            thickness += isCoverlay ? m_board.stackup.rows[row].thickness : 0;
        }
    }
    return thickness;
}

std::vector<LaidStack> LocalStack::laidStacks(const std::vector<LayerId>& drawn) const {
    std::map<std::pair<std::size_t, bool>, std::vector<std::size_t>> byBase;
    for (std::size_t row = 0; row < m_has.size(); ++row) {
        const Layer* layer = layerOf(m_board, row);
        const bool isHere = m_has[row] || std::ranges::binary_search(drawn, m_board.stackup.rows[row].layer);
        if (isHere && layer != nullptr && isLaidOn(*layer) && m_board.stackup.rows[row].thickness > 0) {
            const bool isUp = liesUpwards(row);
            if (const auto base = baseOf(row, isUp)) {
                byBase[{*base, isUp}].push_back(row);
            }
        }
    }
    std::vector<LaidStack> stacks;
    for (auto& [key, rows] : byBase) {
        if (key.second) {
            std::ranges::reverse(rows);
        }
        stacks.push_back({faceOf(key.first, key.second), std::move(rows)});
    }
    return stacks;
}

}  // namespace model
