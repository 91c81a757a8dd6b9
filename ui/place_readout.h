#pragma once

#include <QObject>
#include <functional>
#include <optional>
#include <utility>

#include "ui/probing.h"
#include "ui/status_line.h"

namespace ui {

/// Where the cursor is, in the status line: from the job's datum, and how far from where a measurement has begun.
class PlaceReadout : public QObject {
    Q_OBJECT

public:
    PlaceReadout(Probing& probing, StatusLine& line, QObject* parent = nullptr);

    void setUnit(models::LengthUnit unit);
    /// What is said of the place besides; empty where there is nothing to say.
    void setNote(std::function<QString(base::PointD)> note) { m_note = std::move(note); }
    /// In nm of the board; none: no measurement is under way.
    void measureFrom(std::optional<base::PointD> place);

private:
    void show();

    StatusLine& m_line;
    std::function<QString(base::PointD)> m_note;
    models::LengthUnit m_unit = models::LengthUnit::Millimetre;
    std::optional<base::PointD> m_cursor;  ///< nm, of the board
    std::optional<base::PointD> m_from;
};

}  // namespace ui
