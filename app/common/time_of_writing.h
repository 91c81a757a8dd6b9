#pragma once

#include <string>

#include "model/base/result.h"

namespace app {

/// The time that files say they were written at, as ISO 8601 in UTC: now, or where the environment variable
/// SOURCE_DATE_EPOCH is set (https://reproducible-builds.org/specs/source-date-epoch), that many seconds after the
/// start of 1970; empty counts as not set. Errors: BadUsage where the variable is no such number.
[[nodiscard]] base::Result<std::string> timeOfWriting();

}  // namespace app
