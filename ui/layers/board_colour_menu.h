#pragma once

#include <QMenu>

#include "ui/layers/layer_model.h"
#include "ui/workspace/session_part.h"

namespace ui {

/// The menu of what a fabricator lets one choose: the colours of solder mask and silkscreen and the surface finish. The
/// first entry of each is what the job says, or the common one. A choice is undone like every other edit, drawn by the
/// 3D view, and kept in the session file beside the job.
class BoardColourMenu : public QMenu {
    Q_OBJECT

public:
    BoardColourMenu(LayerModel& layers, Workspace& workspace, QWidget* parent);

private:
    void fill();
    template <class Value>
    void add(const QString& title, const std::vector<std::string>& names,
             std::optional<Value> model::BoardColourChoice::*part, Value unchosen);
    void choose(const model::BoardColourChoice& chosen);

    LayerModel& m_layers;
    SessionPart<model::BoardColourChoice> m_part;
};

}  // namespace ui
