#include "model/text/scratch_file.h"

#include <fcntl.h>
#include <sys/mman.h>
#include <unistd.h>

#include <cerrno>
#include <cstdlib>
#include <cstring>

#include "model/text/write_all.h"

namespace model {

namespace {

constexpr std::size_t kGathered = std::size_t{1} << 18U;

}  // namespace

ScratchFile::~ScratchFile() {
    close();
}

void ScratchFile::write(std::string_view bytes) {
    m_size += bytes.size();
    m_pending += bytes;
    if (m_pending.size() >= kGathered) {
        flush();
    }
}

base::Status ScratchFile::status() const {
    return m_failure.empty() ? base::Status(base::Done{})
                             : base::Error{base::ErrorCode::OutputFailed,
                                           m_place.named.string() + " cannot be written: " + m_failure};
}

std::string_view ScratchFile::bytes() {
    if (m_file < 0 && m_failure.empty()) {
        return m_pending;
    }
    flush();
    if (m_failure.empty() && m_mapped.empty()) {
        void* mapped = ::mmap(nullptr, m_size, PROT_READ, MAP_PRIVATE, m_file, 0);
        if (mapped == MAP_FAILED) {
            fail();
        } else {
            m_mapped = {static_cast<const char*>(mapped), m_size};
        }
    }
    return m_mapped;
}

void ScratchFile::moveTo(FileWriter& file, const base::Progress& progress) {
    if (m_file >= 0) {
        flush();
        m_pending.resize(kGathered);
        off_t at = 0;
        for (ssize_t count = 1; count > 0 && file.status().ok() && !progress.isCancelled(); at += count) {
            count = ::pread(m_file, m_pending.data(), kGathered, at);
            if (count < 0) {
                fail();
            } else {
                file.write({m_pending.data(), static_cast<std::size_t>(count)});
            }
        }
    } else {
        file.write(m_pending);
    }
    close();
    m_pending = {};
}

void ScratchFile::fail() {
    if (m_failure.empty()) {
        m_failure = std::strerror(errno);
    }
}

void ScratchFile::flush() {
    if (m_file < 0 && m_failure.empty()) {
        open();
    }
    if (m_failure.empty() && !writeAll(m_file, m_pending)) {
        fail();
    }
    m_pending.clear();
}

void ScratchFile::open() {
    std::string name = (m_place.folder / "copperscope.partXXXXXX").string();
    m_file = ::mkostemp(name.data(), O_CLOEXEC);
    if (m_file < 0 || ::unlink(name.c_str()) != 0) {
        fail();
    }
}

void ScratchFile::close() {
    if (!m_mapped.empty()) {
        ::munmap(const_cast<char*>(m_mapped.data()), m_mapped.size());
        m_mapped = {};
    }
    if (m_file >= 0) {
        ::close(m_file);
        m_file = -1;
    }
}

}  // namespace model
