#pragma once

#include <QObject>
#include <functional>
#include <optional>
#include <utility>

#include "ui/shell/status_line.h"
#include "ui/views/probing.h"

namespace ui {

/// Where the cursor is, in the status line: from the job's datum, and how far from where a measurement has begun.
class PositionReadout : public QObject {
    Q_OBJECT

public:
    PositionReadout(Probing& probing, StatusLine& line, QObject* parent = nullptr);

    void setUnit(LengthUnit unit);
    /// What is said of the place besides; empty where there is nothing to say.
    void setNote(std::function<QString(base::PointD)> note) { m_note = std::move(note); }
    /// In nm of the board; none: no measurement is under way.
    void measureFrom(std::optional<base::PointD> location);

private:
    void show();

    StatusLine& m_line;
    std::function<QString(base::PointD)> m_note;
    LengthUnit m_unit = LengthUnit::Millimetre;
    std::optional<base::PointD> m_cursor;  ///< nm, of the board
    std::optional<base::PointD> m_from;
};

}  // namespace ui
