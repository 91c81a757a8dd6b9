#pragma once

#include "ui/workspace/session_part.h"

namespace ui {

/// The thicknesses that the user sets: edits that are undone like every other, worked into the open board and kept in
/// its session.
class ThicknessEditing : public QObject {
    Q_OBJECT

public:
    explicit ThicknessEditing(Workspace& workspace, QObject* parent = nullptr);

    /// One step of the history, however many rows. A thickness of 0 takes a row back to what the job says.
    void edit(const std::vector<model::ThicknessOverride>& changes);

private:
    void show(const model::SetThicknesses& state);

    Workspace& m_workspace;
    SessionPart<model::SetThicknesses, std::vector<model::ThicknessOverride>> m_part;
};

}  // namespace ui
