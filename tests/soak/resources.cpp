#include "tests/soak/resources.h"

#include <malloc.h>
#include <unistd.h>

#include <cstdio>
#include <filesystem>
#include <fstream>
#include <iterator>

namespace soak {

namespace fs = std::filesystem;

namespace {

std::size_t entriesOf(const char* folder) {
    return static_cast<std::size_t>(std::distance(fs::directory_iterator(folder), fs::directory_iterator()));
}

std::uint64_t residentBytes() {
    std::ifstream file("/proc/self/statm");
    std::uint64_t all = 0;
    std::uint64_t resident = 0;
    file >> all >> resident;
    return resident * static_cast<std::uint64_t>(::sysconf(_SC_PAGESIZE));
}

double megabytes(std::uint64_t bytes) {
    return static_cast<double>(bytes) / 1e6;
}

}  // namespace

Resources resourcesNow(const render::gpu::Device& device) {
    (void)::malloc_trim(0);  // what is kept for later is no growth
    const struct mallinfo2 heap = ::mallinfo2();
    Resources now;
    now.residentBytes = residentBytes();
    now.heapBytes = heap.uordblks + heap.hblkhd;
    now.deviceBytes = device.memoryReport().total();
    now.handles = entriesOf("/proc/self/fd") - 1;  // without the one that reads
    now.threads = threadsNow();
    return now;
}

std::size_t threadsNow() {
    return entriesOf("/proc/self/task");
}

std::string textOf(const Resources& resources) {
    char text[160];
    (void)std::snprintf(text, sizeof text, "%.1f MB resident, %.1f MB heap, %.1f MB device, %zu handles, %zu threads",
                        megabytes(resources.residentBytes), megabytes(resources.heapBytes),
                        megabytes(resources.deviceBytes), resources.handles, resources.threads);
    return text;
}

}  // namespace soak
