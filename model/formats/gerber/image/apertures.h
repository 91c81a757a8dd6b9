#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "model/formats/drawing/drawn_job.h"

namespace model::gerber {

/// The statements of an aperture macro (AM), blanks taken out.
class Macro {
public:
    Macro() = default;
    /// `body` is what stands between the macro's name and the closing %.
    explicit Macro(std::string_view body);

    /// What the macro draws with these parameters, lengths in units of `nmPerUnit`. What is not drawn as it is written
    /// is named in `problems`, sentences without values.
    [[nodiscard]] formats::PadShape shape(std::span<const double> parameters, double nmPerUnit,
                                          std::vector<std::string>& problems) const;

private:
    std::vector<std::string> m_statements;
};

/// One of the standard apertures C, R, O and P with the parameters behind it. `isKnown` is false for other letters.
[[nodiscard]] formats::PadShape standardAperture(char letter, std::span<const double> parameters, double nmPerUnit,
                                                 std::vector<std::string>& problems, bool& isKnown);

/// The shape grown by a factor.
[[nodiscard]] formats::PadShape scaled(const formats::PadShape& shape, double factor);
/// The shape as a pen that has been laid down: rotated, mirrored, but not moved.
[[nodiscard]] formats::PadShape turned(const formats::PadShape& shape, const Placement& placement);

}  // namespace model::gerber
