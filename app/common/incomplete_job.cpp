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

int verdictCode(int code, std::span<const model::Document* const> jobs, bool allowsIncomplete) {
    if (areComplete(jobs)) {
        return code;
    }
    std::fprintf(stderr, "copperscope: not everything could be checked: not all of the job could be read%s\n",
                 allowsIncomplete ? "" : " (--allow-incomplete accepts that)");
    return allowsIncomplete ? code : int{kTooClose};
}

}  // namespace app
