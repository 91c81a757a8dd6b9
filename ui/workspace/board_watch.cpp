#include "ui/workspace/board_watch.h"

#include <QStringList>
#include <algorithm>
#include <utility>

#include "model/formats/board_forms.h"
#include "model/formats/common/folder_files.h"
#include "ui/common/paths.h"

namespace ui {

namespace {

namespace fs = std::filesystem;

constexpr int kQuietMs = 700;
/// Of a larger folder only so many files are watched, and the folders that they lie in.
constexpr std::size_t kMostFiles = 2000;

bool isSession(const fs::path& path) {
    return path.filename().string().find(".copperscope.json") != std::string::npos;
}

}  // namespace

BoardWatch::BoardWatch(QObject* parent) : QObject(parent) {
    m_quiet.setSingleShot(true);
    m_quiet.setInterval(kQuietMs);
    const auto wait = [this] { m_quiet.start(); };
    connect(&m_watcher, &QFileSystemWatcher::fileChanged, &m_quiet, wait);
    connect(&m_watcher, &QFileSystemWatcher::directoryChanged, &m_quiet, wait);
    connect(&m_quiet, &QTimer::timeout, this, &BoardWatch::onQuiet);
}

BoardWatch::States BoardWatch::statesOf(const fs::path& path) {
    States states;
    std::error_code error;
    const auto add = [&states](const fs::path& file) {
        std::error_code missing;
        const std::uintmax_t size = fs::file_size(file, missing);
        const fs::file_time_type time = missing ? fs::file_time_type() : fs::last_write_time(file, missing);
        if (!missing && !isSession(file)) {
            states[file] = {size, time};
        }
    };
    if (!fs::is_directory(path, error)) {
        add(path);
        std::ranges::for_each(model::filesBeside(path), add);
        return states;
    }
    base::Progress progress;
    model::Diagnostics ignored;  // reading the board reports them
    if (const auto files = model::formats::filesBelow(path, kMostFiles, progress, ignored)) {
        for (const model::formats::FolderFile& file : *files) {
            add(file.source);
        }
    }
    return states;
}

void BoardWatch::begin(const model::OpenRequest& request) {
    m_begunPath = model::sourceOf(request.path);
    m_begun = statesOf(m_begunPath);
}

void BoardWatch::watch(const model::OpenRequest& request) {
    m_path = model::sourceOf(request.path);
    m_read = m_begunPath == m_path ? std::move(m_begun) : statesOf(m_path);
    m_begun = {};
    m_last = m_read;
    watchPaths();
    m_quiet.start();  // for what changed while it was read
}

void BoardWatch::watchPaths() {
    const QStringList before = m_watcher.files() + m_watcher.directories();
    if (!before.isEmpty()) {
        m_watcher.removePaths(before);
    }
    // A file that is replaced is another one: its folder says so.
    std::error_code error;
    const bool isFolder = fs::is_directory(m_path, error);
    QStringList paths{fromPath(isFolder ? m_path : fs::absolute(m_path, error).parent_path())};
    for (const auto& [file, state] : m_read) {
        paths += fromPath(file);
        if (const QString folder = fromPath(file.parent_path()); isFolder && !paths.contains(folder)) {
            paths += folder;
        }
    }
    m_watcher.addPaths(paths);
}

void BoardWatch::onQuiet() {
    if (m_path.empty()) {
        return;
    }
    States now = statesOf(m_path);
    const bool isStill = now == m_last;
    m_last = now;
    if (!isStill) {
        m_quiet.start();
        return;
    }
    std::error_code error;
    if (now != m_read && fs::exists(m_path, error)) {
        m_read = std::move(now);
        watchPaths();
        emit changed();
    }
}

}  // namespace ui
