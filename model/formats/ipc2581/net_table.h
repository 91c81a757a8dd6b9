#pragma once

#include <string_view>
#include <unordered_map>

#include "model/formats/drawing/drawn_job.h"
#include "model/formats/ipc2581/xml/xml_values.h"

namespace model::ipc2581 {

/// The nets of a step, each once, in the order they are first named.
class NetTable {
public:
    explicit NetTable(formats::DrawnStep& step) : m_step(step) {}

    /// Row of the net of this name as written, which is added if it is new; none for no name, and for what Altium calls
    /// all that is in no net.
    std::int32_t row(std::string_view name) {
        if (name.empty() || name == "No Net") {
            return formats::kNoRow;
        }
        const auto [found, isNew] = m_rows.try_emplace(name, static_cast<std::int32_t>(m_step.nets.size()));
        if (isNew) {
            m_step.nets.push_back({textOf(name), {}});
        }
        return found->second;
    }

private:
    formats::DrawnStep& m_step;
    std::unordered_map<std::string_view, std::int32_t> m_rows;
};

}  // namespace model::ipc2581
