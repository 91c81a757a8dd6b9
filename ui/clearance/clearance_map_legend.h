#pragma once

#include <QSizeF>
#include <QString>
#include <optional>

#include "ui/common/display_units.h"

class QPainter;

namespace ui {

/// What the colours of a distance map mean.
struct ClearanceMapLegend {
    QString title;
    double reach = 0.0;  ///< nm at the end of the ramp
    LengthUnit unit = LengthUnit::Millimetre;
    std::optional<double> mark;  ///< the value at the cursor, nm

    /// The numbers beside the ramp: 0 to the end in round steps, the end itself included.
    [[nodiscard]] std::vector<double> numbers() const;
    /// In the lower right corner of a canvas; not at all where it would cover most of that.
    void paint(QPainter& painter, QSizeF canvas) const;
};

}  // namespace ui
