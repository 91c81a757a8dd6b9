#include "app/common/incomplete_job.h"

#include <algorithm>
#include <cstdio>

#include "app/common/exit_code.h"
#include "model/board/diagnostic_facts.h"

namespace app {

bool areComplete(std::span<const model::Document* const> jobs) {
    return std::ranges::all_of(
        jobs, [](const model::Document* job) { return model::firstError(job->diagnostics) == nullptr; });
}

int incompleteCode(int code, const char* why, bool allowsIncomplete) {
    std::fprintf(stderr, "copperscope: %s%s\n", why, allowsIncomplete ? "" : " (--allow-incomplete accepts that)");
    return allowsIncomplete ? code : int{kTooClose};
}

int verdictCode(int code, std::span<const model::Document* const> jobs, bool allowsIncomplete) {
    return areComplete(jobs) ? code
                             : incompleteCode(code, "not everything could be checked: not all of the job could be read",
                                              allowsIncomplete);
}

}  // namespace app
