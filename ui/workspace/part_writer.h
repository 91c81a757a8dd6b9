#pragma once

#include <QString>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>

#include "model/board/document.h"
#include "model/session/session.h"

namespace ui {

class Workspace;

/// Writes one part of the session of the open board, on the thread for files, and says what others wrote into the file
/// meanwhile (SessionNews). Lives as long as the workspace.
class PartWriter {
public:
    /// One of model::session's functions with what it saves; runs on the thread.
    using Save = std::function<base::Status(const std::filesystem::path& board, const model::Document&,
                                            model::session::KnownPart*)>;
    /// `isLast`: the part was not to be written again since, and the board is still the open one.
    using Ended = std::function<void(const base::Status&, bool isLast)>;

    /// `name` as in "The views".
    PartWriter(Workspace& workspace, QString name);

    /// The part is as the file of the open board holds it.
    void begin();
    /// `ended` hears what came of it, unless it was not begun before the part was to be written again.
    void write(Save save, Ended ended);
    [[nodiscard]] const QString& name() const { return m_name; }

private:
    Workspace& m_workspace;
    QString m_name;
    std::shared_ptr<model::session::KnownPart> m_known;  ///< the thread's while something is being written
    std::uint64_t m_count = 0;                           ///< of what was to be written
};

}  // namespace ui
