#pragma once

#include <QObject>
#include <vector>

#include "model/clearance/waivers.h"
#include "ui/workspace/session_part.h"
#include "ui/workspace/settings.h"

class QWidget;

namespace ui {

/// The waivers of the open board: part of its session, and files to keep them beside the sources of a board. Every edit
/// is a step of the history.
class RuleWaivers : public QObject {
    Q_OBJECT

public:
    using List = std::vector<model::Waiver>;

    RuleWaivers(Workspace& workspace, Settings& settings, QObject* parent = nullptr);

    /// Takes those of the board's session.
    void open(const LoadedBoard& board);
    [[nodiscard]] const List& list() const { return m_list; }

    /// Opens a dialog for reason and author of a waiver that has all the rest; what is accepted counts.
    void request(const model::Waiver& waiver, QWidget& parent);
    void add(const model::Waiver& waiver);
    /// Those that are still there: who withdraws may have seen them in an earlier list.
    void withdraw(const List& waivers);
    /// Instead of those that are there. Errors: BadInput.
    [[nodiscard]] base::Status read(const QString& path);

signals:
    void changed();

private:
    Workspace& m_workspace;
    Settings& m_settings;
    List m_list;
    SessionPart<List> m_part;
};

}  // namespace ui
