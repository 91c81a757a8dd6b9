#pragma once

#include <sys/mman.h>

#include <cstddef>
#include <cstdlib>
#include <memory>
#include <new>
#include <type_traits>

namespace tri {

/// An array of plain values that is never initialised and keeps its memory from one use to the next: filling it with
/// zeros, and the page faults of a fresh one, would cost as much as triangulating.
template <class T>
class Scratch {
    static_assert(std::is_trivially_copyable_v<T> && std::is_trivially_destructible_v<T>);

public:
    /// Room for `count` values; what was in it before is lost if it has to grow.
    T* room(std::size_t count) {
        if (count > m_capacity) {
            m_memory.reset();
            m_memory.reset(static_cast<T*>(allocate(count * sizeof(T))));
            if (m_memory == nullptr) {
                m_capacity = 0;
                throw std::bad_alloc();
            }
            m_capacity = count;
        }
        return m_memory.get();
    }
    [[nodiscard]] std::size_t bytes() const { return m_capacity * sizeof(T); }

    T* data() { return m_memory.get(); }
    T& operator[](std::size_t i) { return m_memory.get()[i]; }
    const T& operator[](std::size_t i) const { return m_memory.get()[i]; }

private:
    /// In large pages, if the system gives them: insertion goes all over the mesh, and a page fault and an address
    /// lookup for every 4 kB would cost 7 % of the time.
    static void* allocate(std::size_t bytes) {
        constexpr std::size_t kLargePage = std::size_t{2} << 20;
        if (bytes < 2 * kLargePage) {
            return std::malloc(bytes);
        }
        void* memory = nullptr;
        if (posix_memalign(&memory, kLargePage, bytes) != 0) {
            return nullptr;
        }
        madvise(memory, bytes, MADV_HUGEPAGE);  // a wish: nothing is lost if it is not granted
        return memory;
    }

    struct Free {
        void operator()(T* memory) const { std::free(memory); }
    };
    std::unique_ptr<T, Free> m_memory;
    std::size_t m_capacity = 0;
};

}  // namespace tri
