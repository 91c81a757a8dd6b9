#include "tests/counted_memory.h"

#include <dlfcn.h>
#include <execinfo.h>
#include <malloc.h>

#include <array>
#include <atomic>
#include <cstdlib>
#include <new>
#include <string_view>

namespace {

std::atomic<std::size_t> g_allocations{0};
std::atomic<std::size_t> g_live{0};
std::atomic<std::size_t> g_peak{0};
std::atomic<std::size_t> g_refusedFrom{0};  // counted like g_allocations; 0: nothing is refused
std::atomic<bool> g_isLasting{false};
std::atomic<bool> g_hasRefused{false};

bool isCalledByPolyclipping() {
    std::array<void*, 64> frames{};
    const int count = backtrace(frames.data(), static_cast<int>(frames.size()));
    for (int i = 0; i < count; ++i) {
        Dl_info info{};
        if (dladdr(frames[static_cast<std::size_t>(i)], &info) != 0 && info.dli_fname != nullptr &&
            std::string_view(info.dli_fname).find("libpolyclipping") != std::string_view::npos) {
            return true;
        }
    }
    return false;
}

bool isRefused(std::size_t allocation) {
    const std::size_t from = g_refusedFrom;
    const bool isMeant = from != 0 && (allocation == from || (g_isLasting && allocation > from));
    return isMeant && !isCalledByPolyclipping();
}

void* take(std::size_t size) {
    const bool isOutOfMemory = isRefused(++g_allocations);
    void* memory = isOutOfMemory ? nullptr : std::malloc(size);
    if (memory == nullptr) {
        g_hasRefused = g_hasRefused || isOutOfMemory;
        throw std::bad_alloc();
    }
    const std::size_t live = g_live += malloc_usable_size(memory);
    std::size_t peak = g_peak;
    while (live > peak && !g_peak.compare_exchange_weak(peak, live)) {
    }
    return memory;
}

void giveBack(void* memory) {
    g_live -= memory != nullptr ? malloc_usable_size(memory) : 0;
    std::free(memory);
}

}  // namespace

namespace counted {

Memory memory() {
    return {g_allocations, g_live, g_peak};
}

void resetPeak() {
    g_peak = g_live.load();
}

Refusal::Refusal(std::size_t nth, bool isLasting) {
    g_hasRefused = false;
    g_isLasting = isLasting;
    g_refusedFrom = g_allocations + nth;
}

Refusal::~Refusal() {
    g_refusedFrom = 0;
}

bool Refusal::hasRefused() const {
    return g_hasRefused;
}

}  // namespace counted

void* operator new(std::size_t size) {
    return take(size);
}
void* operator new[](std::size_t size) {
    return take(size);
}
void operator delete(void* memory) noexcept {
    giveBack(memory);
}
void operator delete[](void* memory) noexcept {
    giveBack(memory);
}
void operator delete(void* memory, std::size_t) noexcept {
    giveBack(memory);
}
void operator delete[](void* memory, std::size_t) noexcept {
    giveBack(memory);
}
