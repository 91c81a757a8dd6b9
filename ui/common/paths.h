#pragma once

#include <QDir>
#include <QFile>
#include <QFileInfo>
#include <QString>
#include <filesystem>

/// Paths between Qt and the core, byte by byte: a file name need not be valid text.
namespace ui {

[[nodiscard]] inline std::filesystem::path toPath(const QString& path) {
    return QFile::encodeName(path).toStdString();
}

[[nodiscard]] inline QString fromPath(const std::filesystem::path& path) {
    return QFile::decodeName(path.c_str());
}

/// The name of the file or folder itself, also for "board/" and ".".
[[nodiscard]] inline QString displayName(const std::filesystem::path& path) {
    return QFileInfo(QDir::cleanPath(QFileInfo(fromPath(path)).absoluteFilePath())).fileName();
}

}  // namespace ui
