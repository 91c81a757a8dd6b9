#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "model/board/diagnostics.h"
#include "model/formats/drawing/drawn_job.h"

namespace model::gerber {

/// A pin that a flash or another object belongs to (TO.P).
struct ImagePin {
    std::int32_t component = formats::kNoRow;  ///< Image::components
    std::string name;
    std::string function;
};

/// What one Gerber file draws, blocks and repeated steps unrolled, in paint order. Rows of symbols, regions, nets,
/// components, pins and attributes are rows of this image; nothing is known about the board yet.
struct Image {
    std::vector<formats::DrawnFeature> features;
    std::vector<formats::DrawnSymbol> symbols;
    std::vector<ShapeSketch> regions;
    std::vector<formats::Words> attributes;  ///< of features: ".AperFunction" and others
    std::vector<std::string> nets;           ///< TO.N
    std::vector<std::string> components;     ///< TO.C and TO.P: reference designators
    std::vector<ImagePin> pins;              ///< TO.P
    formats::Words fileAttributes;           ///< TF, in a comment or not: ".FileFunction"
    formats::Words jobAttributes;            ///< TJ
    std::vector<std::string> comments;       ///< the first ones, and names of layers and images (LN, IN)
    bool isNegative = false;                 ///< IPNEG: what is drawn is what is left out
    bool hasEnd = false;                     ///< M02
    bool isInInches = false;                 ///< MOIN, or nothing is said; of drill files false
    std::vector<DrillTool> tools;            ///< of drill files
    std::size_t flashes = 0;
    std::size_t draws = 0;
    std::size_t contours = 0;
    std::size_t placesBeyond = 0;  ///< coordinates that are farther out than a board can be
    base::PointD cornerBeyond;     ///< the lower left one of these, nm
    Diagnostics diagnostics;

    /// The value of a file attribute; empty if there is none.
    [[nodiscard]] std::string_view fileAttribute(std::string_view name) const;
};

/// Reads every command of a file. What cannot be read or is outdated in a way that matters is reported with its line.
/// `shift`: nm, added to all places.
[[nodiscard]] Image parseImage(std::string_view text, std::string_view path, base::PointD shift = {});

}  // namespace model::gerber
