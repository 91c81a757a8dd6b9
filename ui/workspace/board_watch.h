#pragma once

#include <QFileSystemWatcher>
#include <QTimer>
#include <filesystem>
#include <map>
#include <vector>

#include "model/opening/open_board.h"

namespace ui {

/// Notices when the files of the board on the screen change on the disk. Programs write in pieces, and some write
/// another file and put it in the place of the old one: a change counts once the files have not changed for a while and
/// are there. What the window writes beside the board (sessions) is no change.
class BoardWatch : public QObject {
    Q_OBJECT

public:
    explicit BoardWatch(QObject* parent = nullptr);

    /// Before a board is read: what changes from now on counts.
    void begin(const model::OpenRequest& request);
    /// It is on the screen: from now on changes of its files are told. `request` as it was opened, which may be one of
    /// several forms that lie in what was to be opened.
    void watch(const model::OpenRequest& request);
    /// For how long nothing may happen before a change counts.
    void setQuietMs(int ms) { m_quiet.setInterval(ms); }

signals:
    /// Once per change.
    void changed();

private:
    struct State {
        std::uintmax_t size = 0;
        std::filesystem::file_time_type time;
        bool operator==(const State&) const = default;
    };
    using States = std::map<std::filesystem::path, State>;

    [[nodiscard]] static States statesOf(const std::filesystem::path& path);
    void watchPaths();
    void onQuiet();

    QFileSystemWatcher m_watcher;
    QTimer m_quiet;
    std::filesystem::path m_path;  ///< of the board on the screen; empty: none
    States m_read;                 ///< as they were read
    States m_last;                 ///< when they were last looked at
    std::filesystem::path m_begunPath;
    States m_begun;  ///< when reading began
};

}  // namespace ui
