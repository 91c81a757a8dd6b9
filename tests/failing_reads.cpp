#include "tests/failing_reads.h"

#include <dlfcn.h>
#include <sys/stat.h>
#include <unistd.h>

#include <atomic>
#include <cerrno>

namespace {

std::atomic<bool> g_isCounting{false};
std::atomic<std::size_t> g_reads{0};
std::atomic<std::size_t> g_failsFrom{0};  // counted like g_reads; 0: none fails
std::atomic<bool> g_isLasting{false};

bool isOfRegularFile(int file) {
    struct stat status {};
    return ::fstat(file, &status) == 0 && S_ISREG(status.st_mode);
}

bool mustFail(int file) {
    if (!g_isCounting || !isOfRegularFile(file)) {
        return false;
    }
    const std::size_t number = ++g_reads;
    const std::size_t from = g_failsFrom;
    return from != 0 && (number == from || (g_isLasting && number > from));
}

}  // namespace

// Takes the place of the C library's for all of the program.
extern "C" ssize_t read(int file, void* bytes, std::size_t count) {
    using Read = ssize_t (*)(int, void*, std::size_t);
    static const Read original = reinterpret_cast<Read>(::dlsym(RTLD_NEXT, "read"));
    if (mustFail(file)) {
        errno = EIO;
        return -1;
    }
    return original(file, bytes, count);
}

FailingReads::FailingReads(std::size_t nth, bool isLasting) {
    g_reads = 0;
    g_isLasting = isLasting;
    g_failsFrom = nth;
    g_isCounting = true;
}

FailingReads::~FailingReads() {
    g_isCounting = false;
    g_failsFrom = 0;
}

std::size_t FailingReads::reads() const {
    return g_reads;
}
