#pragma once

#include <QObject>
#include <memory>

#include "model/session/session.h"

namespace ui {

class Workspace;

/// What this window knows of the session file of its board, whichever part of it was read or saved last: so that a save
/// of one part also tells what others did to the rest. One per workspace.
class SessionNews : public QObject {
    Q_OBJECT

public:
    static SessionNews& of(Workspace& workspace);

    /// To be called after every save that went well: what others did to the part that was saved, named as in "The
    /// views", and to the other parts of the file since this window heard of them. Empty for nothing.
    [[nodiscard]] QString afterSave(const model::session::KnownPart& saved, const QString& name);

private:
    explicit SessionNews(Workspace& workspace);

    std::shared_ptr<const model::session::FileContent> m_file;  ///< null: there was none
};

}  // namespace ui
