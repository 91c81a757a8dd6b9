#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>
#include <string_view>

#include "model/base/result.h"

namespace model {

class GzipStream;

/// Where a ScratchFile keeps what has to wait for its place in a file.
struct ScratchPlace {
    std::filesystem::path folder;
    std::filesystem::path named;  ///< what messages say cannot be written
};

/// Writes a file piece by piece, all of it or nothing: the pieces go into a file beside it, which commit() gives its
/// name. What had the name before stays until then, and for good when anything fails or nobody commits; nothing else is
/// left in the folder. A link stays one, and the file it names is replaced. What is no plain file, as a pipe or a
/// device, is written to as it is.
class FileWriter {
public:
    enum class Packing : std::uint8_t { None, Gzip };

    /// Opens the file beside `path`. Failures are kept: see status().
    explicit FileWriter(const std::filesystem::path& path, Packing packing = Packing::None);
    /// Removes what was not committed.
    ~FileWriter();
    FileWriter(const FileWriter&) = delete;
    FileWriter& operator=(const FileWriter&) = delete;

    /// False after a failure, so that long work can end early; who ignores it learns of it from commit(). Pieces may be
    /// small, they are gathered; large ones go to the file at once.
    bool write(std::string_view bytes);
    /// What was written so far, in bytes before packing: the position of what comes next.
    [[nodiscard]] std::uint64_t size() const { return m_size; }
    /// What of it is in the file: all of it after commit().
    [[nodiscard]] std::uint64_t packedSize() const { return m_packedSize; }
    /// Beside it, and failures are said of it; of what is no plain file both are the folder of temporary files.
    [[nodiscard]] ScratchPlace scratchPlace() const;
    /// The first failure: OutputFailed with the path and the reason.
    [[nodiscard]] base::Status status() const;
    /// All of it is on the disk, and only its name is missing: for files of which all or none are to change. Nothing is
    /// written after it. Errors: as status().
    base::Status finish();
    /// Once, at the end: the file is whole on the disk and has its name. Errors: as status().
    base::Status commit();

private:
    void fail(const std::string& why);
    void flush();
    void pack(std::string_view bytes);
    void pass(std::string_view bytes);
    void close();

    std::filesystem::path m_path;    ///< what is replaced: behind a link
    std::filesystem::path m_beside;  ///< what is written; m_path where that is no plain file
    std::string m_pending;
    std::string m_failure;
    std::unique_ptr<GzipStream> m_gzip;  ///< none: bytes go to the file as they are
    std::uint64_t m_size = 0;
    std::uint64_t m_packedSize = 0;
    int m_file = -1;
    bool m_isPlain = true;
    bool m_isFinished = false;
    bool m_isNamed = false;  ///< the file has its name
};

}  // namespace model
