#pragma once

#include <QMenu>

#include "ui/layers/layer_model.h"
#include "ui/workspace/feature.h"
#include "ui/workspace/session_part.h"

namespace ui {

/// Sets of layers to show: those that every board has, the user's own, which are kept in the session file beside the
/// job, and those of saved views. The menu lists them all; the one that is shown is checked.
class LayerSets : public QObject {
    Q_OBJECT

public:
    using List = std::vector<model::session::LayerSet>;

    LayerSets(LayerModel& layers, Workspace& workspace, ActionSet& actions, QWidget& window);

    [[nodiscard]] QMenu& menu() { return m_menu; }
    [[nodiscard]] const List& own() const { return m_own; }
    /// Of the set whose layers are visible ("Only TOP" of a layer shown alone), or empty if none has just those.
    [[nodiscard]] QString shownName() const;
    /// Saves the visible layers; a set of that name is replaced.
    void save(const QString& name);
    void remove(const QString& name);

signals:
    /// Another set may be the one that is shown.
    void changed();

private:
    void requestName();
    void fillMenu();
    void addSet(const model::session::LayerSet& set);
    [[nodiscard]] bool isShown(const std::vector<std::string>& names) const;

    LayerModel& m_layers;
    Workspace& m_workspace;
    ActionSet& m_actions;
    QWidget& m_window;
    QMenu m_menu;
    List m_own;
    SessionPart<List> m_part;
};

}  // namespace ui
