#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "tests/reference/raster.h"

namespace reference {

/// The bytes of a file of the job; nothing when it does not exist.
using ReadFile = std::function<std::optional<std::string>(const std::string& path)>;

/// Paints features files as the format describes them, with a parser of its own.
class OdbPainter {
public:
    explicit OdbPainter(ReadFile read);

    /// Paints a file in the order of its records; negative ones clear. With `isInverse` everything is turned round: the
    /// features of a negative layer clear and its negative features set.
    void paint(const std::string& path, Raster& raster, bool isInverse = false);
    /// Records that were met and cannot be painted.
    [[nodiscard]] const std::vector<std::string>& unknown() const { return m_unknown; }

private:
    /// p' = place + mirror · clockwise rotation · p.
    struct Frame {
        Point location;
        double clockwiseDeg = 0.0;
        bool isMirrored = false;
    };
    struct File;

    void paintRecords(const std::string& text, const std::vector<Frame>& frames, Raster& raster, bool isInverse,
                      int depth);
    void pad(const File& file, const std::vector<std::string>& fields, const std::vector<Frame>& frames, Raster& raster,
             bool value, int depth);
    void track(const File& file, const std::vector<std::string>& fields, const std::vector<Frame>& frames,
               Raster& raster, bool value, bool isArc);

    ReadFile m_read;
    double m_defaultUnit = 25.4;
    std::vector<std::string> m_unknown;
};

}  // namespace reference
