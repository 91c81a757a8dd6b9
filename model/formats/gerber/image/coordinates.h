#pragma once

#include <cstdint>
#include <optional>
#include <string_view>

#include "model/base/point.h"

namespace model::gerber {

/// How the coordinates of a file are written (FS, MO and their outdated forms).
struct CoordinateFormat {
    bool isTrailingOmitted = false;  ///< T: zeros at the end are left out, not those at the beginning
    bool isIncremental = false;
    int integers = 2;  ///< digits before the point
    int decimals = 5;
    bool isAlikeInXAndY = true;  ///< those of y are the same
    bool hasFormat = false;      ///< the file says its digits
    bool hasUnit = false;
    double nmPerUnit = base::kNmPerInch;
    base::PointD shift;  ///< nm, added to all places: of a job that lies farther out than coordinates reach

    /// `FSLAX25Y25` behind FS. False if it cannot be read.
    bool readFormat(std::string_view text);
    void setUnit(bool isInch) {
        nmPerUnit = isInch ? base::kNmPerInch : base::kNmPerMm;
        hasUnit = true;
    }
    /// Digits without a point as a length in nanometres.
    [[nodiscard]] double length(std::int64_t value, int digits) const;
    /// Are these more digits than the format has room for? Zeros in front do not count where they may be left out.
    [[nodiscard]] bool isTooLong(std::int64_t value, int digits) const;
};

/// What a file says of its coordinates anywhere in its head: apertures may come before the unit.
[[nodiscard]] CoordinateFormat findFormat(std::string_view text);

}  // namespace model::gerber
