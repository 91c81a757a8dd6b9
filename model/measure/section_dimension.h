#pragma once

#include <utility>

namespace model {

/// A location in a section, in nm along its line and above the bottom of the board. What was caught counts: of a
/// corner both, of an upright edge how far along it is, of a level one how high.
struct SectionPosition {
    double along = 0.0;
    double z = 0.0;
    bool isOnUpright = false;
    bool isOnLevel = false;
    bool operator==(const SectionPosition&) const = default;
};

/// A distance in a section, from one location to another. Between two upright edges it is level, between two level ones
/// upright, else slanting.
struct SectionDimension {
    SectionPosition from;
    SectionPosition to;
    bool operator==(const SectionDimension&) const = default;

    [[nodiscard]] bool isLevel() const;
    [[nodiscard]] bool isUpright() const { return !isLevel() && isHeightAlone(); }
    /// From where to where it is drawn.
    [[nodiscard]] std::pair<SectionPosition, SectionPosition> ends() const;
    [[nodiscard]] double along() const;   ///< without a sign
    [[nodiscard]] double height() const;  ///< likewise
    /// Of what is drawn.
    [[nodiscard]] double length() const;

private:
    [[nodiscard]] bool isHeightAlone() const;
};

}  // namespace model
