#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "model/base/progress.h"
#include "model/base/result.h"
#include "model/base/stopwatch.h"
#include "model/board/document.h"
#include "model/formats/common/archive.h"
#include "model/formats/common/form_part.h"
#include "model/formats/common/read_options.h"

/// The one place that knows the formats: another one is a folder below model/formats and a row in registry.cpp.
/// Dialogs, help and error texts follow from the rows.
namespace model {

using formats::ReadOptions;

/// What lies at a path, found out once and without knowing any format.
struct BoardInput {
    std::filesystem::path path;
    std::string head;                         ///< first bytes of a file; empty for a folder
    std::optional<formats::Archive> archive;  ///< of a folder or an archive, once it is unpacked
    Diagnostics unpacking;
    base::Stopwatch reading;  ///< since the path was opened
    formats::ArchiveLimits limits{};
};

struct BoardFormat {
    std::string_view name;                     ///< "ODB++ job"
    std::vector<std::string_view> extensions;  ///< ".tgz"; only hints: what a file is follows from its bytes
    std::string_view part;                     ///< what folders and archives of it hold, "an ODB++ matrix"; empty: none
    bool (*probe)(const BoardInput& input);    ///< is the file one of its boards, by its first bytes? Null: no file is
    base::Result<std::shared_ptr<const Document>> (*read)(const BoardInput& input, const ReadOptions& options,
                                                          base::Progress& progress);
    std::string_view key{};  ///< for the command line and reports: "odb"; one word, each its own
    /// Its boards in a folder or archive; null: it is in files alone.
    std::vector<formats::FormPart> (*parts)(const formats::Archive& archive) = nullptr;
    bool isDesign = false;  ///< what is edited: it has rules, and exports beside it may be older
};

/// A board in one of the forms that lie in a folder or archive, as it can be opened by itself.
struct BoardForm {
    const BoardFormat* format = nullptr;  ///< of knownFormats()
    std::filesystem::path path;           ///< the folder or archive itself, or a file in the folder
    std::string member{};                 ///< the file or archive inside an archive; empty: all of it
    std::string contents{};               ///< for people, in a few words
    bool isEmpty = false;                 ///< formats::FormPart::isEmpty
};

/// A board and what it was read from.
struct ReadBoard {
    std::shared_ptr<const Document> document;
    const BoardFormat* format = nullptr;  ///< of knownFormats()
    /// All that lie there where there are several: the one that was read, or that is proposed, first.
    std::vector<BoardForm> forms{};
};

/// Those that say more of a board come first. Of several forms in one folder or archive the first is read, designs
/// before exports.
[[nodiscard]] std::span<const BoardFormat> knownFormats();
[[nodiscard]] std::vector<std::string> formatKeys();
/// Their extensions as file dialogs want them: "*.tgz *.txt".
[[nodiscard]] std::string namePatterns(std::span<const BoardFormat> formats = knownFormats());
/// For help and error texts: "ODB++ job (folder, .tgz), …".
[[nodiscard]] std::string describeFormats();
/// Is the path named like a board, or is it a folder?
[[nodiscard]] bool isNamedLikeBoard(const std::filesystem::path& path);

/// Opens a board of any known format, whatever its name. Folders and archives may hold it in several: the format that
/// the options name is read, or else the richest, and the others are named in its messages; options that only ask leave
/// `document` null where there are several. Errors: BadUsage for formats
/// that are not known; BadInput with the reason in plain words when the input
/// is missing, is no board (then with what it is, and what can be read) or cannot be unpacked; Cancelled. A bad record
/// inside a readable job is no error: it is listed in Document::diagnostics.
[[nodiscard]] base::Result<ReadBoard> readAnyBoard(const std::filesystem::path& path, const ReadOptions& options,
                                                   base::Progress& progress);
/// The same without what it was read from.
[[nodiscard]] base::Result<std::shared_ptr<const Document>> readBoard(const std::filesystem::path& path,
                                                                      const ReadOptions& options,
                                                                      base::Progress& progress);

/// Which format would be read, found out without reading the board. Errors: those of readAnyBoard before it reads one.
[[nodiscard]] base::Result<const BoardFormat*> formatAt(const std::filesystem::path& path, const ReadOptions& options,
                                                        base::Progress& progress);

}  // namespace model
