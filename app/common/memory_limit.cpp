#include "app/common/memory_limit.h"

#include <sys/resource.h>
#include <unistd.h>

#include <cstdio>
#include <cstdlib>
#include <exception>
#include <fstream>
#include <new>
#include <sstream>
#include <string>
#include <system_error>
#include <thread>

#include "app/common/exit_code.h"
#include "model/base/limits.h"

namespace app {

namespace {

#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
constexpr bool kIsSanitized = true;
#else
constexpr bool kIsSanitized = false;
#endif

constexpr std::uint64_t kDeviceBytes = 256 * base::kMiB;
constexpr std::uint64_t kDeviceBytesPerCore = 16 * base::kMiB;  // stacks of its threads, 8 MiB each, in two pools

/// What counts against the limit so far: VmData of proc(5), in bytes; 0 where the system does not tell.
std::uint64_t bytesTaken() {
    std::ifstream file("/proc/self/status");
    for (std::string line; std::getline(file, line);) {
        if (line.starts_with("VmData:")) {
            std::uint64_t kib = 0;
            std::istringstream(line.substr(7)) >> kib;
            return kib * 1024;
        }
    }
    return 0;
}

std::string mib(std::uint64_t bytes) {
    return std::to_string(bytes / base::kMiB) + " MiB";
}

std::uint64_t limitInForce() {
    rlimit limit{};
    const bool isSet = getrlimit(RLIMIT_DATA, &limit) == 0 && limit.rlim_cur != RLIM_INFINITY;
    return isSet ? limit.rlim_cur : 0;
}

[[noreturn]] void endProcess() {
    try {
        if (const std::exception_ptr current = std::current_exception()) {
            std::rethrow_exception(current);
        }
    } catch (const std::bad_alloc&) {
        std::_Exit(failOutOfMemory());
    } catch (const std::system_error& error) {  // a thread that found no room for its stack
        if (error.code() == std::errc::resource_unavailable_try_again) {
            std::_Exit(failOutOfMemory());
        }
    } catch (...) {
    }
    std::abort();
}

}  // namespace

void limitMemory(std::uint64_t bytes) {
    rlimit limit{};
    if (kIsSanitized || bytes == 0 || getrlimit(RLIMIT_DATA, &limit) != 0) {
        return;
    }
    limit.rlim_cur = limit.rlim_max == RLIM_INFINITY || bytes < limit.rlim_max ? bytes : limit.rlim_max;
    static_cast<void>(setrlimit(RLIMIT_DATA, &limit));
}

std::uint64_t machineMemory() {
    const long pages = sysconf(_SC_PHYS_PAGES);
    const long size = sysconf(_SC_PAGESIZE);
    return pages > 0 && size > 0 ? static_cast<std::uint64_t>(pages) * static_cast<std::uint64_t>(size) : 0;
}

bool isMemoryLimited() {
    const std::uint64_t limit = limitInForce();
    return limit != 0 && limit < machineMemory();
}

base::Status checkRoomForDevice() {
    const std::uint64_t limit = limitInForce();
    const std::uint64_t taken = bytesTaken();
    const std::uint64_t left = limit > taken ? limit - taken : 0;
    const std::uint64_t needed = kDeviceBytes + std::thread::hardware_concurrency() * kDeviceBytesPerCore;
    if (limit == 0 || left >= needed) {
        return base::Done{};
    }
    return base::Error{base::ErrorCode::DeviceFailed, "out of memory: a Vulkan device may take " + mib(needed) +
                                                          ", and " + mib(left) + " are left of the " + mib(limit) +
                                                          " that --max-memory sets"};
}

int failOutOfMemory() {
    const std::uint64_t limit = limitInForce();
    if (limit == 0) {
        std::fputs("copperscope: out of memory\n", stderr);
    } else {
        std::fprintf(stderr,
                     "copperscope: out of memory: this takes more than %.0f MiB, the limit that --max-memory sets\n",
                     static_cast<double>(limit) / static_cast<double>(base::kMiB));
    }
    return kFailed;
}

void endWhereMemoryRunsOut() {
    std::set_terminate(endProcess);
}

}  // namespace app
