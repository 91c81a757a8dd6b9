#pragma once

#include "ui/workspace/workspace.h"

namespace ui {

/// Makes the highlighting of nets a step of the undo history, whoever changes it: a set that took ten clicks is not
/// lost to one Esc. Nets that are stepped through one by one, as with the arrows in the table, are one step.
class HighlightHistory : public QObject {
    Q_OBJECT

public:
    explicit HighlightHistory(Workspace& workspace);

private:
    void record();
    void apply(const std::vector<model::BoardNet>& nets);

    Workspace& m_workspace;
    std::vector<model::BoardNet> m_before;
    bool m_isApplying = false;
};

}  // namespace ui
