#include "app/common/incomplete_job.h"

#include <algorithm>
#include <cstdio>

#include "app/common/exit_code.h"
#include "model/board/diagnostic_facts.h"

namespace app {

int verdictCode(int code, std::span<const model::Document* const> jobs, bool allowsIncomplete) {
    const bool isPart = std::ranges::any_of(
        jobs, [](const model::Document* job) { return model::firstError(job->diagnostics) != nullptr; });
    if (!isPart) {
        return code;
    }
    std::fprintf(stderr, "copperscope: not everything could be checked: not all of the job could be read%s\n",
                 allowsIncomplete ? "" : " (--allow-incomplete accepts that)");
    return allowsIncomplete ? code : int{kTooClose};
}

}  // namespace app
