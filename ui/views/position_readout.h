#pragma once

#include <QObject>
#include <functional>
#include <optional>

#include "ui/views/probing.h"

namespace ui {

/// Where the pointer is, or what a tool has snapped to there, for the status line: from the job's datum, and how far
/// from where a measurement has begun.
class PositionReadout : public QObject {
    Q_OBJECT

public:
    PositionReadout(Probing& probing, Workspace& workspace, QObject* parent = nullptr);

    /// What is to be known of the location besides; empty where there is nothing.
    void setNote(std::function<QString(base::PointD)> note) { m_note = std::move(note); }
    /// In nm of the board; none: no measurement is under way.
    void measureFrom(std::optional<base::PointD> location);
    /// What a click would take, in place of where the pointer is; none: no tool takes anything.
    void snapTo(std::optional<base::PointD> location);

signals:
    /// Empty while the pointer is beside the board.
    void changed(const QString& text);

private:
    void update();

    Workspace& m_workspace;
    std::function<QString(base::PointD)> m_note;
    std::optional<base::PointD> m_pointer;  ///< nm, of the board
    std::optional<base::PointD> m_from;
    std::optional<base::PointD> m_snapped;
};

}  // namespace ui
