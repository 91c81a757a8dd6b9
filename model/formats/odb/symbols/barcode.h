#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "model/formats/common/text_layout.h"
#include "model/formats/odb/features/features.h"

namespace model::odb {

/// A barcode in its own system: nanometres, the lower left corner of the bars at the origin.
struct BarcodeLayout {
    ShapeSketch bars;  ///< the bars; for an inverted one a background with the bars left out
    double width = 0.0;
    std::vector<formats::TextStroke> string;  ///< the text beside the bars
    std::string problem;
};

/// Elements of the code 39 pattern of a text, bar and space in turn, true for wide ones: start, text, check character
/// if wanted, stop, with a narrow space between characters. Full ASCII writes what code 39 does not have as pairs;
/// plain code 39 takes lower-case letters as capitals. Empty when a character cannot be written.
[[nodiscard]] std::vector<bool> code39(std::string_view text, bool isFullAscii, bool hasChecksum);

/// Draws UPC39, which is code 39 with wide elements of three narrow ones. Another code, or a text it cannot hold, gives
/// the outline of the space that the bars of code 39 would take, and a problem.
[[nodiscard]] BarcodeLayout layOut(const BarcodeRecord& barcode, const formats::Font& font);

}  // namespace model::odb
