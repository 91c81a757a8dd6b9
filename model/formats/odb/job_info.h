#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "model/board/diagnostics.h"
#include "model/formats/odb/text/records.h"

namespace model::odb {

/// What `misc/info` says; all of it may be missing (odb-notes, Container).
struct MiscInfo {
    std::string jobName;
    std::string generator;  ///< SAVE_APP, or ODB_SOURCE where that is absent
    std::string version;    ///< "8.1"
    std::optional<Unit> unit;
};

[[nodiscard]] MiscInfo parseInfo(std::string_view text, std::string_view path, Diagnostics& diagnostics);

}  // namespace model::odb
