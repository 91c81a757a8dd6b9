#pragma once

#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "model/base/result.h"
#include "model/board/diagnostics.h"
#include "model/formats/gerber/naming/file_role.h"

namespace model::gerber {

/// What files of a Gerber job draw, as somebody says: it counts more than anything the files, names or job file say.
///
/// Its file is text, a line per file of the job; lines that begin with # are comments:
///
///     top.art = copper top
///     "# 2.art" = copper 2
///     gnd.art = copper 3 negative
///     masks/top.art = solder-mask top
///     thru.tap = drill plated
///     buried.tap = drill plated 2-3
///     fab.art = ignore
///
/// Left of the last = stands the file's name, or its path inside the job; in any case, in quotes if it begins with # or
/// a quote, or ends in a blank. A path counts more than a name, which means the files of that name in all folders.
/// Words on the right: roleOfWords().
class LayerMap {
public:
    struct Row {
        std::string file;
        FileRole role;           ///< its source is Told
        std::uint32_t line = 0;  ///< of the map's file; 0 if it was made otherwise
    };

    /// Sets what a file draws, over what was set for it before.
    void set(std::string file, FileRole role, std::uint32_t line = 0);
    [[nodiscard]] std::span<const Row> rows() const { return m_rows; }
    [[nodiscard]] bool isEmpty() const { return m_rows.empty(); }
    /// What it says of a file of the job, by its path inside the job; none if it says nothing.
    [[nodiscard]] const Row* find(std::string_view path) const;

private:
    std::vector<Row> m_rows;  ///< each file once
};

/// Words that say what a file draws, in any order and case: one of copper, solder-mask, paste, silkscreen, outline,
/// drill, rout, components, glue, document or ignore; top, bottom or inner; the number of a copper layer, 1 is the top;
/// of drills the first and last copper layer that they pass ("1-4"), plated or non-plated; of copper negative. Nothing
/// if a word is none of these or the kind is missing.
[[nodiscard]] std::optional<FileRole> roleOfWords(std::string_view words);
/// The same words for a role; "document" if it is not known.
[[nodiscard]] std::string wordsOf(const FileRole& role);

/// Understands a map's file. What cannot be understood is reported with its line, under `path`.
[[nodiscard]] LayerMap parseLayerMap(std::string_view text, std::string_view path, Diagnostics& diagnostics);
/// The text that parseLayerMap() understands as this map.
[[nodiscard]] std::string layerMapText(const LayerMap& map);
/// A row of that text, with the end of the line.
[[nodiscard]] std::string layerMapRow(const LayerMap::Row& row);
/// Errors: BadInput when the file cannot be read or holds no row that can be understood.
[[nodiscard]] base::Result<LayerMap> readLayerMap(const std::filesystem::path& path, Diagnostics& diagnostics);
/// Errors: OutputFailed.
[[nodiscard]] base::Status writeLayerMap(const std::filesystem::path& path, const LayerMap& map);

/// The map that is used without being asked for, if it is there: "<file or folder of the job>.layers.txt", beside it.
[[nodiscard]] std::filesystem::path layerMapBeside(const std::filesystem::path& job);

}  // namespace model::gerber
