#pragma once

#include <QDialog>
#include <QMainWindow>
#include <functional>
#include <map>
#include <utility>
#include <vector>

#include "ui/workspace/actions.h"
#include "ui/workspace/settings.h"
#include "ui/workspace/workspace.h"

namespace ui {

class BoardViews;
class GpuContext;
class LayerModel;
class NetStyles;
class PartPicking;
class PlanPainter;
class PositionReadout;
class Probing;

struct DockSpec {
    ActionId toggle;
    const char* name;  ///< QMainWindow::saveState finds it by this
    QString title;
    Qt::DockWidgetArea area;  ///< where it opens, unless the use of the window has another place for it
};

/// What Esc ends before what: of one rank in the order of the features.
enum class EscapeRank {
    Tool,  ///< what clicks are for, a step or all of it
    Mark,  ///< of a location that was found
    Alone  ///< a layer that is shown alone
};

/// What the features of a window share. A feature (layers, clearances, …) is made once by its row in
/// ui/shell/features.cpp; it connects its actions, adds its panel and listens to the workspace. What it makes are
/// children of the window.
struct FeatureContext {
    QMainWindow& window;
    GpuContext& device;
    Workspace& workspace;
    ActionSet& actions;
    Settings& settings;
    LayerModel& layers;
    NetStyles& netStyles;
    PartPicking& parts;
    BoardViews& views;
    Probing& probing;
    PlanPainter& plan;
    PositionReadout& position;

    /// What Esc ends once no work is left to stop: the first that returns true was it.
    std::multimap<EscapeRank, std::function<bool()>> escapes{};
    /// Put what the settings hold into effect, at the start and when they are reset.
    std::vector<std::function<void()>> restorers{};

    /// `slot` is done when the user triggers the action, as long as `receiver` lives.
    template <class Receiver, class Slot>
    void on(ActionId id, Receiver* receiver, Slot slot) const {
        QObject::connect(&actions[id], &QAction::triggered, receiver, std::move(slot));
    }
    template <class Slot>
    void on(ActionId id, Slot slot) const {
        on(id, &window, std::move(slot));
    }
    /// Actions of which one is checked; which one is kept in the settings.
    template <class Value, class Apply>
    void addChoice(std::vector<std::pair<ActionId, Value>> rows, Apply apply) {
        const auto choose = [this, rows, apply](Value value) {
            for (const auto& [id, own] : rows) {
                actions[id].setChecked(own == value);
            }
            settings.choose(value);
            apply(value);
        };
        for (const auto& [id, own] : rows) {
            on(id, [choose, own = own] { choose(own); });
        }
        restorers.emplace_back([this, choose] { choose(settings.choice<Value>()); });
    }

    /// What Settings::kSwitches names is kept in the settings; at first each is as it is now.
    void keepSwitches();

    /// Takes the panel over. Its action brings it to the front, and hides it when it is there. Whether it is shown at
    /// first is a matter of the use of the window (ui/shell/panel_arrangements.h).
    void addPanel(const DockSpec& spec, QWidget& panel) const;
    /// Brings the panel to the front.
    static void raise(QWidget& panel);

    /// `take` is called with the file that the user names. Proposed is `what` after the name of the board, in the
    /// folder of the last file that was named, beside the board before the first one. Filters:
    /// "Name (*.ending)"; the chosen one's ending is added where the name has none.
    void nameFile(const QString& title, const QString& what, const QStringList& filters,
                  const std::function<void(const QString&)>& take) const;
    /// The same for a file that holds what `make` says for its path, all of it or nothing: writes it, and reports what
    /// came of it.
    void saveFile(const QString& title, const QString& what, const QStringList& filters,
                  const std::function<base::Result<std::string>(const QString&)>& make) const;
    /// `open` is called with the file that the user chooses in this dialog, which begins with `folder`. Without filters
    /// a folder is chosen.
    QDialog& openFile(const QString& title, const QString& filters, const QString& folder,
                      const std::function<void(const QString&)>& open) const;
    /// The same for a board: a file of any format, or a folder. The dialog begins where the last one was chosen.
    enum class BoardPath { File, Folder };
    QDialog& openBoardPath(const QString& title, BoardPath kind, const std::function<void(const QString&)>& open) const;
};

}  // namespace ui
