#pragma once

#include "model/generate/layout.h"

namespace model::generate {

/// How many elements of each kind a block holds.
struct BlockShare {
    int lines = 0;
    int arcs = 0;
    int circles = 0;
    int trails = 0;
    int pads = 0;
    int tracksPerTrail = 3;
    std::uint64_t random = 0;  ///< chooses the sizes of pads and the depth of meanders
};

/// Draws one block of 8 × 4 mm, two cells side by side. In a cell, from the top: print, a row of eight pads, four vias,
/// room for traces, a row of eight pads. A via is three circles: hole, upper and lower pad.
/// - A line runs from a pad to its via, or is a mark of the print (at least every third one).
/// - A trail joins two vias of the two cells on the bottom, nested so that none cross, or a pad of the upper row to the
/// one of the lower row on the top; it meanders as traces of matched length do.
/// - Vias without a trail go to the planes in turn.
/// Which sites are in use depends on the counts alone.
class BlockMaker {
public:
    static constexpr std::int32_t kWidthUm = 8000;
    static constexpr std::int32_t kHeightUm = 4000;
    static constexpr std::uint64_t kMaxLines = 20;
    static constexpr std::uint64_t kMaxArcs = 2;
    static constexpr std::uint64_t kMaxCircles = 24;
    static constexpr std::uint64_t kMaxTrails = 8;
    static constexpr std::uint64_t kMaxPads = 32;

    /// `corner`: lower left of the block.
    BlockMaker(PointUm corner, const BlockShare& share);
    [[nodiscard]] Block make();

private:
    [[nodiscard]] PointUm viaSite(int via) const;
    [[nodiscard]] BlockNet netOfVia(int via) const;
    [[nodiscard]] int random(int choices);

    void addVias();
    void addTestPads();
    void addBottomTrails();
    void addTopTrails();
    void addPads();
    void addPrint();
    void addPad(BoardLayer plane, PointUm at, Pen pen, BlockNet net);
    void addTrack(BoardLayer plane, PointUm a, PointUm b, Pen pen, BlockNet net);
    void addTrail(BoardLayer plane, const std::vector<PointUm>& path, BlockNet net);

    PointUm m_corner;
    BlockShare m_share;
    int m_vias = 0;
    int m_bottomTrails = 0;
    int m_topTrails = 0;
    int m_fanOuts = 0;
    Block m_block;
};

}  // namespace model::generate
