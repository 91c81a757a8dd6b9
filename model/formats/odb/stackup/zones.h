#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "model/board/diagnostics.h"
#include "model/formats/odb/text/records.h"
#include "model/geometry/shapes.h"

namespace model::odb {

/// A ZONE of `steps/<step>/zones`: a part of the board with a stackup of its own. It is a block of a ZONE line with the
/// name, LYR lines with its layers, and an S record with its outline:
///
///     ZONE Flex;UID=7
///     LYR 1 2 3
///     S P 0
///     OB 0 0 I
///     …
///     SE
struct ZoneRecord {
    std::string name;
    std::vector<std::string> layers;  ///< as written: numbers of rows of the matrix (ZoneRows), or names
    ShapeId outline;                  ///< in ZoneFile::outlines; none if it draws none
    std::uint32_t line = 0;
};

struct ZoneFile {
    std::vector<ZoneRecord> zones;
    ShapeTable outlines;
};

/// Unreadable and unknown records are reported.
[[nodiscard]] ZoneFile parseZones(std::string_view text, std::string_view path, Unit defaultUnit,
                                  Diagnostics& diagnostics);

}  // namespace model::odb
