#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "model/board/board_face.h"

/// The stackup at one location of a rigid-flex board, where some layers are missing. Heights of a stackup are those
/// where all layers are (decision 45); here what lies on others lies on those that are there.
namespace model {

/// Films and plates that are laid or glued on a face one on the other, from the inside out.
struct LaidStack {
    BoardFace face;                 ///< without a mask
    std::vector<std::size_t> rows;  ///< of Stackup::rows
};

class LocalStack {
public:
    /// `has`: by row of Stackup::rows, whether it is here.
    LocalStack(const Document& board, std::vector<bool> has) : m_board(board), m_has(std::move(has)) {}

    [[nodiscard]] const std::vector<bool>& has() const { return m_has; }
    /// The outermost copper or dielectric, a row of Stackup::rows. None: nothing is here.
    [[nodiscard]] std::optional<std::size_t> outerRow(bool isTop) const;
    /// Its outer face, with the solder mask on it.
    [[nodiscard]] std::optional<BoardFace> outerFace(bool isTop) const;
    /// How thick the coverlays are that lie on this face.
    [[nodiscard]] Nm coverlayOn(const BoardFace& face) const;
    /// Coverlays, adhesives and stiffeners, by the copper or dielectric that they lie on; also those that are drawn
    /// here although no zone says so (`drawn`, rising).
    [[nodiscard]] std::vector<LaidStack> laidStacks(const std::vector<LayerId>& drawn) const;

private:
    [[nodiscard]] bool isCore(std::size_t row) const;
    [[nodiscard]] bool liesUpwards(std::size_t row) const;
    [[nodiscard]] std::optional<std::size_t> baseOf(std::size_t row, bool isUp) const;
    [[nodiscard]] BoardFace faceOf(std::size_t row, bool isTop) const;
    void addMask(BoardFace& face) const;

    const Document& m_board;
    std::vector<bool> m_has;
};

/// By row of Stackup::rows, whether it is where the layers are for which this holds. A dielectric that is no layer of
/// the job is where the copper above and below it is.
[[nodiscard]] std::vector<bool> rowsWhere(const Document& board, const std::function<bool(LayerId)>& isHere);

/// Is the layer laid or glued onto what is there (coverlay, adhesive, stiffener) instead of filling the space beside
/// the copper?
[[nodiscard]] bool isLaidOn(LayerUse use);
[[nodiscard]] bool isLaidOn(const Layer& layer);
/// The layer of the job that a solder mask which we added is of; of all others the layer itself.
[[nodiscard]] LayerId drawnBy(const Document& board, LayerId layer);

}  // namespace model
