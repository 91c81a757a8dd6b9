#include "model/formats/ipc2581/job_steps.h"

#include <algorithm>

#include "model/base/limits.h"

namespace model::ipc2581 {

namespace {

using formats::DrawnStep;

class StepPlacer {
public:
    StepPlacer(Reading& reading, std::vector<SourceStep>& steps)
        : m_reading(reading), m_steps(steps), m_states(steps.size()) {}

    /// Those that are reachable, every step before those it holds.
    std::vector<std::size_t> order(std::size_t shown) {
        visit(shown, 0);
        std::ranges::reverse(m_order);
        return m_order;
    }

    void place(std::size_t step, const std::vector<std::int32_t>& rowOfStep, DrawnStep& drawn) {
        for (const SourceRepeat& repeat : m_steps[step].repeats) {
            const std::size_t child = find(repeat.step);
            const bool isBehind = child < m_steps.size() && rowOfStep[child] > rowOfStep[step];
            if (isBehind) {
                addBlock(repeat, child, rowOfStep[child], drawn);
            }
        }
    }

private:
    enum class State : std::uint8_t { Untouched, Open, Done };

    [[nodiscard]] std::size_t find(std::string_view name) const {
        return static_cast<std::size_t>(std::ranges::find(m_steps, name, &SourceStep::name) - m_steps.begin());
    }

    void visit(std::size_t step, int depth) {
        m_states[step] = State::Open;
        for (const SourceRepeat& repeat : m_steps[step].repeats) {
            const std::size_t child = find(repeat.step);
            if (child == m_steps.size()) {
                m_reading.report(Severity::Warning, repeat.line,
                                 "a StepRepeat names a step that the file does not have");
            } else if (m_states[child] == State::Open || depth >= base::kMostStepDepth) {
                m_reading.report(Severity::Error, repeat.line,
                                 "the step contains itself or has " +
                                     base::moreThan(base::kMostStepDepth, "levels of steps") +
                                     "; its copies are missing");
            } else if (m_states[child] == State::Untouched) {
                visit(child, depth + 1);
            }
        }
        m_states[step] = State::Done;
        m_order.push_back(step);
    }

    void addBlock(const SourceRepeat& repeat, std::size_t child, std::int32_t row, DrawnStep& drawn) {
        Turn turn{{}, repeat.ccwDeg, repeat.isMirrored, 1.0};
        const PointD datum = turn.apply(m_steps[child].datum);
        for (int j = 0; j < repeat.rows; ++j) {
            for (int i = 0; i < repeat.columns; ++i) {
                if (drawn.copies.size() >= base::kMostCopies) {
                    return m_reading.report(
                        Severity::Error, repeat.line,
                        "the step has " + base::moreThan(base::kMostCopies, "copies") + "; the rest is missing");
                }
                const PointD at = {repeat.first.x + i * repeat.pitch.x - datum.x,
                                   repeat.first.y + j * repeat.pitch.y - datum.y};
                const Placement placement{m_reading.rounded(at, repeat.line), normalDegrees(-repeat.ccwDeg),
                                          repeat.isMirrored};
                drawn.copies.push_back({row, placement, repeat.isMirrored, repeat.line});
            }
        }
    }

    Reading& m_reading;
    std::vector<SourceStep>& m_steps;
    std::vector<State> m_states;
    std::vector<std::size_t> m_order;
};

/// From rows of the LayerList to rows of the job.
void renumberLayers(DrawnStep& step, const std::vector<std::int32_t>& rows) {
    std::vector<std::vector<formats::DrawnFeature>> features(rows.size());
    for (std::size_t row = 0; row < step.features.size(); ++row) {
        features[static_cast<std::size_t>(rows[row])] = std::move(step.features[row]);
    }
    step.features = std::move(features);
    for (formats::DrawnGroup& group : step.groups) {
        for (auto& [layer, feature] : group.features) {
            layer = rows[static_cast<std::size_t>(layer)];
        }
    }
    for (formats::DrawnZone& zone : step.zones) {
        for (std::int32_t& layer : zone.layers) {
            layer = rows[static_cast<std::size_t>(layer)];
        }
    }
}

}  // namespace

void addSteps(Reading& reading, std::vector<SourceStep> steps, std::size_t shown, const std::vector<std::int32_t>& rows,
              formats::DrawnJob& job) {
    StepPlacer placer(reading, steps);
    const std::vector<std::size_t> order = placer.order(shown);
    std::vector<std::int32_t> rowOfStep(steps.size(), formats::kNoRow);
    for (std::size_t i = 0; i < order.size(); ++i) {
        rowOfStep[order[i]] = static_cast<std::int32_t>(i);
    }
    for (const std::size_t step : order) {
        renumberLayers(steps[step].drawn, rows);
        placer.place(step, rowOfStep, steps[step].drawn);
        job.steps.push_back(std::move(steps[step].drawn));
    }
    for (std::size_t step = 0; step < steps.size(); ++step) {
        if (rowOfStep[step] == formats::kNoRow) {
            job.steps.emplace_back().name = steps[step].drawn.name;
        }
    }
}

}  // namespace model::ipc2581
