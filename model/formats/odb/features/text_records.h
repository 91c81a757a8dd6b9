#pragma once

#include <cstdint>
#include <string>

#include "model/formats/common/text_layout.h"
#include "model/formats/odb/text/lengths.h"
#include "model/formats/odb/text/records.h"
#include "model/geometry/shapes.h"

namespace model::odb {

/// How a pad, text or barcode lies: the orientation field, with the angle that follows codes 8 and 9 (odb-notes,
/// Features).
struct Orientation {
    double clockwiseDeg = 0.0;
    bool isMirrored = false;
};
[[nodiscard]] Orientation readOrientation(Fields& fields);

/// `T x y font pol orient xsize ysize width 'text' version`, from the sizes on. The file gives the pen's width as a
/// factor of 12 mil. The version says how old tools placed the text; both are placed alike.
struct TextRecord {
    std::string font;
    formats::TextLine line;
};

/// `B x y code font pol orient E width height fasc cs bg astr astr_pos 'text'`.
struct BarcodeRecord {
    std::string code;  ///< UPC39 is code 39; others are not drawn
    std::string font;
    std::string text;     ///< UTF-8
    Nm elementWidth = 0;  ///< of a narrow bar
    Nm height = 0;        ///< of the bars
    bool isFullAscii = false;
    bool hasChecksum = false;
    bool isInverted = false;  ///< bars are left out of a background
    bool hasString = false;   ///< the text is written beside the bars
    bool isStringAbove = false;
};

/// What follows the orientation; `font` has been read before it. Fails like any other field.
[[nodiscard]] TextRecord readText(Fields& fields, std::int64_t nmPerUnit, std::string_view font);
[[nodiscard]] BarcodeRecord readBarcode(Fields& fields, std::int64_t nmPerUnit, std::string_view code,
                                        std::string_view font);

}  // namespace model::odb
