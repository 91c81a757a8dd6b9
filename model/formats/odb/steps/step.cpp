#include "model/formats/odb/steps/step.h"

#include <algorithm>
#include <atomic>
#include <functional>

#include "model/base/parallel.h"
#include "model/formats/odb/stackup/layer_facts.h"
#include "model/formats/odb/text/records.h"

namespace model::odb {

namespace {

/// Parses a file if it can be read.
template <class T, class Parse>
void read(const JobContext& job, const std::string& path, Parsed<T>& into, Parse parse) {
    if (const auto file = job.tree.read(path, into.diagnostics)) {
        into.path = file->path;
        into.value = parse(file->text(), file->path, job.defaultUnit, into.diagnostics);
    }
}

}  // namespace

std::size_t findStep(const Steps& steps, std::string_view name) {
    const auto location =
        std::ranges::find_if(steps, [name](const StepData& s) { return equalsIgnoringCase(s.name, name); });
    return static_cast<std::size_t>(location - steps.begin());
}

Steps collectSteps(const JobContext& job, const std::string& name, Diagnostics& diagnostics) {
    Steps steps;
    std::vector<std::string> wanted{name};
    for (std::size_t next = 0; next < wanted.size(); ++next) {
        if (findStep(steps, wanted[next]) < steps.size()) {
            continue;
        }
        const std::string folder = "steps/" + wanted[next];
        if (!job.tree.hasFolder(folder)) {
            diagnostics.report(Severity::Error, folder, 0,
                               "step " + wanted[next] + " has no folder; its copies are missing");
            continue;
        }
        StepData step;
        step.name = wanted[next];
        step.folder = folder;
        step.layers.resize(job.matrix.layers.size());
        read(job, step.folder + "/stephdr", step.header, parseStepHeader);
        for (const StepRepeat& repeat : step.header.value.repeats) {
            wanted.push_back(repeat.step);
        }
        steps.push_back(std::move(step));
    }
    return steps;
}

namespace {

/// One file to parse, with its size so that the largest go first.
struct Task {
    std::uint64_t size = 0;
    std::function<void()> run;
};

class TaskList {
public:
    explicit TaskList(const JobContext& job) : m_job(job) {
        for (const MatrixLayer& layer : job.matrix.layers) {
            m_layerNames.push_back(layer.name);
        }
    }

    /// Plans `parse(text, path, default unit, diagnostics)` for a file, if it exists.
    template <class T, class Parse>
    void add(const std::string& path, Parsed<T>& into, Parse parse) {
        if (m_job.tree.has(path)) {
            m_tasks.push_back(
                {m_job.tree.storedSize(path), [this, path, &into, parse] { read(m_job, path, into, parse); }});
        }
    }

    void addStep(StepData& step) {
        add(step.folder + "/profile", step.profile, parseFeatures);
        add(step.folder + "/zones", step.zones, parseZones);
        add(step.folder + "/eda/data", step.eda,
            [this](std::string_view text, std::string_view path, Unit unit, Diagnostics& d) {
                return parseEda(text, path, unit, m_layerNames, *m_job.attributeTypes, d);
            });
        constexpr const char* kFolders[] = {"cadnet", "refnet", "curcadnet"};
        for (std::size_t i = 0; i < step.netlists.size(); ++i) {
            add(step.folder + "/netlists/" + kFolders[i] + "/netlist", step.netlists[i], parseNetlist);
        }
        for (std::size_t row = 0; row < step.layers.size(); ++row) {
            if (m_job.matrix.rowOf(m_layerNames[row]) == row) {
                addLayer(step, row);
            }
        }
    }

    bool run(base::Progress& progress) {
        std::ranges::stable_sort(m_tasks, std::greater<>(), &Task::size);
        std::uint64_t total = 1;
        for (const Task& task : m_tasks) {
            total += task.size;
        }
        std::atomic<std::uint64_t> done{0};
        base::parallelFor(m_tasks.size(), [&](std::size_t i) {
            if (!progress.isCancelled()) {
                m_tasks[i].run();
                done += m_tasks[i].size;
                progress.setFraction(static_cast<float>(static_cast<double>(done) / static_cast<double>(total)));
            }
        });
        return !progress.isCancelled();
    }

private:
    void addLayer(StepData& step, std::size_t row) {
        const MatrixLayer& layer = m_job.matrix.layers[row];
        const std::string folder = step.folder + "/layers/" + layer.name;
        StepLayer& into = step.layers[row];
        add(folder + "/features", into.features, parseFeatures);
        add(folder + "/profile", into.profile, parseFeatures);
        add(folder + "/attrlist", into.facts,
            [&layer](std::string_view text, std::string_view path, Unit unit, Diagnostics& d) {
                return factsOf(AttributeList(text, path, unit, d), layer);
            });
        if (layer.isHoles()) {
            add(folder + "/tools", into.tools, [](std::string_view text, std::string_view path, Unit, Diagnostics& d) {
                return parseTools(text, path, d);
            });
        }
        if (layer.type == LayerType::Component) {
            add(folder + "/components", into.components,
                [this](std::string_view text, std::string_view path, Unit unit, Diagnostics& d) {
                    return parseComponents(text, path, unit, *m_job.attributeTypes, d);
                });
        }
    }

    const JobContext& m_job;
    std::vector<Task> m_tasks;
    std::vector<std::string> m_layerNames;
};

}  // namespace

bool readSteps(const JobContext& job, Steps& steps, base::Progress& progress) {
    TaskList tasks(job);
    for (StepData& step : steps) {
        tasks.addStep(step);
    }
    return tasks.run(progress);
}

}  // namespace model::odb
