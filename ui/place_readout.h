#pragma once

#include <QObject>
#include <optional>

#include "ui/plan_painter.h"
#include "ui/probing.h"
#include "ui/status_line.h"

namespace ui {

/// Where the cursor is, in the status line: from the job's datum, and how far from a place that the user has put down.
class PlaceReadout : public QObject {
    Q_OBJECT

public:
    PlaceReadout(Probing& probing, PlanPainter& plan, StatusLine& line, QObject* parent = nullptr);

    void setUnit(models::LengthUnit unit);
    /// Puts the place under the cursor down, to measure from; or takes it away. False if the cursor is on no board.
    bool measureFromCursor(bool isOn);

private:
    void show();

    PlanPainter& m_plan;
    StatusLine& m_line;
    models::LengthUnit m_unit = models::LengthUnit::Millimetre;
    std::optional<base::PointD> m_cursor;  ///< nm, of the board
    std::optional<base::PointD> m_from;
};

}  // namespace ui
