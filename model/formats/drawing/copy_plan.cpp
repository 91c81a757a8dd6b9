#include "model/formats/drawing/copy_plan.h"

#include <algorithm>

#include "model/base/limits.h"

namespace model::formats {

namespace {

/// Why a copy cannot be; empty if it can.
std::string problemOf(const DrawnCopy& copy, std::size_t step, const std::vector<CopyPlan>& plans) {
    if (copy.step <= static_cast<std::int64_t>(step) || static_cast<std::size_t>(copy.step) >= plans.size()) {
        return "a copy of a step that is not there, or that holds the copy itself; it is missing";
    }
    const CopyPlan& child = plans[static_cast<std::size_t>(copy.step)];
    if (child.height >= base::kMostStepDepth) {
        return "the step has " + base::moreThan(base::kMostStepDepth, "levels of steps") + "; those within are missing";
    }
    return plans[step].total + child.total > base::kMostCopies
               ? "the step has " + base::moreThan(base::kMostCopies, "copies") + "; the rest is missing"
               : std::string();
}

}  // namespace

std::vector<CopyPlan> planCopies(const DrawnJob& job, Diagnostics& diagnostics) {
    std::vector<CopyPlan> plans(job.steps.size());
    for (std::size_t step = job.steps.size(); step-- > 0;) {  // those that are placed lie behind
        CopyPlan& plan = plans[step];
        for (const DrawnCopy& copy : job.steps[step].copies) {
            if (const std::string problem = problemOf(copy, step, plans); !problem.empty()) {
                diagnostics.report(Severity::Error, job.steps[step].copiesFile, copy.line, problem);
                continue;
            }
            const auto child = static_cast<std::size_t>(copy.step);
            plan.copies.push_back({child, copy.placement, copy.isFlipped, copy.line});
            plan.total += plans[child].total;
            plan.height = std::max(plan.height, plans[child].height + 1);
        }
    }
    return plans;
}

}  // namespace model::formats
