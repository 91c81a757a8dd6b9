#include "model/formats/odb/copy_plan.h"

#include <algorithm>

#include "model/base/limits.h"
#include "model/board/copies.h"

namespace model::odb {

namespace {

/// The placement that rotates a step around its datum and lays the datum on `location`.
Placement onDatum(Point location, const StepRepeat& repeat, Point datum) {
    Placement placement{{}, repeat.clockwiseDeg, repeat.isMirrored};
    const Point moved = placement.apply(datum);
    placement.origin = {location.x - moved.x, location.y - moved.y};
    return placement;
}

class CopyPlanner {
public:
    CopyPlanner(const Steps& steps, Diagnostics& diagnostics)
        : m_steps(steps), m_diagnostics(diagnostics), m_plans(steps.size()), m_states(steps.size(), State::Untouched) {}

    std::vector<formats::CopyPlan> plan() {
        visit(0, 0);
        return std::move(m_plans);
    }

private:
    enum class State : std::uint8_t { Untouched, Open, Done };

    /// Children first; a step that is still open contains the one that needs it.
    void visit(std::size_t step, int depth) {
        m_states[step] = State::Open;
        for (const StepRepeat& repeat : m_steps[step].header.value.repeats) {
            const std::size_t child = findStep(m_steps, repeat.step);
            if (child == m_steps.size()) {
                continue;  // reported when the steps were collected
            }
            if (m_states[child] == State::Open || depth >= base::kMostStepDepth) {
                report(step, repeat,
                       "the step contains itself or has " + base::moreThan(base::kMostStepDepth, "levels of steps") +
                           "; its copies are missing");
                continue;
            }
            if (m_states[child] == State::Untouched) {
                visit(child, depth + 1);
            }
            addBlock(step, repeat, child);
        }
        m_states[step] = State::Done;
    }

    void addBlock(std::size_t step, const StepRepeat& repeat, std::size_t child) {
        formats::CopyPlan& plan = m_plans[step];
        plan.height = std::max(plan.height, m_plans[child].height + 1);
        for (int row = 0; row < repeat.rows; ++row) {
            for (int column = 0; column < repeat.columns; ++column) {
                if (plan.total + m_plans[child].total > base::kMostCopies) {
                    return report(
                        step, repeat,
                        "the step has " + base::moreThan(base::kMostCopies, "copies") + "; the rest is missing");
                }
                const Point location = {repeat.first.x + column * repeat.pitch.x,
                                        repeat.first.y + row * repeat.pitch.y};
                plan.copies.push_back({child, onDatum(location, repeat, m_steps[child].header.value.datum),
                                       repeat.isFlipped, repeat.line});
                plan.total += m_plans[child].total;
            }
        }
    }

    void report(std::size_t step, const StepRepeat& repeat, std::string_view text) {
        m_diagnostics.report(Severity::Error, m_steps[step].header.path, repeat.line, text);
    }

    const Steps& m_steps;
    Diagnostics& m_diagnostics;
    std::vector<formats::CopyPlan> m_plans;
    std::vector<State> m_states;
};

}  // namespace

std::vector<formats::CopyPlan> planCopies(const Steps& steps, Diagnostics& diagnostics) {
    return CopyPlanner(steps, diagnostics).plan();
}

}  // namespace model::odb
