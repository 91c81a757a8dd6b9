#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "model/board/document.h"

namespace model {

/// How far locations and sizes of the same item may be apart in two jobs.
inline constexpr Nm kSamePlace = 1'000;

[[nodiscard]] bool isSamePlace(Point a, Point b, Nm reach = kSamePlace);

/// What a board holds besides areas, with the copies of its steps, in coordinates of the board.
struct FlatBoard {
    static constexpr std::int32_t kNoNet = -1;

    struct Hole {
        Point middle;
        Nm width = 0;  ///< of the box around it
        Nm height = 0;
        bool isPlated = false;
        std::int32_t top = -1;  ///< first and last copper layer passed, counted from the top; −1: not known
        std::int32_t bottom = -1;
    };
    struct PinAt {
        std::string_view name;
        Point position;
        std::int32_t net = kNoNet;
    };
    struct Part {
        std::string_view refdes;
        Point position;
        double clockwiseDeg = 0.0;  ///< 0 to 360
        bool isBottom = false;
        bool isPlaced = true;  ///< false: the job does not say where it lies
        bool hasSide = true;  ///< false: nor on which side; its pins are on both, or it has none: `isBottom` is a guess
        std::uint32_t firstPin = 0;  ///< of `pins`
        std::uint32_t pinCount = 0;
    };
    /// A pad on copper.
    struct Pad {
        Point middle;
        std::int32_t layer = 0;  ///< of the copper layers, counted from the top
        std::int32_t net = kNoNet;
    };

    std::vector<Hole> holes;
    std::vector<Part> parts;
    std::vector<PinAt> pins;
    std::vector<Pad> pads;
    std::vector<std::string_view> nets;  ///< names; each copy has nets of its own
};

/// The document must live as long as the result; `shift` is added to all coordinates.
[[nodiscard]] FlatBoard flatten(const Document& board, Point shift);

/// Copper layers of the board from the top.
[[nodiscard]] std::vector<LayerId> boardCopper(const Document& board);

/// Where the holes are, or the pins of a board without holes.
[[nodiscard]] std::vector<Point> locationsOf(const FlatBoard& board);

/// How far apart the same item may lie in the two, neither of them shifted: kSamePlace, and half a step more where only
/// one of them has all of its round holes and pins at whole steps of 10 µm, as what KiCad writes as ODB++ unless it is
/// told to be finer.
[[nodiscard]] Nm reachOf(const FlatBoard& a, const FlatBoard& b);

/// How many of `moved` lie within `reach` of one of `fixed` once `shift` is added to them; each counts once.
[[nodiscard]] std::size_t countMatches(const std::vector<Point>& fixed, const std::vector<Point>& moved, Point shift,
                                       Nm reach);

}  // namespace model
