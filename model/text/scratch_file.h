#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "model/base/progress.h"
#include "model/base/result.h"
#include "model/text/file_writer.h"

namespace model {

/// Bytes of a file that is being written, kept until what stands before them in it is known: a few in memory, more in a
/// file without a name, which is gone when this is, however the program ends.
class ScratchFile {
public:
    /// The file is made once one is needed. Failures are kept: see status().
    explicit ScratchFile(ScratchPlace place) : m_place(std::move(place)) {}
    ~ScratchFile();
    ScratchFile(const ScratchFile&) = delete;
    ScratchFile& operator=(const ScratchFile&) = delete;

    /// Pieces may be small, they are gathered. After a failure nothing happens any more.
    void write(std::string_view bytes);
    [[nodiscard]] std::uint64_t size() const { return m_size; }
    /// The first failure: OutputFailed with ScratchPlace::named and the reason.
    [[nodiscard]] base::Status status() const;

    /// All of it at once, mapped rather than read; nothing is written after that. Empty after a failure.
    [[nodiscard]] std::string_view bytes();
    /// Writes all of it to `file`, unless that is cancelled, and gives its room back: once, at the end. Failures of
    /// `file` stay there.
    void moveTo(FileWriter& file, const base::Progress& progress);

private:
    void fail();
    void flush();
    void open();
    void close();

    ScratchPlace m_place;
    std::string m_pending;
    std::string m_failure;
    std::string_view m_mapped;
    std::uint64_t m_size = 0;
    int m_file = -1;  ///< none as long as all is pending
};

}  // namespace model
