#include "model/text/file_writer.h"

#include <fcntl.h>
#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <cstring>
#include <system_error>

#include "model/text/gzip_stream.h"
#include "model/text/write_all.h"

namespace model {

namespace fs = std::filesystem;

namespace {

constexpr std::size_t kGathered = std::size_t{1} << 18U;

/// Two writers of one program never share it.
std::string endingOfPart() {
    static std::atomic<unsigned> count{0};
    return ".part" + std::to_string(::getpid()) + '-' + std::to_string(count++);
}

}  // namespace

FileWriter::FileWriter(const fs::path& named, Packing packing)
    : m_gzip(packing == Packing::Gzip ? std::make_unique<GzipStream>() : nullptr) {
    std::error_code error;
    const fs::path linked = fs::is_symlink(named, error) ? fs::weakly_canonical(named, error) : named;
    m_path = error ? named : linked;
    m_isPlain = !fs::exists(m_path, error) || fs::is_regular_file(m_path, error);
    m_beside = m_isPlain ? fs::path(m_path.string() + endingOfPart()) : m_path;
    m_file = ::open(m_beside.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0666);
    if (m_file < 0) {
        fail(std::strerror(errno));
    }
}

FileWriter::~FileWriter() {
    close();
    if (m_isPlain && !m_isNamed) {
        ::unlink(m_beside.c_str());
    }
}

bool FileWriter::write(std::string_view bytes) {
    m_size += bytes.size();
    if (bytes.size() >= kGathered) {
        flush();
        pack(bytes);
        return m_failure.empty();
    }
    m_pending += bytes;
    if (m_pending.size() >= kGathered) {
        flush();
    }
    return m_failure.empty();
}

ScratchPlace FileWriter::scratchPlace() const {
    if (!m_isPlain) {
        std::error_code error;
        const fs::path folder = fs::temp_directory_path(error);
        return {folder, folder};
    }
    return {m_path.has_parent_path() ? m_path.parent_path() : fs::path("."), m_path};
}

base::Status FileWriter::status() const {
    return m_failure.empty()
               ? base::Status(base::Done{})
               : base::Error{base::ErrorCode::OutputFailed, m_path.string() + " cannot be written: " + m_failure};
}

base::Status FileWriter::finish() {
    if (m_isFinished) {
        return status();
    }
    m_isFinished = true;
    flush();
    if (m_gzip) {
        std::string end;
        m_gzip->finish(end);
        pass(end);
    }
    if (m_failure.empty() && m_isPlain && ::fsync(m_file) != 0) {
        fail(std::strerror(errno));
    }
    close();
    return status();
}

base::Status FileWriter::commit() {
    const base::Status finished = finish();
    if (finished && m_isPlain) {
        std::error_code error;
        fs::rename(m_beside, m_path, error);
        m_isNamed = !error;
        if (error) {
            fail(error.message());
        }
    }
    return status();
}

void FileWriter::fail(const std::string& why) {
    if (m_failure.empty()) {
        m_failure = why;
    }
}

void FileWriter::flush() {
    pack(m_pending);
    m_pending.clear();
}

void FileWriter::pack(std::string_view bytes) {
    if (m_gzip) {
        std::string packed;
        m_gzip->add(bytes, packed);
        pass(packed);
    } else {
        pass(bytes);
    }
}

void FileWriter::pass(std::string_view bytes) {
    m_packedSize += bytes.size();
    if (m_failure.empty() && !writeAll(m_file, bytes)) {
        fail(std::strerror(errno));
    }
}

void FileWriter::close() {
    if (m_file >= 0 && ::close(m_file) != 0) {
        fail(std::strerror(errno));
    }
    m_file = -1;
}

}  // namespace model
