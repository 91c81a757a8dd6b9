#pragma once

#include <map>
#include <optional>
#include <string>

#include "model/formats/drawing/drawn_job.h"
#include "model/formats/gerber/pad_index.h"
#include "model/formats/gerber/placements.h"

namespace model::gerber {

/// Collects the components of a board from whatever names them: pins of X2 files, netlists, pick-and-place files.
class PartList {
public:
    explicit PartList(formats::DrawnStep& step) : m_step(step) {}

    /// Row of the component of this name, which is made if it is not there.
    [[nodiscard]] std::int32_t component(const std::string& refdes);
    [[nodiscard]] std::int32_t find(const std::string& refdes) const;
    /// Row of a pin within its component, which is made if it is not there.
    [[nodiscard]] std::int32_t pin(std::int32_t component, const std::string& name, Point position, std::int32_t net);
    /// A pad of a component on a copper layer, or something of its on a silkscreen: tells its side.
    void isSeenOn(std::int32_t component, LayerSide side, bool isPad, bool isThrough);

    /// Brings in the places, values and packages of a pick-and-place file. Its origin, and its unit where it says none,
    /// are those that lay components on their pins, or without pins on the board.
    void place(const PlacementFile& file, std::string_view path, const PadIndex& pads, const Box& board,
               Diagnostics& diagnostics);
    /// Settles sides, places and packages of what no file places.
    void finish(Diagnostics& diagnostics);
    [[nodiscard]] bool isEmpty() const { return m_step.components.empty(); }

private:
    struct Facts {
        int top = 0;  ///< pads on this side only
        int bottom = 0;
        int legendTop = 0;
        int legendBottom = 0;
        bool hasThrough = false;
        bool isPlaced = false;
        bool hasSide = false;
        std::string package;
        std::map<std::string, std::int32_t> pins;
    };

    /// How places of a file become those on the board: times the factor, then plus the shift.
    struct Fit {
        double factor = 1.0;
        Point shift;
        bool isByPins = false;  ///< the components lie on their pins then; else their places are on the board
    };

    [[nodiscard]] std::optional<Fit> fitOf(const PlacementFile& file, const PadIndex& pads, const Box& board) const;
    [[nodiscard]] std::optional<Point> shiftOf(const PlacementFile& file, double factor) const;
    void addPackage(formats::DrawnComponent& component, const Facts& facts);

    formats::DrawnStep& m_step;
    std::map<std::string, std::int32_t> m_rows;
    std::vector<Facts> m_facts;
    std::map<std::string, std::int32_t> m_packages;
};

}  // namespace model::gerber
