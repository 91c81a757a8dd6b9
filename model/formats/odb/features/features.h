#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "model/board/document.h"
#include "model/formats/common/text_layout.h"
#include "model/formats/odb/text/feature_attributes.h"
#include "model/formats/odb/text/records.h"
#include "model/geometry/shapes.h"

namespace model::odb {

enum class FeatureKind : std::uint8_t {
    Line,
    Arc,
    Pad,
    Surface,
    Text,
    Barcode,
    Bad  ///< a record that cannot be read; it still has an ordinal
};

/// A symbol as a features file refers to it. The same name in another unit, or resized, is another shape.
struct SymbolRef {
    std::string name;
    Unit unit = Unit::Inch;
    Nm resize = 0;  ///< added to the size (P records with -1)
    auto operator<=>(const SymbolRef&) const = default;
};

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

/// One record. Its row in FeatureFile::features is the feature number that eda/data uses, so bad records have rows too.
struct Feature {
    FeatureKind kind = FeatureKind::Bad;
    bool isNegative : 1 = false;
    bool isClockwise : 1 = false;        ///< arcs
    bool isMirrored : 1 = false;         ///< pads, texts, barcodes
    Plating plating = Plating::NotSaid;  ///< attribute .drill
    std::uint32_t index = 0;             ///< row of `symbols`; of `surfaces`, `texts`, `barcodes` for these
    std::uint32_t line = 0;              ///< 1-based
    std::uint32_t attributes = FeatureAttributes::kNone;  ///< row of FeatureAttributes::sets
    Point a;                                              ///< start, or location of a pad, text or barcode
    Point b;                                              ///< end of a line or arc
    Point centre;                                         ///< of an arc
    double clockwiseDeg = 0.0;                            ///< pads, texts, barcodes
};

/// A `features` or `profile` file, numbers in nanometres, nothing resolved yet.
struct FeatureFile {
    Unit unit = Unit::Inch;
    std::vector<SymbolRef> symbols;
    std::vector<Feature> features;
    FeatureAttributes attributes;
    ShapeTable surfaces;                     ///< one shape per S record, in the file's order
    std::vector<std::uint32_t> surfaceEnds;  ///< by surface: line of its SE
    std::vector<TextRecord> texts;
    std::vector<BarcodeRecord> barcodes;
    bool hasNegatives = false;
};

/// The outline a `profile` file draws: all polygons of its surfaces. Nothing when it has none.
[[nodiscard]] std::optional<ShapeSketch> profileOf(const FeatureFile& file);

/// Reads every record; what cannot be read is reported with its line. `defaultUnit` holds for files without a unit line
/// (odb-notes, Units).
[[nodiscard]] FeatureFile parseFeatures(std::string_view text, std::string_view path, Unit defaultUnit,
                                        Diagnostics& diagnostics);

}  // namespace model::odb
