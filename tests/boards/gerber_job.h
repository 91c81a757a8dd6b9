#pragma once

#include <QTemporaryDir>
#include <filesystem>
#include <fstream>
#include <memory>
#include <string>

#include "model/formats/common/archive.h"
#include "model/formats/registry.h"

/// A Gerber job in a folder of its own: the files of an archive, and others beside them.
class GerberJob {
public:
    /// Unpacks an archive, folders left out.
    [[nodiscard]] bool take(const std::filesystem::path& archive) {
        base::Progress progress;
        model::Diagnostics diagnostics;
        const auto files = model::formats::Archive::open(archive, {}, progress, diagnostics);
        if (!files) {
            return false;
        }
        for (const auto& [path, row] : files->rows()) {
            const auto bytes = files->bytes(row);
            if (!bytes) {
                return false;
            }
            write(std::filesystem::path(files->path(row)).filename().string(), std::string(bytes->view()));
        }
        return true;
    }
    void write(const std::string& name, const std::string& text) const {
        std::ofstream(path() / name, std::ios::binary) << text;
    }
    [[nodiscard]] std::filesystem::path path() const { return m_folder.path().toStdString(); }
    [[nodiscard]] std::shared_ptr<const model::Document> open() const {
        base::Progress progress;
        const auto board = model::readBoard(path(), {}, progress);
        return board ? *board : nullptr;
    }

private:
    QTemporaryDir m_folder;
};
