#pragma once

#include <QFont>
#include <QRectF>
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
    /// In the lower right corner of a canvas; empty where it would cover most of that.
    [[nodiscard]] QRectF place(const QFont& font, QSizeF canvas) const;
    /// There, or not at all.
    void paint(QPainter& painter, QSizeF canvas) const;
};

}  // namespace ui
