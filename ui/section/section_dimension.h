#pragma once

#include <QCoreApplication>
#include <QString>
#include <optional>
#include <utility>

#include "ui/common/display_units.h"

namespace ui {

/// A location in a section that was snapped to, in nm along the line and above the bottom: a corner, or on an edge.
struct SectionPosition {
    double along = 0.0;
    double z = 0.0;
    bool isOnUpright = false;  ///< on an upright edge: how far along it is counts
    bool isOnLevel = false;    ///< on a level edge: how high it is counts; of a corner both
};

/// A distance in a section, between two locations one after the other.
class SectionDimension {
    Q_DECLARE_TR_FUNCTIONS(ui::SectionDimension)
public:
    void clear() { *this = {}; }
    /// The first location, the second one, or the first of a next distance.
    void add(const SectionPosition& location);

    [[nodiscard]] const std::optional<SectionPosition>& from() const { return m_from; }
    /// From where to where the distance is drawn: between two upright edges level, between two level ones upright.
    [[nodiscard]] std::optional<std::pair<SectionPosition, SectionPosition>> ends() const;
    /// "0.2 mm along", "0.035 mm high", or both and how far that is apart. Empty before there are two locations.
    [[nodiscard]] QString text(LengthUnit unit) const;

private:
    [[nodiscard]] bool isAlongAlone() const;
    [[nodiscard]] bool isHeightAlone() const;

    std::optional<SectionPosition> m_from;
    std::optional<SectionPosition> m_to;
};

}  // namespace ui
