#pragma once

#include <span>

#include "model/board/document.h"

namespace app {

/// Could all of the jobs be read: is none of their diagnostics an error?
[[nodiscard]] bool areComplete(std::span<const model::Document* const> jobs);

/// The exit code of a verdict that does not hold for everything: `code`, or kTooClose unless that is allowed
/// (--allow-incomplete). Says `why` on stderr.
[[nodiscard]] int incompleteCode(int code, const char* why, bool allowsIncomplete);

/// The exit code of a command that ends with a verdict on jobs (a limit, an agreement), which only holds for what could
/// be read of them: `code`, or kTooClose where a diagnostic is an error, unless that is allowed (--allow-incomplete).
/// Says so on stderr, in the words of rules that could not check everything.
[[nodiscard]] int verdictCode(int code, std::span<const model::Document* const> jobs, bool allowsIncomplete);

}  // namespace app
