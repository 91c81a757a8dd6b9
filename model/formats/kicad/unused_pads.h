#pragma once

#include <cstdint>
#include <vector>

#include "model/formats/kicad/canvas.h"

namespace model::kicad {

/// Copper that a pad or via keeps only where something ends there (remove_unused_layers), on inner layers or on all: it
/// waits until all tracks and zones are drawn. What keeps it is a track on that layer that ends there or runs over its
/// middle, or a via or a pad of another footprint that is on that layer too and touches it on any layer; in files of
/// KiCad 6 what a zone fills there, too. Later ones name the layers on which zones keep it.
class UnusedPads {
public:
    /// A via or pad.
    struct Owner {
        std::vector<std::int32_t> rows;  ///< the copper it is on, from the top
        std::int32_t net = formats::kNoRow;
        std::int32_t component = formats::kNoRow;
        PointD at;
        double clockwiseDeg = 0.0;
        PointD core;  ///< half sizes of the rectangle that its copper lies around by `radius`; none: it is round
        double radius = 0.0;
        double hole = 0.0;  ///< radius; all that is there where its copper waits
        bool isPad = false;
        bool waits = false;      ///< its copper does
        bool keepsEnds = false;  ///< but not on its first and last row
    };
    struct Waiting {
        std::int32_t row = 0;
        Origin origin;
        std::int32_t symbol = 0;
        PointD at;
        double clockwiseDeg = 0.0;
        double reach = 0.0;     ///< how far from `at` a track may end; below 0: it is kept in any case
        std::size_t owner = 0;  ///< as add() numbered it
    };

    explicit UnusedPads(Canvas& canvas) : m_canvas(canvas) {}

    /// Of all vias and pads, whether copper of theirs waits or not.
    std::size_t add(Owner owner);
    void add(const Waiting& pad) { m_waiting.push_back(pad); }
    /// When all tracks and zones are drawn: draws those that are kept.
    void draw();

private:
    void drawOn(std::int32_t row, const std::vector<Waiting>& pads);
    [[nodiscard]] bool isTouched(const Waiting& pad) const;

    Canvas& m_canvas;
    std::vector<Waiting> m_waiting;
    std::vector<Owner> m_owners;
    std::vector<std::size_t> m_byNet;  ///< rows of m_owners, by net and x
    double m_farthest = 0.0;           ///< that any of them reaches
};

}  // namespace model::kicad
