#pragma once

#include <string>
#include <utility>
#include <variant>

#include "model/base/assert.h"

namespace base {

/// Why a whole operation failed. The command line maps these to exit codes (docs/command-line.md).
enum class ErrorCode {
    Cancelled,     ///< the user asked to stop; nothing is wrong
    BadInput,      ///< the input cannot be read or is not what it claims to be
    BadUsage,      ///< a name, option or combination that does not exist
    DeviceFailed,  ///< no usable Vulkan device, or it was lost
    OutputFailed,  ///< the output cannot be written
};

/// A failed operation in words a user can act on: what, where, and if known which line.
struct Error {
    ErrorCode code = ErrorCode::BadInput;
    std::string text;
};

/// A value, or the reason why there is none. Used where a whole operation fails; a single bad record goes to
/// Diagnostics instead.
template <class T>
class [[nodiscard]] Result {
public:
    Result(T value) : m_state(std::move(value)) {}
    Result(Error error) : m_state(std::move(error)) {}

    [[nodiscard]] bool ok() const { return std::holds_alternative<T>(m_state); }
    explicit operator bool() const { return ok(); }

    [[nodiscard]] T& value() {
        ASSERT(ok());
        return std::get<T>(m_state);
    }
    [[nodiscard]] const T& value() const {
        ASSERT(ok());
        return std::get<T>(m_state);
    }
    [[nodiscard]] const Error& error() const {
        ASSERT(!ok());
        return std::get<Error>(m_state);
    }
    T* operator->() { return &value(); }
    const T* operator->() const { return &value(); }
    T& operator*() { return value(); }
    const T& operator*() const { return value(); }

private:
    std::variant<T, Error> m_state;
};

/// The result of an operation that has nothing to give back.
struct Done {};
using Status = Result<Done>;

}  // namespace base

/// Declares what a Result holds, or returns its error: `ASSIGN_OR_RETURN(const Board board, readBoard(path));`.
#define ASSIGN_OR_RETURN(declaration, ...) ASSIGN_OR_RETURN_AS(RESULT_NAME(result_, __LINE__), declaration, __VA_ARGS__)
#define ASSIGN_OR_RETURN_AS(result, declaration, ...) \
    auto result = __VA_ARGS__;                        \
    if (!result) {                                    \
        return result.error();                        \
    }                                                 \
    declaration = std::move(*result)
#define RESULT_NAME(prefix, line) RESULT_NAME_OF(prefix, line)
#define RESULT_NAME_OF(prefix, line) prefix##line
/// Returns the error of a Status, if it has one.
#define RETURN_IF_ERROR(...)                                      \
    do {                                                          \
        if (const base::Status status_ = __VA_ARGS__; !status_) { \
            return status_.error();                               \
        }                                                         \
    } while (false)
