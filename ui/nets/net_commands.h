#pragma once

#include <QObject>

#include "ui/nets/net_styles.h"
#include "ui/workspace/actions.h"
#include "ui/workspace/selection_model.h"

namespace ui {

class NetsPanel;

/// What the commands of the menu Nets do. They are for the highlighted nets, or else for the net of what is under the
/// cursor, or else of what is selected.
class NetCommands : public QObject {
    Q_OBJECT

public:
    NetCommands(const ActionSet& actions, SelectionModel& selection, NetStyles& styles, NetsPanel& panel,
                QObject* parent = nullptr);

    /// Lights the net of what is pointed at or selected up, or ends that.
    void highlightNet();

signals:
    /// There is no net to do it to.
    void missed(const QString& what);

private:
    [[nodiscard]] std::vector<model::BoardNet> targets();
    void colour();
    void hide();

    SelectionModel& m_selection;
    NetStyles& m_styles;
};

}  // namespace ui
