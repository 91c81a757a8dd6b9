#pragma once

#include <QObject>
#include <vector>

#include "model/clearance/waivers.h"
#include "ui/workspace/session_part.h"
#include "ui/workspace/settings.h"

class QWidget;

namespace ui {

/// The waivers of the open board: part of its session, and files to keep them beside the sources of a board. Every edit
/// is a step of the history, however many waivers it concerns.
class RuleWaivers : public QObject {
    Q_OBJECT

public:
    using List = std::vector<model::Waiver>;

    RuleWaivers(Workspace& workspace, Settings& settings, QObject* parent = nullptr);

    /// Takes those of the board's session.
    void open(const LoadedBoard& board);
    [[nodiscard]] const List& list() const { return m_list; }

    /// Opens a dialog for reason and author of waivers that have all the rest, the same for all; what is accepted
    /// counts. Not with none.
    void request(const List& waivers, QWidget& parent);
    /// All in one step. Those of one place become the one of the worst of them, and replace what was waived there.
    void add(const List& waivers);
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
