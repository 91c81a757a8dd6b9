#include "model/section/section_labels.h"

#include <algorithm>
#include <array>

#include "model/board/local_stack.h"

namespace model {

namespace {

bool isOf(const Document& board, const SectionPiece& piece, const StackupRow& row) {
    if (row.type == LayerType::Dielectric) {
        const Nm middle = row.z + row.thickness / 2;
        return isDielectric(piece.material) && piece.bottom <= middle && middle <= piece.top &&
               (board.layer(piece.layer).type == LayerType::Body || piece.layer == row.layer);
    }
    return row.layer.isValid() && drawnBy(board, piece.layer) == row.layer;
}

/// Films lie on what there is; below a board, and where they hang under copper, their outer face is the lower one.
Nm bottomOf(const Document& board, const SectionPiece& piece, const StackupRow& row) {
    if (!row.layer.isValid() || !isLaidOn(board.layer(row.layer))) {
        return row.z;
    }
    return board.layer(row.layer).side == LayerSide::Bottom ? piece.bottom : piece.top - row.thickness;
}

}  // namespace

std::uint32_t colourOf(const SectionPiece& piece, const std::vector<std::uint32_t>& layers) {
    constexpr std::uint32_t kGrey = 0xa0a0a4;
    const std::uint32_t own = piece.layer.row() < layers.size() ? layers[piece.layer.row()] : kGrey;
    return colourOf(piece.material).value_or(own);
}

std::vector<SectionLegendRow> legendOf(const std::vector<SectionPiece>& drawn,
                                       const std::vector<std::uint32_t>& layers) {
    std::array<std::vector<std::uint32_t>, kSectionMaterialCount> colours;
    for (const SectionPiece& piece : drawn) {  // by layer, which are in order from the top
        std::vector<std::uint32_t>& own = colours[static_cast<std::size_t>(piece.material)];
        if (std::ranges::find(own, colourOf(piece, layers)) == own.end()) {
            own.push_back(colourOf(piece, layers));
        }
    }
    std::vector<SectionLegendRow> rows;
    for (std::size_t i = 0; i < colours.size(); ++i) {
        const auto material = static_cast<SectionMaterial>(i);
        if (!colours[i].empty() && material != SectionMaterial::Other) {
            rows.push_back({material, std::move(colours[i])});
        }
    }
    return rows;
}

std::optional<RowMark> markOf(const Document& board, const std::vector<SectionPiece>& drawn, std::size_t row,
                              const SectionWindow& window) {
    const StackupRow& own = board.stackup.rows[row];
    std::optional<RowMark> mark;
    for (const SectionPiece& piece : drawn) {
        const double along = std::min(piece.most(), window.to);
        const bool isInSight = piece.least() < window.to && piece.most() > window.from &&
                               double(piece.bottom) <= window.top && double(piece.top) >= window.bottom;
        if (!isInSight || (mark && along <= mark->along) || !isOf(board, piece, own)) {
            continue;
        }
        const bool isDielectricRow = own.type == LayerType::Dielectric;
        const double low = isDielectricRow ? double(own.z) : double(piece.bottom);
        const double high = isDielectricRow ? double(own.z + own.thickness) : double(piece.top);
        mark = RowMark{along, (std::max(low, window.bottom) + std::min(high, window.top)) / 2,
                       bottomOf(board, piece, own)};
    }
    return mark;
}

}  // namespace model
