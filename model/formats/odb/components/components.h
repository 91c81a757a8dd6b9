#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "model/board/diagnostics.h"
#include "model/board/document.h"
#include "model/formats/odb/text/record_attributes.h"
#include "model/formats/odb/text/records.h"

namespace model::odb {

/// A TOP record: a pin where it lies on the board.
struct PlacedPin {
    std::int32_t number = -1;  ///< row of the package's pins; -1 unknown
    base::Point position;
    std::int32_t net = -1;  ///< number of the NET record in eda/data; -1 none
    std::string name;
    std::uint32_t line = 0;
};

/// A CMP record with its pins (odb-notes, Nets and parts).
struct PlacedComponent {
    std::int32_t package = -1;  ///< number of the PKG record in eda/data; -1 unknown
    base::Point position;
    double clockwiseDeg = 0.0;  ///< 0 to 360
    bool isMirrored = false;    ///< as written; not reliable
    std::string refdes;
    std::string part;
    Nm height = 0;  ///< .comp_height; 0 unknown
    std::uint32_t line = 0;
    std::int32_t number = 0;               ///< of the CMP records of the file, those that are unreadable too; from 0
    std::vector<TextProperty> properties;  ///< attributes, then PRP
    std::vector<PlacedPin> pins;
};

/// Unreadable and unknown records are reported.
[[nodiscard]] std::vector<PlacedComponent> parseComponents(std::string_view text, std::string_view path,
                                                           Unit defaultUnit, const AttributeTypes& types,
                                                           Diagnostics& diagnostics);

}  // namespace model::odb
